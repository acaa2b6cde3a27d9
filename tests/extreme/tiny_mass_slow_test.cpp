// SPDX-License-Identifier: MIT
// Extreme 11, nodes of vanishing mass, in the compositions that tiny_mass_test.cpp does not run.
#include "extreme/tiny_mass.hpp"

namespace bolide::extreme {
namespace {

using float_linear_flip = method<shape::linear, transfer::flip, scheme::usf, float>;
using methods = testing::Types<linear_flip_musl, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl, float_linear_flip>;
INSTANTIATE_TYPED_TEST_SUITE_P(Extreme, TinyMass, methods, method_names);

} // namespace
} // namespace bolide::extreme
