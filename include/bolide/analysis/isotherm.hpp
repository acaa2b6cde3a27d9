// SPDX-License-Identifier: MIT
// Isotherms of an equation of state with a temperature: p(rho) at constant T, and the cold isotherm (T = 0, e = e_c).
//
//   isotherm        e from eos::energy_at_temperature at each density
//   cold_isotherm   e = cold_energy: the model's own zero of thermal energy, so that no root is sought
// A point whose e was not found carries the status of the inversion and NaN; the others are not lost for it.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/inverse.hpp"

#include <cmath>
#include <vector>

namespace bolide::analysis {

struct isotherm_state {
  double density;             // kg/m3
  double energy;              // J/kg
  double pressure;            // Pa
  double sound_speed_squared; // m2/s2, the isentropic one, raw
  double melt_fraction;       // -
  double region;              // region_value
  eos::status what;           // of the inversion; ok on the cold isotherm
};

namespace detail {
template <class Eos> isotherm_state isotherm_state_at(const Eos& eos, double rho, const eos::inverse& e) {
  const double none = std::nan("");
  if (e.what != eos::status::ok) return {rho, none, none, none, none, none, e.what};
  const auto at = eos.evaluate(rho, e.value);
  return {rho, e.value, at.pressure, at.sound_speed_squared, at.melt_fraction, at.region, e.what};
}
} // namespace detail

/// p, e and the rest at temperature T (K) and the given densities, in any order.
template <class Eos> std::vector<isotherm_state> isotherm(const Eos& eos, double T, const std::vector<double>& densities) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: analysis::isotherm needs a ThermalEquationOfState.");
  require(T > 0, "temperature of an isotherm", T, "> 0 (the isotherm of 0 K is cold_isotherm)", "K");
  std::vector<isotherm_state> states;
  for (const double rho : densities) {
    require(rho > 0, "density on an isotherm", rho, "> 0", "kg/m3");
    states.push_back(detail::isotherm_state_at(eos, rho, eos::energy_at_temperature(eos, rho, T)));
  }
  return states;
}

/// The same at 0 K.
template <class Eos> std::vector<isotherm_state> cold_isotherm(const Eos& eos, const std::vector<double>& densities) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: analysis::cold_isotherm needs a ThermalEquationOfState.");
  std::vector<isotherm_state> states;
  for (const double rho : densities) {
    require(rho > 0, "density on an isotherm", rho, "> 0", "kg/m3");
    states.push_back(detail::isotherm_state_at(eos, rho, {eos.evaluate(rho, 0.0).cold_energy, eos::status::ok}));
  }
  return states;
}

} // namespace bolide::analysis
