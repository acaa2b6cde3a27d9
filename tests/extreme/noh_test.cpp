// SPDX-License-Identifier: MIT
// optimise: -O1
// Extremes 1 and 2: Noh's implosion, planar and cylindrical, from cold gas of e = 0, 1e-30, 1e-12 and 1e-6 J/kg. The sphere:
// noh_slow_test.cpp.
#include "extreme/noh.hpp"

namespace bolide {
namespace {
using namespace extreme;

template <class Method> class Noh : public testing::Test {};
using methods = testing::Types<bspline_apic_usf, bspline_apic_musl, float_apic_usf>;
TYPED_TEST_SUITE(Noh, methods, method_names);
template <class Method> constexpr double courant = Method::scheme_type::stress_first ? 0.2 : 0.4; // noh.hpp

TYPED_TEST(Noh, PlanarAndCylinderAreWithinFivePercent) {
  for (const int axes : {1, 2}) record_noh<TypeParam>({.axes = axes, .courant = courant<TypeParam>}, true);
}

TYPED_TEST(Noh, TheColdnessOfTheGasDoesNotMatter) {
  for (const int axes : {1, 2}) {
    const double at_zero = noh<TypeParam>({.axes = axes, .cells = 100}).density;
    double worst = 0;
    for (const double e : {1e-30, 1e-12, 1e-6})
      worst = std::max(worst, std::abs(noh<TypeParam>({.axes = axes, .cells = 100, .energy = e}).density / at_zero - 1));
    verify::record({.section = "extremes",
                    .problem = std::string("Noh, ") + (axes == 1 ? "planar" : "cylinder") + ", e0 1e-30, 1e-12, 1e-6 against 0",
                    .composition = axes == 1 ? composition<TypeParam, space::planar_1d>() : composition<TypeParam, space::axisymmetric>(),
                    .measure = "change of the plateau density",
                    .value = worst,
                    .bound = 1e-3});
    EXPECT_LT(worst, 1e-3);
  }
}

} // namespace
} // namespace bolide
