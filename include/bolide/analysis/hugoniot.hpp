// SPDX-License-Identifier: MIT
// The exact shock state behind a steady shock in any equation of state (Rankine-Hugoniot), for set-up and reference work.
//
//   rho (us - up) = rho0 us,   p = p0 + rho0 us up,   e = e0 + p0 up/(rho0 us) + up^2/2
// hugoniot() finds us for a given up: the residual p_eos(rho, e) - p is scanned from high us (weak compression) down, so that the
// LARGEST us is taken where there are several (an equation of state with jumps); a sign change at a jump is no root and is passed.
// Steps of 5e-4 in rho0/rho: two roots closer than that are not told apart.
// The material ahead is at rest in state (rho0, e0, p0).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/state.hpp"

#include <cmath>

namespace bolide::analysis {

struct shock_state {
  double particle_speed; // m/s, up
  double shock_speed;    // m/s, us
  double density;        // kg/m3
  double pressure;       // Pa
  double energy;         // J/kg
  double temperature;    // K; NaN where the model knows none
  double melt_fraction;  // 0 where the model knows none
};

namespace detail {
template <class Eos> shock_state behind(const Eos& eos, double rho0, double e0, double p0, double up, double us) {
  const double rho = rho0 * us / (us - up), e = e0 + p0 * up / (rho0 * us) + 0.5 * up * up;
  shock_state s{up, us, rho, p0 + rho0 * us * up, e, std::nan(""), 0};
  if constexpr (ThermalEquationOfState<Eos>) {
    const auto r = eos.evaluate(rho, e);
    s.temperature = r.temperature;
    s.melt_fraction = r.melt_fraction;
  }
  return s;
}
} // namespace detail

/// The shock that drives the material at rest in (rho0, e0, p0) to speed up > 0. Throws bad_parameter where there is none.
template <class Eos> shock_state hugoniot(const Eos& eos, double rho0, double e0, double p0, double up) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::hugoniot needs an EquationOfState.");
  require(rho0 > 0, "hugoniot rho0", rho0, "> 0", "kg/m3");
  require(up > 0, "hugoniot up", up, "> 0", "m/s");
  const auto residual = [&](double compression) { // of compression = up/us = 1 - rho0/rho
    const double us = up / compression, p = p0 + rho0 * us * up;
    const double e = e0 + p0 * up / (rho0 * us) + 0.5 * up * up;
    return (eos.evaluate(rho0 / (1 - compression), e).pressure - p) / (std::abs(p) + std::abs(p0) + 1);
  };
  // Weak compression: the momentum jump wins (residual < 0).
  // Geometric steps below 1 %, then even ones to a compression of 0.95.
  double low = 1e-9, f_low = residual(low);
  for (double high = low; high < 0.95;) {
    high = high < 0.005 ? high * 1.1 : high + 0.0005;
    const double f_high = residual(high);
    if (f_low < 0 && f_high >= 0) {
      const double c = eos::bracketed_root(residual, low, high);
      if (std::abs(residual(c)) < 1e-6) return detail::behind(eos, rho0, e0, p0, up, up / c);
    }
    low = high, f_low = f_high;
  }
  require(false, "hugoniot up", up, "a particle speed that the equation of state can carry (no shock with rho < 20 rho0)", "m/s");
  return {};
}

/// The same from a material state.
template <class Eos> shock_state hugoniot(const Eos& eos, const eos::material_state& ahead, double up) {
  return hugoniot(eos, ahead.density, ahead.energy, ahead.pressure, up);
}

} // namespace bolide::analysis
