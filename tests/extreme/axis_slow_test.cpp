// SPDX-License-Identifier: MIT
// optimise: -Og
// Extreme 15, the axis of r-z, in the compositions that axis_test.cpp does not run.
#include "extreme/axis.hpp"

#include "bolide/shape/cubic_bspline.hpp"

namespace bolide::extreme {
namespace {

using cubic_flip_musl = method<shape::cubic_bspline, transfer::flip, scheme::musl>;
using float_linear_flip = method<shape::linear, transfer::flip, scheme::usf, float>;
using methods = testing::Types<bspline_apic_musl, cubic_flip_musl, float_linear_flip>;
INSTANTIATE_TYPED_TEST_SUITE_P(Extreme, Axis, methods, method_names);

} // namespace
} // namespace bolide::extreme
