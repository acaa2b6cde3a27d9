// SPDX-License-Identifier: MIT
// The solid branch:  e_k = 3RT + G T^2/2,  p - p_c = [3R gamma T + ge G T^2/2]/V.
// Ends at the solidus energy E_ms = 3R T_m + G T_m^2/2. (The paper goes on with it to the liquidus, superheated to 1.32 T_m.)
#pragma once

#include "bolide/eos/phase/branch/branch.hpp"

namespace bolide::phase::branch {

struct solid {
  grover_parameters q;

  explicit solid(const grover_parameters& parameters = {}) : q(parameters) { q.validate(); }

  template <class V> BOLIDE_INLINE coefficients<V> at(const isochore<V>& v) const {
    using T = scalar_t<V>;
    return {V(T(3 * q.R)), V(T(0)), V(T(0)), v.electron, T(3 * q.R) * v.gamma, T(3 * q.R) * v.gamma_slope};
  }
  /// K, at thermal energy e_k (J/kg).
  template <class V> V temperature(const isochore<V>& v, V e_k) const {
    coefficients<V> c = at(v);
    return solve(c, v, e_k).temperature;
  }
  /// e_k (J/kg) at a temperature: the inverse.
  template <class V> V energy(const isochore<V>& v, V temperature) const { return branch::energy(at(v), v, temperature); }
  template <class V> BOLIDE_INLINE phase_point<V> evaluate(const isochore<V>& v, V e_k) const {
    return branch::evaluate(at(v), v, scalar_t<V>(q.ge), e_k, V(scalar_t<V>(0)), V(region_value<V>(region::solid)));
  }
  /// E_ms: thermal energy of the solid at its melting temperature.
  template <class V> BOLIDE_INLINE V end(const isochore<V>& v) const {
    using T = scalar_t<V>;
    return v.melting * (T(3 * q.R) + T(0.5) * v.electron * v.melting);
  }
};

} // namespace bolide::phase::branch
