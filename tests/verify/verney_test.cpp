// SPDX-License-Identifier: MIT
// Imploding beryllium shells stop where the exact balance says. More compositions and resolutions: verney_slow_test.cpp.
#include "verify/verney.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(Verney, ReferenceFigures) {
  const double radii[] = {50 * mm, 45 * mm, 40 * mm}, cylinder[] = {417.08, 454.65, 490.30};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(verney{2}.speed(radii[i]), cylinder[i], 0.01);
  const double radii_of_sphere[] = {50 * mm, 40 * mm, 30 * mm}, spherical[] = {545.1, 619.8, 675.0};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(verney{3}.speed(radii_of_sphere[i]), spherical[i], 0.05);
}

template <class Method> class Verney : public testing::Test {};
using methods = testing::Types<bspline_apic_usf>;
TYPED_TEST_SUITE(Verney, methods, method_names);

TYPED_TEST(Verney, CylinderStops) { check_verney<TypeParam>(2, 40, 2, 0.003); }
TYPED_TEST(Verney, SphereStops) { check_verney<TypeParam>(3, 40, 2, 0.005); }

} // namespace
} // namespace bolide
