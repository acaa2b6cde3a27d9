// SPDX-License-Identifier: MIT
// A user's two columns as a cold curve: the curve that made them comes back, in every unit and both orders; p = -de/dV; monotone where
// the points are; what it does outside; and every refusal with its sentence.
#include "bolide/core/unit.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/cold/user_table.hpp"
#include "unit/eos/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace bolide;
using bolide::test::expect_close;
using cold::table_columns, cold::user_table, cold::value_column, cold::volume_column;

const cold::rose source;
const double rho0 = source.reference_density(), atom = 26.982 * unit::u;

struct columns {
  std::vector<double> volume, value;
};
/// n points of the source, x from 0.4 to 2.5 evenly in ln x, 1 among them only by chance.
columns sample(int n, auto volume, auto value) {
  columns c;
  for (int i = 0; i < n; ++i) {
    const double x = 0.4 * std::pow(2.5 / 0.4, double(i) / (n - 1));
    c.volume.push_back(volume(x));
    c.value.push_back(value(source.evaluate(x)));
  }
  return c;
}
const auto ratio = [](double x) { return x; };
const auto GPa = [](const cold_point<double>& p) { return p.pressure / 1e9; };

void expect_source(const user_table& t, double relative_p, double relative_e, const std::string& what) {
  expect_close(t.reference_density(), rho0, 1e-6, 0, what + " rho0");
  EXPECT_NEAR(t.evaluate(1.0).energy, 0, 1e-6) << what; // J/kg: round-off of tables of some 1e7 J/kg
  for (double x = 0.41; x < 2.5; x *= 1.013) {
    const auto a = t.evaluate(x), b = source.evaluate(x);
    expect_close(a.pressure, b.pressure, relative_p, 1e9, what + " p at " + std::to_string(x));
    expect_close(a.energy, b.energy, relative_e, 1e9 / rho0, what + " e at " + std::to_string(x));
  }
}

TEST(UserTable, ComesBackFromPressureInEveryUnit) {
  const double angstrom3 = unit::angstrom * unit::angstrom * unit::angstrom, g_cm3 = 1e3;
  const auto p = sample(80, ratio, GPa);
  expect_source({p.volume, p.value, {.value_unit = unit::GPa, .reference_density = rho0}}, 5e-5, 5e-6, "V/V0, GPa");
  const auto d = sample(80, [](double x) { return rho0 / x / 1e3; }, [](const auto& c) { return c.pressure / 1e11; });
  expect_source(
      {d.volume, d.value, {.volume = volume_column::density, .volume_unit = g_cm3, .value_unit = unit::Mbar, .reference_density = rho0}},
      5e-5, 5e-6, "g/cm3, Mbar");
  const auto v = sample(80, [](double x) { return x / rho0 * 1e6; }, GPa); // cm3/kg
  expect_source({v.volume, v.value, {.volume = volume_column::specific_volume, .volume_unit = 1e-6, .value_unit = unit::GPa}}, 5e-5, 5e-6,
                "cm3/kg, rho0 found");
  const auto a = sample(80, [](double x) { return x / rho0 * atom * 1e30; }, GPa);
  expect_source(
      {a.volume, a.value, {.volume = volume_column::atomic_volume, .volume_unit = angstrom3, .value_unit = unit::GPa, .atomic_mass = atom}},
      5e-5, 5e-6, "angstrom3, rho0 found");
}
TEST(UserTable, ComesBackFromEnergy) {
  const double angstrom3 = unit::angstrom * unit::angstrom * unit::angstrom;
  const auto e = sample(160, ratio, [](const auto& c) { return c.energy / 1e6 - 12.0; }); // from another zero
  expect_source({e.volume, e.value, {.value = value_column::specific_energy, .value_unit = unit::MJ, .reference_density = rho0}}, 5e-4,
                1e-5, "MJ/kg");
  const auto a = sample(160, [](double x) { return x / rho0 * atom * 1e30; }, [](const auto& c) { return c.energy * atom / unit::eV - 3.36; });
  const user_table t(a.volume, a.value,
                     {.volume = volume_column::atomic_volume,
                      .volume_unit = angstrom3,
                      .value = value_column::atomic_energy,
                      .value_unit = unit::eV,
                      .atomic_mass = atom});
  expect_close(t.reference_density(), rho0, 2e-5, 0, "rho0 found");
  for (double x = 0.42; x < 2.4; x *= 1.02) expect_close(t.evaluate(x).pressure, source.evaluate(x).pressure, 1e-3, 1e9, "p at " + std::to_string(x));
}
TEST(UserTable, ErrorFallsWithTheFourthPowerOfTheStep) {
  const auto worst = [](int n) {
    const auto p = sample(n, ratio, GPa);
    const user_table t(p.volume, p.value, {.value_unit = unit::GPa, .reference_density = rho0});
    double most = 0;
    for (double x = 0.5; x < 2; x *= 1.0007) most = std::max(most, std::abs(t.evaluate(x).pressure - source.evaluate(x).pressure));
    return most;
  };
  EXPECT_NEAR(worst(40) / worst(80), 16, 2);
  EXPECT_NEAR(worst(80) / worst(160), 16, 1);
}
TEST(UserTable, OrderDoesNotMatter) {
  auto p = sample(30, ratio, GPa);
  const table_columns c{.value_unit = unit::GPa, .reference_density = rho0};
  const user_table rising(p.volume, p.value, c);
  std::reverse(p.volume.begin(), p.volume.end());
  std::reverse(p.value.begin(), p.value.end());
  const user_table falling(p.volume, p.value, c);
  for (const double x : {0.3, 0.5, 1.0, 1.7, 3.0}) {
    EXPECT_EQ(rising.evaluate(x).pressure, falling.evaluate(x).pressure);
    EXPECT_EQ(rising.evaluate(x).energy, falling.evaluate(x).energy);
  }
}

/// p = -de/dV and slope = dp/dx inside and outside; p, e, slope continuous at every point of the table and at its ends.
void expect_consistent(const user_table& t, const std::vector<double>& x, const std::string& what) {
  for (double s = 0.5 * x.front(); s < 2 * x.back(); s *= 1.0113) {
    const double h = 2e-6 * s;
    bool knot = false;
    for (const double k : x) knot = knot || std::abs(k - s) < 3 * h;
    if (knot) continue;
    const auto a = t.evaluate(s - h), b = t.evaluate(s), c = t.evaluate(s + h);
    expect_close(-t.reference_density() * (c.energy - a.energy) / (2 * h), b.pressure, 1e-7, 1e9, what + " p = -de/dV at " + std::to_string(s));
    expect_close((c.pressure - a.pressure) / (2 * h), b.slope, 1e-7, 1e10, what + " dp/dx at " + std::to_string(s));
  }
  for (const double k : x) {
    const auto a = t.evaluate(k * (1 - 1e-12)), b = t.evaluate(k * (1 + 1e-12));
    expect_close(a.energy, b.energy, 1e-9, 4e5, what + " e continuous at " + std::to_string(k));
    expect_close(a.pressure, b.pressure, 1e-9, 1e9, what + " p continuous at " + std::to_string(k));
    expect_close(a.slope, b.slope, 1e-7, 1e10, what + " slope continuous at " + std::to_string(k));
  }
}
TEST(UserTable, IsConsistentInsideAndOutside) {
  const auto p = sample(25, ratio, GPa);
  expect_consistent({p.volume, p.value, {.value_unit = unit::GPa, .reference_density = rho0}}, p.volume, "pressure");
  const auto e = sample(25, ratio, [](const auto& c) { return c.energy; });
  expect_consistent({e.volume, e.value, {.value = value_column::specific_energy, .reference_density = rho0}}, e.volume, "energy");
  const std::vector<double> x{0.5, 0.7, 1, 1.2, 1.3}; // compression only: it ends under pressure
  const std::vector<double> GPas{300, 90, 25, 12, 10};
  expect_consistent({x, GPas, {.value_unit = unit::GPa, .reference_density = 3000}}, x, "all compressed");
}
TEST(UserTable, OutsideItSaysSoAndGoesOnSanely) {
  const auto p = sample(25, ratio, GPa);
  const user_table t(p.volume, p.value, {.value_unit = unit::GPa, .reference_density = rho0});
  EXPECT_NEAR(t.x_low(), 0.4, 1e-15);
  EXPECT_NEAR(t.x_high(), 2.5, 1e-14);
  EXPECT_FALSE(t.outside_validity(0.41) || t.outside_validity(2.49));
  EXPECT_TRUE(t.outside_validity(0.39) && t.outside_validity(2.51));
  double last = t.evaluate(0.4).pressure;
  for (double x = 0.39; x > 0.01; x *= 0.9) {
    const auto c = t.evaluate(x);
    EXPECT_GT(c.pressure, last) << x;
    EXPECT_LT(c.slope, 0) << x;
    last = c.pressure;
  }
  last = t.evaluate(2.5).pressure;
  for (double x = 2.6; x < 1e3; x *= 1.1) { // a pull that dies out
    const auto c = t.evaluate(x);
    EXPECT_TRUE(c.pressure >= last && c.pressure <= 0) << x;
    last = c.pressure;
  }
  EXPECT_TRUE(std::isfinite(t.evaluate(1e6).energy));
  EXPECT_TRUE(std::isnan(t.evaluate(std::nan("")).pressure));
}

TEST(UserTable, IsMonotoneWhereThePointsAre) {
  std::mt19937 random(5);
  std::uniform_real_distribution<> step(0.01, 0.2), jump(0, 1);
  for (int k = 0; k < 200; ++k) {
    std::vector<double> x{0.4}, p{500};
    while (x.back() < 1.5) { // steps of very different height
      x.push_back(x.back() + step(random));
      p.push_back(p.back() - std::pow(jump(random), 6) * 100 - 1e-3);
    }
    const user_table t(x, p, {.value_unit = unit::GPa, .reference_density = rho0});
    double last = t.evaluate(x.front()).pressure;
    for (double s = x.front(); s < x.back(); s += 0.001) {
      const double now = t.evaluate(s).pressure;
      ASSERT_LE(now, last + 1e-3) << k << " at " << s;
      last = now;
    }
    for (std::size_t i = 0; i < x.size(); ++i) expect_close(t.evaluate(x[i]).pressure, p[i] * 1e9, 1e-13, 0, "the points themselves");
  }
}

// Curves with bends at every point, the hardest thing for a table: its bound holds all the same.
TEST(UserTable, TableBoundHoldsOnRandomCurves) {
  std::mt19937 random(9);
  std::uniform_real_distribution<> step(0.02, 0.2), jump(0, 1);
  for (int k = 0; k < 40; ++k) {
    std::vector<double> x{0.3}, p{900};
    while (x.back() < 2) {
      x.push_back(x.back() + step(random));
      p.push_back(p.back() - std::pow(jump(random), 3) * 400 * (x.back() - x[x.size() - 2]) / (x.back() * x.back()) - 1e-3);
    }
    const user_table exact(x, p, {.value_unit = unit::GPa, .reference_density = rho0});
    const cold::tabulated table(exact, 3.3, 100);
    std::uniform_real_distribution<> pick(0.2, 3.3);
    for (int i = 0; i < 20000; ++i) {
      const double s = 1 / pick(random);
      const auto a = table.evaluate(s), b = exact.evaluate(s);
      ASSERT_LE(std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + 1e9), table.error().pressure) << k << " at " << s;
      ASSERT_LE(std::abs(a.energy - b.energy) / (std::abs(b.energy) + 1e9 / rho0), table.error().energy) << k << " at " << s;
      ASSERT_LE(std::abs(a.slope - b.slope) / (std::abs(b.slope) + 1e9), table.error().slope) << k << " at " << s;
    }
  }
}

TEST(UserTable, LanesGiveTheScalarAnswer) {
  const auto p = sample(25, ratio, GPa);
  const user_table t(p.volume, p.value, {.value_unit = unit::GPa, .reference_density = rho0});
  const auto x = test::ramp<pack<double, 4>>(0.35, 0.8);
  const auto many = t.evaluate(x);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(lane(many.pressure, i), t.evaluate(lane(x, i)).pressure);
}

// ---- text -----------------------------------------------------------------------------------------------------------------------------
const std::string good = "# my curve\nV/V0, p (GPa)\n0.8; 30\n 0.9,10.5 # comment\n\n1.0\t+0.0\r\n1.1 -6.1\n1.2,-9D0\n";
const table_columns text_columns{.value_unit = unit::GPa, .reference_density = rho0};

TEST(UserTable, ReadsText) {
  const auto t = user_table::from_text(good, text_columns);
  EXPECT_EQ(t.x_low(), 0.8);
  EXPECT_EQ(t.x_high(), 1.2);
  EXPECT_NEAR(t.evaluate(0.9).pressure, 10.5e9, 1);
  EXPECT_NEAR(t.evaluate(1.2).pressure, -9e9, 1);
  const std::string path = ::testing::TempDir() + "cold_user_table_test.csv";
  std::ofstream(path) << good;
  EXPECT_EQ(user_table::read(path, text_columns).evaluate(0.87).pressure, t.evaluate(0.87).pressure);
  std::remove(path.c_str());
}

void expect_refusal(const std::string& text, const table_columns& c, const std::string& sentence) {
  try {
    user_table::from_text(text, c, "my.csv");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const bad_parameter& e) {
    EXPECT_EQ(std::string(e.what()), sentence);
  }
}
TEST(UserTable, RefusesBadTextWithItsLine) {
  const auto& c = text_columns;
  expect_refusal("0.8 30\n0.9 ten\n", c, "my.csv line 2: expected two numbers, found '0.9 ten'");
  expect_refusal("0.8 30\n0.9\n", c, "my.csv line 2: expected two numbers, found '0.9'");
  expect_refusal("V p\n0.8 30\n0.9 10 7\n", c, "my.csv line 3: expected two columns, found a third, '7'");
  expect_refusal("0.8 30\n0.9 nan\n", c, "my.csv line 2: expected two numbers, found '0.9 nan'");
  expect_refusal("0.8 30\n0.9 inf\n", c, "my.csv line 2: expected two numbers, found '0.9 inf'");
  expect_refusal("0.8 30\n0.9 10\n1 0\n0.95 5\n1.1 -5\n", c, "my.csv line 4: the volumes are not sorted: they must rise or fall throughout");
  expect_refusal("0.8 30\n0.9 10\n0.9 9\n1 0\n1.1 -5\n", c, "my.csv line 3: the volume is that of the point before");
  expect_refusal("# a\n-0.8 30\n0.9 10\n1 9\n1.1 0\n1.2 -5\n", c, "my.csv line 2: expected a volume or density > 0");
  expect_refusal("0.8 30\n0.9 10\n1 0\n", c, "my.csv line 4: the table has 3 points, at least 4 are needed");
  expect_refusal("", c, "my.csv line 1: the table has 0 points, at least 4 are needed");
  expect_refusal("0.5 30\n0.6 20\n0.7 10\n0.8 5\n", c, "cold::user_table x = V/V0 = 1 = 1: must be among the points, which run from 0.5 to 0.8");
  expect_refusal(std::string("\0\1\2 \xff\n\0\n3", 9), c, "my.csv line 2: expected two numbers, found '?'");
}
TEST(UserTable, RefusesBadColumnsWithASentence) {
  expect_refusal(good, {}, "cold::user_table reference_density = 0 kg/m3: must be > 0 where the first column is V/V0 (unit: kg/m3)");
  expect_refusal(good, {.volume_unit = -1, .reference_density = 1}, "cold::user_table volume_unit = -1: must be > 0 and finite");
  expect_refusal(good, {.value_unit = 0, .reference_density = 1}, "cold::user_table value_unit = 0: must be > 0 and finite");
  expect_refusal(good, {.value = value_column::atomic_energy, .reference_density = 1},
                 "cold::user_table atomic_mass = 0 kg: must be > 0 where a column is per atom (unit: kg)");
  expect_refusal("1 5\n2 4\n3 3\n4 2\n", {.volume = volume_column::specific_volume},
                 "cold::user_table: nowhere among the points does the pressure fall through 0: state reference_density");
  EXPECT_THROW(user_table::read("/no/such/file.csv", text_columns), bad_parameter);
}
TEST(UserTable, RefusesBadVectorsWithTheirPoint) {
  const auto refused = [](std::vector<double> x, std::vector<double> p, const std::string& sentence) {
    try {
      user_table(x, p, {.reference_density = 1});
      ADD_FAILURE() << "accepted";
    } catch (const bad_parameter& e) {
      EXPECT_EQ(std::string(e.what()), sentence);
    }
  };
  refused({0.8, 0.9, 1, 1.1}, {3, 2, std::nan(""), 0}, "cold::user_table point 3: not a finite number");
  refused({0.8, 1, 0.9, 1.1}, {3, 2, 1, 0}, "cold::user_table point 3: the volumes are not sorted: they must rise or fall throughout");
  refused({0.8, 0.9, 1}, {3, 2, 1}, "cold::user_table point 4: the table has 3 points, at least 4 are needed");
  refused({0.8, 0.9, 1, 1.1}, {3, 2, 1}, "cold::user_table number of values = 3: must be that of the volumes, 4");
}
} // namespace
