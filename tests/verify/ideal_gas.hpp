// SPDX-License-Identifier: MIT
// An ideal gas for problems with known answers. c^2 has a trace added because a material wants c^2 > 0 at e = 0 to scale its floor.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"

namespace bolide::verify {

struct ideal_gas {
  double gamma = 1.4, rho0 = 1, trace = 1e-12; // trace: m2/s2
  template <class V> eos_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V p = T(gamma - 1) * rho * e;
    return {p, T(gamma) * p / rho + T(trace)};
  }
  double reference_density() const { return rho0; }
};
static_assert(EquationOfState<ideal_gas>);

} // namespace bolide::verify
