// SPDX-License-Identifier: MIT
// Taylor bar against the test, on three resolutions.
#include "verify/taylor_bar.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class TaylorBar : public testing::Test {};
using methods = testing::Types<linear_flip_musl, bspline_flip_musl, bspline_apic_usf>;
TYPED_TEST_SUITE(TaylorBar, methods, method_names);

TYPED_TEST(TaylorBar, EndsAsTheTestDid) { check_taylor<TypeParam>(3); }

} // namespace
} // namespace bolide
