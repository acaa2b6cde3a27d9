// SPDX-License-Identifier: MIT
// The same bits on 1, 2, 4 and 7 threads, on every repeat and across a restart: the methods that threads_test.cpp leaves out, and 3-D.
#include "bolide/scheme/usl.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/transfer/xpic.hpp"
#include "verify/threads.hpp"

namespace bolide {
namespace {
using namespace test;
using namespace verify;

template <class Method> class Threads : public testing::Test {};
using methods = testing::Types<linear_flip_musl, bspline_flip_usf, bspline_apic_musl, method<shape::cubic_bspline, transfer::xpic<2>, scheme::usl>,
                               method<shape::linear, transfer::flip, scheme::usf, float>>;
TYPED_TEST_SUITE(Threads, methods, method_names);
TYPED_TEST(Threads, TheNumberOfThreadsChangesNoBit) { expect_the_same_bits(impact<TypeParam>); }

/// Two blocks of 17,576 particles meet.
auto cubes(int threads) {
  using point = vec<double, 3>;
  const initial_state at{2785, 0};
  const double a = 26 * 0.05 * mm;
  const body first{"first", box{point{0, 0, -a}, point{a, a, 0}}, aluminium(), 0.05 * mm, at, point{0, 0, 3000.}, jitter{0.1, 9}};
  const body second{"second", box{point{0, 0, 0}, point{a, a, a}}, aluminium(), 0.05 * mm, at, point{0, 500., -3000.}, jitter{0.1, 10}};
  return solver{space::cartesian_3d{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, on_threads<double>(threads), first, second};
}
TEST(Threads3d, ChangeNoBit) { expect_the_same_bits(cubes); }

} // namespace
} // namespace bolide
