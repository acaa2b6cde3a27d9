// SPDX-License-Identifier: MIT
// Extremes 13 and 19: an elastic disc through 100 turns, and ten million steps of 48 particles in double and float.
#include "extreme/extreme.hpp"

#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

namespace bolide {
namespace {
using namespace extreme;

using float_flip = method<shape::quadratic_bspline, transfer::flip, scheme::musl, float>;
template <class Method> class Spin : public testing::Test {};
using methods = testing::Types<linear_flip_musl, bspline_flip_musl, bspline_apic_musl, float_flip>;
TYPED_TEST_SUITE(Spin, methods, method_names);

/// sum m (x v_y - y v_x), and of APIC's affine part inertia m h^2 (C_yx - C_xy).
template <class Method, class Solver> double angular_momentum(Solver& sim) {
  double sum = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    double l = value<field::position>(s, i, 0) * value<field::velocity>(s, i, 1) -
               value<field::position>(s, i, 1) * value<field::velocity>(s, i, 0);
    if constexpr (Method::transfer_type::affine)
      l += Method::shape_type::inertia * square(sim.cell()) *
           (value<field::affine_velocity>(s, i, 2) - value<field::affine_velocity>(s, i, 1));
    sum += value<field::mass>(s, i) * l;
  });
  return sum;
}

/// A soft disc (wave speed 6 rim speeds) turns 100 times. Jaumann's rate keeps the centrifugal stress with the material; what it drifts is
/// reported.
TYPED_TEST(Spin, OfAnElasticDisc) {
  using point = vec<double, 2>;
  using T = typename TypeParam::scalar;
  const double radius = 1, h = radius / 5, omega = 2 * std::numbers::pi;
  const material soft{eos::mie_grueneisen{{.rho0 = 1000, .c0 = 40, .s = 1.3, .gamma0 = 1}}, strength::elastic_perfectly_plastic{5e5, 1e30},
                      failure::none{}, viscosity::none{}};
  auto sim = make<TypeParam, space::plane_strain>(h, one_thread<T>(),
                                                  body{"disc", sphere{point{0, 0}, radius}, soft, h / 2, initial_state{1000, 0}});
  sim.for_each_body([&](auto& s) {
    auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.template get<field::velocity>(0)[i] = static_cast<T>(-omega * value<field::position>(s, i, 1));
      p.template get<field::velocity>(1)[i] = static_cast<T>(omega * value<field::position>(s, i, 0));
      if constexpr (TypeParam::transfer_type::affine) {
        p.template get<field::affine_velocity>(1)[i] = static_cast<T>(-omega);
        p.template get<field::affine_velocity>(2)[i] = static_cast<T>(omega);
      }
    }
  });
  const double start = angular_momentum<TypeParam>(sim), kinetic = sim.energies().now.kinetic;
  std::string stopped;
  try {
    sim.run(100);
  } catch (const run_stopped& e) { stopped = e.what(); }
  EXPECT_EQ(stopped, "");
  is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-2, sizeof(T) == 8 ? 1e-9 : 1e-1, 1e-4});
  const auto row = [&](const char* measure, double got, double bound, const std::string& note) {
    verify::record({.section = "extremes",
                    .problem = "elastic disc of 10 cells, 100 turns",
                    .composition = composition<TypeParam, space::plane_strain>(),
                    .measure = measure,
                    .value = got,
                    .bound = bound,
                    .seconds = sim.solver_seconds(),
                    .note = note});
  };
  const bool exact = TypeParam::transfer_type::affine;
  row("angular momentum, change", angular_momentum<TypeParam>(sim) / start - 1, exact ? 1e-6 : verify::none,
      std::to_string(sim.steps()) + " steps");
  row("kinetic energy, change", sim.energies().now.kinetic / kinetic - 1, verify::none, floors(sim));
  if (exact) { EXPECT_LT(std::abs(angular_momentum<TypeParam>(sim) / start - 1), 1e-6); }
}

/// A bar of 24 cells swings in its first mode, ten million steps of 1e-3 of the usual length.
template <class T> void tiny_steps(double& energy, double& momentum, double& position) {
  using point = vec<double, 1>;
  using m = method<shape::quadratic_bspline, transfer::flip, scheme::musl, T>;
  const double h = 0.1 * mm, length = 24 * h;
  const material al{eos::mie_grueneisen{}, strength::none{}, failure::none{}, viscosity::none{}};
  auto c = one_thread<T>();
  c.courant = 4e-4;
  c.first_step = 1;
  c.step_cap = 20'000'000;
  auto sim = make<m, space::planar_1d>(h, c, body{"bar", box{point{-length / 2}, point{length / 2}}, al, h / 2, initial_state{2785, 0}});
  EXPECT_LE(sim.particle_count(), 64u);
  sim.for_each_body([&](auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      s.columns.template get<field::velocity>()[i] =
          static_cast<T>(10 * std::sin(std::numbers::pi * value<field::position>(s, i) / length));
  });
  const auto start = sim.energies().now.total();
  for (long i = 0; i < 10'000'000; ++i) sim.step();
  is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1, sizeof(T) == 8 ? 1e-9 : 1, sizeof(T) == 8 ? 1e-9 : 1});
  energy = sim.energies().now.total() / start - 1;
  momentum = sim.energies().momentum_error(0);
  position = 0;
  double mass = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    position += value<field::mass>(s, i) * value<field::position>(s, i);
    mass += value<field::mass>(s, i);
  });
  position /= mass * h;
}
template <class T> void report(const char* name, double energy_bar, double momentum_bar) {
  double energy = 0, momentum = 0, position = 0;
  tiny_steps<T>(energy, momentum, position);
  const auto row = [&](const char* measure, double got, double bound, const char* unit) {
    verify::record({.section = "extremes",
                    .problem = "1e7 steps of 1e-3 of the usual length, swinging bar of 48 points",
                    .composition = name,
                    .measure = measure,
                    .value = got,
                    .bound = bound,
                    .unit = unit});
    EXPECT_LT(std::abs(got), bound) << measure;
  };
  row("total energy, change", energy, energy_bar, "");
  row("momentum over sum m |v|", momentum, momentum_bar, "");
  row("centre of mass, drift", position, 1, "cells");
}
TEST(TenMillionSteps, InDouble) { report<double>("planar_1d, bspline_flip_musl", 1e-9, 1e-9); }
TEST(TenMillionSteps, InFloat) { report<float>("planar_1d, bspline_flip_musl_float", 0.1, 1e-3); }

} // namespace
} // namespace bolide
