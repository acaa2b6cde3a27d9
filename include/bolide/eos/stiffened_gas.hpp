// SPDX-License-Identifier: MIT
// Stiffened gas: an ideal gas under a constant inner pressure p_inf. The simplest equation of state of a liquid that has a shock.
//
//   p = (gamma - 1) rho e + gamma p_inf (rho/rho0 - 1),   c^2 = gamma (p + p_inf)/rho
//
// The usual form p = (gamma - 1) rho e' - gamma p_inf is the same with e' = e + gamma p_inf/((gamma - 1) rho0); here e = 0 is the state
// of p = 0 at rho0, so that ambient_state() and a body at rest are simple. Hugoniot from that state, exact:
//   us = a + sqrt(a^2 + c0^2),  a = (gamma + 1) up/4,  c0^2 = gamma p_inf/rho0,  p = rho0 us up.
// Validity: shocks in water to about 1 GPa with the default; no temperature of its own (wrap it in eos::isentrope_temperature).
// The stated box: 0.5 to 2 rho0, and -1 to 10 times the energy gamma p_inf/((gamma - 1) rho0) that the usual form counts from.
// p < -p_inf gives c^2 < 0, raw, and outside_validity() says so. Cost: one division.
// Default: water, gamma 4.4, p_inf 0.6 GPa, 1000 kg/m3 (c0 = 1625 m/s).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/validity.hpp"

namespace bolide::eos {

struct stiffened_gas_parameters {
  double gamma = 4.4;   // ratio of specific heats
  double p_inf = 6e8;   // Pa, inner pressure
  double rho0 = 1000;   // kg/m3, where p = 0 at e = 0
};

struct stiffened_gas {
  using parameters = stiffened_gas_parameters;

  explicit stiffened_gas(const parameters& p = {}) : q_(p) {
    require(q_.gamma > 1, "eos::stiffened_gas gamma", q_.gamma, "> 1");
    require(q_.p_inf > 0, "eos::stiffened_gas p_inf", q_.p_inf, "> 0 (0 is eos::ideal_gas)", "Pa");
    require(q_.rho0 > 0, "eos::stiffened_gas rho0", q_.rho0, "> 0", "kg/m3");
  }

  template <class V> BOLIDE_INLINE caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V p = T(q_.gamma - 1) * rho * e + T(q_.gamma * q_.p_inf) * (rho * T(1 / q_.rho0) - V(T(1)));
    return {p, T(q_.gamma) * (p + V(T(q_.p_inf))) / rho, T(q_.gamma - 1) * rho};
  }

  double reference_density() const { return q_.rho0; }
  const parameters& values() const { return q_; }
  validity_box validity() const {
    const double shift = q_.gamma * q_.p_inf / ((q_.gamma - 1) * q_.rho0);
    return {0.5 * q_.rho0, 2 * q_.rho0, -shift, 10 * shift};
  }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    return evaluate(rho, e).pressure < V(scalar_t<V>(-q_.p_inf));
  }

private:
  parameters q_;
};

static_assert(EquationOfState<stiffened_gas> && EquationOfState<stiffened_gas, pack<float, 4>>);

} // namespace bolide::eos
