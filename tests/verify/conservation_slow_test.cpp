// SPDX-License-Identifier: MIT
// Conservation in every space, on both grids, with every shape, transfer and scheme at least once, in double and float.
#include "verify/conservation.hpp"

#include "bolide/scheme/usl.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/transfer/pic.hpp"
#include "bolide/transfer/xpic.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class C> class Conservation : public testing::Test {};
using linear_flip_usf_float = method<shape::linear, transfer::flip, scheme::usf, float>;
using bspline_apic_musl_float = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
using cubic_apic_musl = method<shape::cubic_bspline, transfer::apic, scheme::musl>;
using cubic_apic_usl_float = method<shape::cubic_bspline, transfer::apic, scheme::usl, float>;
using cubic_flip_usf = method<shape::cubic_bspline, transfer::flip, scheme::usf>;
using bspline_xpic_usf = method<shape::quadratic_bspline, transfer::xpic<5>, scheme::usf>;
using gimp_pic_musl = method<shape::gimp, transfer::pic, scheme::musl>;
using compositions =
    testing::Types<composed_of<linear_flip_musl, space::cartesian_3d>, composed_of<bspline_flip_usf, space::cartesian_3d>,
                   composed_of<bspline_apic_usf, space::cartesian_3d, grid::uniform>, composed_of<cubic_apic_musl, space::cartesian_3d>,
                   composed_of<linear_flip_usf_float, space::cartesian_3d, grid::uniform>, composed_of<bspline_apic_musl_float, space::cartesian_3d>,
                   composed_of<bspline_xpic_usf, space::cartesian_3d>, composed_of<gimp_pic_musl, space::cartesian_3d, grid::uniform>,
                   composed_of<bspline_apic_usf, space::plane_strain, grid::uniform>, composed_of<cubic_apic_musl, space::plane_strain>,
                   composed_of<cubic_flip_usf, space::plane_strain, grid::uniform>,
                   composed_of<cubic_apic_usl_float, space::plane_strain, grid::uniform>,
                   composed_of<bspline_apic_musl, space::axisymmetric, grid::uniform>, composed_of<cubic_apic_musl, space::axisymmetric>,
                   composed_of<bspline_apic_musl_float, space::axisymmetric>, composed_of<cubic_apic_musl, space::planar_1d, grid::uniform>>;
TYPED_TEST_SUITE(Conservation, compositions, composed_names);
TYPED_TEST(Conservation, OfGrazingBalls) { check_kept<TypeParam>(); }

} // namespace
} // namespace bolide
