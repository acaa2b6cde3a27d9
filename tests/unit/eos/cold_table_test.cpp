// SPDX-License-Identifier: MIT
// A table's stated error is a bound for every cold curve: many random points, none above it.
#include "bolide/eos/cold/birch_murnaghan.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/cold/user_table.hpp"
#include "bolide/eos/cold/vinet.hpp"
#include "bolide/potential/setfl.hpp"
#include "bolide/potential/zhou04.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace bolide;

/// The largest deviation over random eta in [low, high], as cold::table_error measures it.
template <class Exact> cold::table_error worst(const Exact& exact, const cold::tabulated& table, double low, double high, int points) {
  std::mt19937 random(42);
  std::uniform_real_distribution<> pick(low, high);
  const double GPa = 1e9;
  cold::table_error r;
  for (int i = 0; i < points; ++i) {
    const double x = 1 / pick(random);
    const auto a = table.evaluate(x), b = exact.evaluate(x);
    r.pressure = std::max(r.pressure, std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + GPa));
    r.energy = std::max(r.energy, std::abs(a.energy - b.energy) / (std::abs(b.energy) + GPa / exact.reference_density()));
    r.slope = std::max(r.slope, std::abs(a.slope - b.slope) / (std::abs(b.slope) + GPa));
  }
  return r;
}
void expect_bound(const cold::table_error& found, const cold::table_error& stated, const std::string& what) {
  EXPECT_LE(found.pressure, stated.pressure) << what;
  EXPECT_LE(found.energy, stated.energy) << what;
  EXPECT_LE(found.slope, stated.slope) << what;
  EXPECT_GE(found.pressure, 0.3 * stated.pressure - 2e-13) << what; // and no fantasy either
  EXPECT_GE(found.energy, 0.3 * stated.energy - 2e-13) << what;
  EXPECT_GE(found.slope, 0.2 * stated.slope - 2e-13) << what;
}
template <class Exact> void expect_honest(const Exact& exact, const std::string& what, int points, double eta_max = 5, int per_unit = 200) {
  const cold::tabulated table{exact, eta_max, per_unit};
  const auto inside = worst(exact, table, 0.2, eta_max, points), outside = worst(exact, table, 1e-4, 0.2, points);
  std::printf("%-16s eta <= %g, %5d a unit: p %.2e of %.2e, e %.2e of %.2e, slope %.2e of %.2e; x > 5: p %.2e of %.2e\n", what.c_str(),
              eta_max, per_unit, inside.pressure, table.error().pressure, inside.energy, table.error().energy, inside.slope,
              table.error().slope, outside.pressure, table.error_expanded().pressure);
  expect_bound(inside, table.error(), what);
  expect_bound(outside, table.error_expanded(), what + ", x > 5");
  EXPECT_LE(std::max({inside.pressure, inside.energy, outside.pressure, outside.energy}), table.max_relative_error()) << what;
}

const int many = 200000;

TEST(ColdTable, BoundHoldsOnRandomPointsOfSmoothCurves) {
  for (const int per_unit : {20, 200, 1000}) {
    expect_honest(cold::rose{}, "Rose", many, 5, per_unit);
    expect_honest(cold::vinet{}, "Vinet", many, 5, per_unit);
    expect_honest(cold::birch_murnaghan{}, "Birch-Murnaghan", many, 5, per_unit);
    expect_honest(cold::cai_ye{}, "Cai-Ye", many / 10, 5, per_unit);
  }
  expect_honest(cold::rose{}, "Rose", many, 1.7, 333);
}

TEST(ColdTable, BoundHoldsOnRandomPointsOfCurvesThatJumpOrKink) {
  for (const int per_unit : {50, 200, 1000}) {
    expect_honest(cold::cai_ye{cold::cutoff::sharp}, "Cai-Ye sharp", many, 5, per_unit);
    expect_honest(cold::lattice{potential::zhou04{}}, "Zhou 2004", many / 10, 5, per_unit);
  }
}

TEST(ColdTable, BoundHoldsOnRandomPointsOfTablesOfTables) {
  const std::string path = ::testing::TempDir() + "cold_table_test.setfl";
  potential::write_setfl(potential::zhou04{}, 4001, 0.05, 4001, 0.005, path);
  for (const int per_unit : {50, 200}) expect_honest(cold::lattice{potential::setfl::read(path)}, "setfl", many / 10, 5, per_unit);
  std::remove(path.c_str());

  const cold::rose rose;
  std::vector<double> x, p, e;
  for (int i = 0; i <= 60; ++i) {
    x.push_back(0.3 * std::pow(10, i / 60.0)); // 0.3 to 3
    p.push_back(rose.evaluate(x.back()).pressure / 1e9);
    e.push_back(rose.evaluate(x.back()).energy / 1e6);
  }
  const double rho0 = rose.reference_density();
  expect_honest(cold::user_table{x, p, {.value_unit = unit::GPa, .reference_density = rho0}}, "user's p", many, 3.3);
  expect_honest(cold::user_table{x, e, {.value = cold::value_column::specific_energy, .value_unit = unit::MJ, .reference_density = rho0}},
                "user's e", many, 3.3);
}

TEST(ColdTable, DocumentedErrorOfTheDefault) {
  const cold::tabulated table{cold::cai_ye{}};
  EXPECT_LT(table.error().pressure, 1e-8);
  EXPECT_LT(table.error().energy, 1e-9);
  EXPECT_LT(table.error().slope, 1e-6);
}
} // namespace
