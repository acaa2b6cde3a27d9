// SPDX-License-Identifier: MIT
// optimise: -O2
// Sedov's blast wave from a plane and from an axis; from a point, and on finer cells: sedov_slow_test.cpp.
#include "verify/sedov_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(SedovPlanar, ApicUsf) { verify_sedov<1, bspline_apic_usf>({50, 100, 200}, 64, {.rho = 0.1, .u = 0.05, .p = 0.08, .order = 1}); }
TEST(SedovPlanar, FlipUsf) { verify_sedov<1, bspline_flip_usf>({50, 100, 200}, 64, {.rho = 0.15, .u = 0.13, .p = 0.17, .note = thin_peak}); }
TEST(SedovCylindrical, ApicUsf) { verify_sedov<2, bspline_apic_usf>({50, 100}, 4, {.rho = 0.2, .u = 0.15, .p = 0.2, .note = thin_peak}); }

} // namespace
} // namespace bolide
