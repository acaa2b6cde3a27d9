// SPDX-License-Identifier: MIT
// Initial states of a material: cold_state(eos) and ambient_state(eos, T0). Set-up work, any equation of state.
//
//   cold_state     the scale point itself: reference density, e = 0. For eos::grover 0 K and x = 1 (p is p_c(1), a few MPa, not 0).
//   ambient_state  p = 0 at T = T0 on the model's own surface, the density nearest to the reference density (eos/inverse.hpp). A model
//                  without a temperature: p(rho, e = 0) = 0.
//   scaled_to      the model wrapped in eos::scaled_density so that its ambient density is the one wanted.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/inverse.hpp"
#include "bolide/eos/scaled_density.hpp"

#include <cmath>

namespace bolide::eos {

struct material_state {
  double density;     // kg/m3
  double energy;      // J/kg
  double temperature; // K; NaN where the model knows none
  double pressure;    // Pa
  double sound_speed; // m/s
};

/// The state at (rho, e). Throws bad_parameter where c^2 is not positive.
template <class Eos> material_state state_at(const Eos& eos, double rho, double e) {
  const auto r = eos.evaluate(rho, e);
  require(r.sound_speed_squared > 0, "sound speed squared of a material state", r.sound_speed_squared,
          "> 0 (the model is stable there)", "m2/s2");
  double temperature = std::nan("");
  if constexpr (ThermalEquationOfState<Eos>) temperature = r.temperature;
  return {rho, e, temperature, r.pressure, std::sqrt(r.sound_speed_squared)};
}

template <class Eos> material_state cold_state(const Eos& eos) { return state_at(eos, eos.reference_density(), 0.0); }

/// p = 0 at temperature T0 (K). A model without a temperature ignores T0: p = 0 at e = 0. Throws bad_parameter where there is none.
template <class Eos> material_state ambient_state(const Eos& eos, double T0 = 293) {
  require(T0 > 0 && T0 < 1e5, "ambient temperature", T0, "between 0 and 1e5", "K");
  const double rho0 = eos.reference_density();
  const auto near = [rho0](double rho) { return rho >= 0.6 * rho0 && rho <= 1.6 * rho0; };
  double rho, e = 0;
  if constexpr (ThermalEquationOfState<Eos>) {
    rho = density_at_pressure_temperature(eos, 0.0, T0, rho0).value;
    require(near(rho), "ambient temperature", T0,
            "one at which the equation of state has p = 0 between 0.6 and 1.6 times its reference density", "K");
    e = energy_at_temperature(eos, rho, T0).value;
  } else {
    rho = density_at_pressure_energy(eos, 0.0, 0.0, rho0).value;
    require(near(rho), "reference density", rho0, "within a factor 0.6 to 1.6 of a density with p = 0 at e = 0", "kg/m3");
  }
  return state_at(eos, rho, e);
}

/// The model with its density scaled so that p = 0 at T0 lies at `density`.
template <class Eos> scaled_density<Eos> scaled_to(const Eos& eos, double density, double T0 = 293) {
  require(density > 0, "density at ambient", density, "> 0", "kg/m3");
  return {eos, density / ambient_state(eos, T0).density};
}

} // namespace bolide::eos
