// SPDX-License-Identifier: MIT
// The two free energies of eos::reference: solid and liquid, each a closed form in (V, T). SI, per mass, x = rho0 V, L = ln x.
//
//   F_s = e_c(x) + 3RT ln(1 - exp(-theta/T)) + F_e
//   F_l = e_l(x) - 3/2 RT ln(1 + sqrt2 t + t^2) + 3/2 RT ln(1 + T/T_b) + F_e,   t = T/theta_l,   T_b = theta_l^2 x^(2/3)/kappa
//   F_e = -9/2 RT ln(1 + T/T_F),   T_F = 9R/G(x)
//
// Solid: Einstein oscillators. Liquid: softer ones (by the entropy of disorder dS), of a form that is algebraic in T (C is 3R but for
//   terms of (theta_l/T)^3), which become free: below T_b they vibrate, above it 3RT ln(theta_l/T) turns into 3/2 RT ln(kappa x^(-2/3)/T),
//   the ideal gas with its absolute entropy (kappa is Sackur and Tetrode's). x -> infinity: T_b -> 0, the ideal gas at every T.
// Electrons: G T^2/2 when cold, never more than the three electrons of an atom as a classical gas (9/2 RT).
// Volume: gamma = 2/3 + 4 b y/(1 + y)^2, y = (x/x_g)^n, for both phases, so that theta, and with it T_b (Lindemann's T_m but for a
//   factor), is closed: ln theta = ln theta0 - 2/3 L + (4b/n) [1/(1+y)] from 1 to x.
//   theta_l/theta = exp(-dS/3R) at x -> 0, where only the height b of the two gammas differs.
// Cold curves: e_c = E (1 - (1 + a + d a^3) exp(-a)), a = eta (x^(1/3) - 1), E = 9 K0/(rho0 eta^2): Rose's with one more constant.
//   e_l = e_c + c R T_b for x <= x_join; beyond, E_coh + sum_0^7 b_k x^-(1 + k/3), joined there with three derivatives, b_0 .. b_3 free.
// Zero-point energies are part of the cold curves.
//
// Every thermal term is T f(T/Theta(x)), so that with Gamma = -dln Theta/dL, e = its energy and C its heat capacity
//   F_L = -Gamma e,   F_LT = -Gamma C,   F_LL = -Gamma_L e + Gamma^2 (e - T C);      p = -F_L/V,   V^2 dp/dV|_T = F_L - F_LL.
#pragma once

#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/reference/parameters.hpp"

#include <array>
#include <cmath>

namespace bolide::eos::detail {

/// F(L, T) and what follows from it. slope and curvature are F_L and F_LL at constant T, cross is F_LT.
template <class V> struct free_energy {
  V energy, heat, slope, curvature, cross; // e, C = T S_T, F_L, F_LL, F_LT
};

/// A curve of x alone with its first two derivatives by L.
template <class V> struct volume_function {
  V value, slope, curvature;
};

/// All that depends on the volume only.
template <class V> struct reference_volume {
  V x, log_x, cube_root;
  V gamma, gamma_slope;               // of the solid; dgamma/dL
  V liquid_gamma, liquid_gamma_slope; // of the liquid
  V einstein, liquid_einstein;        // theta of either, K
  V free;                             // T_b, K
  V fermi;                            // T_F, K
  V electron, electron_slope;         // Gamma of the electrons and its derivative by L
};

/// What tells the phases apart at a volume. loose: share of the free term, 0 in the solid and 1 in the liquid.
template <class V> struct lattice {
  V einstein, gamma, gamma_slope, loose;
};
template <class V> struct heat_content {
  V energy, heat;
};

/// e/(3RT) and C/(3R) of Einstein's oscillators at theta/T.
template <class V> BOLIDE_INLINE heat_content<V> oscillator(V ratio) {
  using T = scalar_t<V>;
  const V one(T(1)), u = min(ratio, V(T(80))), q = exp(-u), inverse = u / (one - q), u2 = u * u;
  const auto hot = u < V(T(0.25)); // 1 - q has lost digits: Bernoulli's series, next term 3e-17
  const V energy =
      one - T(0.5) * u + u2 * (T(1.0 / 12) - u2 * (T(1.0 / 720) - u2 * (T(1.0 / 30240) - u2 * (T(1.0 / 1209600) - u2 * T(1.0 / 47900160)))));
  const V heat = one - u2 * (T(1.0 / 12) - u2 * (T(1.0 / 240) - u2 * (T(1.0 / 6048) - u2 * (T(1.0 / 172800) - u2 * T(9.0 / 47900160)))));
  return {select(hot, energy, q * inverse), select(hot, heat, q * inverse * inverse)};
}

class reference_phases {
public:
  explicit reference_phases(const reference_parameters& parameters) : q_(parameters) {
    q_.validate();
    R_ = q_.R();
    kappa_ = q_.kappa();
    energy_ = 9 * q_.K0 / (q_.rho0 * q_.eta * q_.eta);
    power_at_one_ = 1 / (1 + std::pow(1 / q_.x_gamma, q_.n));
    liquid_theta_ = q_.theta * std::exp(-q_.dS / (3 * R_) - 4 * (q_.b_liquid - q_.b) / q_.n * (1 - power_at_one_));
    join();
  }

  const reference_parameters& parameters() const { return q_; }

  template <class V> BOLIDE_INLINE reference_volume<V> at(V x) const {
    using T = scalar_t<V>;
    reference_volume<V> v;
    const V one(T(1));
    v.x = x;
    v.log_x = log(x);
    v.cube_root = exp(v.log_x * T(1.0 / 3));
    const V y = exp(T(q_.n) * (v.log_x - T(std::log(q_.x_gamma)))), r = one / (one + y), yr = y * r;
    const V bell = T(4) * yr * r, bell_slope = T(q_.n) * bell * (r - yr), square_root = v.cube_root * v.cube_root, shrink = one / square_root;
    v.gamma = T(2.0 / 3) + T(q_.b) * bell;
    v.gamma_slope = T(q_.b) * bell_slope;
    v.liquid_gamma = T(2.0 / 3) + T(q_.b_liquid) * bell;
    v.liquid_gamma_slope = T(q_.b_liquid) * bell_slope;
    v.einstein = T(q_.theta) * exp(T(4 * q_.b / q_.n) * (r - T(power_at_one_))) * shrink;
    const V soft = exp(T(4 * q_.b_liquid / q_.n) * (r - T(power_at_one_)));
    v.liquid_einstein = T(liquid_theta_) * soft * shrink;
    v.free = T(liquid_theta_ * liquid_theta_ / kappa_) * square(soft) * shrink;
    const V denominator = one + T(q_.electron_saturation) * square_root, share = one / denominator;
    v.fermi = T(9 * R_ / (q_.G * (1 + q_.electron_saturation))) * denominator / square_root;
    v.electron = T(2.0 / 3) * share;
    v.electron_slope = -v.electron * (T(2.0 / 3) - v.electron);
    return v;
  }

  template <class V> BOLIDE_INLINE volume_function<V> solid_cold(const reference_volume<V>& v) const {
    using T = scalar_t<V>;
    const V a = T(q_.eta) * (v.cube_root - T(1)), m = T(q_.eta / 3) * v.cube_root, fall = T(energy_) * exp(-a), d(T(q_.delta));
    const V slope = a * (V(T(1)) + d * a * (a - T(3)));
    const V curvature = V(T(1)) + d * a * (T(3) * a - T(6)) - slope;
    return {V(T(energy_)) - fall * (V(T(1)) + a * (V(T(1)) + d * a * a)), fall * slope * m, fall * m * (curvature * m + slope * T(1.0 / 3))};
  }

  template <class V> BOLIDE_INLINE volume_function<V> liquid_cold(const reference_volume<V>& v, const volume_function<V>& solid) const {
    using T = scalar_t<V>;
    const V lambda = T(2) * v.liquid_gamma - T(2.0 / 3), lift = T(q_.c * R_) * v.free;
    const auto expanded = v.x > V(T(q_.x_join));
    volume_function<V> r{solid.value + lift, solid.slope - lambda * lift, solid.curvature + (lambda * lambda - T(2) * v.liquid_gamma_slope) * lift};
    if (!any(expanded)) return r;
    const V u = V(T(1)) / v.cube_root, w = u - T(middle), u3 = u * u * u; // b_0 + .. + b_7 u^7 about the middle: no cancellation
    V sum = V(T(tail_[7])), first = V(T(0)), second = V(T(0));
    for (std::size_t k = 7; k-- > 0;) {
      second = second * w + first;
      first = first * w + sum;
      sum = sum * w + T(tail_[k]);
    }
    const V slope = -u3 * (sum + T(1.0 / 3) * u * first), curvature = u3 * (sum + u * (T(7.0 / 9) * first + T(2.0 / 9) * u * second));
    return {select(expanded, T(q_.E_coh) + u3 * sum, r.value), select(expanded, slope, r.slope), select(expanded, curvature, r.curvature)};
  }

  template <class V> BOLIDE_INLINE lattice<V> solid_lattice(const reference_volume<V>& v) const {
    return {v.einstein, v.gamma, v.gamma_slope, V(scalar_t<V>(0))};
  }
  template <class V> BOLIDE_INLINE lattice<V> liquid_lattice(const reference_volume<V>& v) const {
    return {v.liquid_einstein, v.liquid_gamma, v.liquid_gamma_slope, V(scalar_t<V>(1))};
  }

  /// e/(3RT) and C/(3R) of the vibrations of either phase.
  template <class V> static BOLIDE_INLINE heat_content<V> vibration(const lattice<V>& phase, V temperature) {
    using T = scalar_t<V>;
    const auto is_liquid = phase.loose > V(T(0));
    const V t = temperature / phase.einstein, linear = T(root2) * t, square_term = t * t, inverse = T(0.5) / (V(T(1)) + linear + square_term);
    const V w = (linear + T(2) * square_term) * inverse;
    const heat_content<V> liquid{w, w + (linear + T(4) * square_term) * inverse - T(2) * w * w};
    if (all(is_liquid)) return liquid;
    const heat_content<V> solid = oscillator(phase.einstein / temperature);
    return {select(is_liquid, liquid.energy, solid.energy), select(is_liquid, liquid.heat, solid.heat)};
  }

  /// The thermal energy and heat capacity of a phase at T > 0.
  template <class V> BOLIDE_INLINE heat_content<V> heat(const reference_volume<V>& v, const lattice<V>& phase, V temperature) const {
    using T = scalar_t<V>;
    const heat_content<V> o = vibration(phase, temperature);
    const V s = temperature / (temperature + v.free), z = temperature / (temperature + v.fermi), loose = T(-1.5 * R_) * phase.loose;
    return {temperature * (T(3 * R_) * o.energy + loose * s + T(4.5 * R_) * z),
            T(3 * R_) * o.heat + loose * s * (T(2) - s) + T(4.5 * R_) * z * (T(2) - z)};
  }

  /// e, C, F_L, F_LL, F_LT of a phase with cold curve `cold` at T > 0.
  template <class V>
  BOLIDE_INLINE free_energy<V> evaluate(const reference_volume<V>& v, const volume_function<V>& cold, const lattice<V>& phase, V temperature) const {
    using T = scalar_t<V>;
    const heat_content<V> o = vibration(phase, temperature);
    const V s = temperature / (temperature + v.free), z = temperature / (temperature + v.fermi), loose = T(-1.5 * R_) * phase.loose;
    const V gamma = phase.gamma, lambda = T(2) * v.liquid_gamma - T(2.0 / 3), lambda_slope = T(2) * v.liquid_gamma_slope;
    const V c1 = T(3 * R_) * o.heat, c2 = loose * s * (T(2) - s), c3 = T(4.5 * R_) * z * (T(2) - z);
    const V e1 = T(3 * R_) * temperature * o.energy, e2 = loose * temperature * s, e3 = T(4.5 * R_) * temperature * z;
    return {cold.value + e1 + e2 + e3, c1 + c2 + c3, cold.slope - gamma * e1 - lambda * e2 - v.electron * e3,
            cold.curvature - phase.gamma_slope * e1 - lambda_slope * e2 - v.electron_slope * e3 + gamma * gamma * (e1 - temperature * c1) +
                lambda * lambda * (e2 - temperature * c2) + v.electron * v.electron * (e3 - temperature * c3),
            -(gamma * c1 + lambda * c2 + v.electron * c3)};
  }

  /// S of a phase at T > 0, J/(kg K). Set-up work.
  double entropy(const reference_volume<double>& v, const lattice<double>& phase, double temperature) const {
    const double u = phase.einstein / temperature;
    const double vibrations = phase.loose > 0 ? 1.5 * R_ * std::log1p((root2 + 1 / u) / u) : -3 * R_ * std::log(-std::expm1(-u));
    return heat(v, phase, temperature).energy / temperature + vibrations - 1.5 * R_ * phase.loose * std::log1p(temperature / v.free) +
           4.5 * R_ * std::log1p(temperature / v.fermi);
  }

private:
  static constexpr double middle = 0.9; // of the series' variable x^(-1/3)
  static constexpr double root2 = 1.4142135623730951; // the liquid's C is then 3R but for terms of (theta/T)^3
  reference_parameters q_;
  double R_ = 0, kappa_ = 0, energy_ = 0, power_at_one_ = 0, liquid_theta_ = 0;
  std::array<double, 8> tail_{};

  /// b_4 .. b_7 from value and three derivatives of the dense branch at x_join (b_0 .. b_3 are parameters).
  void join() {
    const double L = std::log(q_.x_join), X = std::cbrt(q_.x_join), y = std::pow(q_.x_join / q_.x_gamma, q_.n), r = 1 / (1 + y);
    const double bell = 4 * q_.b_liquid * y * r * r, lambda = 2.0 / 3 + 2 * bell, lambda_1 = 2 * q_.n * bell * (1 - y) * r;
    const double lambda_2 = 2 * q_.n * q_.n * bell * r * r * (1 - 4 * y + y * y);
    const double lift = q_.c * R_ * at(q_.x_join).free;
    const double a = q_.eta * (X - 1), m = q_.eta * X / 3, g = q_.delta, fall = energy_ * std::exp(-a);
    const double first = a - 3 * g * a * a + g * a * a * a, second = 1 - 6 * g * a + 3 * g * a * a - first;
    const double p2_slope = -(1 + 6 * g) + 12 * g * a - 3 * g * a * a;
    double d[4] = {energy_ - fall * (1 + a + g * a * a * a) + lift - q_.E_coh, fall * first * m - lambda * lift,
                   fall * (second * m * m + first * m / 3) + (lambda * lambda - lambda_1) * lift,
                   fall * ((p2_slope - second) * m * m * m + second * m * m + first * m / 9) +
                       (2 * lambda * lambda_1 - lambda_2 - lambda * (lambda * lambda - lambda_1)) * lift};
    tail_ = {q_.b0, q_.b1, q_.b2, q_.b3, 0, 0, 0, 0};
    for (int k = 0; k < 4; ++k) {
      const double w = -(3 + k) / 3.0, term = tail_[static_cast<std::size_t>(k)] * std::exp(w * L);
      for (int i = 0; i < 4; ++i) d[i] -= term * std::pow(w, i);
    }
    // sum_k c_k w_k^i = d_i with w_k = -(3+k)/3, k = 4..7, c_k = b_k x_join^w_k: by Lagrange's polynomials on the w.
    for (int k = 4; k < 8; ++k) {
      double c[4] = {1, 0, 0, 0}, scale = 1; // product of (w - w_j) over j != k
      int degree = 0;
      for (int j = 4; j < 8; ++j) {
        if (j == k) continue;
        const double w = -(3 + j) / 3.0;
        for (int i = ++degree; i >= 0; --i) c[i] = (i > 0 ? c[i - 1] : 0) - w * c[i];
        scale *= -(3 + k) / 3.0 - w;
      }
      double sum = 0;
      for (int i = 0; i < 4; ++i) sum += c[i] * d[i];
      tail_[static_cast<std::size_t>(k)] = sum / scale * std::exp((3 + k) / 3.0 * L);
    }
    for (std::size_t i = 0; i < 8; ++i) // Taylor's shift to the middle
      for (std::size_t k = 7; k-- > i;) tail_[k] += middle * tail_[k + 1];
  }
};

} // namespace bolide::eos::detail
