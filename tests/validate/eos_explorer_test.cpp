// SPDX-License-Identifier: MIT
// The contract of the example eos_explorer, that others' scripts depend on: header rows, names, digits, exit codes, and that bad input
// leaves no output. Numbers are compared with the library called directly.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE)

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/impedance_match.hpp"
#include "bolide/analysis/isentrope.hpp"
#include "bolide/analysis/melt_thresholds.hpp"
#include "bolide/analysis/riemann.hpp"
#include "bolide/eos/cold/birch_murnaghan.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/vinet.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/query.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/potential/setfl.hpp"
#include "bolide/potential/zhou04.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace bolide;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

using row = std::vector<std::string>;

row split(const std::string& line) {
  row cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

struct answer {
  int code;
  std::string out, err;
  std::string header() const { return out.substr(0, out.find('\n')); }
  /// The rows below the header.
  std::vector<row> rows() const {
    std::vector<row> all;
    std::istringstream in(out);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) all.push_back(split(line));
    return all;
  }
};

double number(const std::string& cell) {
  EXPECT_FALSE(cell.empty());
  char* end = nullptr;
  const double x = std::strtod(cell.c_str(), &end);
  EXPECT_EQ(*end, '\0') << cell;
  return x;
}

/// Both compiled from the same header, but with other flags: the last bits may differ.
void expect_same(const std::string& cell, double expected, double scale = 0, double relative = 1e-12) {
  EXPECT_NEAR(number(cell), expected, relative * (std::abs(expected) + scale)) << cell;
}

class EosExplorer : public ::testing::Test {
protected:
  fs::path folder;
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("bolide_explorer_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  answer run(const std::string& arguments, const std::string& input = "") const {
    std::ofstream(folder / "stdin", std::ios::binary) << input;
    const std::string command = "cd '" + folder.string() + "' && " BOLIDE_EXAMPLE " " + arguments + " >stdout 2>stderr <stdin";
    const int status = std::system(command.c_str());
    answer a{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder / "stdout"), read(folder / "stderr")};
    for (const char* name : {"stdin", "stdout", "stderr"}) fs::remove(folder / name);
    return a;
  }
  /// Exit code 2, nothing on standard output, one sentence that holds these words.
  void expect_refused(const std::string& arguments, const std::string& input, const std::vector<std::string>& words) const {
    SCOPED_TRACE(arguments + " <<< " + input);
    const answer a = run(arguments, input);
    EXPECT_EQ(a.code, 2);
    EXPECT_EQ(a.out, "");
    EXPECT_EQ(std::count(a.err.begin(), a.err.end(), '\n'), 1) << a.err;
    for (const auto& word : words) EXPECT_NE(a.err.find(word), std::string::npos) << "'" << word << "' is not in: " << a.err;
  }
  answer good(const std::string& arguments, const std::string& input = "") const {
    answer a = run(arguments, input);
    EXPECT_EQ(a.code, 0) << arguments << "\n" << a.err;
    return a;
  }
};

const std::string points_header = ",region,temperature_K,pressure_Pa,sound_speed_squared_m2_s2,dp_de,dp_dV,melt_fraction,status";

/// Every column of `points` against query().
template <class Eos>
void expect_points(const answer& a, const Eos& eos, const std::vector<std::array<double, 2>>& states, bool melts, double relative = 1e-12) {
  EXPECT_EQ(a.header(), "rho,e" + points_header);
  const auto rows = a.rows();
  ASSERT_EQ(rows.size(), states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto [rho, e] = states[i];
    const auto q = eos::query(eos, rho, e);
    const row& r = rows[i];
    ASSERT_EQ(r.size(), 10u);
    EXPECT_EQ(number(r[0]), rho);
    EXPECT_EQ(number(r[1]), e);
    EXPECT_EQ(r[2], eos::region_name(eos, rho, e));
    if (std::isnan(q.temperature)) EXPECT_EQ(r[3], "");
    else expect_same(r[3], q.temperature, 0, relative);
    expect_same(r[4], q.pressure, 1e9, relative);
    expect_same(r[5], q.sound_speed_squared, 1e6, relative);
    expect_same(r[6], q.pressure_energy, 0, relative);
    expect_same(r[7], q.pressure_volume, 1e12, relative);
    if (melts) expect_same(r[8], q.melt_fraction, 1, relative);
    else EXPECT_EQ(r[8], "");
    EXPECT_EQ(r[9], eos::name(q.what));
  }
}

std::string csv_of(const std::vector<std::array<double, 2>>& states) {
  std::string text = "rho,e\n";
  for (const auto& [rho, e] : states) text += to_text(rho) + "," + to_text(e) + "\n";
  return text;
}

const std::vector<std::array<double, 2>> states = {{2700, 1e5}, {2700, 1.3e6}, {3800, 5e6}, {4200, 1.05e7}, {2600, 3e6}, {2500, 2e7},
                                                   {1500, 8e6}, {900, 1.5e7},  {4500, 1e6}, {2000, 1e6},    {20000, 1e7}};

template <class Phase> auto grover_of() { return eos::grover{cold::cai_ye{}, Phase{}}; }

} // namespace

// ---- points ---------------------------------------------------------------------------------------------------------------------------

TEST_F(EosExplorer, PointsAreTheLibrarysAnswersForEveryModel) {
  const std::string in = csv_of(states);
  expect_points(good("points --eos paper", in), grover_of<phase::paper>(), states, true);
  expect_points(good("points --eos mixed", in), grover_of<phase::mixed>(), states, true);
  expect_points(good("points --eos helm", in), grover_of<phase::helm>(), states, true);
  expect_points(good("points --eos reference", in), eos::reference{}, states, true, 1e-8); // its melting line is fitted at start-up
  expect_points(good("points --eos mixed --cold rose", in), eos::grover{cold::rose{}, phase::mixed{}}, states, true);
  expect_points(good("points --eos mie-gruneisen", in), eos::mie_grueneisen{}, states, false);
  expect_points(good("points --eos tillotson", in), eos::tillotson{}, states, false);
  const std::vector<std::array<double, 2>> gas = {{1.2, 2e5}, {0.1, 1e6}, {12, 1e5}};
  expect_points(good("points --eos ideal-gas", csv_of(gas)), eos::ideal_gas{}, gas, false);
  const std::vector<std::array<double, 2>> water = {{1000, 0}, {1200, 3e5}, {980, 1e4}};
  expect_points(good("points --eos stiffened-gas", csv_of(water)), eos::stiffened_gas{}, water, false);
  const std::string tnt = "--set rho0=1630kg/m3 --set A=371.2GPa --set B=3.231GPa --set R1=4.15 --set R2=0.95 --set omega=0.3";
  const eos::jwl products({.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.3});
  const std::vector<std::array<double, 2>> burnt = {{1630, 4.3e6}, {2200, 5e6}, {100, 2e6}};
  expect_points(good("points --eos jwl " + tnt, csv_of(burnt)), products, burnt, false);
}

TEST_F(EosExplorer, RatioOfVolumesIsTheModelsOwn) {
  for (const std::string name : {"mixed", "tillotson", "mie-gruneisen"}) {
    const double rho0 = name == "mixed" ? cold::cai_ye{}.reference_density() : name == "tillotson" ? 2700 : 2785;
    const auto by_x = good("points --eos " + name, "x,e\n0.8,2e6\n1.05,3e5\n");
    EXPECT_EQ(by_x.header(), "x,e" + points_header);
    const auto by_rho = good("points --eos " + name, csv_of({{rho0 / 0.8, 2e6}, {rho0 / 1.05, 3e5}})).rows();
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(by_x.rows()[i][0], i == 0 ? "0.8" : "1.05");
      for (std::size_t k = 2; k < 10; ++k) EXPECT_EQ(by_x.rows()[i][k], by_rho[i][k]) << name;
    }
  }
  EXPECT_EQ(good("points --eos mixed", "e,x\n2e6,0.8\n").rows()[0][4], good("points --eos mixed", "x,e\n0.8,2e6\n").rows()[0][4]);
}

TEST_F(EosExplorer, RegionsHaveTheirNames) {
  const auto regions = [&](const std::string& name, const std::string& lines) {
    std::string all;
    for (const row& r : good("points --eos " + name, "x,e\n" + lines).rows()) all += r[2] + " ";
    return all;
  };
  EXPECT_EQ(regions("mixed", "1,1e6\n1,1.3e6\n1,2e6\n1,1.2e7\n1.4,3e6\n"), "solid mixed liquid hot_liquid gas ");
  EXPECT_EQ(regions("paper", "1,1e6\n1,1.3e6\n1,2e6\n1,1.2e7\n1.4,3e6\n"), "solid solid liquid hot_liquid gas ");
  EXPECT_EQ(regions("helm", "1,1e6\n1,1.3e6\n1,2e6\n1,1.2e7\n1.4,9e6\n"), "solid mixed liquid hot_liquid hot_liquid ");
  EXPECT_EQ(regions("tillotson", "0.8,1e6\n1,2e7\n1.2,1e6\n1.2,3e6\n1.2,8e6\n1.2,2e7\n"),
            "compressed compressed expanded_cold expanded_cold transition expanded_hot ");
  EXPECT_EQ(regions("mie-gruneisen", "0.8,1e6\n"), "single ");
  EXPECT_EQ(regions("ideal-gas", "0.8,1e6\n"), "single ");
  EXPECT_EQ(regions("stiffened-gas", "0.8,1e6\n"), "single ");
}

TEST_F(EosExplorer, ReferenceFiguresOfTheEquationOfState) {
  // Latent energies at V0: E_ms 1.1511, E_m 1.5306 MJ/kg (T_m = 1220 K there); the superheated solid of the paper's model ends at 1612 K.
  const auto r = good("points --eos mixed", "x,e\n1,1.1510e6\n1,1.1512e6\n1,1.5305e6\n1,1.5307e6\n").rows();
  EXPECT_EQ(r[0][2] + r[1][2] + r[2][2] + r[3][2], "solidmixedmixedliquid");
  EXPECT_EQ(number(r[1][3]), 1220);
  const auto paper = good("points --eos paper", "x,e\n1,1.5306e6\n").rows();
  EXPECT_NEAR(number(paper[0][3]), 1612, 1);
}

TEST_F(EosExplorer, StateOutsideTheBoxHasItsRowAndAnotherStatus) {
  const auto r = good("points --eos mixed", "x,e\n1,1e6\n0.6,0\n0.15,1e8\n1.6,1.8e6\n").rows();
  ASSERT_EQ(r.size(), 4u);
  EXPECT_EQ(r[0].back(), "ok");
  EXPECT_EQ(r[1].back(), "below_cold_energy");
  EXPECT_EQ(r[2].back(), "outside_validity");
  EXPECT_EQ(r[3].back(), "below_cold_energy"); // e_c(1.6) is 2.06 MJ/kg
  EXPECT_EQ(good("points --eos mixed", "x,e\n1.6,3e6\n").rows()[0].back(), "unstable");
  EXPECT_EQ(good("points --eos mie-gruneisen", "rho,e\n10000,1e6\n").rows()[0].back(), "outside_validity");
  EXPECT_EQ(good("points --eos ideal-gas", "rho,e\n1,-5\n").rows()[0].back(), "outside_validity");
  EXPECT_LT(number(good("points --eos mixed", "x,e\n0.6,0\n").rows()[0][3]), 0); // T <= 0 is told, not hidden
}

TEST_F(EosExplorer, NoLinesGiveAHeaderAlone) {
  EXPECT_EQ(good("points --eos mixed", "x,e\n").out, "x,e" + points_header + "\n");
  EXPECT_EQ(good("points --eos mixed", "x,e\r\n1,1e6\r\n\r\n").rows().size(), 1u); // as spreadsheets end their lines
}

TEST_F(EosExplorer, NumbersHaveSeventeenDigits) {
  const auto r = good("points --eos mixed", "x,e\n0.9,2.5e6\n").rows();
  const double p = eos::query(grover_of<phase::mixed>(), cold::cai_ye{}.reference_density() / 0.9, 2.5e6).pressure;
  expect_same(r[0][4], p);
  std::string digits;
  for (const char c : r[0][4])
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) digits += c;
  EXPECT_GE(digits.size(), 16u) << r[0][4]; // the last may be a 0 that is not written
}

// ---- the error contract ---------------------------------------------------------------------------------------------------------------

TEST_F(EosExplorer, BadLinesAreRefusedByNumberAndNothingIsWritten) {
  const struct {
    const char* input;
    std::vector<std::string> words;
  } cases[] = {
      {"x,e\n1,1e6\nfoo,1e6\n", {"line 3", "'foo'", "not a number"}},
      {"x,e\n1,1e6\n1,\n", {"line 3", "missing"}},
      {"x,e\n1\n", {"line 2", "1 fields", "2"}},
      {"x,e\n1,2,3\n", {"line 2", "3 fields"}},
      {"x,e\n1,1e6\n\n1,1e6\n", {"line 3"}},
      {"x,e\nnan,1e6\n", {"line 2", "nan", "finite"}},
      {"x,e\n1,NaN\n", {"line 2", "NaN"}},
      {"x,e\n1,inf\n", {"line 2", "inf", "finite"}},
      {"x,e\n1,1e999\n", {"line 2", "1e999", "too large"}},
      {"x,e\n1,1e6\n1,2e6\n0,1e6\n", {"line 4", "x = 0", "> 0"}},
      {"x,e\n-0.5,1e6\n", {"line 2", "x = -0.5", "> 0"}},
      {"rho,e\n0,1e6\n", {"line 2", "rho = 0", "> 0"}},
      {"rho,e\n-1,1e6\n", {"line 2", "rho = -1", "> 0"}},
      {"x,e\n1e-320,1e6\n", {"line 2"}},
      {"x,e\n1 2,1e6\n", {"line 2", "1 2"}},
      {"x,e\n0x10,1e6\n", {"line 2", "0x10"}},
      {"x,e\n1kg,1e6\n", {"line 2", "1kg"}},
      {"x,T\n1,300\n", {"line 1", "x,T", "x,e"}},
      {"1,1e6\n", {"line 1", "1,1e6"}},
      {"x,e,id\n1,1e6,a\n", {"line 1", "x,e,id"}},
      {"", {"line 1", "empty"}},
  };
  for (const auto& c : cases) expect_refused("points --eos mixed", c.input, c.words);
}

TEST_F(EosExplorer, UnknownNamesAreRefusedWithTheKnownOnes) {
  const std::string in = "x,e\n1,1e6\n";
  expect_refused("points --eos foo", in,
                 {"'foo'", "paper", "mixed", "helm", "reference", "mie-gruneisen", "tillotson", "ideal-gas", "stiffened-gas", "jwl"});
  expect_refused("points --eos tillotson --cold foo", in, {"'foo'", "cai-ye"});
  expect_refused("points --eos mixed --cold foo", in, {"'foo'", "cai-ye", "cai-ye-sharp", "zhou04", "rose", "vinet", "bm3", "setfl:FILE"});
  expect_refused("points --eos mixed --cold setfl:none.setfl", in, {"none.setfl"});
  expect_refused("points --eos tillotson --set E1=1MJ/kg", in, {"E1", "tillotson", "E0"});
  expect_refused("points --eos tillotson --set E0=5", in, {"E0", "5", "no unit", "MJ/kg"});
  expect_refused("points --eos tillotson --set E0=5GPa", in, {"E0", "GPa"});
  expect_refused("points --eos tillotson --set A=75.2", in, {"A", "75.2", "no unit", "GPa"});
  expect_refused("points --eos tillotson --set A=nan", in, {"A", "nan"});
  expect_refused("points --eos tillotson --set A", in, {"'A'", "name=value"});
  expect_refused("points --eos tillotson --set rho0=-1kg/m3", in, {"rho0", "-1", "> 0"});
  expect_refused("points --eos jwl", in, {"jwl", "rho0", "missing"});
  expect_refused("points --eos jwl --set rho0=1630kg/m3 --set A=371.2GPa", in, {"jwl", "B", "missing"});
  expect_refused("points --in none.csv", "", {"none.csv"});
  expect_refused("points --foo 3", in, {"--foo"});
  expect_refused("dots", in, {"dots"});
  expect_refused("", in, {"command"});
}

TEST_F(EosExplorer, EveryCommandRefusesBadNumbers) {
  expect_refused("cold --x 0.5,0", "", {"--x", "0", "> 0"});
  expect_refused("cold --x 0.5,,1", "", {"--x", "missing"});
  expect_refused("cold --x nan", "", {"--x", "nan"});
  expect_refused("cold", "x\n1\nfoo\n", {"line 3", "foo"});
  expect_refused("cold", "y\n1\n", {"line 1", "'x'"});
  expect_refused("hugoniot --up 1000,-1", "", {"--up", "-1", "> 0"});
  expect_refused("hugoniot --up 1000,foo", "", {"--up", "foo"});
  expect_refused("hugoniot --up 1000 --initial warm", "", {"--initial", "warm", "ambient"});
  expect_refused("hugoniot --up 1000 --density 0", "", {"--density", "> 0"});
  expect_refused("hugoniot --up 1000 --eos ideal-gas --initial ambient", "", {"p = 0"});
  expect_refused("hugoniot --eos ideal-gas --set gamma=1.05 --up 1000", "", {"1000", "no such shock"}); // rho/rho0 would be 41
  expect_refused("isentrope --from 2700,0", "", {"--to"});
  expect_refused("isentrope --to 2700", "", {"--from"});
  expect_refused("isentrope --from 2700 --to 2600", "", {"--from", "RHO,E"});
  expect_refused("isentrope --from 2700,0 --to -1", "", {"--to", "> 0"});
  expect_refused("isentrope --from 2700,0 --to 2600 --rows 1", "", {"--rows"});
  expect_refused("release", "", {"--up"});
  expect_refused("release --up 0", "", {"--up", "> 0"});
  expect_refused("match --eos mixed --velocity 1000", "", {"--eos2"});
  expect_refused("match --eos mixed --eos2 mixed", "", {"--velocity"});
  expect_refused("match --eos mixed --eos2 mixed --velocity -1", "", {"--velocity", "> 0"});
  expect_refused("melt --eos tillotson", "", {"tillotson", "melting"});
  expect_refused("riemann --left 1,0 --right 1,0,1 --time 1 --x 0", "", {"--left", "RHO,U,P"});
  expect_refused("riemann --left 1,0,1 --right 1,0,1 --time 0 --x 0", "", {"--time", "> 0"});
  expect_refused("riemann --eos ideal-gas --left -1,0,1 --right 1,0,1 --time 1 --x 0", "", {"--left", "-1"});
}

TEST_F(EosExplorer, NothingIsHalfWritten) {
  std::ofstream(folder / "table.csv") << "what was here";
  std::ofstream(folder / "bad.csv") << "x,e\n1,1e6\n2,foo\n";
  expect_refused("points --eos mixed --in bad.csv --out table.csv", "", {"line 3", "foo"});
  EXPECT_EQ(read(folder / "table.csv"), "what was here");
  expect_refused("cold --x 0.5,1 --out table.csv --plot picture.pdf", "", {"picture.pdf", ".png", ".svg"});
  EXPECT_EQ(read(folder / "table.csv"), "what was here");
  EXPECT_FALSE(fs::exists(folder / "picture.pdf"));
  EXPECT_EQ(run("cold --x 1 --out /proc/none/table.csv").code, 1);
}

TEST_F(EosExplorer, FilesAreReadAndWritten) {
  std::ofstream(folder / "in.csv") << "x,e\n1,1e6\n";
  const auto a = good("points --eos mixed --in in.csv --out sub/out.csv");
  EXPECT_EQ(a.out, "");
  EXPECT_EQ(read(folder / "sub/out.csv"), good("points --eos mixed", "x,e\n1,1e6\n").out);
  std::ofstream(folder / "x.csv") << "x\n0.5\n1\n";
  EXPECT_EQ(good("cold --in x.csv").out, good("cold --x 0.5,1").out);
  EXPECT_EQ(good("hugoniot", "up\n1000\n").out, good("hugoniot --up 1000").out);
  EXPECT_EQ(good("hugoniot --up 1km/s").out, good("hugoniot --up 1000").out);
}

// ---- cold curves ----------------------------------------------------------------------------------------------------------------------

template <class Cold> void expect_cold(const answer& a, const Cold& cold) {
  EXPECT_EQ(a.header(), "x,energy_J_kg,pressure_Pa,dp_dx_Pa");
  ASSERT_EQ(a.rows().size(), 3u);
  const double xs[] = {0.5, 1, 1.6};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = cold.evaluate(xs[i]);
    const row r = a.rows()[i];
    EXPECT_EQ(number(r[0]), xs[i]);
    expect_same(r[1], c.energy, 1e5);
    expect_same(r[2], c.pressure, 1e9);
    expect_same(r[3], c.slope, 1e9);
  }
}

TEST_F(EosExplorer, ColdCurvesAreTheLibrarys) {
  const std::string x = " --x 0.5,1,1.6";
  expect_cold(good("cold --cold cai-ye" + x), cold::cai_ye{});
  expect_cold(good("cold --cold cai-ye-sharp" + x), cold::cai_ye{cold::cutoff::sharp});
  expect_cold(good("cold --cold zhou04" + x), cold::lattice(potential::zhou04{}));
  expect_cold(good("cold --cold rose" + x), cold::rose{});
  expect_cold(good("cold --cold vinet" + x), cold::vinet{});
  expect_cold(good("cold --cold bm3" + x), cold::birch_murnaghan{});
  potential::write_setfl(potential::zhou04{}, 2001, 0.05, 4001, 0.005, (folder / "zhou.setfl").string());
  expect_cold(good("cold --cold setfl:zhou.setfl" + x), cold::lattice(potential::setfl::read((folder / "zhou.setfl").string())));
}

TEST_F(EosExplorer, ColdCurvesHaveTheTabulatedFigures) { // docs/eos.md: p_c in GPa at x = 0.5
  const struct {
    const char* name;
    double p;
  } table[] = {{"cai-ye-sharp", 256.7}, {"cai-ye", 256.51}, {"zhou04", 191.6}, {"rose", 205.5}, {"vinet", 245.1}, {"bm3", 290.6}};
  for (const auto& [name, p] : table)
    EXPECT_NEAR(number(good(std::string("cold --x 0.5 --cold ") + name).rows()[0][2]) / 1e9, p, 0.051) << name;
}

TEST_F(EosExplorer, ParametersAreSetWithUnits) {
  const auto stiff = good("cold --cold vinet --set bulk_modulus=100GPa --set density=2.7g/cc --x 1").rows()[0];
  expect_same(stiff[3], -100e9);
  const auto t = eos::query(eos::tillotson({.A = 80e9, .E0 = 6e6}), 2900, 1e6);
  expect_same(good("points --eos tillotson --set A=80GPa --set E0=6MJ/kg", "rho,e\n2900,1e6\n").rows()[0][4], t.pressure);
  phase::grover_parameters q;
  q.Tm0 = 1300;
  expect_same(good("points --eos mixed --set Tm0=1300K", "rho,e\n2700,1.35e6\n").rows()[0][3],
              eos::query(eos::grover{cold::cai_ye{}, phase::mixed{q}}, 2700, 1.35e6).temperature);
}

TEST_F(EosExplorer, TableIsNearTheExactModelAndOnlyOnRequest) {
  const double exact = number(good("cold --x 0.7123").rows()[0][2]), table = number(good("cold --x 0.7123 --table").rows()[0][2]);
  EXPECT_NE(exact, table);
  EXPECT_NEAR(table, exact, 1e-6 * exact);
  EXPECT_NEAR(exact, cold::cai_ye{}.evaluate(0.7123).pressure, 1e-12 * exact);
  for (const std::string name : {"mixed", "mie-gruneisen", "tillotson"}) { // the measured error is told
    const auto fast = good("points --table --eos " + name, "x,e\n0.81,1.7e6\n"), slow = good("points --eos " + name, "x,e\n0.81,1.7e6\n");
    const double p = number(slow.rows()[0][4]);
    EXPECT_NE(fast.rows()[0][4], slow.rows()[0][4]);
    EXPECT_NEAR(number(fast.rows()[0][4]), p, 1e-5 * p);
    EXPECT_EQ(fast.rows()[0][2], slow.rows()[0][2]);
    EXPECT_NE(fast.err.find("measured error of pressure"), std::string::npos) << fast.err;
    EXPECT_EQ(slow.err, "");
  }
}

TEST_F(EosExplorer, ColdCurveOfTwoColumns) {
  std::ofstream file(folder / "mine.csv");
  file << "x,pressure_GPa\n";
  const cold::vinet exact;
  for (int i = 0; i <= 60; ++i) file << to_text(0.6 + 0.01 * i) << "," << to_text(exact.evaluate(0.6 + 0.01 * i).pressure / 1e9) << "\n";
  file.close();
  const row r = good("cold --cold table:mine.csv --set density=2697.8kg/m3 --x 0.755").rows()[0];
  EXPECT_NEAR(number(r[2]), exact.evaluate(0.755).pressure, 1e-4 * exact.evaluate(0.755).pressure);
  EXPECT_NEAR(number(r[1]), exact.evaluate(0.755).energy, 1e-4 * exact.evaluate(0.755).energy);
  expect_refused("cold --cold table:mine.csv --x 1", "", {"mine.csv", "density"});
  std::ofstream(folder / "bad.csv") << "x,pressure_GPa\n0.9,10\n1,foo\n1.1,-6\n1.2,-9\n";
  expect_refused("cold --cold table:bad.csv --set density=2697.8kg/m3 --x 1", "", {"bad.csv", "3"});
  std::ofstream(folder / "bad.csv") << "x,pump\n0.9,10\n";
  expect_refused("cold --cold table:bad.csv --x 1", "", {"bad.csv", "line 1", "pressure_GPa"});
}

// ---- curves ---------------------------------------------------------------------------------------------------------------------------

void expect_shock(const row& r, const analysis::shock_state& s, const std::string& region, double relative = 1e-10) {
  const double expected[] = {s.particle_speed, s.shock_speed, s.density, s.pressure, s.energy};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(number(r[k]), expected[k], relative * expected[k]);
  if (std::isnan(s.temperature)) EXPECT_EQ(r[5], "");
  else EXPECT_NEAR(number(r[5]), s.temperature, 10 * relative * s.temperature);
  EXPECT_EQ(r[6], region);
}

TEST_F(EosExplorer, HugoniotIsTheLibrarys) {
  const auto a = good("hugoniot --eos mixed --up 1000,3320,6000");
  EXPECT_EQ(a.header(), "up,us,rho,pressure_Pa,energy_J_kg,temperature_K,region");
  const auto mixed = grover_of<phase::mixed>();
  const auto cold = eos::cold_state(mixed), ambient = eos::ambient_state(mixed);
  ASSERT_EQ(a.rows().size(), 3u);
  expect_shock(a.rows()[0], analysis::hugoniot(mixed, cold, 1000), "solid");
  expect_shock(a.rows()[1], analysis::hugoniot(mixed, cold, 3320), "solid");
  expect_shock(a.rows()[2], analysis::hugoniot(mixed, cold, 6000), "liquid");
  expect_shock(good("hugoniot --eos mixed --initial ambient --up 4300").rows()[0], analysis::hugoniot(mixed, ambient, 4300), "mixed");
  const auto scaled = eos::scaled_to(mixed, 2785);
  expect_shock(good("hugoniot --eos mixed --initial ambient --density 2785 --up 2000").rows()[0],
               analysis::hugoniot(scaled, eos::ambient_state(scaled), 2000), "solid");
  const eos::reference best;
  const auto liquid = analysis::hugoniot(best, eos::ambient_state(best), 5500);
  expect_shock(good("hugoniot --eos reference --initial ambient --up 5500").rows()[0], liquid,
               eos::region_name(best, liquid.density, liquid.energy), 1e-8);
  const eos::tillotson t;
  expect_shock(good("hugoniot --eos tillotson --up 2000").rows()[0], analysis::hugoniot(t, 2700, 0, 0, 2000), "compressed");
  const eos::mie_grueneisen m; // us = c0 + s up by construction
  const row r = good("hugoniot --eos mie-gruneisen --up 3000").rows()[0];
  EXPECT_NEAR(number(r[1]), 5328 + 1.338 * 3000, 1e-6);
  EXPECT_EQ(r[5], "");
  EXPECT_EQ(r[6], "single");
}

TEST_F(EosExplorer, ShockOutsideTheBoxIsTold) {
  const auto a = good("hugoniot --eos mie-gruneisen --up 1000,90000");
  EXPECT_EQ(a.rows().size(), 2u);
  EXPECT_NE(a.err.find("up = 90000 m/s"), std::string::npos) << a.err;
  EXPECT_NE(a.err.find("outside_validity"), std::string::npos) << a.err;
  EXPECT_EQ(a.err.find("up = 1000 m/s"), std::string::npos) << a.err;
}

TEST_F(EosExplorer, StrongShockOfAGasIsExact) { // from e = 0: us = (gamma + 1)/2 up, rho = 6 rho0
  const row r = good("hugoniot --eos ideal-gas --up 1000").rows()[0];
  EXPECT_NEAR(number(r[1]), 1200, 1e-6);
  EXPECT_NEAR(number(r[2]), 7.2, 1e-8);
  EXPECT_NEAR(number(r[3]), 1.44e6, 1e-2);
}

void expect_path(const answer& a, const analysis::isentrope_curve& path) {
  EXPECT_EQ(a.header(), "rho,energy_J_kg,pressure_Pa,temperature_K,particle_velocity_m_s,region");
  const auto rows = a.rows();
  ASSERT_EQ(rows.size(), path.states.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& s = path.states[i];
    EXPECT_NEAR(number(rows[i][0]), s.density, 1e-9 * s.density);
    EXPECT_NEAR(number(rows[i][1]), s.energy, 1e-8 * s.energy);
    EXPECT_NEAR(number(rows[i][2]), s.pressure, 1e-8 * (std::abs(s.pressure) + 1e9));
    EXPECT_NEAR(number(rows[i][3]), s.temperature, 1e-8 * s.temperature);
    EXPECT_NEAR(number(rows[i][4]), s.particle_speed, 1e-8 * (std::abs(s.particle_speed) + 1e3));
  }
}

TEST_F(EosExplorer, IsentropesAreTheLibrarys) {
  const auto mixed = grover_of<phase::mixed>();
  expect_path(good("isentrope --eos mixed --from 3500,3e6 --to 2500 --rows 21"), analysis::isentrope(mixed, 3500, 3e6, 2500, 21));
  expect_path(good("isentrope --eos mixed --from 2700,3e5 --to 3500 --rows 5"), analysis::isentrope(mixed, 2700, 3e5, 3500, 5));
  const auto a = good("release --eos mixed --initial ambient --up 3320 --rows 11");
  const auto path = analysis::release(mixed, analysis::hugoniot(mixed, eos::ambient_state(mixed), 3320), 11);
  expect_path(a, path);
  EXPECT_EQ(number(a.rows().front()[4]), 3320);
  EXPECT_NEAR(number(a.rows().back()[2]), 0, 1);
  EXPECT_EQ(a.rows().back()[5], "liquid");
  EXPECT_EQ(good("release --up 2000").rows().size(), 101u);
}

TEST_F(EosExplorer, GasExpandsByItsPowerLaw) { // p = p0 (rho/rho0)^1.4
  const auto rows = good("isentrope --eos ideal-gas --from 2,3e5 --to 1 --rows 3").rows();
  const double p0 = 0.4 * 2 * 3e5;
  EXPECT_NEAR(number(rows[2][2]), p0 * std::pow(0.5, 1.4), 1e-8 * p0);
  EXPECT_NEAR(number(rows[0][2]), p0, 1e-8 * p0);
}

TEST_F(EosExplorer, MatchIsTheLibrarys) {
  const auto a = good("match --eos mie-gruneisen --eos2 tillotson --velocity 5000");
  EXPECT_EQ(a.header(), "interface_velocity_m_s,pressure_Pa");
  const eos::mie_grueneisen m;
  const eos::tillotson t;
  const auto met = analysis::impedance_match(m, eos::cold_state(m), t, eos::cold_state(t), 5000);
  EXPECT_NEAR(number(a.rows()[0][0]), met.velocity, 1e-8 * met.velocity);
  EXPECT_NEAR(number(a.rows()[0][1]), met.pressure, 1e-8 * met.pressure);
  const row same = good("match --eos mie-gruneisen --eos2 mie-gruneisen --velocity 6640").rows()[0];
  EXPECT_NEAR(number(same[0]), 3320, 1e-6);
  EXPECT_NEAR(number(same[1]), 2785 * (5328 + 1.338 * 3320) * 3320, 1e3);
}

TEST_F(EosExplorer, MeltingThresholdsAreTheLibrarys) {
  const auto a = good("melt --eos mixed --initial ambient");
  EXPECT_EQ(a.header(), "event,up,us,rho,pressure_Pa,energy_J_kg,temperature_K");
  const auto mixed = grover_of<phase::mixed>();
  const auto t = analysis::find_melt_thresholds(mixed, eos::ambient_state(mixed));
  const analysis::shock_state* expected[] = {&t.hugoniot_begin, &t.hugoniot_end, &t.release_begin, &t.release_end};
  const char* events[] = {"hugoniot_onset", "hugoniot_completion", "release_onset", "release_completion"};
  ASSERT_EQ(a.rows().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const row r = a.rows()[i];
    EXPECT_EQ(r[0], events[i]);
    EXPECT_NEAR(number(r[1]), expected[i]->particle_speed, 1e-6 * expected[i]->particle_speed);
    EXPECT_NEAR(number(r[4]), expected[i]->pressure, 1e-6 * expected[i]->pressure);
  }
}

TEST_F(EosExplorer, SodsShockTubeIsExact) { // Toro's table: p* = 0.30313, u* = 0.92745, densities 0.42632 and 0.26557
  const auto a = good("riemann --eos ideal-gas --left 1,0,1 --right 0.125,0,0.1 --time 0.2 --x -0.3,0.1,0.3,0.5");
  EXPECT_EQ(a.header(), "x,rho,velocity_m_s,pressure_Pa,energy_J_kg,temperature_K,region");
  const double rho[] = {1, 0.42632, 0.26557, 0.125}, u[] = {0, 0.92745, 0.92745, 0}, p[] = {1, 0.30313, 0.30313, 0.1};
  ASSERT_EQ(a.rows().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const row r = a.rows()[i];
    EXPECT_NEAR(number(r[1]), rho[i], 1e-5);
    EXPECT_NEAR(number(r[2]), u[i], 1e-5);
    EXPECT_NEAR(number(r[3]), p[i], 1e-5);
    EXPECT_NEAR(number(r[4]), p[i] / (0.4 * rho[i]), 1e-4);
    EXPECT_EQ(r[6], "single");
  }
}

TEST_F(EosExplorer, RiemannOfTwoMetals) {
  const eos::mie_grueneisen m;
  const auto solution = analysis::riemann(m, {2785, 1000, 0}, m, {2785, -1000, 0});
  const row r = good("riemann --eos mie-gruneisen --left 2785,1000,0 --right 2785,-1000,0 --time 1us --x 0").rows()[0];
  EXPECT_NEAR(number(r[3]), solution.star_pressure(), 1e-7 * solution.star_pressure());
  EXPECT_NEAR(number(r[3]), 2785 * (5328 + 1.338 * 1000) * 1000, 1e4);
}

// ---- list, pictures, --quick ----------------------------------------------------------------------------------------------------------

TEST_F(EosExplorer, ListHasEveryName) {
  const auto a = good("list");
  EXPECT_EQ(a.header(), "kind,name,reference_density_kg_m3,rho_min_kg_m3,rho_max_kg_m3,e_min_J_kg,e_max_J_kg,parameters,source");
  std::string names;
  for (const row& r : a.rows()) {
    EXPECT_EQ(r.size(), 9u);
    EXPECT_FALSE(r[8].empty()) << r[1];
    names += r[0] + ":" + r[1] + " ";
  }
  for (const char* name :
       {"eos:paper ", "eos:mixed ", "eos:helm ", "eos:reference ", "eos:mie-gruneisen ", "eos:tillotson ", "eos:ideal-gas ",
        "eos:stiffened-gas ", "eos:jwl ", "cold:cai-ye ", "cold:cai-ye-sharp ", "cold:zhou04 ", "cold:rose ", "cold:vinet ", "cold:bm3 ",
        "cold:setfl:FILE "})
    EXPECT_NE(names.find(name), std::string::npos) << name;
}

TEST_F(EosExplorer, EveryCurveIsDrawn) {
  const struct {
    const char *command, *word; // a word of the SVG's labels
  } cases[] = {{"cold --x 0.3,5 --compare rose,vinet", "cold energy (MJ/kg)"},
               {"hugoniot --eos mie-gruneisen --up 1000,5000 --compare tillotson", "5.35 km/s + 1.34 up"},
               {"isentrope --eos tillotson --from 3500,2e6 --to 2700", "pressure (GPa)"},
               {"release --eos tillotson --up 2000", "particle speed (km/s)"},
               {"match --eos mie-gruneisen --eos2 tillotson --velocity 3000", "velocity of the interface (km/s)"},
               {"melt --eos mixed --initial ambient", "solidus"},
               {"riemann --eos ideal-gas --left 1,0,1 --right 0.125,0,0.1 --time 0.2 --x -0.5,0.5", "density"}};
  for (const auto& [command, word] : cases) {
    const auto with = good(std::string(command) + " --plot a.svg"), again = good(std::string(command) + " --plot a.png");
    EXPECT_EQ(with.out, again.out);
    const std::string svg = read(folder / "a.svg"), png = read(folder / "a.png");
    EXPECT_EQ(svg.substr(0, 4), "<svg") << command;
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
    EXPECT_NE(svg.find(word), std::string::npos) << command;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << command;
    EXPECT_EQ(png.substr(1, 3), "PNG") << command;
    EXPECT_GT(png.size(), 10000u);
    fs::remove(folder / "a.svg");
    fs::remove(folder / "a.png");
  }
}

TEST_F(EosExplorer, QuickTourIsWell) {
  const auto a = good("--quick");
  EXPECT_NE(a.out.find("all is well"), std::string::npos) << a.out;
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(run("--version").code, 0);
  EXPECT_EQ(run("--help").code, 0);
}

#else
TEST(EosExplorer, ProgramIsThere) { GTEST_SKIP() << "the example is not built: one of its libraries is missing"; }
#endif
