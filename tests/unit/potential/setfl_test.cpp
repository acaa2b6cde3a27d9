// SPDX-License-Identifier: MIT
// setfl files: what is written comes back, energies and pressures of the lattice within the interpolation error that is stated here;
// an element is chosen among several; every kind of damage is refused with a sentence that names its line; nothing crashes.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/potential/setfl.hpp"
#include "bolide/potential/zhou04.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

namespace {
using namespace bolide;

template <class P> potential::setfl written_and_read(const P& p, int n_rho, double d_rho, int n_r, double d_r) {
  const std::string path = ::testing::TempDir() + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".setfl"; // tests run side by side
  potential::write_setfl(p, n_rho, d_rho, n_r, d_r, path);
  auto r = potential::setfl::read(path);
  std::remove(path.c_str());
  return r;
}

struct difference {
  double energy = 0, pressure = 0, slope = 0; // eV; relative to |p| + 1 GPa
};
template <class P> difference largest_difference(const P& p, const potential::setfl& file, double low, double high) {
  const cold::lattice exact{p};
  const cold::lattice read{file};
  difference most;
  for (double x = low; x < high; x *= 1.017) {
    const auto a = exact.evaluate(x), b = read.evaluate(x);
    most.energy = std::max(most.energy, std::abs(exact.energy_per_atom(x) - read.energy_per_atom(x)));
    most.pressure = std::max(most.pressure, std::abs(a.pressure - b.pressure) / (std::abs(a.pressure) + 1e9));
    most.slope = std::max(most.slope, std::abs(a.slope - b.slope) / (std::abs(a.slope) + 1e9));
  }
  return most;
}

TEST(Setfl, RoundTripKeepsTheLattice) {
  const potential::cai_ye sharp(potential::cutoff::sharp), none;
  const potential::zhou04 zhou;
  const auto file = written_and_read(sharp, 20001, 0.01, 20001, 7.0 / 20000);
  EXPECT_EQ(file.mass(), 26.982);
  EXPECT_EQ(file.lattice_constant(), 4.05);
  EXPECT_EQ(file.structure(), lattice::fcc);
  EXPECT_EQ(file.element(), "Al");
  EXPECT_EQ(file.reach(), sharp.reach());
  EXPECT_NEAR(file.largest_density(), 200, 1e-10);
  const auto check = [](const difference& d, double energy, double pressure, double slope) {
    EXPECT_LT(d.energy, energy);
    EXPECT_LT(d.pressure, pressure);
    EXPECT_LT(d.slope, slope);
  };
  check(largest_difference(sharp, file, 0.3, 1.6), 1e-12, 2e-9, 3e-5);
  check(largest_difference(none, written_and_read(none, 20001, 0.01, 20001, 0.001), 0.3, 1.6), 2e-12, 1e-8, 3e-5);
  check(largest_difference(zhou, written_and_read(zhou, 20001, 0.01, 20001, 0.001), 0.3, 3), 2e-9, 2e-5, 1e-3); // F steps and bends at its joins
  check(largest_difference(sharp, written_and_read(sharp, 2001, 0.1, 2001, 7.0 / 2000), 0.3, 1.3), 1e-9, 1e-6, 1e-3);
}
TEST(Setfl, ErrorFallsWithTheFourthPowerOfTheStep) {
  const potential::cai_ye p(potential::cutoff::sharp);
  const auto worst = [&](int n) {
    const auto file = written_and_read(p, n, 200.0 / (n - 1), n, 7.0 / (n - 1));
    double most = 0;
    for (double r = 1.5; r < 6.5; r *= 1.00113) most = std::max(most, std::abs(file.density(r).value - p.density(r).value));
    return most;
  };
  EXPECT_NEAR(worst(501) / worst(1001), 16, 1.5);
}
TEST(Setfl, SplineDerivativesAreThoseOfTheFunctions) {
  const potential::zhou04 p;
  const auto file = written_and_read(p, 2001, 0.05, 4001, 0.005);
  for (double r = 1.5; r < 7; r *= 1.0413) {
    const auto a = p.pair(r), b = file.pair(r), f = p.density(r), g = file.density(r);
    EXPECT_NEAR(a.value, b.value, 1e-8) << r;
    EXPECT_NEAR(a.first, b.first, 1e-6) << r;
    EXPECT_NEAR(a.second, b.second, 1e-3) << r;
    EXPECT_NEAR(f.value, g.value, 1e-8) << r;
    EXPECT_NEAR(f.first, g.first, 1e-6) << r;
    EXPECT_NEAR(f.second, g.second, 1e-3) << r;
  }
}
TEST(Setfl, OutsideItsTables) {
  const auto file = written_and_read(potential::cai_ye(potential::cutoff::sharp), 101, 0.5, 101, 0.07);
  EXPECT_EQ(file.pair(7.1).value, 0);
  EXPECT_EQ(file.density(7.1).first, 0);
  const auto end = file.embedding(50), beyond = file.embedding(60); // a straight line
  EXPECT_NEAR(beyond.value, end.value + 10 * end.first, 1e-12);
  EXPECT_EQ(beyond.second, 0);
  EXPECT_TRUE(std::isnan(file.embedding(std::nan("")).value));
  EXPECT_TRUE(std::isnan(file.pair(std::nan("")).value));
}

// ---- files written by hand -------------------------------------------------------------------------------------------------------------
std::string line_of(int n, double first, double step) {
  std::ostringstream s;
  for (int i = 0; i < n; ++i) s << first + step * i << (i + 1 < n ? " " : "\n");
  return s.str();
}
const std::string head = "comment\ncomment\ncomment\n";
std::string small_file() {
  return head + "1 Fe\n5 0.5 6 1.0 5.0\n26 55.845 2.87 bcc\n" + line_of(5, 0, -1) + line_of(6, 5, -1) + line_of(6, 6, -1);
}
std::string two_elements() {
  return head + "2 Al Cu\n5 0.5 6 1.0 5.0\n13 26.98 4.05 fcc\n" + line_of(5, 0, -1) + line_of(6, 5, -1) + "29 63.55 3.615 FCC\n" + line_of(5, 0, -2) +
         line_of(6, 10, -2) + line_of(6, 1, 1) + line_of(6, 2, 1) + line_of(6, 3, 1);
}

TEST(Setfl, ReadsBccAndFortranNumbers) {
  const auto p = potential::setfl::parse(small_file());
  EXPECT_EQ(p.structure(), lattice::bcc);
  EXPECT_NEAR(p.embedding(0.75).value, -1.5, 1e-14); // straight lines stay straight
  EXPECT_NEAR(p.density(2.5).value, 2.5, 1e-14);
  EXPECT_NEAR(p.pair(2.0).value, 4.0 / 2, 1e-14);
  EXPECT_EQ(p.reach(), 5.0);
  std::string fortran = small_file();
  fortran.replace(fortran.find("55.845"), 6, "5.5845D+01");
  EXPECT_EQ(potential::setfl::parse(fortran).mass(), 55.845);
}
TEST(Setfl, LayoutDoesNotMatter) { // any number of values in a line, blanks before, Windows line ends
  std::string text = small_file(), one_per_line = head + "1 Fe\n5 0.5 6 1.0 5.0\n\n   26 55.845 2.87 bcc  \n";
  std::istringstream rest(text.substr(text.find("bcc\n") + 4));
  for (std::string word; rest >> word;) one_per_line += "  " + word + "\r\n";
  EXPECT_NEAR(potential::setfl::parse(one_per_line).pair(2.0).value, 2, 1e-14);
}
TEST(Setfl, ChoosesAnElement) {
  const auto al = potential::setfl::parse(two_elements(), "Al"), cu = potential::setfl::parse(two_elements(), "Cu");
  EXPECT_EQ(al.mass(), 26.98);
  EXPECT_EQ(cu.mass(), 63.55);
  EXPECT_NEAR(al.pair(1.0).value, 2, 1e-14); // the tables come as Al-Al, Cu-Al, Cu-Cu
  EXPECT_NEAR(cu.pair(1.0).value, 4, 1e-14);
  EXPECT_NEAR(cu.embedding(1.0).value, -4, 1e-14);
  EXPECT_NEAR(cu.density(1.0).value, 8, 1e-14);
  EXPECT_EQ(cu.lattice_constant(), 3.615);
}

void expect_refusal(const std::string& text, const std::string& sentence, const std::string& element = "") {
  try {
    potential::setfl::parse(text, element, "f.eam");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const bad_parameter& e) {
    EXPECT_EQ(std::string(e.what()), sentence);
  }
}
std::string changed(std::string text, const std::string& from, const std::string& to) { return text.replace(text.find(from), from.size(), to); }

TEST(Setfl, RefusesWithLineAndExpectation) {
  const std::string s = small_file();
  expect_refusal("", "f.eam line 1: expected comment line 1 of 3, found the end of the text");
  expect_refusal("a\nb\n", "f.eam line 3: expected comment line 3 of 3, found the end of the text");
  expect_refusal(head, "f.eam line 4: expected the number of elements, a whole number from 1 to 100, found the end of the line");
  expect_refusal(changed(s, "1 Fe", "Fe"), "f.eam line 4: expected the number of elements, a whole number from 1 to 100, found 'Fe'");
  expect_refusal(changed(s, "1 Fe", "0 Fe"), "f.eam line 4: expected the number of elements, a whole number from 1 to 100, found '0'");
  expect_refusal(changed(s, "1 Fe", "2 Fe"), "f.eam line 4: expected 2 names of elements, found the end of the line");
  expect_refusal(two_elements(), "f.eam line 4: holds several elements (Al, Cu): say which one");
  expect_refusal(two_elements(), "f.eam line 4: holds no element 'Ni', it has Al, Cu", "Ni");
  expect_refusal(changed(s, "5 0.5", "5.0 0.5"), "f.eam line 5: expected N_rho, a whole number from 5 to 10000000, found '5.0'");
  expect_refusal(changed(s, "5 0.5", "3 0.5"), "f.eam line 5: expected N_rho, a whole number from 5 to 10000000, found '3'");
  expect_refusal(changed(s, "5 0.5", "99999999999 0.5"), "f.eam line 5: expected N_rho, a whole number from 5 to 10000000, found '99999999999'");
  expect_refusal(changed(s, "5 0.5", "5 -0.5"), "f.eam line 5: expected d_rho > 0, found -0.5");
  expect_refusal(changed(s, "1.0 5.0", "1.0"), "f.eam line 5: expected the cut-off (angstrom), found the end of the line");
  expect_refusal(changed(s, "26 55.845", "26 heavy"), "f.eam line 6: expected the mass of Fe (u), found 'heavy'");
  expect_refusal(changed(s, "55.845", "0"), "f.eam line 6: expected a mass > 0 u, found 0");
  expect_refusal(changed(s, "2.87", "-1"), "f.eam line 6: expected a lattice constant > 0 angstrom, found -1");
  expect_refusal(changed(s, "bcc", "hcp"), "f.eam line 6: expected the structure fcc or bcc, found 'hcp'");
  expect_refusal(changed(s, " bcc", ""), "f.eam line 6: expected the structure of Fe (fcc or bcc), found the end of the line");
  expect_refusal(changed(s, "0 -1 -2", "0 nan -2"), "f.eam line 7: expected value 2 of 5 of F(rho) of Fe, found 'nan'");
  expect_refusal(changed(s, "5 4 3", "5 4e999 3"), "f.eam line 8: expected value 2 of 6 of f(r) of Fe, found '4e999'");
  expect_refusal(changed(s, "6 5 4 3 2 1\n", "6 5 4\n"), "f.eam line 10: expected value 4 of 6 of r phi(r) of Fe-Fe, found the end of the text");
  expect_refusal(changed(s, "6 5 4 3 2 1\n", "6 5 4 x"), "f.eam line 9: expected value 4 of 6 of r phi(r) of Fe-Fe, found 'x'");
  expect_refusal(s + "7\n", "f.eam line 10: expected the end of the text after the last of 6 values, found '7' (wrong N_rho or N_r, or a "
                            "file of another style, such "
                            "as adp or fs)");
  try {
    potential::setfl::read("/no/such/file.eam");
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "file '/no/such/file.eam': cannot be opened (No such file or directory)");
  }
  EXPECT_THROW(potential::setfl::read("/tmp"), bad_parameter); // a folder
}

TEST(Setfl, NeverCrashesOnDamage) {
  const std::string whole = two_elements();
  const auto refused = [](const std::string& text) {
    try {
      potential::setfl::parse(text, "Cu");
    } catch (const bad_parameter& e) {
      EXPECT_NE(std::string(e.what()).find("line"), std::string::npos);
      return true;
    }
    return false;
  };
  for (std::size_t n = 0; n + 2 < whole.size(); ++n) EXPECT_TRUE(refused(whole.substr(0, n))) << n; // cut short anywhere (the last digit may go)
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> place(0, whole.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 3000);
  int refusals = 0;
  for (int i = 0; i < 3000; ++i) { // damaged anywhere: refused or read, nothing else
    std::string text = whole;
    for (int k = 0; k < 3; ++k) text[place(random)] = static_cast<char>(byte(random));
    refusals += refused(text) ? 1 : 0;
  }
  EXPECT_GT(refusals, 1500);
  for (int i = 0; i < 300; ++i) { // noise
    std::string text(static_cast<std::size_t>(length(random)), ' ');
    std::generate(text.begin(), text.end(), [&] { return static_cast<char>(byte(random)); });
    EXPECT_TRUE(refused(text));
  }
}

// Public files, where they are installed (Debian: lammps-data): a potential with published constants, and files that are no setfl.
TEST(Setfl, ReadsPublicFiles) {
  const std::string folder = "/usr/share/lammps/potentials/";
  if (!std::ifstream(folder + "Cu_mishin1.eam.alloy")) GTEST_SKIP() << "no " << folder << "Cu_mishin1.eam.alloy (Debian: lammps-data)";
  const cold::lattice copper{potential::setfl::read(folder + "Cu_mishin1.eam.alloy")}; // Mishin et al., Phys. Rev. B 63 (2001) 224106
  EXPECT_NEAR(copper.cohesive_energy_per_atom(), 3.54, 0.0005);
  EXPECT_NEAR(copper.bulk_modulus() / 1e9, 138.3, 0.1);
  const auto c = copper.elastic_constants();
  EXPECT_NEAR(c.C11 / 1e9, 169.9, 0.1);
  EXPECT_NEAR(c.C12 / 1e9, 122.6, 0.1);
  EXPECT_NEAR(c.C44 / 1e9, 76.2, 0.1);
  EXPECT_NO_THROW(potential::setfl::read(folder + "W_zhou.eam.alloy"));
  EXPECT_NO_THROW(potential::setfl::read(folder + "NiAlH_jea.eam.alloy", "Al"));
  for (const char* other : {"AlFe_mm.eam.fs", "NiAlH_jea.eam.fs", "AlCu.adp", "Ni_u3.eam"})
    EXPECT_THROW(potential::setfl::read(folder + other, std::string(other) == "Ni_u3.eam" ? "" : "Al"), bad_parameter) << other;
}

TEST(Setfl, WriterRefusesWhatItCannotWrite) {
  const potential::cai_ye p(potential::cutoff::sharp);
  const std::string path = ::testing::TempDir() + "setfl_refused.setfl";
  try {
    potential::write_setfl(p, 101, 1, 101, 0.05, path);
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "write_setfl (n_r - 1) d_r = 5 angstrom: must be at least the potential's reach, 6.682499999999999 (unit: angstrom)");
  }
  EXPECT_THROW(potential::write_setfl(p, 4, 1, 101, 0.1, path), bad_parameter);
  EXPECT_THROW(potential::write_setfl(p, 101, 0, 101, 0.1, path), bad_parameter);
  EXPECT_THROW(potential::write_setfl(p, 101, 1, 101, 0.1, "/no/such/folder/x.setfl"), bad_parameter);
}
} // namespace
