// SPDX-License-Identifier: MIT
// The end of the release isentrope from a compressed state down to a pressure (0 by default): residual energy and free-surface speed.
// Followed as in isentrope.hpp (release() there gives the curve itself). The end is met by a bracketed root on the length of the last
// step. Stops with bad_parameter where c^2 is not positive, or where the pressure never falls to p_end (a gas and p_end = 0).
#pragma once

#include "bolide/analysis/isentrope.hpp"

#include <cmath>

namespace bolide::analysis {

struct released_state {
  double density;       // kg/m3
  double energy;        // J/kg
  double pressure;      // Pa
  double temperature;   // K; NaN where the model knows none
  double melt_fraction; // 0 where the model knows none
  double speed_gain;    // m/s, integral of dp/(rho c): a free surface moves at up + speed_gain
  int steps;
};

/// Expands (rho, e) isentropically to pressure p_end.
template <class Eos> released_state release_isentrope(const Eos& eos, double rho, double e, double p_end = 0) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::release_isentrope needs an EquationOfState.");
  const double p = eos.evaluate(rho, e).pressure;
  require(p > p_end, "pressure at the start of a release", p, "above the end pressure", "Pa");
  const auto above = [&](const detail::isentrope_point& a) { return detail::pressure_at(eos, a) - p_end; };
  const auto arrival = detail::follow_isentrope(eos, rho, e, true, above);
  const auto s = detail::isentrope_state_at(eos, arrival.point, 0);
  require(arrival.end != isentrope_end::unstable, "density on the isentrope", s.density,
          "where the equation of state is stable (c^2 > 0) until the end is reached", "kg/m3");
  require(arrival.end != isentrope_end::density_limit, "end pressure of a release", p_end,
          "one that the isentrope reaches (a gas comes to p = 0 only in vacuum)", "Pa");
  return {s.density, s.energy, s.pressure, s.temperature, s.melt_fraction, s.particle_speed, arrival.steps};
}

} // namespace bolide::analysis
