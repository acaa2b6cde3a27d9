// SPDX-License-Identifier: MIT
// The hot liquid, tau = T/T_m > 3R/(2 al) = 10:  e_k = 3/2 RT + G T^2/2 + T_m K,  p - p_c = [RT + ge G T^2/2 + lambda T_m K]/V,
// K = dS + (al/2)(tau_hot^2 - 1). (The paper prints alpha' for alpha'/2 there; with the half, p, T and c^2 join the liquid's.)
#pragma once

#include "bolide/eos/phase/branch/branch.hpp"

namespace bolide::phase::branch {

struct hot_liquid {
  grover_parameters q;

  explicit hot_liquid(const grover_parameters& parameters = {}) : q(parameters) { q.validate(); }

  template <class V> BOLIDE_INLINE coefficients<V> at(const isochore<V>& v) const {
    using T = scalar_t<V>;
    return {V(T(1.5 * q.R)), V(T(0)), V(T(q.K())), v.electron, V(T(q.R)), V(T(0))};
  }
  /// K, at thermal energy e_k (J/kg).
  template <class V> V temperature(const isochore<V>& v, V e_k) const {
    coefficients<V> c = at(v);
    return solve(c, v, e_k).temperature;
  }
  /// e_k (J/kg) at a temperature: the inverse.
  template <class V> V energy(const isochore<V>& v, V temperature) const { return branch::energy(at(v), v, temperature); }
  template <class V> BOLIDE_INLINE phase_point<V> evaluate(const isochore<V>& v, V e_k) const {
    return branch::evaluate(at(v), v, scalar_t<V>(q.ge), e_k, V(scalar_t<V>(1)), V(region_value<V>(region::hot_liquid)));
  }
  /// E_G: thermal energy where the hot liquid takes over from the liquid.
  template <class V> BOLIDE_INLINE V begin(const isochore<V>& v) const {
    using T = scalar_t<V>;
    const double hot = q.hot();
    return v.melting * (T(1.5 * q.R * hot + q.K()) + T(0.5 * hot * hot) * v.electron * v.melting);
  }
};

} // namespace bolide::phase::branch
