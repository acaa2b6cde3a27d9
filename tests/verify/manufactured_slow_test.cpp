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

/// The same ring in plane strain, where its free surfaces are stairs on the lattice: no convergence is seen (the slab of r-z, with its surfaces on grid
/// lines, has order 2). Reported.
TEST(ManufacturedRing, InPlaneStrainItsStairsAreReported) {
  const auto coarse = run<bspline_apic_musl>(expanding_ring{}, 1.0 / 40, 0.2), fine = run<bspline_apic_musl>(expanding_ring{}, 1.0 / 80, 0.1);
  verify::record({.section = "smooth",
                  .problem = "manufactured: expanding ring",
                  .composition = composition<bspline_apic_musl>("plane_strain"),
                  .measure = "RMS of the displacement over its largest, h = 1/80 m, dt ~ h^2",
                  .value = fine.rms,
                  .bound = 0.08,
                  .order = order(coarse.rms, fine.rms),
                  .seconds = fine.seconds,
                  .note = "no convergence: free surfaces are stairs on the lattice (cause not isolated); order 2 in r-z, where they lie on grid lines"});
  EXPECT_LT(fine.rms, 0.08);
}

} // namespace
} // namespace bolide
