// SPDX-License-Identifier: MIT
// Jones-Wilkins-Lee equation of state of detonation products. V = rho0/rho (rho0: density of the explosive), z_i = R_i V:
//
//   p = A (1 - omega/z_1) exp(-z_1) + B (1 - omega/z_2) exp(-z_2) + omega rho e
//   c^2 = dp_ref/drho + omega e + p omega/rho,   dp_ref/drho = sum A_i exp(-z_i) [z_i (z_i - omega) - omega]/(R_i rho0)
//
// e in J/kg counts the chemical energy: the unburnt explosive, burnt in place, has e = E_0/rho0 (E_0: the J/m3 of the tables).
// No default: a fit belongs to one explosive at one loading density. No temperature: wrap in eos::isentrope_temperature.
// Stated box: 1e-4 to 2 rho0 (beyond the overdriven states that fits are made from), e from 0 to A/(R1 rho0) (some ten times a
// detonation's). Guard: z is kept below 80 (exp(-80) = 2e-35), so that nothing overflows in expansion: the terms have long vanished.
// Cost: two exp and one division.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/validity.hpp"

#include <cmath>
#include <limits>

namespace bolide::eos {

/// All six must be given: what is left out is NaN, and refused.
struct jwl_parameters {
  double rho0 = std::numeric_limits<double>::quiet_NaN();  // kg/m3, of the explosive
  double A = std::numeric_limits<double>::quiet_NaN();     // Pa
  double B = std::numeric_limits<double>::quiet_NaN();     // Pa
  double R1 = std::numeric_limits<double>::quiet_NaN();
  double R2 = std::numeric_limits<double>::quiet_NaN();
  double omega = std::numeric_limits<double>::quiet_NaN(); // Grueneisen coefficient
};

struct jwl {
  using parameters = jwl_parameters;

  explicit jwl(const parameters& p) : q_(p) {
    require(q_.rho0 > 0, "eos::jwl rho0", q_.rho0, "> 0", "kg/m3");
    require(q_.A > 0, "eos::jwl A", q_.A, "> 0", "Pa");
    require(std::isfinite(q_.B), "eos::jwl B", q_.B, "finite", "Pa");
    require(q_.R2 > 0, "eos::jwl R2", q_.R2, "> 0");
    require(q_.R1 > q_.R2, "eos::jwl R1", q_.R1, "above R2");
    require(q_.omega > 0 && q_.omega < q_.R2, "eos::jwl omega", q_.omega, "> 0 and < R2 (else the second term pulls at V = 1)");
  }

  template <class V> BOLIDE_INLINE caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V inverse = V(T(1)) / rho, gamma_rho = T(q_.omega) * rho;
    const term<V> a = cold(V(T(q_.A)), T(q_.R1), rho, inverse), b = cold(V(T(q_.B)), T(q_.R2), rho, inverse);
    const V p = a.p + b.p + gamma_rho * e;
    return {p, a.slope + b.slope + T(q_.omega) * (e + p * inverse), gamma_rho};
  }

  double reference_density() const { return q_.rho0; }
  const parameters& values() const { return q_; }
  validity_box validity() const { return {1e-4 * q_.rho0, 2 * q_.rho0, 0, q_.A / (q_.R1 * q_.rho0)}; }

private:
  template <class V> struct term { V p, slope; };

  /// A (1 - omega/z) exp(-z) and its derivative in rho.
  template <class V> BOLIDE_INLINE term<V> cold(V A, scalar_t<V> R, V rho, V inverse) const {
    using T = scalar_t<V>;
    const V z = min(R * T(q_.rho0) * inverse, V(T(80))), omega_over_z = rho * (T(q_.omega) / (R * T(q_.rho0)));
    const V fall = A * exp(-z);
    return {fall * (V(T(1)) - omega_over_z), fall * (z * (z - T(q_.omega)) - T(q_.omega)) * (T(1) / (R * T(q_.rho0)))};
  }

  parameters q_;
};

static_assert(EquationOfState<jwl> && EquationOfState<jwl, pack<float, 4>>);

} // namespace bolide::eos
