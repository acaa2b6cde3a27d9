// SPDX-License-Identifier: MIT
// Sedov's blast wave: energy E set free at t = 0 on a plane (j = 1, E per area, both sides: the published 0.0673185 is that of one side), a line
// (2, per length) or a point (3) of cold gas of density rho0. With the shock at r_s = (E t^2/(alpha rho0))^(1/(j+2)) and the self-similar variable V in [V_0, V_2] (Sedov 1959; Kamm 2000):
//   V_0 = 2/((j+2) gamma), V_2 = 4/((j+2)(gamma+1)),  x1 = (j+2)(gamma+1) V/4,  x2 = b ((j+2) gamma V/2 - 1),  x3 = d (1 - (2+j(gamma-1)) V/2),
//   x4 = b (1 - (j+2) V/2),  b = (gamma+1)/(gamma-1),  d = (j+2)(gamma+1)/((j+2)(gamma+1) - 2 (2+j(gamma-1)))
//   r/r_s = x1^-a0 x2^-a2 x3^-a1,  u/u_2 = x1 r/r_s,  rho/rho_2 = x2^a3 x3^a4 x4^a5,  p/p_2 = x1^(a0 j) x3^(a4-2 a1) x4^(1+a5)
// alpha comes from the energy integral. For gamma < gamma_s where the standard case holds (gamma < 7 for j = 3; all for j = 1, 2 but gamma = 2
// of j = 2, where two exponents have poles). The test of this file holds mass, energy and all three equations of motion against it.
#pragma once

#include "verify/exact/flow.hpp"

#include "bolide/core/contract.hpp"

#include <cmath>
#include <numbers>

namespace bolide::verify {

class sedov {
public:
  sedov(int j, double energy, double gamma = 1.4, double rho0 = 1) : j_(j), gamma_(gamma), rho0_(rho0) {
    const double n = j + 2, g = gamma;
    v0_ = 2 / (n * g), v2_ = 4 / (n * (g + 1));
    b_ = (g + 1) / (g - 1), d_ = n * (g + 1) / (n * (g + 1) - 2 * (2 + j * (g - 1)));
    const double d2 = 2 * (g - 1) + j, d3 = j * (2 - g);
    require(std::abs(d3) > 1e-6, "Sedov gamma", gamma, "other than 2");
    a0_ = 2 / n, a2_ = -(g - 1) / d2;
    a1_ = n * g / (2 + j * (g - 1)) * (2 * d3 / (g * n * n) - a2_);
    a3_ = j / d2, a4_ = n * j * a1_ / d3, a5_ = -2 * j / d3;
    alpha_ = energy_integral();
    e_ = energy;
  }
  double alpha() const { return alpha_; }
  double shock(double t) const { return std::pow(e_ * t * t / (alpha_ * rho0_), 1.0 / (j_ + 2)); }
  double shock_speed(double t) const { return 2.0 / (j_ + 2) * shock(t) / t; }
  flow behind_shock(double t) const {
    const double us = shock_speed(t);
    return {rho0_ * b_, 2 * us / (gamma_ + 1), 2 * rho0_ * us * us / (gamma_ + 1)};
  }
  flow at(double r, double t) const {
    const double rs = shock(t);
    if (r >= rs) return {rho0_, 0, 0};
    double low = 1e-300, high = v2_ - v0_; // r/r_s rises with V; close to V_0 like a small power of V - V_0, hence the geometric mean
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
      const double mid = std::sqrt(low) * std::sqrt(high);
      (radius(mid) < r / rs ? low : high) = mid;
    }
    const auto f = shape(std::sqrt(low) * std::sqrt(high));
    const auto s = behind_shock(t);
    return {s.rho * f.rho, s.u * f.u, s.p * f.p};
  }

private:
  int j_;
  double gamma_, rho0_, e_ = 0, alpha_ = 0, v0_, v2_, b_, d_, a0_, a1_, a2_, a3_, a4_, a5_;

  struct variables {
    double x1, x2, x3, x4;
  };
  variables at_v(double beyond) const { // beyond: V - V_0
    const double n = j_ + 2, v = v0_ + beyond;
    return {0.25 * n * (gamma_ + 1) * v, b_ * 0.5 * n * gamma_ * beyond, d_ * (1 - 0.5 * (2 + j_ * (gamma_ - 1)) * v), b_ * (1 - 0.5 * n * v)};
  }
  double radius(double beyond) const {
    const auto x = at_v(beyond);
    return std::pow(x.x1, -a0_) * std::pow(x.x2, -a2_) * std::pow(x.x3, -a1_);
  }
  flow shape(double beyond) const { // over the values behind the shock
    const auto x = at_v(beyond);
    return {std::pow(x.x2, a3_) * std::pow(x.x3, a4_) * std::pow(x.x4, a5_), x.x1 * radius(beyond),
            std::pow(x.x1, a0_ * j_) * std::pow(x.x3, a4_ - 2 * a1_) * std::pow(x.x4, 1 + a5_)};
  }
  /// E t^2/(rho0 r_s^(j+2)): area * integral of (rho u^2/2 + p/(gamma-1)) l^(j-1) dl in units of rho0 (r_s/t)^2, over V = V_0 + (V_2 - V_0) w^m
  /// with m = -2/a2, so that l ~ w^2 at V_0; by the midpoint rule with Richardson's step.
  double energy_integral() const {
    const auto sum = [this](int cells) {
      const double m = -2 / a2_, us = 2.0 / (j_ + 2);
      double total = 0, l_before = 0;
      for (int i = 0; i < cells; ++i) {
        const auto beyond = [&](double w) { return (v2_ - v0_) * std::pow(w, m); };
        const double middle = beyond((i + 0.5) / cells), l_after = radius(beyond((i + 1.0) / cells));
        const auto f = shape(middle);
        const double l = radius(middle), u = 2 * us / (gamma_ + 1) * f.u;
        total += (0.5 * b_ * f.rho * u * u + 2 * us * us / (gamma_ + 1) * f.p / (gamma_ - 1)) * std::pow(l, j_ - 1) * (l_after - l_before);
        l_before = l_after;
      }
      return total;
    };
    const double area = j_ == 1 ? 2 : j_ == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi;
    return area * (4 * sum(4000) - sum(2000)) / 3;
  }
};

} // namespace bolide::verify
