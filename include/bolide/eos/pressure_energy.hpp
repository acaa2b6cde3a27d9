// SPDX-License-Identifier: MIT
// dp/de at constant density of any equation of state: the model's own, or a central difference where it gives none.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/math.hpp"

namespace bolide::eos {

/// dp/de at constant density, kg/m3. The difference moves e by 1e-4 of c^2 at the reference density (error of order 1e-8).
template <class Eos, class V> BOLIDE_INLINE V pressure_energy(const Eos& eos, V rho, V e) {
  using T = scalar_t<V>;
  if constexpr (requires { eos.evaluate(rho, e).pressure_energy; }) return eos.evaluate(rho, e).pressure_energy;
  else {
    const double c2 = eos.evaluate(eos.reference_density(), 0.0).sound_speed_squared;
    const T step = static_cast<T>((sizeof(T) == 8 ? 1e-4 : 1e-2) * (c2 < 0 ? -c2 : c2));
    return (eos.evaluate(rho, e + step).pressure - eos.evaluate(rho, e - step).pressure) / V(2 * step);
  }
}

} // namespace bolide::eos
