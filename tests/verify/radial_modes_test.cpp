// SPDX-License-Identifier: MIT
// Sphere, cylinder and thin ring vibrate with their known periods. All compositions: radial_modes_slow_test.cpp.
#include "verify/radial_modes.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(RadialModes, ReferenceFigures) {
  const double per_root = 2 * std::numbers::pi / radial.longitudinal_speed();
  EXPECT_NEAR(sphere_root(), 2.73627, 5e-6);
  EXPECT_NEAR(cylinder_root(), 2.16176, 5e-6);
  EXPECT_NEAR(4.765 * mm * per_root / sphere_root(), 1.76540 * us, 5e-12);
  EXPECT_NEAR(10 * mm * per_root / cylinder_root(), 4.68957 * us, 5e-12);
  // the same roots from the closed forms
  const double ratio = radial.longitudinal_speed() / (2 * radial.shear_speed()), x = sphere_root(), y = cylinder_root();
  EXPECT_NEAR(std::tan(x) / x * (1 - square(ratio * x)), 1, 1e-6);
  EXPECT_NEAR(y * bessel(0, y) / bessel(1, y), (1 - 2 * radial.nu) / (1 - radial.nu), 1e-6);
}

template <class Method> class RadialModes : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_apic_usf>;
TYPED_TEST_SUITE(RadialModes, methods, method_names);

TYPED_TEST(RadialModes, HaveTheirPeriods) { check_radial_modes<TypeParam>(8); }

} // namespace
} // namespace bolide
