// SPDX-License-Identifier: MIT
// The exact Riemann solution of stiffened gases (p_inf = 0: ideal ones) from the textbook's two-branch pressure functions, with another
// gamma and p_inf on either side: what the general solver is measured by. Shares no code with it.
//   P = p + p_inf behaves as the pressure of an ideal gas; f(p) = change of speed across the wave
#pragma once

#include <cmath>

namespace bolide::test {

struct gamma_side {
  double gamma, p_inf, rho, u, p;
  double c() const { return std::sqrt(gamma * (p + p_inf) / rho); }
  double change(double p_star) const {
    const double P = p_star + p_inf, P0 = p + p_inf;
    if (p_star > p) return (P - P0) * std::sqrt(2 / ((gamma + 1) * rho) / (P + (gamma - 1) / (gamma + 1) * P0));
    return 2 * c() / (gamma - 1) * (std::pow(P / P0, (gamma - 1) / (2 * gamma)) - 1);
  }
  double density(double p_star) const {
    const double P = p_star + p_inf, P0 = p + p_inf, k = (gamma - 1) / (gamma + 1);
    return p_star > p ? rho * (P / P0 + k) / (k * P / P0 + 1) : rho * std::pow(P / P0, 1 / gamma);
  }
  /// Speed of the shock into the material (p_star > p).
  double shock_speed(double p_star) const {
    return c() * std::sqrt((gamma + 1) / (2 * gamma) * ((p_star + p_inf) / (p + p_inf)) + (gamma - 1) / (2 * gamma));
  }
};

struct gamma_solution {
  double p, u;
};

inline gamma_solution exact_riemann(const gamma_side& l, const gamma_side& r) {
  const auto f = [&](double p) { return l.change(p) + r.change(p) + r.u - l.u; };
  double low = -std::fmin(l.p_inf, r.p_inf), high = l.p + r.p + 1e-30;
  while (f(high) < 0) high *= 2;
  for (int i = 0; i < 2000 && high - low > 1e-17 * (std::abs(low) + std::abs(high)); ++i) {
    const double middle = low > 0 && high > 4 * low ? std::sqrt(low * high) : 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (f(middle) < 0 ? low : high) = middle;
  }
  return {high, 0.5 * (l.u + r.u) + 0.5 * (r.change(high) - l.change(high))};
}

} // namespace bolide::test
