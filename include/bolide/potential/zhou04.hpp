// SPDX-License-Identifier: MIT
// The embedded-atom potential of Zhou, Johnson and Wadley (Phys. Rev. B 69 (2004) 144113).
//
//   f(r)   = f_e exp[-beta (u - 1)]/(1 + (u - lambda)^20),  u = r/r_e
//   phi(r) = A exp[-alpha (u - 1)]/(1 + (u - kappa)^20) - B exp[-beta (u - 1)]/(1 + (u - lambda)^20)
//   F(rho) = sum Fn_i (rho/(0.85 rho_e) - 1)^i   for rho < 0.85 rho_e
//            sum F_i  (rho/rho_e - 1)^i          up to 1.15 rho_e
//            F_e (1 - eta ln y) y^eta, y = rho/rho_s   above
// As published: where the pieces join, F steps by 4e-7 eV, F' by 6e-7 eV/rho_e and, at 1.15 rho_e, F'' by 2.3 eV/rho_e^2 (aluminium of
// 2004): the cold curve's p_c steps by 7 kPa at x = 1.1037, its slope from -71 to -151 GPa at x = 0.9152. F(0) is -1e-6 eV rather
// than 0. No cut-off is published: the (u - lambda)^20 of the denominators ends both functions near 2 r_e. The lattice is fcc with
// a0 = sqrt 2 r_e.
// Default: aluminium of 2004. The set of 2001 (Acta Mater. 49, 4005) has the same form; its a0 and bulk modulus are not aluminium's.
#pragma once

#include "bolide/concepts/potential.hpp"
#include "bolide/core/contract.hpp"

#include <array>
#include <cmath>

namespace bolide::potential {

struct zhou_parameters {
  double r_e = 2.863924, f_e = 1.403115;       // angstrom, -
  double rho_e = 20.418205, rho_s = 23.195740; // -
  double alpha = 6.613165, beta = 3.527021;
  double A = 0.314873, B = 0.365551; // eV
  double kappa = 0.379846, lambda = 0.759692;
  std::array<double, 4> Fn{-2.807602, -0.301435, 1.258562, -1.247604}; // eV
  std::array<double, 4> F{-2.83, 0, 0.622245, -2.488244};              // eV
  double eta = 0.785902, F_e = -2.824528;                              // -, eV
  double mass = 26.981539;                                             // atomic mass unit
};

class zhou04 {
public:
  explicit zhou04(const zhou_parameters& parameters = {}) : q_(parameters) {
    require(q_.r_e > 0, "potential::zhou04 r_e", q_.r_e, "> 0", "angstrom");
    require(q_.f_e > 0, "potential::zhou04 f_e", q_.f_e, "> 0");
    require(q_.rho_e > 0, "potential::zhou04 rho_e", q_.rho_e, "> 0");
    require(q_.rho_s > 0, "potential::zhou04 rho_s", q_.rho_s, "> 0");
    require(q_.alpha > 0, "potential::zhou04 alpha", q_.alpha, "> 0");
    require(q_.beta > 0, "potential::zhou04 beta", q_.beta, "> 0");
    require(q_.mass > 0, "potential::zhou04 mass", q_.mass, "> 0", "u");
  }

  potential_value pair(double r) const {
    const potential_value repulsion = damped(q_.A, q_.alpha, q_.kappa, r), attraction = damped(q_.B, q_.beta, q_.lambda, r);
    return {repulsion.value - attraction.value, repulsion.first - attraction.first, repulsion.second - attraction.second};
  }
  potential_value density(double r) const { return damped(q_.f_e, q_.beta, q_.lambda, r); }
  potential_value embedding(double rho) const {
    if (rho < lower * q_.rho_e) return cubic(q_.Fn, lower * q_.rho_e, rho);
    if (rho < upper * q_.rho_e) return cubic(q_.F, q_.rho_e, rho);
    const double log_y = std::log(rho / q_.rho_s), scale = q_.F_e * std::pow(rho / q_.rho_s, q_.eta), eta = q_.eta;
    return {scale * (1 - eta * log_y), -scale * eta * eta * log_y / rho, -scale * eta * eta * (1 + (eta - 1) * log_y) / (rho * rho)};
  }

  double reach() const { return uncut_reach; }
  double lattice_constant() const { return std::sqrt(2.0) * q_.r_e; }
  lattice structure() const { return lattice::fcc; }
  double mass() const { return q_.mass; }
  const zhou_parameters& parameters() const { return q_; }

private:
  static constexpr double lower = 0.85, upper = 1.15; // in rho_e, where the pieces of F join

  /// scale exp[-decay (u - 1)]/(1 + (u - shift)^20).
  potential_value damped(double scale, double decay, double shift, double r) const {
    const double u = r / q_.r_e, w = u - shift, w18 = std::pow(w, 18), inverse = 1 / (1 + w18 * w * w);
    const double value = scale * std::exp(-decay * (u - 1)) * inverse;
    const double log_1 = -decay - 20 * w18 * w * inverse; // d ln/du and its derivative
    const double log_2 = -20 * w18 * (19 - w18 * w * w) * inverse * inverse;
    return {value, value * log_1 / q_.r_e, value * (log_1 * log_1 + log_2) / (q_.r_e * q_.r_e)};
  }
  static potential_value cubic(const std::array<double, 4>& c, double scale, double rho) {
    const double s = rho / scale - 1;
    return {c[0] + s * (c[1] + s * (c[2] + s * c[3])), (c[1] + s * (2 * c[2] + s * 3 * c[3])) / scale, (2 * c[2] + s * 6 * c[3]) / (scale * scale)};
  }

  zhou_parameters q_;
};

static_assert(EmbeddedAtomPotential<zhou04>);

} // namespace bolide::potential
