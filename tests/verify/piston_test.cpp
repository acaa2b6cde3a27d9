// SPDX-License-Identifier: MIT
// The elastic-plastic piston in copper (20 m/s, a rod onto a mirror) and aluminium (100 m/s, two equal rods).
#include "verify/elastic_plastic.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Piston : public testing::Test {};
using methods = testing::Types<bspline_apic_usf, bspline_apic_musl, bspline_flip_usf>;
TYPED_TEST_SUITE(Piston, methods, method_names);

TYPED_TEST(Piston, Copper) { verify_piston<TypeParam>(copper_piston, driven_by::mirror, true); }
TYPED_TEST(Piston, Aluminium) { verify_piston<TypeParam>(aluminium_piston, driven_by::equal_rod, true); }

/// With linear shapes a particle that crosses a cell changes the stress by more than these waves carry.
TEST(PistonLinear, IsReported) {
  verify_piston<linear_flip_usf>(copper_piston, driven_by::mirror, false);
  verify_piston<linear_flip_usf>(aluminium_piston, driven_by::equal_rod, false);
}

} // namespace
} // namespace bolide
