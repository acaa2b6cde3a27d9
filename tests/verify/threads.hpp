// SPDX-License-Identifier: MIT
// Is a scene computed to the same bits on 1, 2, 4 and 7 threads, on a repeat, and across a restart with another number of threads? A hash of the whole
// particle state after 24 steps.
#pragma once

#include "unit/solver/memory_archive.hpp"
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide::verify {
using namespace test;
inline constexpr int all_steps = 24, middle = 14;

template <class T> controls<T> on_threads(int threads) {
  controls<T> c;
  c.threads = threads;
  c.first_step = 1;
  return c;
}
/// Large enough (18,800 and 17,600 particles) that the loops run in parallel; below 16,384 the solver keeps to one thread.
template <class Method> auto impact(int threads) {
  using point = vec<double, 2>;
  const initial_state at{2785, 0};
  const body ball{"ball", sphere{point{0, -5.5 * mm}, 5.5 * mm}, aluminium(), 0.05 * mm, at, point{0, 6640.}, jitter{0.1, 5}};
  const body plate{"plate", box{point{0, 0}, point{20 * mm, 2.2 * mm}}, aluminium(), 0.05 * mm, at, point{0, 0}, jitter{0.1, 6}};
  return solver{space::axisymmetric{},          grid::sparse{0.1 * mm},         typename Method::shape_type{}, typename Method::transfer_type{},
                typename Method::scheme_type{}, on_threads<typename Method::scalar>(threads), ball,                          plate};
}

struct run_of {
  std::uint64_t before_last, last;
  entries in_the_middle; // the checkpoint
};
/// The particles' bits, and those of a sum of the ledger.
template <class Solver> std::uint64_t all_bits(Solver& sim) {
  return state_hash(sim) ^ static_cast<std::uint64_t>(std::abs(sim.energies().viscous_heating) * 1e15);
}
template <class Solver> run_of advance(Solver sim, int from, [[maybe_unused]] int threads) {
  sim.for_each_body([](const auto& s) { EXPECT_GT(s.columns.size(), 16384u); });
  run_of r{};
  for (int i = from; i < all_steps; ++i) {
    if (i == middle) r.in_the_middle = listed(sim);
    if (i + 1 == all_steps) r.before_last = all_bits(sim);
    sim.step();
  }
#if defined(_OPENMP)
  EXPECT_EQ(sim.threads(), threads);
#endif
  r.last = all_bits(sim);
  return r;
}
/// scene(threads) makes the solver.
template <class Scene> void expect_the_same_bits(const Scene& scene) {
  const auto one = advance(scene(1), 0, 1), seven = advance(scene(7), 0, 7);
  EXPECT_NE(one.before_last, one.last) << "the hash must be able to tell";
  EXPECT_EQ(advance(scene(2), 0, 2).last, one.last) << "2 threads";
  EXPECT_EQ(advance(scene(4), 0, 4).last, one.last) << "4 threads";
  EXPECT_EQ(seven.last, one.last) << "7 threads";
  EXPECT_EQ(advance(scene(7), 0, 7).last, one.last) << "7 threads once more";
  const auto restarted = [&](const run_of& checkpoint, int threads) {
    auto sim = scene(threads);
    put_back(sim, checkpoint.in_the_middle);
    return advance(std::move(sim), middle, threads).last;
  };
  EXPECT_EQ(restarted(seven, 2), one.last) << "7 threads, then 2";
  EXPECT_EQ(restarted(one, 4), one.last) << "1 thread, then 4";
}

} // namespace bolide::verify
