// SPDX-License-Identifier: MIT
// The equation of state of the paper: a cold curve plus the heat of Grover's phase regions.
//
//   x = rho0/rho,  e_k = e - e_c(x),  p = p_c(x) + p_th(x, e_k)
//   c^2 = V^2 [ p_th dp/de - dp_c/dV - dp_th/dV|e_k ]
// The last follows from c^2 = V^2 (p p_e - p_V) with de_k/dV|e = p_c. T, T_m, melt fraction and region are the phase solver's,
// cold_energy = e_c. e < e_c is answered by the phase solver's linear continuation (T <= 0). Nothing is floored.
// Stated box: density up to the table of the cold curve (an exact curve: 5 rho0) and down to 1e-6 rho0, or as far as the phase solver says
// (helm: x <= 5); e up to 200 MJ/kg (10^5 K at V0, as far as the heat terms were checked). Its lower end in energy is the cold curve.
// Composed by hand:  eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}}
// Cost: 12 to 15 ns per call with the table in pack<double, 8> (docs/eos.md).
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/concepts/phase_solver.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/validity.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace bolide::eos {

template <class Cold, class Phase> struct grover {
  static_assert(ColdCurve<Cold>, "bolide: eos::grover needs a ColdCurve first: "
                                 "evaluate(x) -> {energy, pressure, slope} and reference_density().");
  static_assert(PhaseSolver<Phase>, "bolide: eos::grover needs a PhaseSolver second: evaluate(x, e_k, V) -> phase_point.");

  Cold cold;
  Phase phase;

  explicit grover(Cold cold_curve, Phase phase_solver = {})
      : cold(std::move(cold_curve)), phase(std::move(phase_solver)), inverse_density_(1 / cold.reference_density()) {
    require(cold.reference_density() > 0, "eos::grover reference density of the cold curve", cold.reference_density(), "> 0", "kg/m3");
  }

  template <class V> BOLIDE_INLINE thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const T rho0 = static_cast<T>(cold.reference_density());
    const V volume = V(T(1)) / rho, x = rho0 * volume;
    const cold_point<V> c = cold_at(x, rho * T(inverse_density_));
    const phase_point<V> h = heat_at(x, e - c.energy, volume, rho);
    const V c2 = volume * (volume * (h.thermal_pressure * h.pressure_energy - h.pressure_volume) - x * c.slope);
    return {c.pressure + h.thermal_pressure, c2, h.temperature, h.melting_temperature, h.melt_fraction, c.energy, h.region,
            h.pressure_energy, h.temperature_energy};
  }

  double reference_density() const { return cold.reference_density(); }
  validity_box validity() const {
    const double rho0 = cold.reference_density();
    double low = 1e-6, high = 5;
    if constexpr (requires { phase.largest_volume_ratio(); }) low = 1 / phase.largest_volume_ratio();
    if constexpr (requires { cold.eta_max(); }) high = cold.eta_max();
    return {low * rho0, high * rho0, -std::numeric_limits<double>::infinity(), 2e8};
  }
  /// Where values or derivatives jump: energies (J/kg) at a density, and densities (kg/m3). A table puts its nodes there.
  std::vector<double> energy_borders(double rho) const {
    std::vector<double> borders;
    if constexpr (requires { phase.energy_borders(1.0, rho); }) {
      const double x = cold.reference_density() / rho;
      for (const double e_k : phase.energy_borders(x, rho)) borders.push_back(cold.evaluate(x).energy + e_k);
    }
    return borders;
  }
  std::vector<double> density_borders() const {
    if constexpr (requires { phase.border_volume_ratios(); }) {
      std::vector<double> borders = phase.border_volume_ratios();
      for (double& x : borders) x = cold.reference_density() / x;
      return borders;
    } else return {};
  }
  /// Where the cold curve answers by its continuation: compressed beyond the table. (e < e_c shows as temperature < 0.)
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V) const {
    using T = scalar_t<V>;
    if constexpr (requires { cold.eta_max(); }) return rho > V(T(cold.eta_max() * cold.reference_density()));
    else return rho < V(T(0));
  }

private:
  double inverse_density_; // m3/kg, V0

  // A cold curve or a phase solver may offer a cheaper door when rho/rho0 or rho is at hand already.
  template <class V> BOLIDE_INLINE cold_point<V> cold_at(V x, V eta) const {
    if constexpr (requires { cold.at_density_ratio(eta); }) return cold.at_density_ratio(eta);
    else return cold.evaluate(x);
  }
  template <class V> BOLIDE_INLINE phase_point<V> heat_at(V x, V e_k, V volume, V rho) const {
    if constexpr (requires { phase.evaluate_at_density(x, e_k, rho); }) return phase.evaluate_at_density(x, e_k, rho);
    else return phase.evaluate(x, e_k, volume);
  }
};

} // namespace bolide::eos
