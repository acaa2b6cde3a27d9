// SPDX-License-Identifier: MIT
// The liquid branch, tau = T/T_m:  the solid's terms + q in e and lambda q/V in p,  q = T_m [dS - (al/2)(1 + tau^2)].
// From the liquidus energy E_m = E_ms + T_m (dS - al), where T = T_m, to the hot liquid at tau = 3R/(2 al).
#pragma once

#include "bolide/eos/phase/branch/branch.hpp"

namespace bolide::phase::branch {

struct liquid {
  grover_parameters q;

  explicit liquid(const grover_parameters& parameters = {}) : q(parameters) { q.validate(); }

  template <class V> BOLIDE_INLINE coefficients<V> at(const isochore<V>& v) const {
    using T = scalar_t<V>;
    return {V(T(3 * q.R)), T(q.al) / v.melting, V(T(q.dS - 0.5 * q.al)), v.electron, T(3 * q.R) * v.gamma, T(3 * q.R) * v.gamma_slope};
  }
  /// K, at thermal energy e_k (J/kg).
  template <class V> V temperature(const isochore<V>& v, V e_k) const {
    coefficients<V> c = at(v);
    return solve(c, v, e_k).temperature;
  }
  /// e_k (J/kg) at a temperature: the inverse.
  template <class V> V energy(const isochore<V>& v, V temperature) const { return branch::energy(at(v), v, temperature); }
  template <class V> BOLIDE_INLINE phase_point<V> evaluate(const isochore<V>& v, V e_k) const {
    return branch::evaluate(at(v), v, scalar_t<V>(q.ge), e_k, V(scalar_t<V>(1)), V(region_value<V>(region::liquid)));
  }
  /// E_m: thermal energy of the liquid at its melting temperature.
  template <class V> BOLIDE_INLINE V begin(const isochore<V>& v) const {
    using T = scalar_t<V>;
    return v.melting * (T(3 * q.R + q.dS - q.al) + T(0.5) * v.electron * v.melting);
  }
};

} // namespace bolide::phase::branch
