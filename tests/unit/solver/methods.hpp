// SPDX-License-Identifier: MIT
// The solver's own behaviour that every method must show: what leaves is counted, what is at rest sleeps and changes no bit, one particle flies on.
#pragma once

#include "unit/solver/scenes.hpp"

namespace bolide::test {

template <class Method> class LeavingBox : public testing::Test {};
TYPED_TEST_SUITE_P(LeavingBox);

TYPED_TEST_P(LeavingBox, CountsMassMomentumAndEnergy) {
  using point = vec<double, 2>;
  const body shot{"shot", sphere{point{0, 0}, 0.4 * mm}, aluminium(), 0.05 * mm, initial_state{2785, 1e5}, point{0, 5000.}};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<double>(), shot};
  sim.add(leaving_box<2>{{0, -1 * mm}, {1 * mm, 1 * mm}});
  double mass = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) mass += s.columns.template get<field::mass>()[i];
  });
  const auto n = sim.particle_count();
  sim.run(0.2 * us); // partly out
  const auto& l = sim.energies();
  EXPECT_GT(l.particles_left, 0u);
  EXPECT_LT(l.particles_left, n);
  EXPECT_EQ(sim.particle_count() + l.particles_left, n);
  double stays = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      stays += s.columns.template get<field::mass>()[i];
      EXPECT_LT(s.columns.template get<field::position>(1)[i], 1.12 * mm) << "who is out leaves at most a cell and a step late";
    }
  });
  EXPECT_NEAR(stays + l.mass_left, mass, 1e-14 * mass);
  EXPECT_NEAR(l.momentum_left[1], l.mass_left * 5000, 0.2 * l.mass_left * 5000);
  EXPECT_LT(std::abs(l.momentum_error(1)), 1e-13);
  EXPECT_LT(std::abs(l.residual()), 1e-12);
  EXPECT_LT(std::abs(l.drift()), 1e-12);
  sim.run(0.32 * us); // all of it, the last at 0.28 us and a cell: an empty grid steps on
  EXPECT_EQ(sim.energies().particles_left, n);
  EXPECT_EQ(sim.particle_count(), 0u);
  EXPECT_LT(std::abs(sim.energies().momentum_error(1)), 1e-13);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-12);
}
/// A wide plate, in two parts that touch: blocks of either wake by the other.
template <class Method> auto impact_on_wide_plate(bool skip_quiet, double quiet_speed = 0) {
  using point = vec<double, 2>;
  const initial_state at{2785, 0};
  auto c = one_thread<typename Method::scalar>();
  c.skip_quiet = skip_quiet;
  c.quiet_speed = quiet_speed;
  const body ball{"ball", sphere{point{0, -0.4 * mm}, 0.4 * mm}, aluminium(), 0.05 * mm, at, point{0, 6640}};
  const body plate{"plate", box{point{0, 0}, point{4 * mm, 0.3 * mm}}, aluminium(), 0.05 * mm, at};
  const body rim{"rim", box{point{4 * mm, 0}, point{9 * mm, 0.3 * mm}}, aluminium(), 0.05 * mm, at};
  return solver{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c,
                ball, plate, rim};
}
template <class Method> class Quiet : public testing::Test {};
TYPED_TEST_SUITE_P(Quiet);

TYPED_TEST_P(Quiet, SleepingBlocksChangeNoBit) {
  auto lazy = impact_on_wide_plate<TypeParam>(true), busy = impact_on_wide_plate<TypeParam>(false);
  std::size_t slept = 0, most = 0;
  for (int i = 0; i < 900; ++i) {
    lazy.step();
    busy.step();
    if (i % 60 != 0) continue;
    ASSERT_EQ(lazy.dt(), busy.dt()) << "step " << i;
    ASSERT_EQ(state_hash(lazy), state_hash(busy)) << "step " << i;
    slept += lazy.sleeping_particles();
    most = std::max(most, lazy.sleeping_particles());
    EXPECT_EQ(busy.sleeping_particles(), 0u);
  }
  EXPECT_GT(most, lazy.particle_count() / 2) << "the plate must sleep at first";
  EXPECT_LT(lazy.sleeping_particles(), most / 2) << "and be woken by the wave";
  EXPECT_EQ(lazy.energies().plastic_work, busy.energies().plastic_work);
  EXPECT_EQ(lazy.energies().drift(), busy.energies().drift());
}
TYPED_TEST_P(Quiet, MaterialAtRestSleepsForEver) {
  using point = vec<double, 2>;
  const body plate{"plate", box{point{0, 0}, point{4 * mm, 0.3 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 0}};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<typename TypeParam::scalar>(), plate};
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_EQ(sim.sleeping_particles(), sim.particle_count());
  EXPECT_EQ(sim.cause(), step_cause::sound) << "a sleeper still asks for its time step";
}

template <class Method> class OneParticle : public testing::Test {};
TYPED_TEST_SUITE_P(OneParticle);

TYPED_TEST_P(OneParticle, FliesOnForEver) {
  using point = vec<double, 2>;
  const body grain{"grain", box{point{0.3 * mm, 0}, point{0.35 * mm, 0.05 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 0}, point{0, 7000.}};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<double>(), grain};
  ASSERT_EQ(sim.particle_count(), 1u);
  sim.run(20 * us); // 1400 cells
  sim.for_each_body([&](const auto& s) {
    EXPECT_NEAR(s.columns.template get<field::position>(1)[0], 0.14 + 0.025e-3, 1e-9);
    EXPECT_NEAR(s.columns.template get<field::velocity>(1)[0], 7000, 1e-6);
    EXPECT_NEAR(s.columns.template get<field::velocity>(0)[0], 0, 1e-3);
    EXPECT_NEAR(s.columns.template get<field::mass>()[0] / s.columns.template get<field::volume>()[0], 2785, 1e-3);
  });
  EXPECT_LE(sim.node_count(), 9u * grid::block_map<2>::nodes_per_block) << "the grid is as large as the material, wherever that is";
}
REGISTER_TYPED_TEST_SUITE_P(LeavingBox, CountsMassMomentumAndEnergy);
REGISTER_TYPED_TEST_SUITE_P(Quiet, SleepingBlocksChangeNoBit, MaterialAtRestSleepsForEver);
REGISTER_TYPED_TEST_SUITE_P(OneParticle, FliesOnForEver);

} // namespace bolide::test
