// SPDX-License-Identifier: MIT
// optimise: -Og
// Flyer impact against the exact Rankine-Hugoniot state: the methods that flyer_1d_test.cpp and flyer_rz_test.cpp do not run, and the other
// equations of state in r-z.
#include "verify/flyer.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(FlyerRZ, Tillotson) { verify_flyer_rz("tillotson", tillotson()); }
TEST(FlyerRZ, Helm) { verify_flyer_rz("helm", helm()); }
TEST(FlyerRZ, PaperFromTheColdState) { verify_flyer_rz("paper (cold)", paper()); }

template <class Method> class FlyerMethods : public testing::Test {};
using methods = testing::Types<linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_musl>;
TYPED_TEST_SUITE(FlyerMethods, methods, method_names);

/// Recorded for every method.
TYPED_TEST(FlyerMethods, MieGrueneisenIn1D) { verify_method_1d<TypeParam>(); }
TYPED_TEST(FlyerMethods, MieGrueneisenInRZ) { verify_method_rz<TypeParam>(); }
TYPED_TEST(FlyerMethods, WithoutViscosityIn1D) { misses_without_viscosity_1d<TypeParam>(); }

} // namespace
} // namespace bolide
