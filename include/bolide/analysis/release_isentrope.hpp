// SPDX-License-Identifier: MIT
// The release isentrope from a compressed state down to a pressure (0 by default): residual energy and free-surface speed.
//
//   de = -p dV,  du = -dp/(rho c) = -c d ln rho,   followed in ln V by an embedded Runge-Kutta pair of order 5(4) (Dormand-Prince)
// The step is controlled at 1e-10 of the scale (e: |e| + 1 kJ/kg, u: 1 m/s + |u|); kinks at phase borders only shorten it. The end is
// met by halving and a bracketed root on the length of the last step. Stops with bad_parameter where c^2 is not positive.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"

#include <algorithm>
#include <cmath>

namespace bolide::analysis {

struct released_state {
  double density;       // kg/m3
  double energy;        // J/kg
  double pressure;      // Pa
  double temperature;   // K; NaN where the model knows none
  double melt_fraction; // 0 where the model knows none
  double speed_gain;    // m/s, integral of dp/(rho c): a free surface moves at up + speed_gain
  int steps;
};

namespace detail {
/// Energy and speed against y = ln V.
struct isentrope_point {
  double y, e, u;
};
struct isentrope_slope {
  double e, u;
};
template <class Eos> isentrope_slope isentrope_rate(const Eos& eos, const isentrope_point& a) {
  const double rho = std::exp(-a.y);
  const auto r = eos.evaluate(rho, a.e);
  return {-r.pressure / rho, std::sqrt(std::max(r.sound_speed_squared, 0.0))};
}
/// One Dormand-Prince step of length h; error receives the scaled difference of the pair.
template <class Eos> isentrope_point isentrope_step(const Eos& eos, const isentrope_point& a, double h, double& error) {
  static constexpr double c[7] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
  static constexpr double w[7][6] = {{},
                                     {1. / 5},
                                     {3. / 40, 9. / 40},
                                     {44. / 45, -56. / 15, 32. / 9},
                                     {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
                                     {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
                                     {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  static constexpr double d[7] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
  isentrope_slope k[7];
  isentrope_point p = a;
  double error_e = 0, error_u = 0;
  for (int i = 0; i < 7; ++i) {
    p = {a.y + c[i] * h, a.e, a.u};
    for (int j = 0; j < i; ++j) {
      p.e += h * w[i][j] * k[j].e;
      p.u += h * w[i][j] * k[j].u;
    }
    k[i] = isentrope_rate(eos, p);
    error_e += h * d[i] * k[i].e;
    error_u += h * d[i] * k[i].u;
  }
  error = std::max(std::abs(error_e) / (std::abs(p.e) + 1e3), std::abs(error_u) / (std::abs(p.u) + 1));
  return p;
}
template <class Eos> double pressure_at(const Eos& eos, const isentrope_point& a) { return eos.evaluate(std::exp(-a.y), a.e).pressure; }

/// Follows the isentrope from (rho, e), expanding or compressing, until until(point) changes sign; watch(point) sees every step.
template <class Eos, class Until>
isentrope_point follow_isentrope(const Eos& eos, double rho, double e, bool expanding, const Until& until, int& steps) {
  isentrope_point a{-std::log(rho), e, 0};
  const bool sign = until(a) > 0;
  double h = expanding ? 1e-3 : -1e-3;
  for (steps = 0; steps < 200000; ++steps) {
    double error = 0;
    const isentrope_point b = isentrope_step(eos, a, h, error);
    if (!(error <= 1e-10) && std::abs(h) > 1e-9) {
      h *= std::clamp(0.9 * std::pow(1e-10 / error, 0.2), 0.1, 0.5);
      continue;
    }
    if ((until(b) > 0) != sign) {
      const auto at = [&](double length) { return until(isentrope_step(eos, a, length, error)); };
      return isentrope_step(eos, a, eos::bracketed_root(at, 0, h), error);
    }
    require(eos.evaluate(std::exp(-b.y), b.e).sound_speed_squared > 0, "density on the isentrope", std::exp(-b.y),
            "where the equation of state is stable (c^2 > 0) until the end is reached", "kg/m3");
    a = b;
    h = std::clamp(h * std::clamp(0.9 * std::pow(1e-10 / std::max(error, 1e-20), 0.2), 0.5, 3.0), -0.02, 0.02);
  }
  require(false, "steps on the isentrope", steps, "below 200000");
  return a;
}
} // namespace detail

/// Expands (rho, e) isentropically to pressure p_end.
template <class Eos> released_state release_isentrope(const Eos& eos, double rho, double e, double p_end = 0) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::release_isentrope needs an EquationOfState.");
  const double p = eos.evaluate(rho, e).pressure;
  require(p > p_end, "pressure at the start of a release", p, "above the end pressure", "Pa");
  released_state r{};
  const auto above = [&](const detail::isentrope_point& a) { return detail::pressure_at(eos, a) - p_end; };
  const auto end = detail::follow_isentrope(eos, rho, e, true, above, r.steps);
  r.density = std::exp(-end.y);
  r.energy = end.e;
  r.speed_gain = end.u;
  const auto at = eos.evaluate(r.density, r.energy);
  r.pressure = at.pressure;
  r.temperature = std::nan("");
  if constexpr (ThermalEquationOfState<Eos>) {
    r.temperature = at.temperature;
    r.melt_fraction = at.melt_fraction;
  }
  return r;
}

} // namespace bolide::analysis
