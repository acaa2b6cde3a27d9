// SPDX-License-Identifier: MIT
// The exact shock states behind a steady shock in any equation of state (Rankine-Hugoniot), for set-up and reference work.
//
//   rho (us - up) = rho0 us,   p = p0 + rho0 us up,   e = e0 + p0 up/(rho0 us) + up^2/2
// Particle and shock speed are relative to the material ahead, which is in state (rho0, e0, p0): at rest for the principal Hugoniot,
// shocked already for a secondary one.
//   hugoniot         the state for a given up: the LARGEST us where there are several (an equation of state with jumps)
//   hugoniot_all     every root, the largest us first
//   reshock          the secondary Hugoniot: a second shock that runs into what a first one left behind
//   reflected_shock  the second shock that brings that material to rest again (a rigid wall, or its mirror image)
// The residual p_eos(rho, e) - p is scanned from high us (weak compression) down to rho = 20 rho0; a sign change at a jump of the
// equation of state is no root and is passed. Steps of 5e-4 in rho0/rho: two roots closer than that are not told apart.
// Cost: some 800 calls of the equation of state.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/state.hpp"

#include <cmath>
#include <vector>

namespace bolide::analysis {

struct shock_state {
  double particle_speed; // m/s, up
  double shock_speed;    // m/s, us
  double density;        // kg/m3
  double pressure;       // Pa
  double energy;         // J/kg
  double temperature;    // K; NaN where the model knows none
  double melt_fraction;  // 0 where the model knows none
  double region;         // region_value; NaN where the model knows none
};

namespace detail {
template <class Eos> shock_state behind(const Eos& eos, double rho0, double e0, double p0, double up, double us) {
  const double rho = rho0 * us / (us - up), e = e0 + p0 * up / (rho0 * us) + 0.5 * up * up;
  shock_state s{up, us, rho, p0 + rho0 * us * up, e, std::nan(""), 0, std::nan("")};
  if constexpr (ThermalEquationOfState<Eos>) {
    const auto r = eos.evaluate(rho, e);
    s.temperature = r.temperature;
    s.melt_fraction = r.melt_fraction;
    s.region = r.region;
  }
  return s;
}

/// Shows `found` every root, the largest us first, until it returns false.
template <class Eos, class Found> void scan_hugoniot(const Eos& eos, double rho0, double e0, double p0, double up, const Found& found) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::hugoniot needs an EquationOfState.");
  require(rho0 > 0, "hugoniot rho0", rho0, "> 0", "kg/m3");
  require(up > 0, "hugoniot up", up, "> 0", "m/s");
  const auto residual = [&](double compression) { // of compression = up/us = 1 - rho0/rho; in units of the pressures that take part
    const double us = up / compression, jump = rho0 * us * up;
    const double e = e0 + p0 * up / (rho0 * us) + 0.5 * up * up;
    return (eos.evaluate(rho0 / (1 - compression), e).pressure - p0 - jump) / (jump + std::abs(p0));
  };
  // Weak compression: the momentum jump wins (residual < 0).
  // Geometric steps below 1 %, then even ones to a compression of 0.95.
  double low = 1e-9, f_low = residual(low);
  for (double high = low; high < 0.95;) {
    high = high < 0.005 ? high * 1.1 : high + 0.0005;
    const double f_high = residual(high);
    if ((f_low < 0) != (f_high < 0)) {
      const double c = eos::bracketed_root(residual, low, high);
      if (std::abs(residual(c)) < 1e-6 && !found(behind(eos, rho0, e0, p0, up, up / c))) return;
    }
    low = high, f_low = f_high;
  }
}
} // namespace detail

/// All shocks that drive the material in (rho0, e0, p0) to speed up > 0, the largest us first; empty where there is none.
template <class Eos> std::vector<shock_state> hugoniot_all(const Eos& eos, double rho0, double e0, double p0, double up) {
  std::vector<shock_state> all;
  detail::scan_hugoniot(eos, rho0, e0, p0, up, [&](const shock_state& s) {
    all.push_back(s);
    return true;
  });
  return all;
}

/// The shock of largest us that drives the material in (rho0, e0, p0) to speed up > 0. Throws bad_parameter where there is none.
template <class Eos> shock_state hugoniot(const Eos& eos, double rho0, double e0, double p0, double up) {
  shock_state first{};
  detail::scan_hugoniot(eos, rho0, e0, p0, up, [&](const shock_state& s) {
    first = s;
    return false;
  });
  require(first.shock_speed > 0, "hugoniot up", up, "a particle speed that the equation of state can carry (no shock with rho < 20 rho0)",
          "m/s");
  return first;
}

/// The same from a material state.
template <class Eos> shock_state hugoniot(const Eos& eos, const eos::material_state& ahead, double up) {
  return hugoniot(eos, ahead.density, ahead.energy, ahead.pressure, up);
}
template <class Eos> std::vector<shock_state> hugoniot_all(const Eos& eos, const eos::material_state& ahead, double up) {
  return hugoniot_all(eos, ahead.density, ahead.energy, ahead.pressure, up);
}

/// The secondary Hugoniot: a shock runs into what `first` left behind and changes its speed by `jump` > 0. The answer's speeds are
/// relative to that material; a shock that runs against first.particle_speed has the speed first.particle_speed - us in first's frame.
template <class Eos> shock_state reshock(const Eos& eos, const shock_state& first, double jump) {
  return hugoniot(eos, first.density, first.energy, first.pressure, jump);
}

/// `first` meets a rigid wall: the shock that runs back and stops the material.
template <class Eos> shock_state reflected_shock(const Eos& eos, const shock_state& first) {
  return reshock(eos, first, first.particle_speed);
}

} // namespace bolide::analysis
