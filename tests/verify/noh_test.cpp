// SPDX-License-Identifier: MIT
// Noh's implosion against a plane and onto an axis; plane strain, spheres and 3-D: noh_slow_test.cpp.
#include "verify/noh_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

const viscosity::bulk usual, little{0.1, 0.1};

TEST(NohPlanar, ApicUsf) { verify_noh<noh_geometry::planar, bspline_apic_usf>({100, 200, 400}, usual, true, {.rho = 0.03, .u = 0.03, .p = 0.03, .note = ripple}); }
TEST(NohPlanar, ApicMusl) { verify_noh<noh_geometry::planar, bspline_apic_musl>({100, 200, 400}, little, true, {.rho = 0.03, .u = 0.03, .p = 0.05, .note = ripple}); }
TEST(NohPlanar, FlipUsfIsReported) {
  verify_noh<noh_geometry::planar, bspline_flip_usf>({100, 200, 400}, usual, false,
                                                     {.note = "the volumes of FLIP's particles sum to 7 % less than the space that they fill, on fine cells too; shock and energy are right"});
}
TEST(NohCylinder, ApicMusl) { verify_noh<noh_geometry::cylinder_rz, bspline_apic_musl>({50, 100, 200}, little, true, {.rho = 0.06, .u = 0.03, .p = 0.12, .note = ripple}); }

} // namespace
} // namespace bolide
