// SPDX-License-Identifier: MIT
// Johnson and Cook's damage: the strain to failure against its formula, and paths of a material point against the integral of d(eps)/eps_f.
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/concepts/failure.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"
#include "unit/material/material_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bolide {
namespace {

template <class V> class JohnsonCookDamage : public testing::Test {};
TYPED_TEST_SUITE(JohnsonCookDamage, lane_types);

TYPED_TEST(JohnsonCookDamage, StrainToFailureIsItsFormula) {
  using V = TypeParam;
  using T = scalar_t<V>;
  EXPECT_TRUE((Failure<failure::johnson_cook_damage, V> && AccumulatingFailure<failure::johnson_cook_damage, V>));
  const auto x = [](double v) { return V(static_cast<T>(v)); };
  for (const auto& m : {failure::johnson_cook_damage{}, failure::johnson_cook_damage::armco_iron(), failure::johnson_cook_damage::steel_4340()})
    for (const double triaxiality : {-5.0, -1.0, -1.0 / 3, 0.0, 1.0 / 3, 1.0, 1.4})
      for (const double rate : {0.1, 1.0, 1e3, 1e6})
        for (const double t : {200.0, 293.0, 700.0, 1300.0, 2000.0}) {
          const long double shape = static_cast<long double>(m.d1) + static_cast<long double>(m.d2) * std::exp(std::min(static_cast<long double>(m.d3 * triaxiality), 40.0L));
          const long double star = std::clamp((t - 293.0L) / (1356 - 293.0L), 0.0L, 1.0L);
          const long double expected = std::max(shape * (1 + static_cast<long double>(m.d4) * std::log(std::max<long double>(rate, 1))) * (1 + static_cast<long double>(m.d5) * star),
                                                static_cast<long double>(m.least_strain));
          const V strain = m.strain_to_failure(x(rate), x(-triaxiality * 4e8), x(4e8), x(t), x(1356));
          test::expect_close(static_cast<double>(lane(strain, 0)), static_cast<double>(expected), test::epsilon<V>(200), static_cast<double>(expected), "eps_f");
        }
}

TYPED_TEST(JohnsonCookDamage, LimitsAreThoseOfTheModel) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const auto x = [](double v) { return V(static_cast<T>(v)); };
  const failure::johnson_cook_damage m;
  const auto at = [&](double p, double s) { return static_cast<double>(lane(m.strain_to_failure(x(1), x(p), x(s), x(293), x(1356)), 0)); };
  EXPECT_EQ(at(-1.5e9, 1e9), at(-9e9, 1e9)) << "sigma* ends at 1.5";
  EXPECT_GT(at(100e9, 1e8), 1e12) << "deep compression: no damage";
  EXPECT_TRUE(std::isfinite(at(100e9, 0)) && std::isfinite(at(-1e9, 0))) << "no stress: the limits answer";
  const auto iron = failure::johnson_cook_damage::armco_iron(); // -2.2 + 5.43 exp(-0.47 1.5) = 0.483
  EXPECT_GT(lane(iron.strain_to_failure(x(1), x(-1.5e9), x(1e9), x(293), x(1811)), 0), 0.4);
  failure::johnson_cook_damage brittle{-1, 0.5, -3, 0, 0};
  EXPECT_EQ(lane(brittle.strain_to_failure(x(1), x(-1e9), x(1e9), x(293), x(1356)), 0), T(1e-3)) << "eps_f,min where the bracket is negative";
  brittle.tension = 2e9;
  EXPECT_TRUE(all(brittle.fails(x(-2.1e9), x(0), x(0), x(0))));
  EXPECT_FALSE(any(brittle.fails(x(-1.9e9), x(0), x(0), x(0))));
}

TEST(JohnsonCookDamageParameters, AreCheckedWithASentence) {
  failure::johnson_cook_damage m;
  EXPECT_NO_THROW(m.validate());
  m.least_strain = 0;
  try {
    m.validate();
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "least strain to failure = 0: must be positive");
  }
  m = {};
  m.d3 = std::nan("");
  EXPECT_THROW(m.validate(), bad_parameter);
}

// ---- paths ------------------------------------------------------------------------------------------------------------------------------
/// p = K (rho/rho0 - 1) at one temperature: pressure and triaxiality follow the volume alone.
struct spring {
  double temperature = 600;
  template <class V> thermal_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    const V zero(T(0));
    return {T(1e11) * (rho * T(1e-4) - T(1)), V(T(1e7)), V(T(temperature)), V(T(1356)), zero, zero, zero, zero, zero};
  }
  double reference_density() const { return 1e4; }
};
using rz = space::axisymmetric;
constexpr double g = 50e9, y = 0.4e9;
template <class Law> auto point(const Law& law, double density) {
  using metal = material<spring, strength::elastic_perfectly_plastic, Law, viscosity::none>;
  return test::material_point<metal, rz>(metal{spring{}, {g, y}, law, {}}, density, 0);
}

/// Extension along z at `rate` with the same contraction across, so that one step changes the volume by exp(dilatation dt) exactly.
rz::gradient<double> extension(double rate, double dilatation, double dt) {
  const double across = -rate / 2 + dilatation / 3;
  return {across, 0, 0, (1 - std::exp(-dilatation * dt) / square(1 - dt * across)) / dt, across};
}

TEST(DamagePath, AtConstantTriaxialityFailsAtTheStrainToFailure) {
  const failure::johnson_cook_damage law;
  for (const double p : {0.04e9, 0.0, -0.2e9, -0.5e9}) {
    auto m = point(law, 1e4 * (1 + p / 1e11));
    const double rate = 1e4, dt = 1e-8; // equivalent strain rate 1e4 /s
    const auto l = extension(rate, 0, dt);
    const double expected = law.strain_to_failure(rate, p, y, 600.0, 1356.0);
    EXPECT_NEAR(expected, (0.54 + 4.89 * std::exp(3.03 * p / y)) * (1 + 0.014 * std::log(1e4)) * (1 + 1.12 * 307 / 1063), 1e-12);
    double plastic = 0;
    for (int i = 0; m.get<field::failed>() == 0 && i < 200000; ++i) {
      plastic = m.get<field::plastic_strain>();
      ASSERT_NEAR(m.get<field::damage>(), std::min(plastic / expected, 1.0), 1e-5);
      m.advance(l, dt, false);
    }
    EXPECT_GT(m.get<field::failed>(), 0) << p;
    EXPECT_NEAR(plastic, expected, 2 * rate * dt) << p; // two steps: D is known after one, the point fails in the next
    for (int c = 0; c < 3; ++c) EXPECT_EQ(m.get<field::deviator>(c), 0);
  }
}

TEST(DamagePath, AlongARisingTriaxialityIsTheIntegral) {
  // extension and dilatation together, p = -k eps: D = int d(eps)/(a + b e^(c eps)) = [eps - ln((a + b e^(c eps))/(a + b))/c] / a
  failure::johnson_cook_damage law;
  law.d4 = law.d5 = 0;
  for (const double dt : {4e-8, 1e-8}) {
    auto m = point(law, 1e4);
    const double rate = 1e4, opening = 1e2; // 1/s
    const auto l = extension(rate, opening, dt);
    const double to_yield = y / (3 * g); // of strain
    while (m.get<field::plastic_strain>() < 0.5) m.advance(l, dt, false);
    const double eps = m.get<field::plastic_strain>();
    // sigma* = 1e11 (1 - exp(-opening t))/Y, with rate t = eps + to_yield; linear to 0.5 % of itself at the end
    const auto star = [&](double strain) { return 1e11 * -std::expm1(-opening * (strain + to_yield) / rate) / y; };
    double exact = 0;
    const int n = 4000; // Simpson's rule of the same integrand
    for (int i = 0; i <= n; ++i) exact += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) / (law.d1 + law.d2 * std::exp(law.d3 * std::min(star(eps * i / n), 1.5)));
    exact *= eps / n / 3;
    const double c = law.d3 * 1e11 * opening / rate / y, b = law.d2 * std::exp(c * to_yield);
    const double closed = (eps - std::log((law.d1 + b * std::exp(c * eps)) / (law.d1 + b)) / c) / law.d1;
    EXPECT_NEAR(closed, exact, 0.005 * exact) << "the closed form, for sigma* linear in the strain";
    EXPECT_NEAR(m.get<field::damage>(), exact, 3 * rate * dt * exact) << dt; // first order in the step
    std::printf("[ figures  ] damage along a rising triaxiality, steps of %g: %.6f, integral %.6f\n", rate * dt, m.get<field::damage>(), exact);
  }
}

} // namespace
} // namespace bolide
