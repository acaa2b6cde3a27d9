// SPDX-License-Identifier: MIT
// The exact solution of Riemann's problem for any equations of state, the same or different ones left and right of x = 0.
//
//   riemann(eosL, {rho, u, p}, eosR, {rho, u, p})  ->  p*, u*, the two waves, a status;   sample(x/t) -> {rho, u, p, e}
// Shocks by the jump conditions, rarefactions by the isentrope's ODE, the contact by a bracketed root (analysis/wave.hpp: assumptions,
// cost, what "not_convex" means). p gives e by eos::energy_at_pressure.
// Vacuum: between the tails of the two waves sample() gives density and pressure 0, velocity and energy NaN.
// Accuracy: 1e-10 in the star state of gases; a fan costs one step of the isentrope per sample.
#pragma once

#include "bolide/analysis/wave.hpp"
#include "bolide/eos/inverse.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace bolide::analysis {

struct flow_state {
  double density;  // kg/m3
  double velocity; // m/s
  double pressure; // Pa
};

struct flow_sample {
  double density;  // kg/m3; 0 in a vacuum
  double velocity; // m/s; NaN in a vacuum
  double pressure; // Pa; 0 in a vacuum
  double energy;   // J/kg; NaN in a vacuum
};

/// The solution. Holds copies of both equations of state.
template <class L, class R> class riemann_solution {
public:
  riemann_solution(wave_curve<L> left, double u_left, wave_curve<R> right, double u_right)
      : left_(std::move(left)), right_(std::move(right)), u_left_(u_left), u_right_(u_right), star_(meet(left_, u_left, right_, u_right)) {}

  wave_status status() const { return star_.status; }
  const std::string& message() const { return star_.message; }
  double star_pressure() const { return star_.pressure; } // Pa
  double star_velocity() const { return star_.velocity; } // m/s
  const wave& left() const { return star_.left; }         // kind, edges' speeds, state between it and the contact
  const wave& right() const { return star_.right; }

  /// The state on the ray x/t (m/s). All NaN where there is no solution.
  flow_sample sample(double x_over_t) const {
    if (star_.status == wave_status::no_solution || std::isnan(x_over_t)) return {std::nan(""), std::nan(""), std::nan(""), std::nan("")};
    const bool gap = star_.status == wave_status::vacuum;
    if (x_over_t <= (gap ? star_.left.velocity : star_.velocity)) return side(left_, star_.left, -1, u_left_, x_over_t);
    if (!gap || x_over_t >= star_.right.velocity) return side(right_, star_.right, 1, u_right_, x_over_t);
    return {0, std::nan(""), 0, std::nan("")};
  }

private:
  /// One side, sign = the direction in which its wave runs.
  template <class Eos> flow_sample side(const wave_curve<Eos>& curve, const wave& w, double sign, double u, double x_over_t) const {
    if (sign * (x_over_t - w.head) >= 0) return {curve.density(), u, curve.pressure(), curve.energy()};
    if (w.kind != wave_kind::rarefaction || sign * (x_over_t - w.tail) <= 0) return {w.density, w.velocity, w.pressure, w.energy};
    const auto a = curve.at_characteristic(sign * (x_over_t - u));
    return {std::exp(-a.y), u - sign * a.u, detail::pressure_at(curve.eos(), a), a.e};
  }

  wave_curve<L> left_;
  wave_curve<R> right_;
  double u_left_, u_right_;
  meeting star_;
};

namespace detail {
/// e of pressure p at density rho. Throws bad_parameter where there is none.
template <class Eos> double energy_of(const Eos& eos, const flow_state& s, const char* where) {
  require(s.density > 0, std::string("density on the ") + where, s.density, "> 0", "kg/m3");
  const auto found = eos::energy_at_pressure(eos, s.density, s.pressure);
  require(found.what == eos::status::ok, std::string("pressure on the ") + where, s.pressure,
          std::string("one that the equation of state has at density ") + to_text(s.density) + " kg/m3 (answer: " + eos::name(found.what) + ")",
          "Pa");
  return found.value;
}
} // namespace detail

/// Two uniform states meet at x = 0, t = 0. Throws bad_parameter where a state does not exist or is unstable (c^2 <= 0).
template <class L, class R>
riemann_solution<L, R> riemann(const L& left_eos, const flow_state& left, const R& right_eos, const flow_state& right) {
  static_assert(EquationOfState<L> && EquationOfState<R>, "bolide: analysis::riemann needs an EquationOfState on either side.");
  require(std::isfinite(left.velocity), "velocity on the left", left.velocity, "finite", "m/s");
  require(std::isfinite(right.velocity), "velocity on the right", right.velocity, "finite", "m/s");
  return {wave_curve<L>(left_eos, left.density, detail::energy_of(left_eos, left, "left")), left.velocity,
          wave_curve<R>(right_eos, right.density, detail::energy_of(right_eos, right, "right")), right.velocity};
}

} // namespace bolide::analysis
