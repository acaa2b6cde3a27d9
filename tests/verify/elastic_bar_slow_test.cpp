// SPDX-License-Identifier: MIT
// Elastic bar in its first mode, every composition, on twice as many cells as elastic_bar_test.cpp.
#include "verify/elastic_bar.hpp"

#include "bolide/scheme/usl.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/transfer/xpic.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class ElasticBar : public testing::Test {};
using cubic = shape::cubic_bspline;
using methods = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl,
                               method<cubic, transfer::flip, scheme::usf>, method<cubic, transfer::flip, scheme::musl>,
                               method<cubic, transfer::apic, scheme::usf>, method<cubic, transfer::apic, scheme::musl>,
                               method<shape::quadratic_bspline, transfer::flip, scheme::usl>,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usl>, method<shape::gimp, transfer::flip, scheme::usf>,
                               method<shape::gimp, transfer::flip, scheme::musl>, method<shape::quadratic_bspline, transfer::xpic<5>, scheme::musl>>;
TYPED_TEST_SUITE(ElasticBar, methods, method_names);

TYPED_TEST(ElasticBar, KeepsItsModeWithSecondOrder) { check_elastic_bar<TypeParam>(30); }

} // namespace
} // namespace bolide
