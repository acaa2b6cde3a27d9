// SPDX-License-Identifier: MIT
// Riemann problems on fine cells in every composition.
#include "verify/riemann_problems.hpp"

#include "bolide/shape/cubic_bspline.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Riemann : public testing::Test {};
using methods = testing::Types<bspline_apic_usf, bspline_apic_musl, bspline_flip_usf, bspline_flip_musl, linear_flip_usf, linear_flip_musl,
                               method<shape::cubic_bspline, transfer::apic, scheme::usf>, method<shape::cubic_bspline, transfer::flip, scheme::usf>,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Riemann, methods, method_names);

TYPED_TEST(Riemann, Sod) {
  auto tube = sod_tube;
  tube.per_cell = 16;
  if (TypeParam::shape_type::smooth) verify_tube<TypeParam>(tube, {200, 400, 800}, {.rho = 0.006, .u = 0.02, .p = 0.008, .order = 1}, 0.01, 0.003);
  else verify_tube<TypeParam>(tube, {200, 400, 800}, {.p = 0.02, .note = linear_does_not_converge}, 0.02, 0.003);
}
TYPED_TEST(Riemann, TwoRarefactions) {
  if (TypeParam::shape_type::smooth) verify_tube<TypeParam>(problem_123, {200, 400, 800}, {.rho = 0.01, .u = 0.02, .p = 0.01, .order = 1, .note = hot_centre});
  else verify_tube<TypeParam>(problem_123, {200, 400, 800}, {.p = 0.03, .note = linear_does_not_converge});
}
TYPED_TEST(Riemann, LeBlanc) {
  if (!TypeParam::shape_type::smooth) GTEST_SKIP() << "linear shapes: the volumes of the fan drift by factors, and the time step with them";
  std::vector<int> cells{225, 450, 900};
  if (TypeParam::shape_type::support == 4 && !TypeParam::transfer_type::affine) cells = {450, 900, 1800}; // the shock starts further ahead
  verify_tube<TypeParam>(leblanc_tube, cells, {.rho = 0.005, .u = 0.05, .p = 0.005, .order = 1, .note = wide_shock}, none, 0.02);
}

} // namespace
} // namespace bolide
