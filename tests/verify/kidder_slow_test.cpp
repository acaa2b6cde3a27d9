// SPDX-License-Identifier: MIT
// Kidder's isentropic compression of a spherical shell, and of the cylindrical one with a shorter time step.
#include "verify/kidder_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(KidderSphere, ApicUsf) { verify_kidder<3, bspline_apic_usf>({50, 100, 200}, viscosity::none{}, {.rho = 0.05, .u = 0.02, .p = 0.06, .note = first_order}); }
TEST(KidderSphere, FlipMusl) { verify_kidder<3, bspline_flip_musl>({50, 100}, viscosity::none{}, {.rho = 0.1, .u = 0.02, .p = 0.15, .note = "six cells in the shell at the end"}); }
TEST(KidderCylinder, ShorterSteps) {
  verify_kidder<2, bspline_apic_usf>({100, 200, 400}, viscosity::none{}, {.rho = 0.02, .u = 0.005, .p = 0.03, .order = 1, .note = first_order}, 0.1);
}

} // namespace
} // namespace bolide
