// SPDX-License-Identifier: MIT
// Ideal gas of constant heat capacity (calorically perfect).
//
//   p = (gamma - 1) rho e,   c^2 = gamma p/rho = gamma (gamma - 1) e,   T = e/c_v
//
// e = 0 at T = 0. There is no solid: T_m = 0 K, melt fraction 1, region gas. p = 0 only at e = 0, so that there is no ambient state:
// give a body its density and energy(T). Compose it with strength::none and failure::none.
// Validity: gases far from their critical point, below dissociation (air: some 2000 K), which the three parameters do not tell: the
// stated box is e >= 0 and 1e-9 to 1e3 rho0 (beyond, no gas is ideal). e < 0 gives p < 0 and c^2 < 0, raw, and
// outside_validity() says so. Cost: three multiplications.
// Default: air, gamma 1.4, c_v 717.5 J/(kg K), and 1.2 kg/m3 as the reference density (bounds and first guesses only).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/validity.hpp"

#include <limits>

namespace bolide::eos {

struct ideal_gas_parameters {
  double gamma = 1.4;  // ratio of specific heats
  double c_v = 717.5;  // J/(kg K), heat capacity at constant volume
  double rho0 = 1.2;   // kg/m3, reference density
};

struct ideal_gas {
  using parameters = ideal_gas_parameters;

  explicit ideal_gas(const parameters& p = {}) : q_(p) {
    require(q_.gamma > 1, "eos::ideal_gas gamma", q_.gamma, "> 1");
    require(q_.c_v > 0, "eos::ideal_gas c_v", q_.c_v, "> 0", "J/(kg K)");
    require(q_.rho0 > 0, "eos::ideal_gas rho0", q_.rho0, "> 0", "kg/m3");
  }

  template <class V> BOLIDE_INLINE thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    return {T(q_.gamma - 1) * rho * e,
            T(q_.gamma * (q_.gamma - 1)) * e,
            T(1 / q_.c_v) * e,
            V(T(0)),
            V(T(1)),
            V(T(0)),
            V(region_value<V>(region::gas)),
            T(q_.gamma - 1) * rho,
            V(T(1 / q_.c_v))};
  }

  double reference_density() const { return q_.rho0; }
  const parameters& values() const { return q_; }
  /// J/kg at temperature T (K): what a body starts with.
  double energy(double temperature) const { return q_.c_v * temperature; }
  validity_box validity() const { return {1e-9 * q_.rho0, 1e3 * q_.rho0, 0, std::numeric_limits<double>::infinity()}; }
  const char* branch_name(double, double) const { return "single"; }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V, V e) const { return e < V(scalar_t<V>(0)); }

private:
  parameters q_;
};

static_assert(ThermalEquationOfState<ideal_gas> && ThermalEquationOfState<ideal_gas, pack<float, 4>>);

} // namespace bolide::eos
