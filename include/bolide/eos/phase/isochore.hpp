// SPDX-License-Identifier: MIT
// What the phase model needs to know of a volume: Grueneisen coefficient, melting temperature, electronic coefficient.
//
// Two volume laws share the branches, V = specific volume, x = V/V0, lambda = 2 gamma - 2/3 = -d ln T_m/d ln V (Lindemann):
//   published  gamma = g0 - a (1 - x),  T_m = Tm0 exp[2a(1-x)] x^(-2(g0-a-1/3)),  G constant
//   helmholtz  the same for x <= 1; for x > 1 gamma = 2/3 + A/x^2 + B/x^4 (C1 at x = 1, an ideal gas at the end),
//              T_m = Tm0 x^(-2/3) exp[-A (1 - x^-2) - (B/2)(1 - x^-4)],  G = G0 x^ge everywhere
// Cost: one log and one exp; helmholtz one exp and one division more.
// Guard: the exponent of T_m is kept above -80 (T_m > 2e-32 K), so that T/T_m is finite in float and for any expansion.
#pragma once

#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/phase/grover_parameters.hpp"

namespace bolide::phase {

template <class V> struct isochore {
  V density;              // kg/m3, 1/V
  V gamma;                // Grueneisen coefficient of the lattice
  V gamma_slope;          // x dgamma/dx
  V melting;              // T_m, K
  V electron;             // G(x), J/(kg K2)
  scalar_t<V> electron_power; // d ln G/d ln V

  BOLIDE_INLINE V lambda() const { return V(scalar_t<V>(2)) * gamma - scalar_t<V>(2.0 / 3.0); }
  BOLIDE_INLINE V lambda_slope() const { return V(scalar_t<V>(2)) * gamma_slope; }
};

inline constexpr double lowest_melting_exponent = -80;

/// The paper's volume law.
struct published {
  template <class V> static BOLIDE_INLINE isochore<V> at(const grover_parameters& q, V x, V density) {
    using T = scalar_t<V>;
    const V exponent = T(2 * q.a) * (V(T(1)) - x) - T(2 * (q.g0 - q.a - 1.0 / 3.0)) * log(x);
    return {density,      V(T(q.g0 - q.a)) + T(q.a) * x,
            T(q.a) * x,   T(q.Tm0) * exp(max(exponent, V(T(lowest_melting_exponent)))), V(T(q.G)), T(0)};
  }
};

/// The volume law of one free energy, sound in expansion.
struct helmholtz {
  template <class V> static BOLIDE_INLINE isochore<V> at(const grover_parameters& q, V x, V density) {
    using T = scalar_t<V>;
    const T B = T(-0.5 * (q.a + 2 * (q.g0 - 2.0 / 3.0))), A = T(q.g0 - 2.0 / 3.0) - B;
    const V log_x = log(x), u = V(T(1)) / (x * x), one(T(1));
    const auto expanded = x > one;
    const V gamma = select(expanded, V(T(2.0 / 3.0)) + u * (A + B * u), V(T(q.g0 - q.a)) + T(q.a) * x);
    const V slope = select(expanded, -u * (T(2) * A + T(4) * B * u), T(q.a) * x);
    const V exponent = select(expanded, -T(2.0 / 3.0) * log_x - (one - u) * (A + T(0.5) * B * (one + u)),
                              T(2 * q.a) * (one - x) - T(2 * (q.g0 - q.a - 1.0 / 3.0)) * log_x);
    return {density, gamma, slope, T(q.Tm0) * exp(max(exponent, V(T(lowest_melting_exponent)))), T(q.G) * exp(T(q.ge) * log_x), T(q.ge)};
  }
};

} // namespace bolide::phase
