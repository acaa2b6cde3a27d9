// SPDX-License-Identifier: MIT
// optimise: -O1
// Sod's tube, the 123 problem and LeBlanc's tube in the compositions that matter most; all others, and finer cells: riemann_slow_test.cpp.
#include "verify/riemann_problems.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Sod : public testing::Test {};
using methods = testing::Types<bspline_apic_usf, bspline_flip_usf, linear_flip_usf>;
TYPED_TEST_SUITE(Sod, methods, method_names);

TYPED_TEST(Sod, ErrorsFallWithTheCell) {
  if (TypeParam::shape_type::smooth) verify_tube<TypeParam>(sod_tube, {100, 200, 400}, {.rho = 0.008, .u = 0.03, .p = 0.011, .order = 1}, 0.01, 0.005);
  else verify_tube<TypeParam>(sod_tube, {100, 200, 400}, {.p = 0.03, .note = linear_does_not_converge}, 0.05, 0.005);
}

template <class Method> class NearVacuum : public testing::Test {};
using smooth_methods = testing::Types<bspline_apic_usf, bspline_flip_usf>;
TYPED_TEST_SUITE(NearVacuum, smooth_methods, method_names);

TYPED_TEST(NearVacuum, TwoRarefactions) { verify_tube<TypeParam>(problem_123, {200, 400}, {.rho = 0.02, .u = 0.03, .p = 0.03, .order = 1, .note = hot_centre}); }
TYPED_TEST(NearVacuum, LeBlanc) { verify_tube<TypeParam>(leblanc_tube, {225, 450}, {.rho = 0.01, .u = 0.1, .p = 0.01, .order = 1, .note = wide_shock}, none, 0.04); }

} // namespace
} // namespace bolide
