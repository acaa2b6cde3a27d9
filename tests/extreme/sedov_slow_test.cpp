// SPDX-License-Identifier: MIT
// Extreme 7: Sedov's blast in r-z with all energy in one particle, whose neighbours have none of it.
//
// The energy is set by solver::initialise, which gives the particle its pressure too. (Written into the column of energies alone it stays without
// effect: a point at rest keeps the pressure it has. The blast then waited at the origin until rounding moved it, to t 0.125 at 40 cells and
// 0.06 at 20, and its radius at t 1 was 6.3 % low; now it has 1 % of its energy in motion at t 1e-4.)
// What is left of the error at t 1, two points per cell side, has three parts:
//   the front      half the height of a peak that is cut off lies outside the jump. The exact profile smeared over a cell and a half gives
//                  +2.3 % with 20 cells, +0.9 % with 40, +0.3 % with 80.
//   the inside     gas of the first cells fills 0.7 of the radius with some hundred points; a point alone in its cell pushes nobody. Energy
//                  within 0.7 r is 0.176 of all with 40 cells, 0.183 with 80, exact 0.208, and the affine motion of these points keeps 0.035:
//                  5 % less energy is a radius 1 % less. With 4 points a side affine motion keeps 0.006.
//   the viscosity  with c_q 0.1, c_l 0.1 (right for Noh) a radius 1 to 2.5 % less than with the default 1.5, 0.06, which is used here.
// Radius, default viscosity: +3.0 % with 20 cells, +0.6 with 30, 0.0 with 40, -1.2 with 60, -1.4 with 80; with 4 points a side +2.1, +0.6 and 0.0
// with 20 to 40. So 0.0 is a crossing of parts of 1 to 2 %; rounding alone, by the order of sums, moves a result by up to 0.7 %.
#include "extreme/noh.hpp"

#include <numeric>

namespace bolide {
namespace {
using namespace extreme;

/// Sedov's point blast in r-z, gamma 1.4: half the energy in the ring next to the origin, 1e-9 J/kg elsewhere. Shock at r = 1 at t = 1.
struct blast {
  double mean, spread, inside, seconds; // inside: share of the energy within 0.7 of the radius
  std::string floors;
};
template <class Method> blast sedov(int cells, const viscosity::bulk& q) {
  using T = typename Method::scalar;
  const double h = 1.0 / cells, energy = 0.851072 / 2;
  auto c = one_thread<T>();
  c.dt_floor = 1e-9;
  auto sim = make<Method, space::axisymmetric>(h, c, body{"gas", half_ball{1.25}, gas(1.4, 1, q), h / 2, initial_state{1, 1e-9}});
  sim.add(grid::mirror{1, 0, true});
  const double ring = 2 * std::numbers::pi * (h / 4) * square(h / 2); // its volume
  int hot = 0;
  sim.initialise([&](auto& point) {
    if (point.position[0] > h / 2 || point.position[1] > h / 2) return;
    point.energy = energy / ring;
    ++hot;
  });
  EXPECT_EQ(hot, 1);
  EXPECT_NEAR(sim.energies().now.internal / energy, 1, 1e-6);
  sim.run(1);
  is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-3, sizeof(T) == 8 ? 1e-9 : 1e-2, 2});
  constexpr int sectors = 6;
  std::vector<double> radius;
  for (int k = 0; k < sectors; ++k) {
    std::vector<double> mass(static_cast<std::size_t>(cells * 5 / 4), 0.0), volume = mass;
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      const double x = value<field::position>(s, i), z = value<field::position>(s, i, 1);
      const auto bin = static_cast<std::size_t>(std::hypot(x, z) / h);
      if (static_cast<int>(std::atan2(x, z) / (0.5 * std::numbers::pi) * sectors) != k || bin >= mass.size()) return;
      mass[bin] += value<field::mass>(s, i);
      volume[bin] += value<field::volume>(s, i);
    });
    for (std::size_t b = 0; b < mass.size(); ++b) mass[b] = volume[b] > 0 ? mass[b] / volume[b] : 0;
    radius.push_back(falls_through(mass, h, 0.5 * (1 + *std::max_element(mass.begin(), mass.end()))));
  }
  const auto [low, high] = std::minmax_element(radius.begin(), radius.end());
  double inside = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    if (std::hypot(value<field::position>(s, i), value<field::position>(s, i, 1)) < 0.7)
      inside += value<field::mass>(s, i) * value<field::energy>(s, i) / energy;
  });
  return {std::accumulate(radius.begin(), radius.end(), 0.0) / sectors, (*high - *low) / h, inside, sim.solver_seconds(), floors(sim)};
}
std::string percent(double x) { return to_text(std::round(1000 * x) / 10) + " %"; }

TEST(Sedov, FromOneParticle) {
  const viscosity::bulk usual, weak(0.1, 0.1);
  const auto coarse = sedov<bspline_apic_musl>(20, usual), b = sedov<bspline_apic_musl>(40, usual), thin = sedov<bspline_apic_musl>(40, weak);
  const auto row = [&](const char* measure, double got, double bound, const char* unit, const std::string& note) {
    verify::record({.section = "extremes",
                    .problem = "Sedov (r-z), energy in one particle, 40 cells",
                    .composition = composition<bspline_apic_musl, space::axisymmetric>(),
                    .measure = measure,
                    .value = got,
                    .bound = bound,
                    .seconds = b.seconds,
                    .unit = unit,
                    .note = note});
  };
  const std::string parts = "a smeared front reads 0.9 % high, points alone in their cells inside (" + percent(b.inside) +
                            " of the energy within 0.7 r, exact 20.8 %) make it 1 to 2 % low; with 20 cells " + percent(coarse.mean - 1) +
                            "; " + b.floors;
  row("shock radius, error", b.mean - 1, 0.02, "", parts);
  row("shock radius with viscosity 0.1, 0.1, error", thin.mean - 1, verify::none, "", "too little viscosity for a strong blast: default 1.5, 0.06");
  row("largest less smallest radius of six sectors", b.spread, 1, "cells", parts);
  EXPECT_LT(std::abs(b.mean - 1), 0.02);
  EXPECT_LT(std::abs(coarse.mean - 1), 0.05);
  EXPECT_LT(std::abs(thin.mean - 1), 0.05);
  EXPECT_LE(b.spread, 1);
}

} // namespace
} // namespace bolide
