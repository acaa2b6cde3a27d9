// SPDX-License-Identifier: MIT
// Van der Waals' fluid in reduced units (critical point rho = T = p = 1), a model with a liquid-vapour dome whose answers are known:
//   p = (8/3) rho T/(1 - rho/3) - 3 rho^2,  e = c_v T - 3 rho,  isentrope T (V - 1/3)^(R/c_v) = const,  R = 8/3
// c_v is the same for liquid and vapour.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"

#include <cmath>

namespace bolide::test {

struct van_der_waals {
  double c_v = 20; // 7.5 R: a heavy molecule

  template <class V> thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V room = V(T(1)) - rho * T(1.0 / 3), temperature = (e + T(3) * rho) * T(1 / c_v), one(T(1));
    const V p = T(8.0 / 3) * rho * temperature / room - T(3) * rho * rho, p_e = T(8.0 / 3 / c_v) * rho / room;
    const V p_rho = T(8.0 / 3) * temperature / (room * room) - T(6) * rho + p_e * T(3); // at constant e: T rises by 3/c_v per rho
    return {p, p_rho + p * p_e / (rho * rho), temperature, V(T(0)), one, T(-3) * rho, V(region_value<V>(region::liquid)), p_e, V(T(1 / c_v))};
  }
  double reference_density() const { return 2; }
  double energy(double rho, double T) const { return c_v * T - 3 * rho; }
  /// T at density `to` on the isentrope through (rho, T).
  double isentrope_temperature(double rho, double T, double to) const {
    return T * std::pow((1 / rho - 1.0 / 3) / (1 / to - 1.0 / 3), 8.0 / 3 / c_v);
  }
};

} // namespace bolide::test
