// SPDX-License-Identifier: MIT
// Taylor bar against the test. More compositions and resolutions: taylor_bar_slow_test.cpp.
#include "verify/taylor_bar.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class TaylorBar : public testing::Test {};
using methods = testing::Types<bspline_flip_musl>;
TYPED_TEST_SUITE(TaylorBar, methods, method_names);

TYPED_TEST(TaylorBar, EndsAsTheTestDid) { check_taylor<TypeParam>(2); }

} // namespace
} // namespace bolide
