// SPDX-License-Identifier: MIT
// The Cai-Ye lattice sum against the reference tables of docs/eos.md, and its table against the lattice sum.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/potential/shells.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "unit/eos/lanes.hpp"

#include <random>

namespace {
using namespace bolide;
using bolide::test::expect_close;

TEST(FccShells, FirstOnes) {
  const auto shells = potential::shells(lattice::fcc, 3);
  const double atoms[] = {12, 6, 24, 12, 24, 8, 48, 6, 36, 24, 24, 24, 72, 48};
  const double squared[] = {0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 6.5, 7.5};
  for (std::size_t i = 0; i < 14; ++i) {
    EXPECT_EQ(shells[i].atoms, atoms[i]) << i;
    EXPECT_NEAR(shells[i].distance * shells[i].distance, squared[i], 1e-14) << i;
  }
}

TEST(CaiYe, ScalePoint) {
  const cold::cai_ye none, sharp(cold::cutoff::sharp);
  EXPECT_NEAR(none.reference_density(), 2697.852, 5e-4);
  EXPECT_NEAR(none.energy_per_atom(1), -3.3188, 5e-5);
  EXPECT_NEAR(sharp.energy_per_atom(1), -3.31832585, 5e-9);
  EXPECT_NEAR(none.cohesive_energy(), 11.8676e6, 50);
  EXPECT_NEAR(sharp.cohesive_energy(), 11.866e6, 500);
  EXPECT_NEAR(none.evaluate(1.0).pressure, -20.6e6, 0.05e6);
  EXPECT_NEAR(sharp.evaluate(1.0).pressure, 4.498e6, 500);
  EXPECT_NEAR(-none.evaluate(1.0).slope, 76.61e9, 5e6);
  EXPECT_NEAR(-sharp.evaluate(1.0).slope, 76.77e9, 5e6);
  EXPECT_EQ(none.evaluate(1.0).energy, 0);
  // With f_e = 0.3833721 the 78 neighbours inside the sharp cut-off give the published electron density.
  EXPECT_NEAR(0.3833721 * sharp.density_at_one(), 4.7726129, 1e-6);
  double neighbours = 0;
  for (const auto& shell : potential::shells(lattice::fcc, 1.65)) neighbours += shell.atoms;
  EXPECT_EQ(neighbours, 78);
}

struct row { double x, p_sharp, e_sharp, p_none, e_none, p_digit_sharp, e_digit_sharp, p_digit_none, e_digit_none; };

TEST(CaiYe, ReferenceTable) {
  // x, p GPa and e MJ/kg with the sharp cut-off and without, and half a unit of the last printed digit of each
  const row rows[] = {
      {0.3, 1316.7, 58.91, 1316.3, 58.899, .05, .005, .05, .0005},
      {0.4, 548.9, 26.80, 548.74, 26.801, .05, .005, .005, .0005},
      {0.5, 256.7, 12.654, 256.51, 12.650, .05, .0005, .005, .0005},
      {0.6, 126.4, 5.853, 126.35, 5.8521, .05, .0005, .005, .00005},
      {0.7, 62.48, 2.493, 62.335, 2.4866, .005, .0005, .0005, .00005},
      {0.8, 28.79, 0.865, 28.722, 0.86281, .005, .0005, .0005, 5e-6},
      {0.9, 10.357, 0.1739, 10.310, 0.17256, .0005, .00005, .0005, 5e-6},
      {1.1, -5.837, 0.118, -5.8503, 0.11912, .0005, .0005, .00005, 5e-6},
      {1.3471, -11.227, 0.967, -11.247, 0.96657, .0005, .0005, .0005, 5e-6},
      {1.6, -11.668, 2.062, -11.691, 2.0612, .0005, .0005, .0005, .00005},
      {2, -9.965, 3.680, -9.9719, 3.6802, .0005, .0005, .00005, .00005},
      {3, -5.716, 6.523, -5.7273, 6.5213, .0005, .0005, .00005, .00005},
      {5, -2.205, 9.204, -2.2119, 9.2022, .0005, .0005, .00005, .00005}};
  const cold::cai_ye none, sharp(cold::cutoff::sharp);
  const double slack = 1.05; // a value that sits on the rounding border
  for (const row& r : rows) {
    const auto n = none.evaluate(r.x), s = sharp.evaluate(r.x);
    EXPECT_NEAR(n.pressure / 1e9, r.p_none, slack * r.p_digit_none) << r.x;
    EXPECT_NEAR(n.energy / 1e6, r.e_none, slack * r.e_digit_none) << r.x;
    EXPECT_NEAR(s.pressure / 1e9, r.p_sharp, slack * r.p_digit_sharp) << r.x;
    EXPECT_NEAR(s.energy / 1e6, r.e_sharp, slack * r.e_digit_sharp) << r.x;
  }
}

TEST(CaiYe, SharpCutoffJumpsWherePredicted) {
  const cold::cai_ye sharp(cold::cutoff::sharp), none;
  const double jumps[][2] = {
      {4.4921, 9}, {2.4452, 29}, {1.5882, 17}, {1.1364, 43}, {0.8645, 18}, {0.6860, 136}, {0.5615, 21}, {0.4706, 148},
      {0.4018, 115}};
  for (const auto& jump : jumps) {
    double best = 1e9, at = 0; // the shell whose crossing is nearest to the printed x
    for (const auto& shell : potential::shells(lattice::fcc, 3)) {
      const double x = std::pow(1.65 / shell.distance, 3);
      if (std::abs(x - jump[0]) < best) best = std::abs(x - jump[0]), at = x;
    }
    EXPECT_LT(best, 6e-5) << jump[0];
    const double above = at * (1 + 1e-9), below = at * (1 - 1e-9);
    EXPECT_NEAR((sharp.evaluate(above).pressure - sharp.evaluate(below).pressure) / 1e6, jump[1], 0.6) << at;
    EXPECT_LT(std::abs(none.evaluate(above).pressure - none.evaluate(below).pressure), 1e4) << at;
  }
}

TEST(CaiYe, DerivativesMatchFiniteDifferences) {
  for (const auto cut : {cold::cutoff::none, cold::cutoff::sharp}) {
    const cold::cai_ye exact(cut);
    for (double x = 0.25; x < 6; x *= 1.0731) {
      const double h = 1e-4 * x;
      const auto d = [&](auto get) {
        return (8 * (get(exact.evaluate(x + h)) - get(exact.evaluate(x - h)))
               - (get(exact.evaluate(x + 2 * h)) - get(exact.evaluate(x - 2 * h)))) / (12 * h);
      };
      bool crossed = false; // a shell inside the stencil
      for (const auto& shell : potential::shells(lattice::fcc, 3)) crossed = crossed || std::abs(std::pow(1.65 / shell.distance, 3) - x) < 3 * h;
      if (crossed) continue;
      const auto c = exact.evaluate(x);
      expect_close(-exact.reference_density() * d([](auto p) { return p.energy; }), c.pressure, 2e-9, 1e9,
          "p = -de/dV at x = " + std::to_string(x));
      expect_close(d([](auto p) { return p.pressure; }), c.slope, 2e-9, 1e9, "dp/dx at x = " + std::to_string(x));
    }
  }
}

TEST(CaiYe, GoesToFreeAtoms) {
  const cold::cai_ye exact;
  for (const double x : {50., 300., 339., 341., 1e4, 1e6, 1e9}) {
    const auto c = exact.evaluate(x);
    EXPECT_TRUE(std::isfinite(c.energy) && std::isfinite(c.pressure) && std::isfinite(c.slope)) << x;
    EXPECT_LE(c.energy, exact.cohesive_energy() * (1 + 1e-12)) << x;
  }
  expect_close(exact.evaluate(1e6).energy, exact.cohesive_energy(), 1e-12, 0, "cohesive energy");
}

TEST(CaiYe, BadParametersAreRefusedWithASentence) {
  cold::cai_ye_parameters q;
  q.mass = -1;
  try {
    cold::cai_ye bad(cold::cutoff::none, q);
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "cold::cai_ye mass = -1 u: must be > 0 (unit: u)");
  }
  EXPECT_THROW(cold::tabulated(cold::cai_ye{}, 0.5), bad_parameter);
  EXPECT_THROW(cold::tabulated(cold::cai_ye{}, 5, 3), bad_parameter);
}

// ---- the table --------------------------------------------------------------------------------------------------------------
TEST(Tabulated, ErrorIsAsMeasuredOnRandomPoints) {
  const cold::cai_ye exact;
  const cold::tabulated table(exact);
  EXPECT_LT(table.error().pressure, 1e-8);
  EXPECT_LT(table.error().energy, 1e-9);
  EXPECT_LT(table.error().slope, 1e-6);
  EXPECT_LT(table.max_relative_error(), 1e-6);
  std::mt19937 random(7);
  std::uniform_real_distribution<> pick(0.2, 5);
  double p = 0, e = 0, s = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = 1 / pick(random), GPa = 1e9;
    const auto a = table.evaluate(x), b = exact.evaluate(x);
    p = std::max(p, std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + GPa));
    e = std::max(e, std::abs(a.energy - b.energy) / (std::abs(b.energy) + GPa / exact.reference_density()));
    s = std::max(s, std::abs(a.slope - b.slope) / (std::abs(b.slope) + GPa));
  }
  EXPECT_LE(p, table.error().pressure);
  EXPECT_LE(e, table.error().energy);
  EXPECT_LE(s, table.error().slope);
  EXPECT_GT(p, 0.1 * table.error().pressure); // the stated error is no fantasy either
}

TEST(Tabulated, ErrorFallsWithTheFourthPowerOfTheStep) {
  const cold::cai_ye exact;
  const double coarse = cold::tabulated(exact, 5, 100).error().pressure, fine = cold::tabulated(exact, 5, 200).error().pressure;
  EXPECT_GT(coarse / fine, 10);
  EXPECT_LT(coarse / fine, 20);
}

TEST(Tabulated, SharpCutoffCannotBeTabulatedBetterThanItsJumps) {
  const cold::tabulated table{cold::cai_ye{cold::cutoff::sharp}, 5, 2000};
  EXPECT_GT(table.error().pressure, 1e-4);
  EXPECT_LT(table.error().pressure, 2e-2); // the jump at x = 1.1364 alone is 43 MPa of (7.4 + 1) GPa: 5e-3, and the bound doubles it
}

TEST(Tabulated, PressureIsMinusTheEnergySlope) {
  const cold::tabulated table{cold::cai_ye{}};
  for (int i = 1; i < 1600; i += 7) {
    const double eta = 0.005 * i + 0.0021; // nodes lie 0.005 apart: the stencil stays within one interval
    const double x = 1 / eta, h = 1e-5 * x;
    const double slope = (table.evaluate(x + h).energy - table.evaluate(x - h).energy) / (2 * h);
    expect_close(-table.reference_density() * slope, table.evaluate(x).pressure, 3e-6, 1e9, "x = " + std::to_string(x));
  }
}

TEST(Tabulated, ContinuesAnalyticallyOutside) {
  const cold::cai_ye exact;
  const cold::tabulated table{exact};
  EXPECT_DOUBLE_EQ(table.eta_max(), 5);
  const double edge = 1 / table.eta_max(), h = 1e-9;
  const auto in = table.evaluate(edge * (1 + h)), out = table.evaluate(edge * (1 - h));
  expect_close(out.pressure, in.pressure, 1e-7, 0, "p at the edge");
  expect_close(out.energy, in.energy, 1e-7, 0, "e at the edge");
  expect_close(out.slope, in.slope, 1e-5, 0, "slope at the edge");
  double last = in.pressure;
  for (const double x : {0.15, 0.1, 0.03, 1e-3, 1e-6}) {
    const auto c = table.evaluate(x);
    EXPECT_GT(c.pressure, last) << x;
    EXPECT_LT(c.slope, 0) << x;
    EXPECT_TRUE(std::isfinite(c.energy)) << x;
    last = c.pressure;
  }
  for (const double x : {1e2, 1e4, 1e9}) {
    const auto c = table.evaluate(x);
    expect_close(c.energy, exact.cohesive_energy(), 1e-3, 0, "e at large x");
    EXPECT_LT(std::abs(c.pressure), 1e6) << x;
  }
  EXPECT_TRUE(std::isnan(table.evaluate(std::nan("")).pressure)); // NaN in, NaN out, no memory touched outside
}

template <class V> struct TabulatedLanes : ::testing::Test {};
TYPED_TEST_SUITE(TabulatedLanes, bolide::test::every_lane);
TYPED_TEST(TabulatedLanes, GiveTheScalarAnswer) {
  using V = TypeParam;
  const cold::cai_ye exact;
  const cold::tabulated table{exact};
  for (double first = 0.19; first < 6; first += 0.0913) {
    const V x = bolide::test::ramp<V>(first, 0.0117);
    const auto many = table.evaluate(x);
    const auto direct = exact.evaluate(x);
    for (int i = 0; i < lane_width<V>; ++i) {
      const double xi = static_cast<double>(lane(x, i));
      const auto one = table.evaluate(xi);
      // A float density ratio is off by 6e-8, which p feels times K/(|p| + 1 GPa) < 80.
      expect_close(lane(many.pressure, i), one.pressure, test::epsilon<V>(100), 1e9, "p");
      expect_close(lane(many.energy, i), one.energy, test::epsilon<V>(100), 4e5, "e");
      expect_close(lane(many.slope, i), one.slope, test::epsilon<V>(2000), 1e9, "slope");
      expect_close(lane(direct.pressure, i), exact.evaluate(xi).pressure, test::epsilon<V>(2), 0, "exact p");
    }
  }
}
} // namespace
