// SPDX-License-Identifier: MIT
// Noh's implosion in plane strain, as a sphere in r-z and as an octant in 3-D.
#include "verify/noh_problem.hpp"

namespace bolide {
namespace {
using namespace verify;

const viscosity::bulk little{0.1, 0.1};

TEST(NohCylinder, PlaneStrain) { verify_noh<noh_geometry::cylinder_plane_strain, bspline_apic_musl>({50, 100}, little, true, {.rho = 0.1, .u = 0.05, .p = 0.2, .note = ripple}); }
TEST(NohSphere, AxisymmetricIsReported) { verify_noh<noh_geometry::sphere_rz, bspline_apic_musl>({50, 100}, little, false, {.note = few_cells}); }
/// The same sphere in r-z and in 3-D, on the same cells.
TEST(NohSphere, AxisymmetricAndOctantAgree) {
  const auto rz = run_noh<noh_geometry::sphere_rz, bspline_apic_musl>(24, 2, little), octant = run_noh<noh_geometry::sphere_3d, bspline_apic_musl>(24, 2, little);
  const auto one = [&](const char* what, double value, double bound, const char* unit = "") {
    record_and_check({.section = "shocks", .problem = name_of(noh_geometry::sphere_3d), .composition = composed<bspline_apic_musl>("cartesian_3d") + ", viscosity 0.1, 0.1",
                      .measure = what, .value = value, .bound = bound, .seconds = octant.errors.seconds, .unit = unit, .note = few_cells});
  };
  one("density in r 0.05-0.15, 24 cells", octant.plateau, none);
  one("shock radius less 0.2, 24 cells", octant.shock_off, 2, "cells");
  one("density in r 0.05-0.15 against r-z, 24 cells", (1 + octant.plateau) / (1 + rz.plateau) - 1, 0.1);
  one("shock radius less that of r-z, 24 cells", octant.shock_off - rz.shock_off, 0.5, "cells");
}

} // namespace
} // namespace bolide
