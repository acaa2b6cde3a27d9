// SPDX-License-Identifier: MIT
// Tillotson's equation of state. eta = rho/rho0, mu = eta - 1, z = 1/eta - 1, w = e/(E0 eta^2) + 1:
//
//   I    rho >= rho0, or e <= E_iv    p = (a + b/w) rho e + A mu + B mu^2
//   III  rho < rho0 and e >= E_cv     p = a rho e + [b rho e/w + A mu exp(-beta z)] exp(-alpha z^2)
//   II   rho < rho0, between          p = [(e - E_iv) p_III + (E_cv - e) p_I]/(E_cv - E_iv)
//   c^2 = p_rho + p p_e/rho^2, with the derivative of the interpolation weights in II
//
// p is continuous; c^2 jumps at rho0 (for e > E_iv), E_iv and E_cv, as the formula has it. Raw: no cut-off in density or pressure;
// cold expansion pulls (-12 GPa at eta = 0.8) and c^2 < 0 below eta = 0.75.
// Guard: b/w has a pole at e = -E0 eta^2. w is kept above 0.1, which only e < -0.9 E0 eta^2 reaches; outside_validity() says where.
// Stated box: 1e-6 to 5 rho0, -0.05 to 2000 E0 (2000 E0 is 10 GJ/kg: a hot gas of Gamma = a, as high as the fits to Thomas-Fermi went).
// Default: aluminium (rho0 2700; E_cv 13.9 MJ/kg as in public codes, others print 15). No temperature: wrap in isentrope_temperature.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/validity.hpp"

#include <vector>

namespace bolide::eos {

struct tillotson_parameters {
  double rho0 = 2700;              // kg/m3
  double a = 0.5, b = 1.63;        // a + b: Grueneisen coefficient at rho0, e = 0; a: that of the hot gas
  double A = 75.2e9, B = 65e9;     // Pa
  double E0 = 5.0e6;               // J/kg
  double alpha = 5, beta = 5;      // decay of the cold terms in expansion
  double E_iv = 3.0e6, E_cv = 13.9e6; // J/kg, incipient and complete vaporisation
};

struct tillotson {
  using parameters = tillotson_parameters;
  static constexpr double smallest_w = 0.1;

  explicit tillotson(const parameters& p = {}) : q_(p) {
    require(q_.rho0 > 0, "eos::tillotson rho0", q_.rho0, "> 0", "kg/m3");
    require(q_.a > 0, "eos::tillotson a", q_.a, "> 0");
    require(q_.b >= 0, "eos::tillotson b", q_.b, ">= 0");
    require(q_.A > 0, "eos::tillotson A", q_.A, "> 0", "Pa");
    require(q_.B >= 0, "eos::tillotson B", q_.B, ">= 0", "Pa");
    require(q_.E0 > 0, "eos::tillotson E0", q_.E0, "> 0", "J/kg");
    require(q_.alpha > 0, "eos::tillotson alpha", q_.alpha, "> 0");
    require(q_.beta > 0, "eos::tillotson beta", q_.beta, "> 0");
    require(q_.E_iv > 0, "eos::tillotson E_iv", q_.E_iv, "> 0", "J/kg");
    require(q_.E_cv > q_.E_iv, "eos::tillotson E_cv", q_.E_cv, "above E_iv", "J/kg");
    inverse_rho0_ = 1 / q_.rho0;
    inverse_E0_ = 1 / q_.E0;
    inverse_width_ = 1 / (q_.E_cv - q_.E_iv);
  }

  template <class V> BOLIDE_INLINE caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1)), eta = rho * T(inverse_rho0_);
    const part<V> hot = hot_part(rho, e, eta), i = condensed(rho, e, eta, hot);
    const auto expanded = eta < one && e > V(T(q_.E_iv));
    part<V> r = i;
    if (any(expanded)) {
      const part<V> iii = vapour(rho, e, eta, hot);
      const V weight = min(max((e - T(q_.E_iv)) * T(inverse_width_), zero), one);
      const V weight_e = select(e < V(T(q_.E_cv)), V(T(inverse_width_)), zero);
      const V rest = one - weight; // not i + weight (iii - i): the pull of I, 10 GPa, would leave its round-off in a thin gas
      r.p = select(expanded, weight * iii.p + rest * i.p, i.p);
      r.p_rho = select(expanded, weight * iii.p_rho + rest * i.p_rho, i.p_rho);
      r.p_e = select(expanded, weight * iii.p_e + rest * i.p_e + weight_e * (iii.p - i.p), i.p_e);
    }
    return {r.p, r.p_rho + r.p * r.p_e / (rho * rho), r.p_e};
  }

  double reference_density() const { return q_.rho0; }
  const parameters& values() const { return q_; }
  validity_box validity() const { return {1e-6 * q_.rho0, 5 * q_.rho0, -0.05 * q_.E0, 2000 * q_.E0}; }
  /// The branch of the table above that answers.
  const char* branch_name(double rho, double e) const {
    if (rho >= q_.rho0) return "compressed";
    return e <= q_.E_iv ? "expanded_cold" : e < q_.E_cv ? "transition" : "expanded_hot";
  }
  /// Where derivatives jump: energies (J/kg) at a density, and densities (kg/m3). A table puts its nodes there.
  std::vector<double> energy_borders(double) const { return {q_.E_iv, q_.E_cv}; }
  std::vector<double> density_borders() const { return {q_.rho0}; }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    using T = scalar_t<V>;
    const V eta = rho * T(inverse_rho0_);
    return e < T((smallest_w - 1) * q_.E0) * eta * eta;
  }

private:
  template <class V> struct part { V p, p_rho, p_e; };

  /// b rho e/w and its derivatives.
  template <class V> BOLIDE_INLINE part<V> hot_part(V rho, V e, V eta) const {
    using T = scalar_t<V>;
    const V one{T(1)}, least{T(smallest_w)}, ratio = e * T(inverse_E0_) / (eta * eta), raw = ratio + one;
    const auto guarded = raw < least;
    const V w = select(guarded, least, raw), b = T(q_.b) / w, r = select(guarded, V(T(0)), ratio / w); // r = -(dw/d ln e)/w
    return {b * rho * e, b * e * (one + T(2) * r), b * rho * (one - r)};
  }
  template <class V> BOLIDE_INLINE part<V> condensed(V rho, V e, V eta, const part<V>& hot) const {
    using T = scalar_t<V>;
    const V mu = eta - T(1);
    return {T(q_.a) * rho * e + hot.p + mu * (T(q_.A) + T(q_.B) * mu),
            T(q_.a) * e + hot.p_rho + (T(q_.A) + T(2 * q_.B) * mu) * T(inverse_rho0_), T(q_.a) * rho + hot.p_e};
  }
  template <class V> BOLIDE_INLINE part<V> vapour(V rho, V e, V eta, const part<V>& hot) const {
    using T = scalar_t<V>;
    const V one(T(1)), z = max(one / eta - one, V(T(0))), mu = eta - one, z_rho = -(z + one) / rho;
    // The exponents are kept above -80 (e^-80 = 2e-35): beyond, the terms have long vanished.
    const V fall = exp(max(-T(q_.alpha) * z * z, V(T(-80)))), cold = T(q_.A) * exp(max(-T(q_.beta) * z, V(T(-80))));
    const V inner = hot.p + cold * mu;
    const V inner_rho = hot.p_rho + cold * (T(inverse_rho0_) - T(q_.beta) * mu * z_rho);
    return {T(q_.a) * rho * e + inner * fall, T(q_.a) * e + fall * (inner_rho - T(2 * q_.alpha) * z * z_rho * inner),
            T(q_.a) * rho + hot.p_e * fall};
  }

  parameters q_;
  double inverse_rho0_ = 0, inverse_E0_ = 0, inverse_width_ = 0; // width: E_cv - E_iv
};

static_assert(EquationOfState<tillotson> && EquationOfState<tillotson, pack<float, 4>>);

} // namespace bolide::eos
