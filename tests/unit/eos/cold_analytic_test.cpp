// SPDX-License-Identifier: MIT
// Rose, Vinet and Birch-Murnaghan: the reference table of docs/eos.md, the published formulas written out in long double, derivatives, lanes.
#include "bolide/eos/cold/birch_murnaghan.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/vinet.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>
#include <string>

namespace {
using namespace bolide;
using bolide::test::expect_close;
using real = long double;

TEST(AnalyticCold, ReferenceTable) {
  struct row { double x, rose, vinet, bm3, digit_rose, digit_vinet, digit_bm3; };
  const row rows[] = {
      {0.3, 829.6, 1100.4, 1796, .05, .05, .5},      {0.4, 397.4, 497.6, 666, .05, .05, .5},        {0.5, 205.5, 245.1, 290.6, .05, .05, .05},
      {0.6, 109.3, 125.0, 137.3, .05, .05, .05},     {0.7, 57.3, 63.1, 66.1, .05, .05, .05},        {0.8, 27.7, 29.5, 30.0, .05, .05, .05},
      {0.9, 10.37, 10.68, 10.72, .005, .005, .005},  {1.1, -6.20, -6.03, -6.05, .005, .005, .005},  {1.3471, -12.49, -11.42, -11.8, .005, .005, .05},
      {1.6, -13.32, -11.5, -12.6, .005, .05, .05},   {2, -11.51, -9.2, -11.2, .005, .05, .05},      {3, -6.35, -4.4, -7.2, .005, .05, .05},
      {5, -2.06, -1.1, -3.5, .005, .05, .05}};
  const cold::rose rose;
  const cold::vinet vinet;
  const cold::birch_murnaghan bm3;
  for (const row& r : rows) {
    EXPECT_NEAR(rose.evaluate(r.x).pressure / 1e9, r.rose, 1.05 * r.digit_rose) << r.x;
    EXPECT_NEAR(vinet.evaluate(r.x).pressure / 1e9, r.vinet, 1.05 * r.digit_vinet) << r.x;
    EXPECT_NEAR(bm3.evaluate(r.x).pressure / 1e9, r.bm3, 1.05 * r.digit_bm3) << r.x;
  }
  EXPECT_NEAR(rose.eta(), 4.695, .0005);
  EXPECT_NEAR(rose.cohesive_energy() / 1e6, 12.015, .0005);
  double best = 0, at = 0;
  for (double x = 1.3; x < 2; x += 1e-4)
    if (const double p = rose.evaluate(x).pressure / 1e9; p < best) best = p, at = x;
  EXPECT_NEAR(best, -13.4, .05);
  EXPECT_NEAR(at, 1.54, .005);
}

// The printed formulas for p_c, independently; e_c by Simpson's rule from x = 1, dp/dx by a sixth-order difference.
template <class Cold, class Pressure> void expect_formula(const Cold& cold, Pressure p, const std::string& what) {
  const double rho0 = cold.reference_density();
  for (const double x : {0.25, 0.5, 0.72, 0.99, 1.0, 1.01, 1.4, 2.5, 6.0}) {
    const int n = 4000;
    const real h = (real(x) - 1) / n, d = 1e-3L * x;
    real area = 0;
    for (int i = 0; i < n; ++i) area += h / 6 * (p(1 + i * h) + 4 * p(1 + (i + 0.5L) * h) + p(1 + (i + 1) * h));
    const real slope = (45 * (p(x + d) - p(x - d)) - 9 * (p(x + 2 * d) - p(x - 2 * d)) + (p(x + 3 * d) - p(x - 3 * d))) / (60 * d);
    const auto c = cold.evaluate(x);
    const std::string at = what + " at x = " + std::to_string(x);
    expect_close(c.pressure, double(p(real(x))), 1e-14, 1e9, "p, " + at);
    expect_close(c.energy, double(-area / rho0), 1e-11, 4e5, "e, " + at);
    expect_close(c.slope, double(slope), 1e-12, 1e9, "dp/dx, " + at);
  }
  EXPECT_EQ(cold.evaluate(1.0).energy, 0);
  EXPECT_EQ(cold.evaluate(1.0).pressure, 0);
}
TEST(AnalyticCold, PublishedFormulas) {
  const real B = 79.4e9L, rho0 = 2697.8L, derivative = 4.7L, E = 3.36L * 1.602176634e-19L / (26.982L * 1.66053906660e-27L);
  expect_formula(cold::rose{}, [&](real x) { // E = -E_c (1 + u) e^-u per atom, p = -dE/dV, V per atom
        const real eta = 3 * std::sqrt(B / (rho0 * E)), u = eta * (std::cbrt(x) - 1);
        return -rho0 * E * u * std::exp(-u) * eta / (3 * std::cbrt(x) * std::cbrt(x));
      }, "Rose");
  expect_formula(cold::vinet{}, [&](real x) {
        const real X = std::cbrt(x);
        return 3 * B * (1 - X) / (X * X) * std::exp(1.5L * (derivative - 1) * (1 - X));
      }, "Vinet");
  expect_formula(cold::birch_murnaghan{}, [&](real x) {
        const real third = 1.0L / 3, y7 = std::pow(x, -7 * third), y5 = std::pow(x, -5 * third), y2 = std::pow(x, -2 * third);
        return 1.5L * B * (y7 - y5) * (1 + 0.75L * (derivative - 4) * (y2 - 1));
      }, "Birch-Murnaghan");
}

TEST(AnalyticCold, BulkModulusAndItsDerivativeAreThoseAskedFor) {
  const auto check = [](const auto& cold, double B, double derivative) {
    const auto modulus = [&](double x) { return -x * cold.evaluate(x).slope; };
    EXPECT_NEAR(modulus(1) / B, 1, 1e-14);
    const double h = 1e-4, dB = (8 * (modulus(1 + h) - modulus(1 - h)) - (modulus(1 + 2 * h) - modulus(1 - 2 * h))) / (12 * h);
    EXPECT_NEAR(dB / cold.evaluate(1.0).slope, derivative, 1e-9);
  };
  check(cold::vinet{{.bulk_modulus = 5e10, .bulk_modulus_derivative = 5.5}}, 5e10, 5.5);
  check(cold::birch_murnaghan{{.bulk_modulus = 5e10, .bulk_modulus_derivative = 3.5}}, 5e10, 3.5);
  const cold::rose rose;
  check(rose, 79.4e9, 1 + 2 * rose.eta() / 3);
}

template <class V> struct AnalyticColdLanes : ::testing::Test {};
TYPED_TEST_SUITE(AnalyticColdLanes, bolide::test::every_lane);
TYPED_TEST(AnalyticColdLanes, GiveTheScalarAnswer) {
  using V = TypeParam;
  const auto check = [](const auto& cold, const std::string& what) {
    for (double first = 0.25; first < 6; first += 0.0913) {
      const V x = bolide::test::ramp<V>(first, 0.0117);
      const auto many = cold.evaluate(x);
      for (int i = 0; i < lane_width<V>; ++i) {
        const auto one = cold.evaluate(static_cast<double>(lane(x, i)));
        // The packs' cube root is good to 3e-7 in float, which p feels times 3 B/(|p| + 1 GPa) < 240.
        expect_close(lane(many.pressure, i), one.pressure, test::epsilon<V>(600), 1e9, what + " p");
        expect_close(lane(many.energy, i), one.energy, test::epsilon<V>(100), 4e5, what + " e");
        expect_close(lane(many.slope, i), one.slope, test::epsilon<V>(100), 1e10, what + " slope");
      }
    }
  };
  check(cold::rose{}, "Rose");
  check(cold::vinet{}, "Vinet");
  check(cold::birch_murnaghan{}, "Birch-Murnaghan");
}

TEST(AnalyticCold, BadParametersAreRefusedWithASentence) {
  try {
    cold::rose bad{{.bulk_modulus = -1}};
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "cold::rose bulk_modulus = -1 Pa: must be > 0 (unit: Pa)");
  }
  EXPECT_THROW(cold::rose({.density = 0}), bad_parameter);
  EXPECT_THROW(cold::rose({.cohesive_energy = std::nan("")}), bad_parameter);
  EXPECT_THROW(cold::vinet({.bulk_modulus_derivative = 1}), bad_parameter);
  EXPECT_THROW(cold::vinet({.bulk_modulus = 0}), bad_parameter);
  EXPECT_THROW(cold::birch_murnaghan({.bulk_modulus_derivative = -1}), bad_parameter);
  EXPECT_THROW(cold::birch_murnaghan({.density = -1}), bad_parameter);
}
} // namespace
