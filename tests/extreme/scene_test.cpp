// SPDX-License-Identifier: MIT
// Extreme 18 and how a run stops: particles leave, all of them leave, there are none, the step is 0, something is not a number. Each ends
// in a count or in a sentence that names the cause, the particle and the step, never in silence.
#include "extreme/extreme.hpp"

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 2>;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
template <class Method> class Scene : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_apic_musl, float_apic_musl>;
TYPED_TEST_SUITE(Scene, methods, method_names);

template <class Method> void record(const char* problem, const char* measure, double got, double bound, const std::string& note = "") {
  verify::record({.section = "extremes",
                  .problem = problem,
                  .composition = composition<Method, space::axisymmetric>(),
                  .measure = measure,
                  .value = got,
                  .bound = bound,
                  .note = note});
  EXPECT_LE(std::abs(got), bound) << problem << ": " << measure;
}
template <class F> std::string message_of(F&& f) {
  try {
    f();
  } catch (const run_stopped& e) { return e.what(); } catch (const bad_parameter& e) {
    return e.what();
  }
  return "";
}

TYPED_TEST(Scene, WhatLeavesIsCounted) {
  using T = typename TypeParam::scalar;
  auto sim = small_impact<TypeParam>();
  sim.add(leaving_box<2>{point{0, -0.3 * mm}, point{1 * mm, 0.6 * mm}});
  const double mass = [&] {
    double m = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) { m += value<field::mass>(s, i); });
    return m;
  }();
  const auto before = sim.particle_count();
  sim.run(0.5 * us);
  is_sound(sim);
  double now = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) { now += value<field::mass>(s, i); });
  const auto& books = sim.energies();
  EXPECT_GT(books.particles_left, 0u);
  EXPECT_EQ(sim.particle_count() + books.particles_left, before);
  record<TypeParam>("an impact in a box that material leaves", "mass here and gone, error", (now + books.mass_left) / mass - 1,
                    sizeof(T) == 8 ? 1e-14 : 1e-6, std::to_string(books.particles_left) + " of " + std::to_string(before) + " left");
  record<TypeParam>("an impact in a box that material leaves", "energy here and gone, error", books.drift(), sizeof(T) == 8 ? 1e-12 : 1e-4);
}

/// When the last particle has left, the run goes to its end.
TYPED_TEST(Scene, AnEmptyGridIsNoAccident) {
  using T = typename TypeParam::scalar;
  const body ball{"ball", sphere{point{0, 0}, 0.4 * mm}, aluminium(), 0.05 * mm, initial_state{2785, 0}, point{0, 7000.}};
  auto sim = make<TypeParam, space::axisymmetric>(0.1 * mm, one_thread<T>(), ball);
  sim.add(leaving_box<2>{point{0, -1 * mm}, point{1 * mm, 1 * mm}});
  const auto before = sim.particle_count();
  const std::string message = message_of([&] { sim.run(1 * us); });
  const auto& books = sim.energies();
  EXPECT_EQ(sim.particle_count(), 0u);
  EXPECT_LT(std::abs(books.drift()), sizeof(T) == 8 ? 1e-12 : 1e-4);
  EXPECT_EQ(message, "");
  record<TypeParam>("all material leaves", "particles neither here nor counted",
                    static_cast<double>(before) - static_cast<double>(books.particles_left), 0, "the run goes on to its end");
}

TYPED_TEST(Scene, NoParticlesIsRefused) {
  using T = typename TypeParam::scalar;
  const body dust{"dust", sphere{point{0, 0}, 0.01 * mm}, aluminium(), 0.05 * mm, initial_state{2785, 0}};
  const std::string message = message_of([&] { make<TypeParam, space::axisymmetric>(0.1 * mm, one_thread<T>(), dust); });
  EXPECT_NE(message.find("number of particles"), std::string::npos) << message;
}

TYPED_TEST(Scene, AStepOfZeroChangesNothing) {
  auto sim = small_impact<TypeParam>();
  sim.run(0);
  for (int i = 0; i < 20; ++i) sim.step();
  const auto total = sim.energies().now.total();
  const double time = sim.time();
  const auto hash = [&] {
    double sum = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) { sum += value<field::position>(s, i, 1) + value<field::velocity>(s, i, 1); });
    return sum;
  };
  const double state = hash();
  for (int i = 0; i < 5; ++i) sim.step(0);
  EXPECT_EQ(sim.time(), time);
  record<TypeParam>("five steps of 0 s in an impact", "sum of positions and velocities, change", hash() / state - 1,
                    TypeParam::transfer_type::affine ? 1e-3 : 1e-6,
                    TypeParam::transfer_type::affine ? "APIC filters velocities by the grid in every step, of whatever length" : "");
  record<TypeParam>("five steps of 0 s in an impact", "total energy, change", sim.energies().now.total() / total - 1, 1e-6);
  sim.run(time + 0.02 * us);
  is_sound(sim);
}

/// A velocity that is no number stops the run at once, and the sentence names the particle and the step.
TYPED_TEST(Scene, NotANumberDoesNotTravel) {
  using T = typename TypeParam::scalar;
  for (const auto poison : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()}) {
    auto sim = small_impact<TypeParam>();
    for (int i = 0; i < 10; ++i) sim.step();
    sim.for_each_body([&](auto& s) {
      if (s.name == "ball") s.columns.template get<field::velocity>(1)[5] = poison;
    });
    const std::string message = message_of([&] { sim.run(1 * us); });
    EXPECT_NE(message.find("stopped at step"), std::string::npos) << message;
    EXPECT_NE(message.find("particle"), std::string::npos);
    record<TypeParam>("a velocity that is no number, after step 10", "steps until the run stops", static_cast<double>(sim.steps() - 10), 2,
                      message.substr(0, 90));
  }
}

/// The step cap, the floor of the step and the bound of the energy each stop the run with their names.
TYPED_TEST(Scene, EveryStopSaysWhy) {
  using T = typename TypeParam::scalar;
  auto c = one_thread<T>();
  c.step_cap = 7;
  auto capped = small_impact<TypeParam>(aluminium(), {}, c);
  EXPECT_NE(message_of([&] { capped.run(1 * us); }).find("step cap of 7"), std::string::npos);
  EXPECT_EQ(capped.steps(), 7);
  c = one_thread<T>();
  c.dt_floor = 0.9999;
  c.first_step = 1;
  auto floored = small_impact<TypeParam>(aluminium(), {}, c);
  const auto message = message_of([&] { floored.run(1 * us); });
  EXPECT_NE(message.find("below its floor"), std::string::npos) << message;
  for (const char* word : {"step", "time", "particle", "position", "velocity", "density", "energy", "pressure"})
    EXPECT_NE(message.find(word), std::string::npos) << word;
}

} // namespace
} // namespace bolide
