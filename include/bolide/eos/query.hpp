// SPDX-License-Identifier: MIT
// All that a model knows of one point, with a status: for set-up, analysis and tables, not for the time loop (evaluate() is).
//
//   query(eos, rho, e) -> full_state
//   dp/de     the model's own, or eos::pressure_energy's central difference where it gives none
//   dp/drho|e = c^2 - p (dp/de)/rho^2        dp/dV|e = -rho^2 dp/drho|e  (V per kg)
//   c_v       = 1/(dT/de); infinite where solid and liquid coexist (T does not move with e)
//   Gamma     = (dp/de)/rho
// NaN stands for what a model has not. The numbers are the raw ones whatever the status; no floor.
// Status, the first that holds: outside_validity (box or the model's own mask), below_cold_energy (e < e_c(rho)), unstable
// (c^2 <= 0 or NaN), ok. rho <= 0 and numbers that are not finite throw bad_parameter.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/pressure_energy.hpp"
#include "bolide/eos/validity.hpp"

#include <cmath>
#include <limits>

namespace bolide::eos {

/// What became of a question. The last three are for inversions (eos/inverse.hpp).
enum class status { ok, outside_validity, below_cold_energy, unstable, no_solution, not_converged };
constexpr const char* name(status s) {
  constexpr const char* names[] = {"ok", "outside_validity", "below_cold_energy", "unstable", "no_solution", "not_converged"};
  return names[static_cast<int>(s)];
}

struct full_state {
  double pressure;            // Pa
  double temperature;         // K
  double sound_speed_squared; // m2/s2, raw
  double melting_temperature; // K, at this density
  double melt_fraction;       // 0 solid .. 1 liquid
  double cold_energy;         // J/kg
  double pressure_energy;     // dp/de at constant density, kg/m3
  double pressure_density;    // dp/drho at constant energy, m2/s2
  double pressure_volume;     // dp/dV at constant energy, Pa kg/m3
  double specific_heat;       // c_v, J/(kg K)
  double grueneisen;          // -
  double region;              // region_value
  status what;
};

/// Status of (rho, e), given what evaluate() answered there.
template <class Eos, class Point> status status_at(const Eos& eos, double rho, double e, const Point& at) {
  if (outside_of(eos, rho, e)) return status::outside_validity;
  if constexpr (requires { at.cold_energy; })
    if (e < at.cold_energy) return status::below_cold_energy;
  return at.sound_speed_squared > 0 ? status::ok : status::unstable;
}

template <class Eos> full_state query(const Eos& eos, double rho, double e) {
  static_assert(EquationOfState<Eos>, "bolide: eos::query needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");
  require(rho > 0 && std::isfinite(rho), "eos::query density", rho, "> 0 and finite", "kg/m3");
  require(std::isfinite(e), "eos::query energy", e, "finite", "J/kg");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto at = eos.evaluate(rho, e);
  full_state r{at.pressure, none, at.sound_speed_squared, none, none, none, 0, 0, 0, none, 0, none, status_at(eos, rho, e, at)};
  r.pressure_energy = pressure_energy(eos, rho, e);
  r.pressure_density = r.sound_speed_squared - r.pressure * r.pressure_energy / (rho * rho);
  r.pressure_volume = -rho * rho * r.pressure_density;
  r.grueneisen = r.pressure_energy / rho;
  if constexpr (ThermalEquationOfState<Eos>) {
    r.temperature = at.temperature;
    r.melting_temperature = at.melting_temperature;
    r.melt_fraction = at.melt_fraction;
    r.cold_energy = at.cold_energy;
    r.region = at.region;
    r.specific_heat = at.temperature_energy == 0 ? std::numeric_limits<double>::infinity() : 1 / at.temperature_energy;
  }
  return r;
}

/// The name of the branch that answers at (rho, e): the model's own branch_name(), or its region's, or "single".
template <class Eos> const char* region_name(const Eos& eos, double rho, double e) {
  if constexpr (requires { eos.branch_name(rho, e); }) return eos.branch_name(rho, e);
  else if constexpr (ThermalEquationOfState<Eos>) return bolide::name(to_region(eos.evaluate(rho, e).region));
  else return "single";
}

} // namespace bolide::eos
