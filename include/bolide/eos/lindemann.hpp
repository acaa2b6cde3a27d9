// SPDX-License-Identifier: MIT
// Lindemann's melting temperature against volume, for an equation of state that knows none:
//   T_m(V) = T_melt L(x)/L(1),  L(x) = exp[2a(1-x)] x^(-2(g0 - a - 1/3)),  x = V/V0  (L(1) = 1), the integral of gamma = g0 - a(1-x).
// Guard: the exponent is kept above -80, as in phase/isochore.hpp.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"

namespace bolide::eos {

struct lindemann {
  double T_melt = 933;      // K at V0 (aluminium at zero pressure)
  double g0 = 2.18, a = 1.7;

  void validate() const {
    require(T_melt > 0, "eos::lindemann T_melt", T_melt, "> 0", "K");
    require(a >= 0 && g0 > a, "eos::lindemann a", a, "between 0 and g0");
  }

  template <class V> BOLIDE_INLINE V melting_temperature(V x) const {
    using T = scalar_t<V>;
    const V exponent = T(2 * a) * (V(T(1)) - x) - T(2 * (g0 - a - 1.0 / 3.0)) * log(x);
    return T(T_melt) * exp(max(exponent, V(T(-80))));
  }
};

} // namespace bolide::eos
