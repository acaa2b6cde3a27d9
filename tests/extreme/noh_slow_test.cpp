// SPDX-License-Identifier: MIT
// Extreme 1 and 2: Noh's sphere in r-z, where every error of the axis, the viscosity and the shock's width is largest; and, reported, what
// the default viscosity, fewer cells and FLIP make of it.
#include "extreme/noh.hpp"

namespace bolide {
namespace {
using namespace extreme;

TEST(NohSphere, IsWithinFivePercent) { record_noh<bspline_apic_musl>({.axes = 3}, true); }
TEST(NohSphere, TheColdnessOfTheGasDoesNotMatter) {
  const double at_zero = noh<bspline_apic_musl>({.axes = 3, .cells = 60}).density;
  double worst = 0;
  for (const double e : {1e-30, 1e-12, 1e-6})
    worst = std::max(worst, std::abs(noh<bspline_apic_musl>({.axes = 3, .cells = 60, .energy = e}).density / at_zero - 1));
  verify::record({.section = "extremes",
                  .problem = "Noh, sphere (r-z), e0 1e-30, 1e-12, 1e-6 against 0, 60 cells",
                  .composition = composition<bspline_apic_musl, space::axisymmetric>(),
                  .measure = "change of the plateau density",
                  .value = worst,
                  .bound = 1e-3});
  EXPECT_LT(worst, 1e-3);
}
/// How the error falls with the cell, and what other choices do: reported.
TEST(NohSphere, OtherChoicesAreReported) {
  const auto r = record_noh<bspline_apic_musl>({.axes = 3, .cells = 100}, false, "shock of three cells against a radius of five");
  EXPECT_NEAR(r.density / 64, 1, 0.15);
  const auto strong = record_noh<bspline_apic_musl>({.axes = 3, .cells = 100, .quadratic = 1.5, .linear = 0.06}, false,
                                                    "the default viscosity sees the convergence and heats ahead of the shock");
  EXPECT_NEAR(strong.density / 64, 0.57, 0.1);
  record_noh<linear_flip_usf>({.axes = 3, .cells = 100, .quadratic = 1.5, .linear = 0.06}, false,
                              "the default viscosity sees the convergence and heats ahead of the shock");
  record_noh<bspline_flip_musl>({.axes = 3, .cells = 100, .quadratic = 0.67, .linear = 0.3}, false,
                                "FLIP wants more viscosity than APIC, and pays by heat ahead of the shock");
}

} // namespace
} // namespace bolide
