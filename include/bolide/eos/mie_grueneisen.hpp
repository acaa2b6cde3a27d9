// SPDX-License-Identifier: MIT
// Mie-Grueneisen equation of state on the linear shock Hugoniot us = c0 + s up, with Gamma rho = gamma0 rho0.
//
//   eta = 1 - rho0/rho,  p_H = rho0 c0^2 eta/(1 - s eta)^2,  p = p_ref(rho) + gamma0 rho0 e
//   compression  p_ref = p_H (1 - gamma0 eta/2)               expansion  p_ref = rho0 c0^2 (rho/rho0 - 1)
//   c^2 = dp_ref/drho + p gamma0 rho0/rho^2                   (continuous at rho0)
//
// Expansion: with Gamma rho constant, hot expanded material (e > c0^2/gamma0, 14 MJ/kg) keeps a finite pressure and a sound speed
// that grows without bound as rho -> 0, which ends a hypervelocity run in a vanishing time step. constant_gamma = true takes
// gamma0 rho e there:
// p is continuous at rho0, c^2 jumps by gamma0 e. The scenes of the library set it; the convention of the literature is the default.
//
// Guard: p_H has a pole at eta = 1/s (rho = 3.96 rho0 for aluminium), which a reflected shock of tens of km/s can cross. From
// guard/s on (guard = 0.95, rho = 3.45 rho0) p_ref goes on linearly in rho: p and c^2 continuous, no pole. outside_validity() says
// which lanes use it, so that a solver can count them.
// Validity: the Hugoniot of solid metals, and states near it; in expansion p does not fall to a gas's. No temperature: wrap in
// eos::isentrope_temperature.
// Default: aluminium 2024 (the parameters of the reference table in docs/validation; LASL, from memory: re-check before quoting).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"

namespace bolide::eos {

struct mie_grueneisen_parameters {
  double rho0 = 2785;   // kg/m3
  double c0 = 5328;     // m/s
  double s = 1.338;     // slope of us over up
  double gamma0 = 2.0;  // Grueneisen coefficient at rho0
  double guard = 0.95;  // of the pole's eta, where the linear continuation starts
  bool constant_gamma = false; // in expansion: Gamma = gamma0 (true) or Gamma rho = gamma0 rho0 (false)
};

struct mie_grueneisen {
  using parameters = mie_grueneisen_parameters;

  explicit mie_grueneisen(const parameters& p = {}) : q_(p) {
    require(q_.rho0 > 0, "eos::mie_grueneisen rho0", q_.rho0, "> 0", "kg/m3");
    require(q_.c0 > 0, "eos::mie_grueneisen c0", q_.c0, "> 0", "m/s");
    require(q_.s > 1, "eos::mie_grueneisen s", q_.s, "> 1 (the guard needs a pole at finite density)");
    require(q_.gamma0 > 0 && q_.gamma0 < 2 * q_.s, "eos::mie_grueneisen gamma0", q_.gamma0,
            "> 0 and < 2 s (p_ref must rise up to the pole)");
    require(q_.guard > 0 && q_.guard < 1, "eos::mie_grueneisen guard", q_.guard, "between 0 and 1");
    inverse_rho0_ = 1 / q_.rho0;
    eta_guard_ = q_.guard / q_.s;
    rho_guard_ = q_.rho0 / (1 - eta_guard_);
    const eos_point<double> at = compressed(eta_guard_);
    p_guard_ = at.pressure;
    slope_guard_ = at.sound_speed_squared;
  }

  template <class V> BOLIDE_INLINE caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V inverse = V(T(1)) / rho, ratio = T(q_.rho0) * inverse, eta = V(T(1)) - ratio;
    const eos_point<V> shock = compressed(min(eta, V(T(eta_guard_))));
    const T bulk = T(q_.rho0 * q_.c0 * q_.c0), grueneisen = T(q_.gamma0 * q_.rho0);
    const auto expanded = eta < V(T(0)), beyond = eta > V(T(eta_guard_));
    const V p_ref = select(expanded, bulk * (rho * T(inverse_rho0_) - T(1)),
                           select(beyond, T(p_guard_) + T(slope_guard_) * (rho - T(rho_guard_)), shock.pressure));
    const V slope = select(expanded, V(T(q_.c0 * q_.c0)), select(beyond, V(T(slope_guard_)), shock.sound_speed_squared));
    if (q_.constant_gamma) {
      const V gamma_rho = T(q_.gamma0) * select(expanded, rho, V(T(q_.rho0)));
      const V p = p_ref + gamma_rho * e;
      return {p, slope + select(expanded, T(q_.gamma0) * e, V(T(0))) + p * gamma_rho * inverse * inverse, gamma_rho};
    }
    const V p = p_ref + grueneisen * e;
    return {p, slope + p * grueneisen * inverse * inverse, V(grueneisen)};
  }

  double reference_density() const { return q_.rho0; }
  const parameters& values() const { return q_; }
  /// kg/m3, from where on the linear continuation answers.
  double guard_density() const { return rho_guard_; }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V) const { return rho > V(scalar_t<V>(rho_guard_)); }

private:
  /// p_ref and dp_ref/drho for 0 <= eta <= eta_guard.
  template <class V> BOLIDE_INLINE eos_point<V> compressed(V eta) const {
    using T = scalar_t<V>;
    const T bulk = T(q_.rho0 * q_.c0 * q_.c0), s = T(q_.s), half = T(0.5 * q_.gamma0);
    const V one(T(1)), d = one / (one - s * eta), p_h = bulk * eta * d * d, x = one - eta;
    const V slope_eta = bulk * (one + s * eta) * d * d * d * (one - half * eta) - half * p_h;
    return {p_h * (one - half * eta), slope_eta * x * x * T(inverse_rho0_)}; // d eta/d rho = (1 - eta)^2/rho0
  }

  parameters q_;
  double inverse_rho0_ = 0, eta_guard_ = 0, rho_guard_ = 0, p_guard_ = 0, slope_guard_ = 0;
};

static_assert(EquationOfState<mie_grueneisen> && EquationOfState<mie_grueneisen, pack<float, 4>>);

} // namespace bolide::eos
