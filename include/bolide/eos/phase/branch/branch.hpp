// SPDX-License-Identifier: MIT
// The common form of the branches of Grover's model. Every one of them is, at a given volume,
//
//   e_k       = b T + G T^2/2 + q,   q = T_m k - s T^2/(2 T_m)          lattice or gas, electrons, melting and anharmonic energy
//   p - p_c   = [ pi T + ge G T^2/2 + lambda q ] / V
//
//              solid     liquid        hot liquid        gas
//   b          3R        3R            3/2 R             3/2 R
//   s          0         al            0                 0
//   k          0         dS - al/2     K                 0
//   pi         3R gamma  3R gamma      R                 R             (hot: (2 gamma - lambda) 3/2 R = R)
//   G          G         G             G                 0
//
// Temperature is the root of A T^2/2 + b T = C, A = G - s/T_m, C = e_k - T_m k, taken as T = 2C/(b + D), D = sqrt(b^2 + 2AC), which
// holds for either sign of A; D is the heat capacity there. Where C < 0 (e_k < 0 in the solid and the gas) a branch goes on with
// G = 0: in the solid and the gas T = C/b, linear and C1 at 0, and a T <= 0 is reported as it is.
// D is kept >= 1e-6 b (reached only by a liquid branch that is called far outside its region).
// The mixed phase has T = T_m and q = e_k - E_ms on top of the solid's b and pi: only who gives T, q and their slopes differs.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/concepts/phase_solver.hpp"
#include "bolide/eos/phase/isochore.hpp"

namespace bolide::phase::branch {

/// The coefficients of the table above.
template <class V> struct coefficients {
  V heat, curvature, latent, electron, lattice, lattice_slope; // b, s/T_m, k, G, pi, x dpi/dx
};

template <class V> struct root {
  V temperature, inverse_capacity; // K, kg K/J
};

/// Temperature and heat capacity at thermal energy e_k. Sets c.electron to 0 where the temperature is below 0.
template <class V> BOLIDE_INLINE root<V> solve(coefficients<V>& c, const isochore<V>& v, V e_k) {
  using T = scalar_t<V>;
  const V C = e_k - v.melting * c.latent;
  c.electron = select(C < V(T(0)), V(T(0)), c.electron);
  const V A = c.electron - c.curvature, b2 = c.heat * c.heat;
  const V D = sqrt(max(b2 + T(2) * A * C, T(1e-12) * b2)), sum = c.heat + D;
  const V r = V(T(1)) / (D * sum); // one division for 1/sum and 1/D
  return {T(2) * C * D * r, sum * r};
}

/// e_k at a temperature: the inverse of solve.
template <class V> BOLIDE_INLINE V energy(const coefficients<V>& c, const isochore<V>& v, V temperature) {
  using T = scalar_t<V>;
  const V A = select(temperature < V(T(0)), V(T(0)), c.electron) - c.curvature;
  return temperature * (c.heat + T(0.5) * A * temperature) + v.melting * c.latent;
}

/// The part of an answer that all branches and the mixed phase share.
/// q_slope and t_slope are V d/dV of q and of T at constant e_k; pressure_energy is V dp/de.
template <class V>
BOLIDE_INLINE phase_point<V> close(const coefficients<V>& c, const isochore<V>& v, scalar_t<V> ge, V temperature, V q, V q_slope, V t_slope,
                                   V pressure_temperature, V pressure_energy, V temperature_energy, V melt_fraction, V where) {
  using T = scalar_t<V>;
  const V electrons = T(0.5) * c.electron * temperature * temperature, lambda = v.lambda();
  const V pv = c.lattice * temperature + ge * electrons + lambda * q;
  const V slope = c.lattice_slope * temperature + ge * v.electron_power * electrons + v.lambda_slope() * q - pv + lambda * q_slope +
                  pressure_temperature * t_slope;
  return {pv * v.density, pressure_energy * v.density, slope * v.density * v.density, temperature, v.melting, melt_fraction, where, temperature_energy};
}

/// V dp/dT at constant V.
template <class V> BOLIDE_INLINE V pressure_slope(const coefficients<V>& c, const isochore<V>& v, scalar_t<V> ge, V temperature) {
  return c.lattice + ge * c.electron * temperature - v.lambda() * c.curvature * temperature;
}

/// Everything at thermal energy e_k, for any branch but the mixed one.
template <class V>
BOLIDE_INLINE phase_point<V> evaluate(coefficients<V> c, const isochore<V>& v, scalar_t<V> ge, V e_k, V melt_fraction, V where) {
  using T = scalar_t<V>;
  const root<V> r = solve(c, v, e_k);
  const V t = r.temperature, bend = T(0.5) * c.curvature * t * t;
  const V q = v.melting * c.latent - bend, q_slope_t = -v.lambda() * (v.melting * c.latent + bend); // V dq/dV at constant T
  const V e_slope = T(0.5) * v.electron_power * c.electron * t * t + q_slope_t;                     // V de_k/dV at constant T
  const V p_t = pressure_slope(c, v, ge, t), inverse = r.inverse_capacity;
  return close(c, v, ge, t, q, q_slope_t, -e_slope * inverse, p_t, p_t * inverse, inverse, melt_fraction, where);
}

} // namespace bolide::phase::branch
