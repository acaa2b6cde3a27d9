// SPDX-License-Identifier: MIT
// Extreme 11, nodes of vanishing mass, in the compositions that differ most; all others: tiny_mass_slow_test.cpp.
#include "extreme/tiny_mass.hpp"

namespace bolide::extreme {
namespace {

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
using methods = testing::Types<linear_flip_usf, float_apic_musl>;
INSTANTIATE_TYPED_TEST_SUITE_P(Extreme, TinyMass, methods, method_names);

} // namespace
} // namespace bolide::extreme
