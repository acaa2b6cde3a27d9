// SPDX-License-Identifier: MIT
// Vinet's equation (Vinet, Ferrante, Rose and Smith, J. Geophys. Res. 92 (1987) 9319): Rose's curve set by B and B'.
//
//   p_c = 3 B (1 - X)/X^2 exp[zeta (1 - X)],  X = x^(1/3),  zeta = 3/2 (B' - 1)
//   e_c = (9 B/(rho0 zeta^2)) [1 - (1 + u) e^-u],  u = -zeta (1 - X)                          (dp_c/dx: cold::universal_binding)
// p_c(1) = 0. Fitted to compression: in expansion its cohesive energy is 9 B/(rho0 zeta^2), nobody's measurement (aluminium's default:
// 8.6 MJ/kg where 12 is right). Validity for aluminium: about 11 % stiff at x = 0.5. Cost: one cube root, one exponential.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/cold/universal_binding.hpp"

namespace bolide::cold {

/// Defaults: aluminium.
struct vinet_parameters {
  double density = 2697.8;              // rho0, kg/m3 at x = 1
  double bulk_modulus = 79.4e9;         // B at x = 1, Pa
  double bulk_modulus_derivative = 4.7; // B' = dB/dp at x = 1
};

class vinet {
public:
  explicit vinet(const vinet_parameters& parameters = {}) : q_(parameters) {
    require(q_.density > 0, "cold::vinet density", q_.density, "> 0", "kg/m3");
    require(q_.bulk_modulus > 0, "cold::vinet bulk_modulus", q_.bulk_modulus, "> 0", "Pa");
    require(q_.bulk_modulus_derivative > 1, "cold::vinet bulk_modulus_derivative", q_.bulk_modulus_derivative, "> 1");
    const double zeta = 1.5 * (q_.bulk_modulus_derivative - 1);
    curve_ = {q_.density, 9 * q_.bulk_modulus / (q_.density * zeta * zeta), zeta};
  }

  template <class V> BOLIDE_INLINE cold_point<V> evaluate(V x) const { return curve_.evaluate(x); }
  double reference_density() const { return q_.density; }
  double cohesive_energy() const { return curve_.energy; }
  const vinet_parameters& parameters() const { return q_; }

private:
  vinet_parameters q_;
  universal_binding curve_{};
};

static_assert(ColdCurve<vinet> && ColdCurve<vinet, pack<float, 4>>);

} // namespace bolide::cold
