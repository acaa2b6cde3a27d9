// SPDX-License-Identifier: MIT
// The solver's own behaviour: storage, time step, stops with a message, leaving box, mirrors, small and empty scenes.
#include "bolide/eos/tillotson.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/solver/methods.hpp"

#include <cmath>

namespace bolide {
namespace {
using namespace test;

// ---- what every method must show (the other methods: solver_slow_test.cpp) ----------------------------------------------------------------
using methods = testing::Types<linear_flip_usf, bspline_apic_usf>;
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, LeavingBox, methods, method_names);
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, Quiet, methods, method_names);
INSTANTIATE_TYPED_TEST_SUITE_P(Solver, OneParticle, methods, method_names);

// ---- storage ----------------------------------------------------------------------------------------------------------------------------
template <class Solver> std::size_t bytes_per_particle(const Solver& sim) {
  std::size_t bytes = 0;
  sim.for_each_body([&](const auto& s) { bytes = std::remove_cvref_t<decltype(s.columns)>::bytes_per_particle; });
  return bytes;
}
/// mass, x, v, carrying v, volume, e, p; + deviator 3, plastic strain; + failed, material volume; + q, c; + affine 4; id.
TEST(BytesPerParticle, ArePinnedForNamedCompositions) {
  EXPECT_EQ(bytes_per_particle(small_impact<linear_flip_usf>()), (4 + 2 * 3 + 4 + 2 + 2) * 8 + 4u) << "the aluminium impact with FLIP";
  EXPECT_EQ(bytes_per_particle(small_impact<bspline_apic_usf>()), (4 + 2 * 3 + 4 + 2 + 2 + 4) * 8 + 4u) << "the default composition";
  using single = method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>;
  EXPECT_EQ(bytes_per_particle(small_impact<single>()), (4 + 2 * 3 + 4 + 2 + 2 + 4) * 4 + 4u);
  const material fluid{eos::mie_grueneisen{}, strength::none{}, failure::none{}, viscosity::none{}};
  EXPECT_EQ(bytes_per_particle(small_flyer<linear_flip_usf>(fluid)), (4 + 3) * 8 + 4u) << "an inviscid fluid in 1-D stores nothing else";
  const material recorded{eos::mie_grueneisen{}, strength::none{}, failure::none{}, viscosity::bulk{}, record::peak_pressure{}};
  EXPECT_EQ(bytes_per_particle(small_flyer<linear_flip_usf>(recorded)), (4 + 3 + 2 + 1) * 8 + 4u);
}

// ---- time step --------------------------------------------------------------------------------------------------------------------------
TEST(TimeStep, StartsSmallGrowsAndEndsOnTime) {
  auto sim = small_flyer<linear_flip_usf>();
  sim.step();
  const double first = sim.dt();
  EXPECT_EQ(sim.cause(), step_cause::growth);
  sim.step();
  EXPECT_NEAR(sim.dt() / first, 1.1, 1e-12);
  EXPECT_EQ(sim.cause(), step_cause::growth);
  const double until = sim.time() + 0.5 * sim.dt();
  sim.run(until);
  EXPECT_EQ(sim.cause(), step_cause::end);
  EXPECT_NEAR(sim.time(), until, 1e-12 * until);
  EXPECT_EQ(sim.steps(), 3);
}
TEST(TimeStep, FollowsTheParticleThatAsksForTheShortest) {
  auto sim = small_flyer<linear_flip_usf>();
  while (sim.time() < 0.1 * us) sim.step();
  EXPECT_TRUE(sim.cause() != step_cause::end) << name(sim.cause());
  EXPECT_LT(sim.dt(), 0.4 * 1e-4 / (6640 + 5000)) << "the fastest particle moves at 6640 m/s in material with c > 5 km/s";
  EXPECT_GT(sim.dt(), 0.4 * 1e-4 / 50000);
}
TEST(TimeStep, ACutStepDoesNotThrottleTheNext) {
  auto sim = small_flyer<linear_flip_usf>();
  while (sim.time() < 0.05 * us) sim.step();
  const double before = sim.dt();
  sim.step(1e-3 * before);
  EXPECT_EQ(sim.cause(), step_cause::end);
  sim.step();
  EXPECT_GT(sim.dt(), 0.8 * before);
}
TEST(TimeStep, RunToNowDoesNothing) {
  auto sim = small_flyer<linear_flip_usf>();
  sim.run(0);
  EXPECT_EQ(sim.steps(), 0);
  EXPECT_GT(sim.energies().initial.total(), 0);
  EXPECT_THROW(sim.run(-1), bad_parameter);
  EXPECT_THROW(sim.run(std::nan("")), bad_parameter);
}

// ---- stops ------------------------------------------------------------------------------------------------------------------------------
template <class Solver> std::string stopped(Solver& sim, int steps = 2000) {
  try {
    for (int i = 0; i < steps; ++i) sim.step();
  } catch (const run_stopped& e) {
    return e.what();
  }
  return "";
}
void names_a_particle(const std::string& text) {
  for (const char* part : {"bolide: stopped at step ", ", time ", " s: ", "Shortest step asked for by particle ", " of body ", ": position ", " m, velocity ", " m/s, density ",
                           " kg/m3, energy ", " J/kg, pressure ", " Pa"})
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST(RunStopped, AtTheStepCap) {
  auto c = one_thread<double>();
  c.step_cap = 7;
  auto sim = small_flyer<linear_flip_usf>(aluminium(), {}, c);
  const auto text = stopped(sim);
  EXPECT_NE(text.find("the step cap of 7 is reached"), std::string::npos) << text;
  EXPECT_EQ(sim.steps(), 7);
  names_a_particle(text);
}
TEST(RunStopped, AtTheFloorOfTheTimeStep) {
  auto c = one_thread<double>();
  c.first_step = 1;
  c.dt_floor = 0.7; // a shock shortens the step by more than that
  auto sim = small_flyer<linear_flip_usf>(aluminium(), {}, c);
  const auto text = stopped(sim);
  EXPECT_NE(text.find("the time step fell to "), std::string::npos) << text;
  EXPECT_NE(text.find("below its floor of "), std::string::npos) << text;
  names_a_particle(text);
}
TEST(RunStopped, AtTheEnergyBound) {
  auto c = one_thread<double>();
  c.energy_bound = 0.001;
  auto sim = small_impact<bspline_apic_usf>(aluminium(), transfer::apic{0.0}, c); // drops its transfer loss
  const auto text = stopped(sim);
  EXPECT_NE(text.find("the total energy changed by -0."), std::string::npos) << text;
  EXPECT_NE(text.find("beyond the bound of 0.001"), std::string::npos) << text;
  names_a_particle(text);
}
TEST(RunStopped, AtNotANumberWhateverFieldItEntersBy) {
  const auto poison = [](auto tag, const char* what) {
    auto sim = small_flyer<bspline_apic_usf>();
    for (int i = 0; i < 5; ++i) sim.step();
    sim.for_each_body([&](auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i)
        if (s.columns.id()[i] == 25) s.columns.template get<decltype(tag)>()[i] = std::nan("");
    });
    const auto text = stopped(sim, 70);
    EXPECT_FALSE(text.empty()) << what << ": NaN went through";
    EXPECT_LE(sim.steps(), 8) << what << ": seen late";
    names_a_particle(text);
  };
  poison(field::velocity{}, "velocity");
  poison(field::energy{}, "energy");
  poison(field::volume{}, "volume");
  poison(field::position{}, "position");
  poison(field::deviator{}, "deviator");
}

// ---- leaving box ------------------------------------------------------------------------------------------------------------------------
TEST(LeavingBoxAtStart, WhatStartsOutsideCountsAsLeft) {
  auto sim = small_impact<linear_flip_usf>();
  sim.add(leaving_box<2>{{0, -0.4 * mm}, {1 * mm, 1 * mm}}); // half of the ball is outside
  for (int i = 0; i < 10; ++i) sim.step();
  EXPECT_GT(sim.energies().particles_left, 0u);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
  EXPECT_LT(std::abs(sim.energies().momentum_error(1)), 1e-13);
}

// ---- mirrors and reflection -------------------------------------------------------------------------------------------------------------
TEST(Reflection, ComesBackAndIsCounted) {
  auto sim = small_flyer<linear_flip_usf>();
  sim.add(grid::mirror{0, -1 * mm, true});
  sim.for_each_body([&](auto& s) { // one particle is thrown at the wall faster than the grid could stop it
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      if (s.columns.id()[i] == 0) s.columns.template get<field::position>()[i] = -1 * mm - 5e-11; // a body further beyond is refused
  });
  sim.step();
  EXPECT_EQ(sim.energies().floors[floor_kind::reflected], 1u);
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) EXPECT_GE(s.columns.template get<field::position>()[i], -1 * mm);
  });
}
TEST(SlipWall, ReversesTheMomentumOfAnElasticSlab) {
  using point = vec<double, 1>;
  const material al{eos::mie_grueneisen{}, strength::none{}, failure::none{}, viscosity::none{}};
  const body slab{"slab", box{point{0.1 * mm}, point{1.1 * mm}}, al, 0.05 * mm, initial_state{2785, 0}, point{-20.}};
  solver sim{space::planar_1d{}, grid::sparse{0.1 * mm}, shape::quadratic_bspline{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), slab};
  sim.add(grid::mirror{0, 0, true});
  const double before = sim.energies().now.total();
  sim.run(1.2 * us); // two cells off the wall: contact after 0.2 us, 0.4 us of it; later the grid would pull the slab back (no gap law)
  const auto& l = sim.energies();
  EXPECT_NEAR(l.momentum_now[0] / (2785 * 1e-3 * 20), 1, 0.03);
  EXPECT_NEAR(l.now.total(), before, 1e-12 * before);
}

/// Images of images are not made: with planes two cells apart total energy drifted by 0.3 % once.
TEST(SlipWall, PlanesOfOneAxisAreThreeCellsApart) {
  auto sim = small_flyer<linear_flip_usf>();
  sim.add(grid::mirror{0, -1 * mm, true});
  EXPECT_THROW(sim.add(grid::mirror{0, -0.8 * mm, false}), bad_parameter);
  EXPECT_NO_THROW(sim.add(grid::mirror{0, -0.7 * mm, false}));
}

// ---- small scenes -----------------------------------------------------------------------------------------------------------------------
TEST(Scenes, EmptyIsRefusedWithASentence) {
  using point = vec<double, 2>;
  const body grain{"grain", sphere{point{0, 0}, 0.01 * mm}, aluminium(), 0.05 * mm, initial_state{2785, 0}}; // smaller than a lattice cell
  try {
    solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), grain};
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "number of particles = 0: must be positive (no lattice point lies inside a body)");
  }
}
// ---- what is at rest ----------------------------------------------------------------------------------------------------------------------
/// A quiet speed lets more sleep. What it leaves out is bounded: displacements of quiet speed times time, and as little of the rest.
TEST(QuietSpeed, LeavesOutNoMoreThanItSays) {
  const double speed = 1e-3; // m/s: strains of 2e-7
  auto exact = impact_on_wide_plate<linear_flip_usf>(true), lazy = impact_on_wide_plate<linear_flip_usf>(true, speed);
  std::size_t exactly = 0, lazily = 0;
  while (exact.time() < 1 * us) exact.step(), exactly += exact.sleeping_particles();
  while (lazy.time() < 1 * us) lazy.step(), lazily += lazy.sleeping_particles();
  EXPECT_GT(lazily, exactly);
  ASSERT_EQ(lazy.steps(), exact.steps());
  std::vector<double> z(exact.particle_count());
  exact.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) z[s.columns.id()[i]] = s.columns.template get<field::position>(1)[i];
  });
  lazy.for_each_body([&](const auto& s) {
    if (s.name != "rim") return;
    for (std::size_t i = 0; i < s.columns.size(); ++i) EXPECT_NEAR(s.columns.template get<field::position>(1)[i], z[s.columns.id()[i]], 10 * speed * exact.time());
  });
  const auto &a = exact.energies(), &b = lazy.energies();
  EXPECT_NEAR(b.now.total(), a.now.total(), 1e-9 * a.now.total());
  EXPECT_THROW(impact_on_wide_plate<linear_flip_usf>(true, -1), bad_parameter);
  EXPECT_THROW(impact_on_wide_plate<linear_flip_usf>(false, 1), bad_parameter);
}
TEST(Scenes, BadBodiesAreRefusedWithASentence) {
  using point = vec<double, 2>;
  const auto make = [](double dx, double density, double fraction) {
    return body{"plate", box{point{0, 0}, point{1e-3, 1e-3}}, aluminium(), dx, initial_state{density, 0}, point{0, 0}, jitter{fraction, 1}};
  };
  EXPECT_NO_THROW(make(1e-4, 2785, 0.1));
  EXPECT_THROW(make(-1e-4, 2785, 0), bad_parameter);
  EXPECT_THROW(make(1e-4, 2785, 0.5), bad_parameter);
  try {
    make(1e-4, -1, 0);
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "initial density of body plate = -1 kg/m3: must be positive (unit: kg/m3)");
  }
}
TEST(Scenes, MassesAreReported) {
  auto sim = small_impact<linear_flip_usf>();
  double mass = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) mass += s.columns.template get<field::mass>()[i];
  });
  const double pi = std::acos(-1.0);
  const double exact = 2785 * (4.0 / 3 * pi * std::pow(0.4e-3, 3) + pi * 4e-6 * 0.3e-3);
  EXPECT_NEAR(sim.geometric_mass(), exact, 1e-12 * exact);
  EXPECT_LT(mass, exact);
  EXPECT_GT(mass, 0.95 * exact);
}

// ---- observers --------------------------------------------------------------------------------------------------------------------------
struct counter {
  int* watched;
  int* finished;
  template <class Solver> void watch(const Solver&) { ++*watched; }
  template <class Solver> void finish(const Solver&) { ++*finished; }
};
TEST(Observers, SeeTheStartEveryStepAndTheEnd) {
  int watched = 0, finished = 0;
  auto sim = small_flyer<linear_flip_usf>();
  sim.run(0.02 * us, counter{&watched, &finished});
  EXPECT_EQ(watched, sim.steps() + 1);
  EXPECT_EQ(finished, 1);
}

TEST(Solver, RefusesAStepBackwards) {
  auto sim = small_flyer<linear_flip_usf>();
  for (const double most : {-1e-9, std::nan("")}) EXPECT_THROW(sim.step(most), bad_parameter);
  EXPECT_EQ(sim.steps(), 0);
}

} // namespace
} // namespace bolide
