// SPDX-License-Identifier: MIT
// The role "phase-region solver": which phase has a material of volume ratio x and thermal energy e_k, and what does the heat do?
//
// A model gives, for a lane type V,
//     template <class V> phase_point<V> evaluate(V x, V thermal_energy, V specific_volume) const;
// x = V/V0, thermal_energy = e - e_c(x) in J/kg, specific_volume in m3/kg. It knows nothing of the cold curve; the equation of state
// adds the two. Every branch (solid, mixed, liquid, hot liquid, gas) is a function of its own that can be called alone.
// Invariants: temperature inverts the branch's energy exactly; region edges as physics.md section 7 / docs/eos.md states them.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class V> struct phase_point {
  V thermal_pressure;   // p - p_c, Pa
  V pressure_energy;    // dp/de at constant V, kg/m3
  V pressure_volume;    // d(p - p_c)/dV at constant e_k, Pa kg/m3
  V temperature;        // K
  V melting_temperature; // K
  V melt_fraction;      // 0 .. 1
  V region;             // region_value
  V temperature_energy; // dT/de_k at constant V, K kg/J: 0 in a mixed phase
};

template <class P, class V = double>
concept PhaseSolver = requires(const P phase, V x) {
  { phase.evaluate(x, x, x).thermal_pressure } -> std::convertible_to<V>;
  { phase.evaluate(x, x, x).pressure_energy } -> std::convertible_to<V>;
  { phase.evaluate(x, x, x).pressure_volume } -> std::convertible_to<V>;
  { phase.evaluate(x, x, x).temperature } -> std::convertible_to<V>;
  { phase.evaluate(x, x, x).melt_fraction } -> std::convertible_to<V>;
  { phase.evaluate(x, x, x).temperature_energy } -> std::convertible_to<V>;
};

} // namespace bolide
