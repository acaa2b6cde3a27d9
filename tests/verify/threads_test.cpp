// SPDX-License-Identifier: MIT
// The same bits on 1, 2 and 4 threads, for every method: a hash of the whole particle state after 60 steps.
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide {
namespace {
using namespace test;

struct hashes {
  std::uint64_t before_last, last;
};
/// Large enough (18,800 and 17,600 particles) that the loops run in parallel; below 16,384 the solver keeps to one thread.
template <class Method> hashes hash_on(int threads, int steps) {
  using point = vec<double, 2>;
  controls<typename Method::scalar> c;
  c.threads = threads;
  c.first_step = 1;
  const initial_state at{2785, 0};
  const body ball{"ball", sphere{point{0, -5.5 * mm}, 5.5 * mm}, aluminium(), 0.05 * mm, at, point{0, 6640.}, jitter{0.1, 5}};
  const body plate{"plate", box{point{0, 0}, point{20 * mm, 2.2 * mm}}, aluminium(), 0.05 * mm, at, point{0, 0}, jitter{0.1, 6}};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c, ball, plate};
  EXPECT_GT(sim.particle_count(), 2 * 16384u);
  hashes h{};
  for (int i = 0; i < steps; ++i) {
    if (i + 1 == steps) h.before_last = state_hash(sim);
    sim.step();
  }
  h.last = state_hash(sim) ^ static_cast<std::uint64_t>(std::abs(sim.energies().viscous_heating) * 1e15); // the ledger's sums too
  return h;
}

template <class Method> class Threads : public testing::Test {};
using methods = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Threads, methods, method_names);

TYPED_TEST(Threads, TheNumberOfThreadsChangesNoBit) {
  const auto one = hash_on<TypeParam>(1, 60);
  EXPECT_EQ(hash_on<TypeParam>(2, 60).last, one.last);
  EXPECT_EQ(hash_on<TypeParam>(4, 60).last, one.last);
  EXPECT_NE(one.before_last, one.last) << "the hash must be able to tell";
}

} // namespace
} // namespace bolide
