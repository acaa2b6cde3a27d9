// SPDX-License-Identifier: MIT
// Manufactured solutions, every composition: the order reached. Linear shapes are reported only.
#include "verify/manufactured.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Manufactured : public testing::Test {};
TYPED_TEST_SUITE(Manufactured, every_method, method_names);

TYPED_TEST(Manufactured, Vortex) { check_vortex<TypeParam>(1.0 / 12, 0.02, 1.5); }
TYPED_TEST(Manufactured, AxisAligned) { check_axis_aligned<TypeParam>(1.0 / 6, 0.02, 1.7); }
TYPED_TEST(Manufactured, ExpandingRing) { check_expanding_ring<TypeParam>(1.0 / 20, 0.02, 1.7); }

/// The same ring in plane strain, with the rims of its lattice.
TEST(ManufacturedRing, InPlaneStrain) {
  check_expanding_ring_in_plane_strain<bspline_apic_musl>(1.0 / 20, 0.02, 1.5);
  check_expanding_ring_in_plane_strain<bspline_flip_musl>(1.0 / 20, 0.02, 1.5);
}

} // namespace
} // namespace bolide
