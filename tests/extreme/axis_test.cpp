// SPDX-License-Identifier: MIT
// Extreme 15, the axis of r-z, in the two compositions that differ most; all others: axis_slow_test.cpp.
#include "extreme/axis.hpp"

namespace bolide::extreme {
namespace {

using methods = testing::Types<linear_flip_usf, float_apic_usf>;
INSTANTIATE_TYPED_TEST_SUITE_P(Extreme, Axis, methods, method_names);

} // namespace
} // namespace bolide::extreme
