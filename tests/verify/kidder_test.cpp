// SPDX-License-Identifier: MIT
// Kidder's isentropic compression of a cylindrical shell; the sphere, finer cells and a shorter time step: kidder_slow_test.cpp.
#include "verify/kidder_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(KidderCylinder, ApicUsf) { verify_kidder<2, bspline_apic_usf>({50, 100, 200}, viscosity::none{}, {.rho = 0.03, .u = 0.01, .p = 0.05, .order = 1, .note = first_order}); }
TEST(KidderCylinder, FlipMusl) { verify_kidder<2, bspline_flip_musl>({50, 100, 200}, viscosity::none{}, {.rho = 0.03, .u = 0.01, .p = 0.06, .order = 1, .note = first_order}); }
TEST(KidderCylinder, ApicUsfWithViscosity) {
  verify_kidder<2, bspline_apic_usf>({50, 100, 200}, viscosity::bulk{}, {.rho = 0.04, .u = 0.01, .p = 0.07, .note = "an artificial viscosity heats what is compressed without a shock; its linear term is of first order"});
}

} // namespace
} // namespace bolide
