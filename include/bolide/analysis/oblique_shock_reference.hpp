// SPDX-License-Identifier: MIT
// How high may the pressure be at the contact line of a curved impact? A reference for single hot points there.
//
// Two like bodies collide at closing speed U, their surfaces inclined at 2 beta to each other at the contact line. Seen from the
// symmetry plane each comes at U/2; seen from the contact line (which runs along the plane at (U/2)/tan beta) material flows in at
//     q = (U/2)/sin beta,   turned by beta onto the plane.
// While an attached oblique shock can turn it (beta small), with the normal shock relations us(up):
//     tan phi = us/t,  tan(phi - beta) = (us - up)/t,  t^2 = q^2 - us^2           p = p0 + rho0 us up  (weak solution)
// p rises from the plane value (up = U/2) with beta until no attached shock turns the flow any more: the detachment angle. From there
// on the flow jets (Walsh, Shreffler, Willig 1953); the pressure at the stagnation point of the jet is, for inflow faster than sound,
// that behind a normal shock of speed q followed by isentropic compression to rest (for slower inflow, isentropic alone), with
//     e + p/rho = e0 + p0/rho0 + q^2/2     (total enthalpy along the stagnation streamline of a steady flow),
// largest at the detachment angle, because q falls with beta.
// Assumptions: steady flow in the frame of the contact line, plane (not axisymmetric), no strength, symmetric bodies, one equation of
// state. For aluminium at 6.64 km/s: 1-D 90 GPa; see docs/eos.md for both figures.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/release_isentrope.hpp"

#include <algorithm>
#include <cmath>

namespace bolide::analysis {

struct contact_line_pressure {
  double plane;              // Pa, the 1-D impact (beta = 0)
  double detachment;         // Pa, behind the attached shock at the detachment angle
  double stagnation;         // Pa, at the jet's stagnation point just beyond that angle
  double angle;              // rad, beta at detachment (the surfaces meet at twice that)
  double inflow;             // m/s, q there
  double reference() const { return std::max(detachment, stagnation); } // Pa
};

namespace detail {
/// The largest turn (rad) that an attached shock gives to inflow of speed q, and the shock that does it.
template <class Eos> double largest_turn(const Eos& eos, const eos::material_state& ahead, double q, shock_state& best) {
  const auto turn = [&](double up, shock_state& s) {
    s = hugoniot(eos, ahead, up);
    const double t2 = q * q - s.shock_speed * s.shock_speed;
    if (t2 <= 0) return 0.0;
    const double t = std::sqrt(t2);
    return std::atan(s.shock_speed / t) - std::atan((s.shock_speed - up) / t);
  };
  // Golden section on up: the turn rises from 0 and falls to 0 where the shock is normal to the flow.
  const double ratio = 0.5 * (std::sqrt(5.0) - 1);
  shock_state s{};
  double low = 1e-3 * q, high = q;
  double a = high - ratio * (high - low), b = low + ratio * (high - low), fa = turn(a, s), fb = turn(b, s);
  for (int i = 0; i < 60; ++i) {
    if (fa < fb || (fa == 0 && fb == 0 && a > 0.9 * q)) {
      low = a, a = b, fa = fb, b = low + ratio * (high - low), fb = turn(b, s);
    } else {
      high = b, b = a, fb = fa, a = high - ratio * (high - low), fa = turn(a, s);
    }
  }
  return turn(0.5 * (low + high), best);
}

/// Pressure where inflow of speed q comes to rest.
template <class Eos> double stagnation_pressure(const Eos& eos, const eos::material_state& ahead, double q) {
  const double goal = ahead.energy + ahead.pressure / ahead.density + 0.5 * q * q;
  double rho = ahead.density, e = ahead.energy;
  if (q > 1.001 * ahead.sound_speed) { // the normal shock of speed q: us rises with up
    const auto excess = [&](double up) { return hugoniot(eos, ahead, up).shock_speed - q; };
    double low = 1e-4 * q;
    if (excess(low) < 0) {
      const shock_state s = hugoniot(eos, ahead, eos::bracketed_root(excess, low, q));
      rho = s.density, e = s.energy;
    }
  }
  const auto missing = [&](const isentrope_point& a) { return goal - a.e - pressure_at(eos, a) * std::exp(a.y); };
  const isentrope_arrival arrival = follow_isentrope(eos, rho, e, false, missing);
  require(arrival.end == isentrope_end::reached, "density on the isentrope of a stagnation streamline", std::exp(-arrival.point.y),
          "where the equation of state is stable (c^2 > 0) until the flow is at rest", "kg/m3");
  return pressure_at(eos, arrival.point);
}
} // namespace detail

/// The reference for bodies of one material that meet at closing speed U (m/s).
template <class Eos> contact_line_pressure oblique_shock_reference(const Eos& eos, const eos::material_state& ahead, double U) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::oblique_shock_reference needs an EquationOfState.");
  require(U > 0, "impact speed", U, "> 0", "m/s");
  contact_line_pressure r{};
  r.plane = hugoniot(eos, ahead, 0.5 * U).pressure;
  // At angle beta the inflow is (U/2)/sin beta; it is attached while that can be turned by beta.
  shock_state s{};
  const auto spare = [&](double beta) { return detail::largest_turn(eos, ahead, 0.5 * U / std::sin(beta), s) - beta; };
  double low = 0.02, high = 0.02;
  while (high < 1.5 && spare(high) > 0) low = high, high += 0.02;
  require(high > low && high < 1.5, "impact speed", U, "fast enough for an attached oblique shock", "m/s");
  r.angle = eos::bracketed_root(spare, low, high);
  spare(r.angle);
  r.inflow = 0.5 * U / std::sin(r.angle);
  r.detachment = s.pressure;
  r.stagnation = detail::stagnation_pressure(eos, ahead, r.inflow);
  return r;
}

} // namespace bolide::analysis
