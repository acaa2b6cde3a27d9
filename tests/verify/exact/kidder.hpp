// SPDX-License-Identifier: MIT
// Kidder's isentropic compression of a shell (Kidder 1976), cylinder (k = 2, gamma 2) or sphere (k = 3, gamma 5/3): gamma = 1 + 2/k.
// Every particle follows r = r0 h(t), h = sqrt(1 - (t/tau)^2), with
//   rho0(r0)^(gamma-1) = [(re^2 - r0^2) rho_i^(gamma-1) + (r0^2 - ri^2) rho_e^(gamma-1)]/(re^2 - ri^2),   p0 = p_e (rho0/rho_e)^gamma
//   rho = rho0 h^(-k),  p = p0 h^(-k gamma),  u = -r0 t/(tau^2 h),   tau^2 = (gamma-1)/2 (re^2 - ri^2)/(c_e^2 - c_i^2),  c^2 = gamma p0/rho0
// Beyond the shell's own rims the same formulas go on: inwards to r_v, where density and pressure vanish (a free surface), outwards for ever. A body
// from r_v to r_out follows them without any boundary condition up to the arrival of the release from r_out:
//   c0(r0)^2 = (gamma-1)/(2 tau^2) (r0^2 - r_v^2) and dr0/dt = -c0/h^2  give  sqrt((gamma-1)/2) atanh(t/tau) = arcosh(r_out/r_v) - arcosh(r/r_v).
#pragma once

#include "verify/exact/flow.hpp"

#include <cmath>

namespace bolide::verify {

struct kidder {
  int k;
  double rho_i, rho_e = 0.01, p_e = 10, ri = 0.9, re = 1.0;
  double gamma() const { return 1 + 2.0 / k; }
  double initial_density(double r0) const {
    const double g = gamma() - 1, w = (r0 * r0 - ri * ri) / (re * re - ri * ri), power = (1 - w) * std::pow(rho_i, g) + w * std::pow(rho_e, g);
    return power > 0 ? std::pow(power, 1 / g) : 0;
  }
  double initial_pressure(double r0) const { return p_e * std::pow(initial_density(r0) / rho_e, gamma()); }
  double tau() const {
    const double g = gamma(), c2_e = g * p_e / rho_e, c2_i = g * initial_pressure(ri) / rho_i;
    return std::sqrt(0.5 * (g - 1) * (re * re - ri * ri) / (c2_e - c2_i));
  }
  double scale(double t) const { return std::sqrt(1 - (t / tau()) * (t / tau())); }
  /// Radius at which density and pressure vanish at the start.
  double vacuum() const {
    const double g = gamma() - 1, i = std::pow(rho_i, g), e = std::pow(rho_e, g);
    return std::sqrt(ri * ri - (re * re - ri * ri) * i / (e - i));
  }
  /// The least outer radius at the start whose release has not come to r0 at time t.
  double undisturbed_from(double r0, double t) const {
    return vacuum() * std::cosh(std::acosh(r0 / vacuum()) + std::sqrt(0.5 * (gamma() - 1)) * std::atanh(t / tau()));
  }
  flow at(double r, double t) const {
    const double h = scale(t), r0 = r / h;
    return {initial_density(r0) * std::pow(h, -k), -r0 * t / (tau() * tau() * h), initial_pressure(r0) * std::pow(h, -k * gamma())};
  }
};

} // namespace bolide::verify
