// SPDX-License-Identifier: MIT
// Uniaxial strain, loaded, unloaded and loaded back, of every strength whose path has a closed form (logarithmic strain e, compression negative):
//   elastic             s_xx = 4/3 G e
//   perfectly plastic   the same between the walls |s_xx| = 2/3 Y
//   linear hardening    q = 3/2 |s_xx| grows by dq = 2 G H/(3 G + H) |de| at yield, eps by 2 G/(3 G + H) |de|
#include "bolide/failure/none.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/linear_hardening.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/material/material_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bolide {
namespace {

struct spring {
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(4e6) * (rho - T(1000)), V(T(4e6))};
  }
  double reference_density() const { return 1000; }
};
constexpr double g = 30e9, y = 0.3e9;

template <class Strength> auto point(Strength s) {
  using metal = material<spring, Strength, failure::none, viscosity::none>;
  return test::material_point<metal>(metal{spring{}, s, {}, {}}, 1000, 0);
}
/// follow(e) after each of n steps of strain.
template <class Point, class F> void strain(Point& m, double& e, double by, int n, F&& follow) {
  for (int i = 0; i < n; ++i) {
    m.advance({by / n * 1e9}, 1e-9, false);
    e += by / n;
    follow(e);
  }
}

TEST(UniaxialStrain, ElasticIsTheLineOfFourThirdsG) {
  auto m = point(strength::elastic{g});
  double e = 0;
  const auto check = [&](double at) { ASSERT_NEAR(m.get<field::deviator>(), 4.0 / 3 * g * at, 1e-11 * g); };
  strain(m, e, -0.05, 500, check);
  strain(m, e, 0.10, 1000, check);
  strain(m, e, -0.05, 500, check);
  EXPECT_NEAR(m.get<field::deviator>(), 0, 1e-6);
}

TEST(UniaxialStrain, PerfectPlasticityStaysBetweenItsWalls) {
  auto m = point(strength::elastic_perfectly_plastic{g, y});
  double e = 0, expected = 0, before = 0, plastic = 0;
  const auto check = [&](double at) { // the play of a spring between two walls
    const double trial = expected + 4.0 / 3 * g * (at - before);
    expected = std::clamp(trial, -2.0 / 3 * y, 2.0 / 3 * y);
    plastic += std::abs(trial - expected) / (2 * g);
    before = at;
    ASSERT_NEAR(m.get<field::deviator>(), expected, 1e-9 * y) << at;
    ASSERT_NEAR(m.get<field::plastic_strain>(), plastic, 1e-10) << at;
  };
  strain(m, e, -0.03, 300, check);
  EXPECT_NEAR(expected, -2.0 / 3 * y, 1e-12 * y);
  strain(m, e, 0.05, 500, check);
  EXPECT_NEAR(expected, 2.0 / 3 * y, 1e-12 * y);
  strain(m, e, -0.02, 200, check);
}

TEST(UniaxialStrain, LinearHardeningHasItsSlope) {
  for (const double h : {0.0, 1e9, 10e9, 60e9}) {
    for (const int n : {30, 3000}) { // exact for any step
      auto m = point(strength::linear_hardening{g, y, h});
      double e = 0, work = 0;
      const double to_yield = y / (2 * g); // |e| at first yield
      strain(m, e, -to_yield, 1, [](double) {});
      EXPECT_LT(m.get<field::plastic_strain>(), 1e-12);
      for (int i = 0; i < n; ++i) work += m.advance({-0.03 / n * 1e9}, 1e-9, false).plastic_work / m.get<field::volume>();
      const double eps = 2 * g * 0.03 / (3 * g + h);
      EXPECT_NEAR(m.get<field::plastic_strain>(), eps, 1e-10) << h << " " << n;
      EXPECT_NEAR(-1.5 * m.get<field::deviator>(), y + h * eps, 1e-9 * (y + h * eps)) << h << " " << n;
      EXPECT_NEAR(work, y * eps + h * eps * eps / 2, 1e-9 * work) << h << " " << n;
      // back: elastic over 2 (Y + H eps), then on with the same slope
      const double turn = (y + h * eps) / g;
      e = 0;
      strain(m, e, turn + 0.01, n, [](double) {});
      const double more = eps + 2 * g * 0.01 / (3 * g + h);
      EXPECT_NEAR(m.get<field::plastic_strain>(), more, 1e-9) << h << " " << n;
      EXPECT_NEAR(1.5 * m.get<field::deviator>(), y + h * more, 1e-8 * (y + h * more)) << h << " " << n;
    }
  }
}

} // namespace
} // namespace bolide
