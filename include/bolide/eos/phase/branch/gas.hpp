// SPDX-License-Identifier: MIT
// The gas of the paper, for V >= V_j:  e_k = 3/2 RT,  p - p_c = (2/3) e_k/V. The temperature is our choice (the paper gives none).
#pragma once

#include "bolide/eos/phase/branch/branch.hpp"

namespace bolide::phase::branch {

struct gas {
  grover_parameters q;

  explicit gas(const grover_parameters& parameters = {}) : q(parameters) { q.validate(); }

  template <class V> BOLIDE_INLINE coefficients<V> at(const isochore<V>&) const {
    using T = scalar_t<V>;
    return {V(T(1.5 * q.R)), V(T(0)), V(T(0)), V(T(0)), V(T(q.R)), V(T(0))};
  }
  /// K, at thermal energy e_k (J/kg).
  template <class V> V temperature(const isochore<V>& v, V e_k) const {
    coefficients<V> c = at(v);
    return solve(c, v, e_k).temperature;
  }
  /// e_k (J/kg) at a temperature: the inverse.
  template <class V> V energy(const isochore<V>& v, V temperature) const { return branch::energy(at(v), v, temperature); }
  template <class V> BOLIDE_INLINE phase_point<V> evaluate(const isochore<V>& v, V e_k) const {
    return branch::evaluate(at(v), v, scalar_t<V>(q.ge), e_k, V(scalar_t<V>(1)), V(region_value<V>(region::gas)));
  }
};

} // namespace bolide::phase::branch
