// SPDX-License-Identifier: MIT
// The same bits on 1, 2 and 4 threads, for every method: a hash of the whole particle state after 60 steps.
#include "unit/solver/scenes.hpp"

namespace bolide {
namespace {
using namespace test;

/// Large enough that several blocks of one colour exist (the loop over blocks is parallel only then).
template <class Method> std::uint64_t hash_on(int threads, int steps) {
  using point = vec<double, 2>;
  controls<typename Method::scalar> c;
  c.threads = threads;
  const initial_state at{2785, 0};
  const body ball{"ball", sphere{point{0, -2 * mm}, 2 * mm}, aluminium(), 0.05 * mm, at, point{0, 6640.}, jitter{0.1, 5}};
  const body plate{"plate", box{point{0, 0}, point{6 * mm, 1 * mm}}, aluminium(), 0.05 * mm, at};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c, ball, plate};
  for (int i = 0; i < steps; ++i) sim.step();
  return state_hash(sim) ^ static_cast<std::uint64_t>(sim.energies().work_mismatch * 1e20); // the ledger's sums too
}

template <class Method> class Threads : public testing::Test {};
using methods = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Threads, methods, method_names);

TYPED_TEST(Threads, TheNumberOfThreadsChangesNoBit) {
  const auto one = hash_on<TypeParam>(1, 60);
  EXPECT_EQ(hash_on<TypeParam>(2, 60), one);
  EXPECT_EQ(hash_on<TypeParam>(4, 60), one);
  EXPECT_NE(hash_on<TypeParam>(1, 59), one) << "the hash must be able to tell";
}
TYPED_TEST(Threads, TwoRunsAreTheSame) { EXPECT_EQ(hash_on<TypeParam>(2, 40), hash_on<TypeParam>(2, 40)); }

} // namespace
} // namespace bolide
