// SPDX-License-Identifier: MIT
// Sphere, cylinder and thin ring vibrate with their known periods, in every composition.
#include "verify/radial_modes.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class RadialModes : public testing::Test {};
TYPED_TEST_SUITE(RadialModes, every_method, method_names);

TYPED_TEST(RadialModes, HaveTheirPeriods) { check_radial_modes<TypeParam>(16); }

} // namespace
} // namespace bolide
