// SPDX-License-Identifier: MIT
// A flyer of V = 6640 m/s on a plate of the same metal, sampled against the exact Rankine-Hugoniot state of its equation of state.
//
// Samples are particles between the shock fronts, ten cells away from both fronts and from the interface (a gas that is compressed a lot: a third of the
// way between them); no release has begun. The shock speed comes from the front's position at two times (midpoint of the jump in velocity,
// interpolated between particles), the front's spread does not enter.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/viscosity/none.hpp"

#include "verify/table.hpp"

#include "unit/solver/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace bolide::verify {
using namespace test;

inline constexpr double impact_speed = 6640, cell = 0.1e-3;

/// An equation of state with the state that its flyer starts from.
template <class Eos> struct start {
  Eos eos;
  initial_state state;
  double speed = impact_speed;  // m/s
  double until = 0.72 * us;     // s: both shocks are still in slabs of 8 mm
  bool wall = false;            // behind the plate, for what would expand
};
template <class Eos> start(Eos, initial_state) -> start<Eos>;
template <class Eos> start(Eos, initial_state, double, double, bool) -> start<Eos>;
inline auto mie_grueneisen() {
  return start{eos::isentrope_temperature{eos::mie_grueneisen{{.constant_gamma = true}}}, initial_state{2785, 0}};
}
inline auto tillotson() { return start{eos::isentrope_temperature{eos::tillotson{}}, initial_state{2700, 0}}; }
template <class Phase> auto grover_ambient(Phase phase) {
  auto eos = eos::grover{cold::tabulated{cold::cai_ye{}}, phase};
  const auto at = eos::ambient_state(eos, 293);
  return start{eos, initial_state{at.density, at.energy}};
}
inline auto mixed() { return grover_ambient(phase::mixed{}); }
inline auto helm() { return grover_ambient(phase::helm{}); }
/// From the cold state: its melting jump makes the Hugoniot from 293 K multi-valued near 80 to 90 GPa.
inline auto paper() {
  auto eos = eos::grover{cold::tabulated{cold::cai_ye{}}, phase::paper{}};
  return start{eos, initial_state{eos.reference_density(), 0}};
}

/// Means over the sampled particles, and the scatter of p (standard deviation over the mean).
struct sampled {
  int n = 0;
  double p = 0, rho = 0, e = 0, temperature = 0, up = 0, us = 0, p_scatter = 0, v_scatter = 0;
  double drift = 0;
};

/// Right-going front: where the axial velocity falls through half of up, among particles of |r| < width.
template <class Solver> double front_position(const Solver& sim, double up, double width) {
  constexpr int axis = Solver::dim - 1;
  std::vector<std::pair<double, double>> zv;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (Solver::dim == 1 || p.template get<field::position>(0)[i] < width)
        zv.emplace_back(p.template get<field::position>(axis)[i], p.template get<field::velocity>(axis)[i]);
  });
  std::sort(zv.begin(), zv.end());
  // mean velocity in bins of half a cell, walked from the quiet end
  const double bin = cell / 2;
  std::vector<double> sum, count;
  const double z0 = zv.front().first;
  for (const auto& [z, v] : zv) {
    const auto b = static_cast<std::size_t>((z - z0) / bin);
    if (b >= sum.size()) sum.resize(b + 1, 0), count.resize(b + 1, 0);
    sum[b] += v, count[b] += 1;
  }
  double ahead_z = 0, ahead_v = 0;
  bool have = false;
  for (std::size_t b = sum.size(); b-- > 0;) {
    if (count[b] == 0) continue;
    const double z = z0 + (static_cast<double>(b) + 0.5) * bin, v = sum[b] / count[b];
    if (have && v >= up / 2) return ahead_z + (z - ahead_z) * (up / 2 - ahead_v) / (v - ahead_v);
    ahead_z = z, ahead_v = v, have = true;
  }
  return std::nan("");
}

/// Samples between the fronts at the solver's time.
template <class Solver> sampled sample(Solver& sim, const analysis::shock_state& exact, double width) {
  constexpr int axis = Solver::dim - 1;
  const double t = sim.time(), interface = exact.particle_speed * t, reach = (exact.shock_speed - exact.particle_speed) * t, away = std::min(10 * cell, 0.3 * reach);
  sampled s;
  double p2 = 0, v2 = 0;
  sim.for_each_body([&](const auto& set) {
    const auto& p = set.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (Solver::dim == 2 && p.template get<field::position>(0)[i] > width) continue;
      const double z = p.template get<field::position>(axis)[i], d = std::abs(z - interface);
      if (d < away || d > reach - away) continue;
      const double pr = p.template get<field::pressure>()[i], v = p.template get<field::velocity>(axis)[i];
      ++s.n;
      s.p += pr, p2 += pr * pr;
      s.up += v, v2 += v * v;
      s.rho += p.template get<field::mass>()[i] / p.template get<field::volume>()[i];
      s.e += p.template get<field::energy>()[i];
      s.temperature += set.material.thermodynamics(p, i).temperature;
    }
  });
  for (double* x : {&s.p, &s.rho, &s.e, &s.temperature, &s.up}) *x /= s.n;
  s.p_scatter = std::sqrt(std::max(0.0, p2 / s.n - s.p * s.p)) / s.p;
  s.v_scatter = std::sqrt(std::max(0.0, v2 / s.n - s.up * s.up));
  return s;
}

template <class Solver> sampled run_flyer(Solver& sim, const analysis::shock_state& exact, double until, double width) {
  sim.run(0.5 * until);
  const double early = front_position(sim, exact.particle_speed, width), t = sim.time();
  sim.run(until);
  const double us = (front_position(sim, exact.particle_speed, width) - early) / (sim.time() - t);
  sampled s = sample(sim, exact, width);
  s.us = us;
  s.drift = sim.energies().drift();
  return s;
}

template <class Start> analysis::shock_state exact_shock(const Start& at) {
  return analysis::hugoniot(at.eos, at.state.density, at.state.energy, at.eos.evaluate(at.state.density, at.state.energy).pressure, at.speed / 2);
}

/// 1-D: slabs of 8 mm, 80 cells of two particles each.
template <class Method, class Start, class Viscosity = viscosity::bulk> sampled flyer_1d(const Start& at, Viscosity q = Viscosity(), typename Method::transfer_type transfer = typename Method::transfer_type()) {
  using point = vec<double, 1>;
  const material al{at.eos, strength::none{}, failure::none{}, q};
  const body flyer{"flyer", box{point{-8 * mm}, point{0}}, al, cell / 2, at.state, point{at.speed}};
  const body plate{"plate", box{point{0}, point{8 * mm}}, al, cell / 2, at.state};
  solver sim{space::planar_1d{}, grid::sparse{cell}, typename Method::shape_type{}, transfer, typename Method::scheme_type{}, one_thread<typename Method::scalar>(), flyer, plate};
  if (at.wall) sim.add(grid::mirror{0, 8 * mm, false});
  return run_flyer(sim, exact_shock(at), at.until, 0);
}

/// r-z: discs of 8 mm between the axis and a slip wall at r = 0.8 mm: plane waves, with the hoop terms, the axis and the wall at work.
template <class Method, class Start, class Viscosity = viscosity::bulk> sampled flyer_rz(const Start& at, Viscosity q = Viscosity(), typename Method::transfer_type transfer = typename Method::transfer_type()) {
  using point = vec<double, 2>;
  const double radius = 0.8 * mm;
  const material al{at.eos, strength::none{}, failure::none{}, q};
  const body flyer{"flyer", box{point{0, -8 * mm}, point{radius, 0}}, al, cell / 2, at.state, point{0, impact_speed}};
  const body plate{"plate", box{point{0, 0}, point{radius, 8 * mm}}, al, cell / 2, at.state};
  solver sim{space::axisymmetric{}, grid::sparse{cell}, typename Method::shape_type{}, transfer, typename Method::scheme_type{}, one_thread<typename Method::scalar>(), flyer, plate};
  sim.add(grid::mirror{0, radius, false});
  return run_flyer(sim, exact_shock(at), 0.72 * us, 2 * radius);
}

/// One line of the table in docs/validation.md: errors in percent, scatter of p in percent and of v in m/s, drift of total energy.
inline void report(const std::string& eos, const char* space, const std::string& method, const sampled& s, const analysis::shock_state& x) {
  const auto percent = [](double a, double b) { return 100 * (a / b - 1); };
  std::printf("| %s | %s | %s | %+.2f | %+.2f | %+.2f | %+.2f | %+.2f | %.1f | %.0f | %.0e |\n", eos.c_str(), space, method.c_str(), percent(s.p, x.pressure),
              percent(s.rho, x.density), percent(s.us, x.shock_speed), percent(s.e, x.energy), percent(s.temperature, x.temperature), 100 * s.p_scatter, s.v_scatter, s.drift);
}

inline constexpr const char* velocity_noise = "FLIP keeps velocity noise behind the shock (some 250 m/s): pressure, energy and temperature are reported only";

/// Rows of the verification table: what near_exact asks, or less where a bound is given.
template <class Method> void record_flyer(const std::string& eos, const char* space, const sampled& s, const analysis::shock_state& x, double bound = 0.01, const std::string& note = "") {
  const auto one = [&](const char* what, double value, double asked) {
    record({.section = "shocks", .problem = "plate impact, " + eos, .composition = std::string(space) + ", " + Method::name(), .measure = what, .value = value, .bound = asked, .note = note});
  };
  one("density behind the shock", s.rho / x.density - 1, bound);
  one("shock speed", s.us / x.shock_speed - 1, bound);
  one("pressure behind the shock", s.p / x.pressure - 1, bound <= 0.01 ? bound : none);
  one("energy behind the shock", s.e / x.energy - 1, bound <= 0.01 ? bound : none);
  if (!std::isnan(x.temperature)) one("temperature behind the shock", s.temperature / x.temperature - 1, bound <= 0.01 ? 0.025 : none);
}

/// The bars of the default composition; `least`: more particles than this were sampled.
inline void near_exact(const sampled& s, const analysis::shock_state& x, int least) {
  ASSERT_GT(s.n, least);
  EXPECT_NEAR(s.p / x.pressure, 1, 0.01);
  EXPECT_NEAR(s.rho / x.density, 1, 0.01);
  EXPECT_NEAR(s.us / x.shock_speed, 1, 0.01);
  EXPECT_NEAR(s.e / x.energy, 1, 0.01);
  if (!std::isnan(x.temperature)) {
    EXPECT_NEAR(s.temperature / x.temperature, 1, 0.025);
  }
  EXPECT_LT(s.p_scatter, 0.05);
}

/// The default composition in an equation of state, in 1-D and in r-z.
using standard = bspline_apic_usf;
template <class Start> void verify_flyer_1d(const std::string& name, const Start& at, int least = 100) {
  const auto x = exact_shock(at);
  const auto s = flyer_1d<standard>(at);
  report(name, "1-D", standard::name(), s, x);
  record_flyer<standard>(name, "planar_1d", s, x);
  near_exact(s, x, least);
}
template <class Start> void verify_flyer_rz(const std::string& name, const Start& at) {
  const auto x = exact_shock(at);
  const auto s = flyer_rz<standard>(at);
  report(name, "r-z", standard::name(), s, x);
  record_flyer<standard>(name, "axisymmetric", s, x);
  near_exact(s, x, 1000);
}

/// Every method in Mie-Grueneisen: bars for what all of them hold.
inline void holds_for_every_method(const sampled& s, const analysis::shock_state& x) {
  EXPECT_NEAR(s.rho / x.density, 1, 0.02);
  EXPECT_NEAR(s.us / x.shock_speed, 1, 0.02);
  EXPECT_LT(std::abs(s.drift), 1e-12);
}
template <class Method> void verify_method_1d() {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_1d<Method>(at);
  report("mie-gruneisen", "1-D", Method::name(), s, x);
  if (Method::name() != standard::name()) record_flyer<Method>("mie-gruneisen", "planar_1d", s, x, 0.02, Method::transfer_type::affine ? "" : velocity_noise);
  holds_for_every_method(s, x);
}
template <class Method> void verify_method_rz() {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_rz<Method>(at);
  report("mie-gruneisen", "r-z", Method::name(), s, x);
  holds_for_every_method(s, x);
}

/// Without artificial viscosity FLIP makes no entropy: a test of the shock must be able to fail.
template <class Method> void misses_without_viscosity_1d() {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_1d<Method>(at, viscosity::none{});
  report("mie-gruneisen, no viscosity", "1-D", Method::name(), s, x);
  const double off_T = std::abs(s.temperature / x.temperature - 1), off_e = std::abs(s.e / x.energy - 1);
  if constexpr (!Method::transfer_type::affine) {
    EXPECT_GT(std::max(off_T / 0.025, off_e / 0.01), 2);
  }
}

} // namespace bolide::verify
