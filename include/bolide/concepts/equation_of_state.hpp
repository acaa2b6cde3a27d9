// SPDX-License-Identifier: MIT
// The role "equation of state": what state of stress has a fluid of density rho and specific energy e?
//
// A model is an aggregate of its SI parameters with one pure function template on the lane type V (core/lane.hpp),
//     template <class V> eos_point<V> evaluate(V rho, V e) const;
// rho in kg/m3 (rho > 0), e in J/kg. A model gives what it knows: eos_point is the least; caloric_point adds dp/de; one that knows its
// temperature gives thermal_point. All is inlined, so that a member that the caller does not read costs nothing.
// The answer is raw: no floor, no cut-off, no clamp. sound_speed_squared may be negative where the surface is unstable; what a
// solver does about that is the solver's, and counted there.
//
// Invariants (the tests of every model check them)
//   c^2 = dp/drho|e + (p / rho^2) dp/de|rho                  the isentropic sound speed, raw
//   reference_density() is the density at which the model's own scale lies, > 0; used for bounds and for first guesses
// Cost: called once per particle and step; no virtual call, no exception, no allocation, branches by select().
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

/// Pressure (Pa) and isentropic sound speed squared (m2/s2, raw: may be negative).
template <class V> struct eos_point {
  V pressure;
  V sound_speed_squared;
};

/// The same with the derivative that inversions and analysis use.
template <class V> struct caloric_point {
  V pressure;
  V sound_speed_squared;
  V pressure_energy; // dp/de at constant density, kg/m3 (rho times the Grueneisen coefficient)
};

/// Where in its phase diagram a point lies. A lane carries it as a number (region_value) so that select() works on it.
enum class region { solid = 0, mixed = 1, liquid = 2, hot_liquid = 3, gas = 4 };
template <class V> constexpr scalar_t<V> region_value(region r) { return static_cast<scalar_t<V>>(static_cast<int>(r)); }
constexpr region to_region(double value) { return static_cast<region>(static_cast<int>(value + 0.5)); }
constexpr const char* name(region r) {
  constexpr const char* names[] = {"solid", "mixed", "liquid", "hot_liquid", "gas"};
  return names[static_cast<int>(r)];
}

/// All that a model with a temperature knows of a point.
template <class V> struct thermal_point {
  V pressure;            // Pa
  V sound_speed_squared; // m2/s2, raw
  V temperature;         // K
  V melting_temperature; // K, at this density
  V melt_fraction;       // 0 solid .. 1 liquid (1 in the gas)
  V cold_energy;         // J/kg, the part of e that is left at 0 K at this density
  V region;              // region_value
  V pressure_energy;     // dp/de at constant density, kg/m3
  V temperature_energy;  // dT/de at constant density, K kg/J: 1/c_v, 0 where solid and liquid coexist
};

template <class E, class V = double>
concept EquationOfState = requires(const E eos, V x) {
  { eos.evaluate(x, x).pressure } -> std::convertible_to<V>;
  { eos.evaluate(x, x).sound_speed_squared } -> std::convertible_to<V>;
  { eos.reference_density() } -> std::convertible_to<double>;
};

/// An equation of state that gives a temperature and a melting temperature beside the pressure.
template <class E, class V = double>
concept ThermalEquationOfState = EquationOfState<E, V> && requires(const E eos, V x) {
  { eos.evaluate(x, x).temperature } -> std::convertible_to<V>;
  { eos.evaluate(x, x).melting_temperature } -> std::convertible_to<V>;
  { eos.evaluate(x, x).melt_fraction } -> std::convertible_to<V>;
  { eos.evaluate(x, x).cold_energy } -> std::convertible_to<V>;
  { eos.evaluate(x, x).region } -> std::convertible_to<V>;
  { eos.evaluate(x, x).pressure_energy } -> std::convertible_to<V>;
  { eos.evaluate(x, x).temperature_energy } -> std::convertible_to<V>;
};

} // namespace bolide
