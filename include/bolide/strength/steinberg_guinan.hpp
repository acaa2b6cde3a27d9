// SPDX-License-Identifier: MIT
// Steinberg, Cochran and Guinan's rate-independent law (J. Appl. Phys. 51 (1980) 1498): shear modulus and yield stress that rise with pressure
// and fall with temperature.
//   f = 1 + A p / eta^(1/3) - B (T - 300 K),   eta = rho/rho0;   f = 0 where this is negative, and at and above melting
//   G = G0 f,   Y = min(Y0 [1 + beta (eps + eps_i)]^n, Y_max) f
// A = G'_p/G0 and B = -G'_T/G0; the authors' own assumption Y'_p/Y0 = G'_p/G0 is made. The melting temperature is that of the equation of state
// at the particle's density, not the authors' (T_m0 = 1220 K for aluminium, 1790 K for copper, on their own energy scale).
// Validity: metals at strain rates above about 1e5 1/s, where the rate no longer matters; below that the yield stress is too high.
// The elastic strain is kept when G changes (material/material.hpp): at melting the elastic shear energy becomes heat.
// Parameters: Steinberg, LLNL report UCRL-MA-106439 (1991); copper compared with public input decks of hydrocodes, aluminium from memory.
// Cost: one cube root per particle and step, and a power in packs where a point yields. 8 bytes more per particle (field::shear_modulus).
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::strength {

struct steinberg_guinan {
  using particle_fields = fields<field::deviator, field::plastic_strain, field::shear_modulus>;
  static constexpr bool carries_shear = true;
  static constexpr bool wants_temperature = true;
  static constexpr const char* name = "steinberg_guinan";

  double shear_modulus;        // G0, Pa
  double yield;                // Y0, Pa
  double largest_yield;        // Y_max, Pa
  double beta;
  double n;
  double initial_strain;       // eps_i
  double pressure_factor;      // A, 1/Pa
  double temperature_factor;   // B, 1/K
  double reference_density;    // rho0, kg/m3
  double reference_temperature = 300; // K

  static steinberg_guinan aluminium_6061_t6() { return {27.6e9, 0.29e9, 0.68e9, 125, 0.10, 0, 6.52e-11, 6.16e-4, 2703}; }
  static steinberg_guinan copper() { return {47.7e9, 0.12e9, 0.64e9, 36, 0.45, 0, 2.83e-11, 3.77e-4, 8930}; }

  /// Throws bad_parameter where a parameter is outside its range.
  void validate() const {
    require(shear_modulus > 0, "Steinberg-Guinan shear modulus", shear_modulus, "positive", "Pa");
    require(yield > 0, "Steinberg-Guinan Y0", yield, "positive", "Pa");
    require(largest_yield >= yield, "Steinberg-Guinan Y_max", largest_yield, "at least Y0", "Pa");
    require(beta >= 0, "Steinberg-Guinan beta", beta, "non-negative");
    require(n >= 0 && n <= 2, "Steinberg-Guinan n", n, "in [0, 2]");
    require(initial_strain >= 0, "Steinberg-Guinan initial strain", initial_strain, "non-negative");
    require(pressure_factor >= 0, "Steinberg-Guinan pressure factor", pressure_factor, "non-negative", "1/Pa");
    require(temperature_factor >= 0, "Steinberg-Guinan temperature factor", temperature_factor, "non-negative", "1/K");
    require(reference_density > 0, "Steinberg-Guinan reference density", reference_density, "positive", "kg/m3");
    require(reference_temperature >= 0, "Steinberg-Guinan reference temperature", reference_temperature, "non-negative", "K");
  }

  /// f: the state's part of G and of Y.
  template <class V> BOLIDE_INLINE V state_factor(V pressure, V density, V temperature, V melting) const {
    using T = scalar_t<V>;
    const V f = T(1) + T(pressure_factor) * pressure * cbrt(T(reference_density) / density) - T(temperature_factor) * (temperature - T(reference_temperature));
    return select(temperature >= melting, V(T(0)), max(f, V(T(0))));
  }
  template <class V> BOLIDE_INLINE V shear_modulus_at(V pressure, V density, V temperature, V melting) const {
    return scalar_t<V>(shear_modulus) * state_factor(pressure, density, temperature, melting);
  }
  template <class V> BOLIDE_INLINE V yield_floor(V temperature, V melting, V pressure, V density) const {
    return scalar_t<V>(yield) * state_factor(pressure, density, temperature, melting);
  }
  template <class V> BOLIDE_INLINE V yield_stress(V plastic_strain, V, V temperature, V melting, V pressure, V density) const {
    using T = scalar_t<V>;
    const V hardened = T(yield) * pow(T(1) + T(beta) * (plastic_strain + T(initial_strain)), V(T(n)));
    return min(hardened, V(T(largest_yield))) * state_factor(pressure, density, temperature, melting);
  }
};

} // namespace bolide::strength
