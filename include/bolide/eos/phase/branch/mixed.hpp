// SPDX-License-Identifier: MIT
// Solid and liquid side by side at one volume: the common tangent of their free energies in the entropy, hence
//   T = T_m(V),  melt fraction nu = (e_k - E_ms)/(E_m - E_ms),  p - p_c = p_solid(V, T_m) + (lambda/V)(e_k - E_ms).
// p and T are continuous at both ends; c drops at the solidus and rises at the liquidus.
#pragma once

#include "bolide/eos/phase/branch/liquid.hpp"
#include "bolide/eos/phase/branch/solid.hpp"

namespace bolide::phase::branch {

struct mixed {
  grover_parameters q;

  explicit mixed(const grover_parameters& parameters = {}) : q(parameters) { q.validate(); }

  /// E_ms and E_m: thermal energies of its two ends.
  template <class V> V begin(const isochore<V>& v) const { return solid{q}.end(v); }
  template <class V> V end(const isochore<V>& v) const { return liquid{q}.begin(v); }
  /// K: the melting temperature, whatever e_k.
  template <class V> V temperature(const isochore<V>& v, V) const { return v.melting; }
  /// Its inverse needs the melt fraction. J/kg
  template <class V> V energy(const isochore<V>& v, V melt_fraction) const {
    return begin(v) + melt_fraction * v.melting * scalar_t<V>(q.dS - q.al);
  }
  template <class V> phase_point<V> evaluate(const isochore<V>& v, V e_k) const {
    using T = scalar_t<V>;
    const coefficients<V> c = solid{q}.at(v);
    const V excess = e_k - begin(v), t = v.melting, capacity = c.heat + c.electron * t;
    const V t_slope = -v.lambda() * t; // V dT_m/dV
    const V q_slope = -(T(0.5) * v.electron_power * c.electron * t * t + capacity * t_slope); // -V dE_ms/dV
    return close(c, v, T(q.ge), t, excess, q_slope, t_slope, pressure_slope(c, v, T(q.ge), t), v.lambda(), V(T(0)),
                 excess / (v.melting * T(q.dS - q.al)), V(region_value<V>(region::mixed)));
  }
};

} // namespace bolide::phase::branch
