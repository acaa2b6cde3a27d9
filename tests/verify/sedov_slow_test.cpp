// SPDX-License-Identifier: MIT
// Sedov's blast wave from a point (r-z), and from a plane and an axis on finer cells.
#include "verify/sedov_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(SedovSpherical, ApicUsf) { verify_sedov<3, bspline_apic_usf>({25, 50}, 2, {.note = thinned}); }
TEST(SedovSpherical, FlipUsf) { verify_sedov<3, bspline_flip_usf>({25, 50}, 2, {.note = thinned}); }
TEST(SedovCylindrical, ApicUsf) { verify_sedov<2, bspline_apic_usf>({100, 200}, 4, {.rho = 0.15, .u = 0.1, .p = 0.12, .note = thin_peak}); }
TEST(SedovPlanar, ApicUsf) { verify_sedov<1, bspline_apic_usf>({200, 400}, 64, {.rho = 0.05, .u = 0.03, .p = 0.05, .order = 1}); }
TEST(SedovPlanar, ApicMusl) { verify_sedov<1, bspline_apic_musl>({200, 400}, 64, {.rho = 0.05, .u = 0.03, .p = 0.05, .order = 1}); }

} // namespace
} // namespace bolide
