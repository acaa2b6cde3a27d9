// SPDX-License-Identifier: MIT
// The embedded-atom potential of Cai and Ye (Phys. Rev. B 54 (1996) 8398).
//
//   f(r)   = exp[-chi (r - r_e)],  r_e = a0/sqrt 2                                  (f_e = 1: only rho/rho_e enters)
//   phi(r) = -alpha (1 + u) e^-u,  u = beta (r/r_a - 1)
//   F(rho) = -F0 (1 - n ln y) y^n + F1 y,  y = rho/rho_e,  rho_e = the sum of f over the fcc lattice at a0 with the same cut-off
// All derivatives are analytic. F' diverges at rho = 0; below y = 1e-200 the atom counts as free (F and its derivatives 0).
//
// Cut-off: `none` reaches 20 angstrom, where the lattice sums have converged to round-off for x >= 0.05; `sharp` drops
// r > 1.65 a0 as published, with a jump in the energy wherever a neighbour crosses it.
// Default: aluminium.
#pragma once

#include "bolide/concepts/potential.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/potential/shells.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace bolide::potential {

enum class cutoff { none, sharp };

/// Defaults: aluminium.
struct cai_ye_parameters {
  double alpha = 0.0834, beta = 7.5995, r_a = 3.0169; // eV, -, angstrom: the pair term
  double F0 = 2.61, F1 = -0.1392, n = 0.5;            // eV, eV, -: the embedding term
  double chi = 2.5;                                   // 1/angstrom: the density term
  double a0 = 4.05;                                   // angstrom, lattice constant at x = 1
  double mass = 26.982;                               // atomic mass unit
  double sharp_cutoff = 1.65;                         // in a0

  /// Throws bad_parameter; `owner` is what its sentence calls the model.
  void validate(std::string_view owner) const {
    const auto name = [&](const char* what) { return std::string(owner).append(" ").append(what); };
    require(alpha > 0, name("alpha"), alpha, "> 0", "eV");
    require(beta > 0, name("beta"), beta, "> 0");
    require(r_a > 0, name("r_a"), r_a, "> 0", "angstrom");
    require(chi > 0, name("chi"), chi, "> 0", "1/angstrom");
    require(n > 0 && n < 1, name("n"), n, "between 0 and 1");
    require(a0 > 0, name("a0"), a0, "> 0", "angstrom");
    require(mass > 0, name("mass"), mass, "> 0", "u");
    require(sharp_cutoff > 0.71, name("sharp_cutoff"), sharp_cutoff, "> 0.71 (the nearest neighbours)", "a0");
  }
};

class cai_ye {
public:
  explicit cai_ye(cutoff reach = cutoff::none, const cai_ye_parameters& parameters = {}, std::string_view owner = "potential::cai_ye")
      : q_(parameters), reach_(reach == cutoff::none ? uncut_reach : q_.sharp_cutoff * q_.a0) {
    q_.validate(owner);
    rho_e_ = 0;
    for (const shell& s : shells(lattice::fcc, reach_ / q_.a0)) rho_e_ += s.atoms * density(s.distance * q_.a0).value;
  }

  potential_value pair(double r) const {
    const double slope = q_.beta / q_.r_a, u = q_.beta * (r / q_.r_a - 1), g = q_.alpha * std::exp(-u);
    return {-(1 + u) * g, slope * u * g, slope * slope * (1 - u) * g};
  }
  potential_value density(double r) const {
    const double f = std::exp(-q_.chi * (r - q_.a0 / std::sqrt(2.0)));
    return {f, -q_.chi * f, q_.chi * q_.chi * f};
  }
  potential_value embedding(double rho) const {
    const double y = rho / rho_e_;
    if (!(y > 1e-200)) return {0, 0, 0};
    const double log_y = std::log(y), y_n = std::pow(y, q_.n), n2 = q_.F0 * q_.n * q_.n;
    return {-q_.F0 * (1 - q_.n * log_y) * y_n + q_.F1 * y, (n2 * log_y * y_n / y + q_.F1) / rho_e_,
            n2 * (1 + (q_.n - 1) * log_y) * (y_n / rho) / rho};
  }

  double reach() const { return reach_; }
  double lattice_constant() const { return q_.a0; }
  lattice structure() const { return lattice::fcc; }
  double mass() const { return q_.mass; }
  /// rho_e: the density of the lattice at x = 1, with f_e = 1.
  double equilibrium_density() const { return rho_e_; }
  const cai_ye_parameters& parameters() const { return q_; }

private:
  cai_ye_parameters q_;
  double reach_ = 0, rho_e_ = 1; // angstrom, -
};

static_assert(EmbeddedAtomPotential<cai_ye>);

} // namespace bolide::potential
