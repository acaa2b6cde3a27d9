// SPDX-License-Identifier: MIT
// Elastic bar in its first mode: second order where no particle changes cell, what cell crossing costs. All compositions: elastic_bar_slow_test.cpp.
#include "verify/elastic_bar.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class ElasticBar : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_usf>;
TYPED_TEST_SUITE(ElasticBar, methods, method_names);

TYPED_TEST(ElasticBar, KeepsItsModeWithSecondOrder) { check_elastic_bar<TypeParam>(15); }

} // namespace
} // namespace bolide
