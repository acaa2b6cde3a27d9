// SPDX-License-Identifier: MIT
// Mie-Grueneisen equation of state on the shock Hugoniot us = c0 + s up + s2 up^2, with Gamma rho = gamma0 rho0.
//
//   eta = 1 - rho0/rho,  p_H = rho0 us^2 eta,  p = p_ref(rho) + gamma0 rho0 e
//   linear (s2 = 0)  us = c0/(1 - s eta)      quadratic  us = 2 c0/(d + r),  d = 1 - s eta,  r = sqrt(d^2 - 4 s2 c0 eta^2)
//     (up = eta us by the jump condition of mass turns the us-up line into a quadratic equation for us; this is its root that is c0 at
//     eta = 0. The form us = c0 + s up + s2 up^2 is that of the LASL fits; codes that write s up + s2 (up/us) up mean another s2.)
//   compression  p_ref = p_H (1 - gamma0 eta/2)               expansion  p_ref = rho0 c0^2 (rho/rho0 - 1)
//   c^2 = dp_ref/drho + p gamma0 rho0/rho^2                   (continuous at rho0)
//
// Expansion: with Gamma rho constant and p_ref linear, hot expanded material (e > c0^2/gamma0, 14 MJ/kg) keeps a finite pressure and a sound speed
// that grows without bound as rho -> 0, which ends a hypervelocity run in a vanishing time step. constant_gamma = true takes
// gamma0 rho e there:
// p is continuous at rho0, c^2 jumps by gamma0 e. The scenes of the library set it; the convention of the literature is the default.
// fading_expansion = true is for strong expansion: with y = rho/rho0 < 1
//   p_ref = rho0 c0^2 (y - 1) y^2,   Gamma = g + (3 gamma0 - 2 g) y + (g - 2 gamma0) y^2,   g = gamma_far = 2/3
// p, c^2 and Gamma rho are continuous at rho0 with their slopes in e; p_ref has its least, -(4/27) rho0 c0^2 (-11.7 GPa for aluminium), at
// y = 2/3 and fades (binding energy c0^2/2); what is left at rho -> 0 is an ideal gas of ratio g + 1, so p -> 0 and c stays finite.
// Stated box: from 0.5 rho0 (constant_gamma 0.1, fading 1e-6) to the guard; -0.01 c0^2 (some 300 K below ambient) to the energy of the
// Hugoniot at the guard.
//
// Guard: p_H has a pole at eta = 1/s (rho = 3.96 rho0 for aluminium), which a reflected shock of tens of km/s can cross. From
// guard/s on (guard = 0.95, rho = 3.45 rho0) p_ref goes on linearly in rho: p and c^2 continuous, no pole. outside_validity() says
// which lanes use it, so that a solver can count them. Quadratic: the end is where r = 0, eta = 1/(s + 2 sqrt(s2 c0)), for s2 > 0 and where
// us is greatest, eta = 2 s/(s^2 - 4 s2 c0), for s2 < 0 (or 1/s if that is less); the guard is the same fraction of it.
// Validity: the Hugoniot of solid metals, and states near it; in expansion p does not fall to a gas's. No temperature: wrap in
// eos::isentrope_temperature.
// Default: aluminium 2024 (the parameters of the reference table in docs/validation; LASL, from memory: re-check before quoting).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/validity.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bolide::eos {

struct mie_grueneisen_parameters {
  double rho0 = 2785;   // kg/m3
  double c0 = 5328;     // m/s
  double s = 1.338;     // slope of us over up
  double gamma0 = 2.0;  // Grueneisen coefficient at rho0
  double guard = 0.95;  // of the pole's eta, where the linear continuation starts
  bool constant_gamma = false; // in expansion: Gamma = gamma0 (true) or Gamma rho = gamma0 rho0 (false)
  double s2 = 0;        // s/m, curvature of us over up
  bool fading_expansion = false; // in expansion: p_ref and Gamma of the third kind above
  double gamma_far = 2.0 / 3.0;  // Gamma for rho -> 0, if fading
};

struct mie_grueneisen {
  using parameters = mie_grueneisen_parameters;

  explicit mie_grueneisen(const parameters& p = {}) : q_(p) {
    require(q_.rho0 > 0, "eos::mie_grueneisen rho0", q_.rho0, "> 0", "kg/m3");
    require(q_.c0 > 0, "eos::mie_grueneisen c0", q_.c0, "> 0", "m/s");
    require(q_.s > 1 || (q_.s > 0 && q_.s2 > 0), "eos::mie_grueneisen s", q_.s, "> 1 (the guard needs a pole at finite density)");
    require(q_.gamma0 > 0 && (q_.gamma0 < 2 * q_.s || q_.s2 != 0), "eos::mie_grueneisen gamma0", q_.gamma0,
            "> 0 and < 2 s (p_ref must rise up to the pole)");
    require(q_.guard > 0 && q_.guard < 1, "eos::mie_grueneisen guard", q_.guard, "between 0 and 1");
    require(std::isfinite(q_.s2), "eos::mie_grueneisen s2", q_.s2, "finite", "s/m");
    require(!(q_.constant_gamma && q_.fading_expansion), "eos::mie_grueneisen fading_expansion", 1, "0 where constant_gamma is set");
    require(!q_.fading_expansion || (q_.gamma_far > 0 && q_.gamma_far <= q_.gamma0), "eos::mie_grueneisen gamma_far", q_.gamma_far,
            "above 0 and at most gamma0");
    require(end_of_hugoniot() < 1, "eos::mie_grueneisen s2", q_.s2, "such that the Hugoniot ends at a finite density", "s/m");
    inverse_rho0_ = 1 / q_.rho0;
    eta_guard_ = q_.guard * end_of_hugoniot();
    rho_guard_ = q_.rho0 / (1 - eta_guard_);
    const eos_point<double> at = compressed(eta_guard_);
    p_guard_ = at.pressure;
    slope_guard_ = at.sound_speed_squared;
    if (q_.s2 != 0)
      for (int i = 1; i <= 200; ++i)
        require(compressed(eta_guard_ * i / 200).sound_speed_squared > 0, "eos::mie_grueneisen s2", q_.s2,
                "such that p_ref rises up to the guard (smaller, or with a smaller gamma0 or guard)", "s/m");
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
    if (q_.fading_expansion) {
      const T far = T(q_.gamma_far), first = T(3 * q_.gamma0 - 2 * q_.gamma_far), second = T(q_.gamma_far - 2 * q_.gamma0);
      const V y = rho * T(inverse_rho0_);
      const V p_cold = select(expanded, bulk * (y - T(1)) * y * y, p_ref);
      const V slope_cold = select(expanded, T(q_.c0 * q_.c0) * y * (T(3) * y - T(2)), slope);
      const V gamma_rho = select(expanded, rho * (far + y * (first + second * y)), V(grueneisen));
      const V gamma_rho_slope = select(expanded, far + y * (T(2) * first + T(3) * second * y), V(T(0)));
      const V p = p_cold + gamma_rho * e;
      return {p, slope_cold + gamma_rho_slope * e + p * gamma_rho * inverse * inverse, gamma_rho};
    }
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
  validity_box validity() const {
    const double low = q_.fading_expansion ? 1e-6 : q_.constant_gamma ? 0.1 : 0.5, us = shock_speed(eta_guard_).value;
    return {low * q_.rho0, rho_guard_, -0.01 * q_.c0 * q_.c0, 0.5 * square(us * eta_guard_)};
  }
  std::vector<double> density_borders() const { return {q_.rho0}; } // where derivatives jump, kg/m3
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V) const { return rho > V(scalar_t<V>(rho_guard_)); }

private:
  template <class V> struct root { V value, slope; };
  /// us and d us/d eta on the Hugoniot, m/s.
  template <class V> BOLIDE_INLINE root<V> shock_speed(V eta) const {
    using T = scalar_t<V>;
    const V d = T(1) - T(q_.s) * eta, r = sqrt(max(d * d - T(4 * q_.s2 * q_.c0) * eta * eta, V(T(0)))), us = T(2 * q_.c0) / (d + r);
    return {us, us * (T(q_.s) + T(2 * q_.s2) * eta * us) / r};
  }
  /// The eta at which the Hugoniot ends.
  double end_of_hugoniot() const {
    if (q_.s2 == 0) return 1 / q_.s;
    if (q_.s2 > 0) return 1 / (q_.s + 2 * std::sqrt(q_.s2 * q_.c0));
    return std::min(1 / q_.s, 2 * q_.s / (q_.s * q_.s - 4 * q_.s2 * q_.c0));
  }
  /// p_ref and dp_ref/drho for 0 <= eta <= eta_guard.
  template <class V> BOLIDE_INLINE eos_point<V> compressed(V eta) const {
    using T = scalar_t<V>;
    const T bulk = T(q_.rho0 * q_.c0 * q_.c0), s = T(q_.s), half = T(0.5 * q_.gamma0);
    if (q_.s2 != 0) {
      const V x = V(T(1)) - eta;
      const root<V> us = shock_speed(max(eta, V(T(0)))); // in expansion nobody reads it, and there need not be a root
      const V p_h = T(q_.rho0) * us.value * us.value * eta, p_h_slope = T(q_.rho0) * us.value * (us.value + T(2) * eta * us.slope);
      return {p_h * (T(1) - half * eta), (p_h_slope * (T(1) - half * eta) - half * p_h) * x * x * T(inverse_rho0_)};
    }
    const V one(T(1)), d = one / (one - s * eta), p_h = bulk * eta * d * d, x = one - eta;
    const V slope_eta = bulk * (one + s * eta) * d * d * d * (one - half * eta) - half * p_h;
    return {p_h * (one - half * eta), slope_eta * x * x * T(inverse_rho0_)}; // d eta/d rho = (1 - eta)^2/rho0
  }

  parameters q_;
  double inverse_rho0_ = 0, eta_guard_ = 0, rho_guard_ = 0, p_guard_ = 0, slope_guard_ = 0;
};

static_assert(EquationOfState<mie_grueneisen> && EquationOfState<mie_grueneisen, pack<float, 4>>);

} // namespace bolide::eos
