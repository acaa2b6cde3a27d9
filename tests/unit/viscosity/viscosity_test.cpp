// SPDX-License-Identifier: MIT
// Artificial bulk viscosity: its formula, its sign, and that it knows expansion from compression.
#include "bolide/viscosity/bulk.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>

namespace bolide {
namespace {

template <class V> class Viscosity : public testing::Test {};
TYPED_TEST_SUITE(Viscosity, lane_types);

TYPED_TEST(Viscosity, IsItsFormulaInCompression) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const viscosity::bulk model(1.5, 0.06);
  for (double d : {-1e3, -1e6, -3.3e7}) {
    const double rho = 2785, c = 5328, l = 1e-4;
    const double expected = rho * (1.5 * l * l * d * d + 0.06 * l * c * -d);
    test::expect_close(static_cast<double>(lane(model.pressure(V(T(rho)), V(T(c)), V(T(d)), T(l)), 0)), expected, test::epsilon<V>(20), 0, "q");
  }
}

TYPED_TEST(Viscosity, VanishesInExpansionAndAtRest) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const viscosity::bulk model;
  for (double d : {0.0, 1e3, 1e8}) {
    EXPECT_EQ(lane(model.pressure(V(T(2785)), V(T(5328)), V(T(d)), T(1e-4)), 0), 0);
    EXPECT_EQ(lane(model.signal_speed(V(T(5328)), V(T(d)), T(1e-4)), 0), 0);
  }
  EXPECT_EQ(lane(viscosity::none{}.pressure(V(T(2785)), V(T(5328)), V(T(-1e8)), T(1e-4)), 0), 0);
}

TYPED_TEST(Viscosity, SignalSpeedIsTheDerivativeOfTheViscousPressure) {
  // Q = q/(rho l |D|): what takes part in the time step
  using V = TypeParam;
  using T = scalar_t<V>;
  const viscosity::bulk model(1.5, 0.06);
  const double l = 1e-4, d = 2e7, rho = 2785, c = 6000;
  const double q = static_cast<double>(lane(model.pressure(V(T(rho)), V(T(c)), V(T(-d)), T(l)), 0));
  test::expect_close(static_cast<double>(lane(model.signal_speed(V(T(c)), V(T(-d)), T(l)), 0)), q / (rho * l * d), test::epsilon<V>(20), 0, "Q");
}

TEST(ViscosityParameters, AreCheckedWithASentence) {
  EXPECT_THROW(viscosity::bulk(-1, 0), bad_parameter);
  EXPECT_THROW(viscosity::bulk(0, 10), bad_parameter);
  EXPECT_THROW(viscosity::bulk(std::nan(""), 0), bad_parameter);
  try {
    viscosity::bulk(1.5, -0.1);
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "linear viscosity = -0.1: must be in [0, 10)");
  }
}

} // namespace
} // namespace bolide
