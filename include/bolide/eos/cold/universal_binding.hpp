// SPDX-License-Identifier: MIT
// The one-parameter binding curve that Rose's and Vinet's equations share:
//
//   e_c = E [1 - (1 + u) e^-u],  u = eta (x^(1/3) - 1)
//   p_c = -rho0 de_c/dx = -rho0 E (eta/3) x^(-2/3) u e^-u
//   dp_c/dx = -rho0 E (eta/3) x^(-2/3) e^-u [(1 - u) (eta/3) x^(-2/3) - (2/3) u/x]
// E is the energy of the free atoms, and the bulk modulus at x = 1 is B = rho0 E eta^2/9. Any x > 0; cost: one cube root, one exponential.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/math.hpp"

namespace bolide::cold {

struct universal_binding {
  double density; // rho0, kg/m3
  double energy;  // E, J/kg
  double eta;     // -

  template <class V> BOLIDE_INLINE cold_point<V> evaluate(V x) const {
    using T = scalar_t<V>;
    const V one(T(1)), root = cbrt(x), u = T(eta) * (root - one), decay = exp(-u), k = T(eta / 3) * root / x;
    const V tension = T(density * energy) * k * decay;
    return {T(energy) * (one - (one + u) * decay), -tension * u, -tension * ((one - u) * k - T(2.0 / 3.0) * u / x)};
  }
};

} // namespace bolide::cold
