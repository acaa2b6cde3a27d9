// SPDX-License-Identifier: MIT
// optimise: -O1
// The same bits on 1, 2, 4 and 7 threads, on every repeat and across a restart: four methods, each shape, transfer, scheme and precision at least once, and
// the models that they leave out. threads_slow_test.cpp has the other methods.
#include "bolide/contact/frictional.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/space/plane_strain.hpp"
#include "verify/threads.hpp"

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace bolide {
namespace {
using namespace test;
using namespace verify;
using point = vec<double, 2>;

/// What the methods leave out (17,600 and 17,600 particles): two velocity fields, a moving and a sticking wall, a period, a body force.
auto sliding_blocks(int threads) {
  const initial_state at{2785, 0};
  const body upper{"upper", box{point{0, 0}, point{8 * mm, 5.5 * mm}}, aluminium(), 0.05 * mm, at, point{300., -500.}, jitter{0.1, 7}};
  const body lower{"lower", box{point{0, -5.5 * mm}, point{8 * mm, 0}}, aluminium(), 0.05 * mm, at, point{0, 500.}, jitter{0.1, 8}};
  solver sim{space::plane_strain{}, grid::sparse{0.1 * mm}, shape::gimp{}, transfer::flip{}, scheme::musl{}, contact::frictional{0.3}, on_threads<double>(threads), upper, lower};
  sim.add(grid::periodic{0, 0.0, 8 * mm});
  sim.add(grid::moving_wall{.axis = 1, .position = -5.6 * mm, .velocity = 400, .material_above = true});
  sim.add(body_force{[](const point& x, double t) { return point{1e9 * std::sin(1e4 * x[1] + 1e7 * t), 0}; }});
  return sim;
}


template <class Method> class Threads : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_usf, method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Threads, methods, method_names);

TYPED_TEST(Threads, TheNumberOfThreadsChangesNoBit) { expect_the_same_bits(impact<TypeParam>); }
TEST(ThreadsOfOtherModels, ChangeNoBit) { expect_the_same_bits(sliding_blocks); }

#if defined(_OPENMP)
/// A solver once set the number of the whole process, and with it that of every other solver.
TEST(ThreadsOfOneSolver, AreItsOwn) {
  const int before = omp_get_max_threads();
  auto sim = sliding_blocks(before + 1);
  sim.step();
  EXPECT_EQ(sim.threads(), before + 1);
  EXPECT_EQ(omp_get_max_threads(), before);
}
#endif

} // namespace
} // namespace bolide
