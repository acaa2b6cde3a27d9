// SPDX-License-Identifier: MIT
// A point in simple shear up to gamma = 100. The Jaumann rate without a yield stress oscillates, as its exact solution does; with one it is steady.
//   elastic   s_rz = G sin(gamma), s_rr = -s_zz = G (1 - cos(gamma)); the explicit step turns the stress by a chord, so that the distance to the
//             centre (G, 0) of the circle grows by sqrt(1 + dgamma^2) per step: exp(gamma dgamma / 2)
//   plastic   steady: s_rr = Y^2/(3 G), s_rz = sqrt(Y^2/3 - s_rr^2)
#include "bolide/failure/none.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/linear_hardening.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/material/material_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {

/// Pressure of the density alone: in simple shear it stays 0.
struct spring {
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(4e6) * (rho - T(1000)), V(T(4e6))};
  }
  double reference_density() const { return 1000; }
};
constexpr double g = 30e9, y = 0.3e9;
using rz = space::axisymmetric;

template <class Strength> auto point(Strength s) {
  using metal = material<spring, Strength, failure::none, viscosity::none>;
  return test::material_point<metal, rz>(metal{spring{}, s, {}, {}}, 1000, 0);
}
template <class Point> void shear(Point& m, double from, double to, double step) {
  const long n = std::lround((to - from) / step);
  for (long i = 0; i < n; ++i) m.advance({0, 1e6, 0, 0, 0}, step / 1e6, false);
}

TEST(SimpleShear, WithoutAYieldStressTheJaumannRateOscillatesAsItsExactSolution) {
  for (const double step : {1e-3, 5e-4}) {
    auto m = point(strength::elastic{g});
    double worst = 0, at = 0;
    for (const double gamma : {0.5, 1.5, 3.1, 4.7, 6.3, 10.0, 30.0, 100.0}) {
      shear(m, at, gamma, step);
      at = gamma;
      const double grown = std::exp(gamma * step / 2); // of the distance from the centre (G, 0)
      const double rr = m.get<field::deviator>(0) / g, rz_ = m.get<field::deviator>(2) / g;
      EXPECT_NEAR(rz_, grown * std::sin(gamma), 1e-4 * grown) << gamma;
      EXPECT_NEAR(rr, 1 - grown * std::cos(gamma), 1e-4 * grown) << gamma;
      EXPECT_EQ(m.get<field::deviator>(1), -m.get<field::deviator>(0)) << gamma;
      worst = std::max(worst, std::hypot(rz_ - std::sin(gamma), rr - 1 + std::cos(gamma)));
    }
    std::printf("[ figures  ] elastic, gamma to 100 in steps of %g: largest error %.3g G, of which the chord's growth %.3g G\n", step, worst, std::exp(50 * step) - 1);
    EXPECT_LT(worst, 1.01 * (std::exp(50 * step) - 1) + 1e-4) << "nothing but the chord";
  }
}

TEST(SimpleShear, WithAYieldStressItIsSteady) {
  auto m = point(strength::elastic_perfectly_plastic{g, y});
  const double rr = y * y / (3 * g), rz_ = std::sqrt(y * y / 3 - rr * rr);
  double at = 0;
  for (const double gamma : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    shear(m, at, gamma, 1e-3);
    at = gamma;
    EXPECT_NEAR(m.get<field::deviator>(2), rz_, 1e-9 * rz_) << gamma; // the explicit step has the same fixed point
    EXPECT_NEAR(m.get<field::deviator>(0), rr, 1e-6 * rr) << gamma;
  }
  EXPECT_NEAR(m.get<field::plastic_strain>(), (100 - std::sqrt(1.0 / 3) * y / g) / std::sqrt(3.0), 1e-3 * 100);
}

TEST(SimpleShear, HardeningRisesWithoutOscillation) {
  auto m = point(strength::linear_hardening{g, y, 0.01e9}); // Y = 0.88 GPa at gamma = 100
  double at = 0, before = 0;
  for (double gamma = 1; gamma <= 100; gamma += 1) {
    shear(m, at, gamma, 1e-3);
    at = gamma;
    const double s = m.get<field::deviator>(2);
    EXPECT_GT(s, before) << gamma;
    before = s;
  }
  const double yield = y + 0.01e9 * m.get<field::plastic_strain>();
  const rz::deviator<double> s{m.get<field::deviator>(0), m.get<field::deviator>(1), m.get<field::deviator>(2)};
  EXPECT_NEAR(std::sqrt(1.5 * rz::contract(s, s)), yield, 1e-9 * yield);
  EXPECT_NEAR(m.get<field::plastic_strain>(), 100 / std::sqrt(3.0), 0.001 * 100);
}

} // namespace
} // namespace bolide
