// SPDX-License-Identifier: MIT
// optimise: -O2
// Conservation in three dimensions, on the uniform grid and in float. More compositions: conservation_slow_test.cpp.
#include "verify/conservation.hpp"

namespace bolide {
namespace {
using namespace verify;

using float_apic = method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>;
template <class C> class Conservation : public testing::Test {};
using compositions = testing::Types<composed_of<bspline_apic_musl, space::cartesian_3d>,
                                    composed_of<bspline_flip_musl, space::plane_strain, grid::uniform>, composed_of<float_apic, space::plane_strain>>;
TYPED_TEST_SUITE(Conservation, compositions, composed_names);
TYPED_TEST(Conservation, OfGrazingBalls) { check_kept<TypeParam>(); }

} // namespace
} // namespace bolide
