// SPDX-License-Identifier: MIT
// The solver's own behaviour in the methods that solver_test.cpp does not run.
#include "unit/solver/methods.hpp"

namespace bolide::test {
namespace {

using methods = testing::Types<linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_musl>;
using quiet_methods = testing::Types<linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_musl,
                                     method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, LeavingBox, methods, method_names);
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, Quiet, quiet_methods, method_names);
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, OneParticle, methods, method_names);

} // namespace
} // namespace bolide::test
