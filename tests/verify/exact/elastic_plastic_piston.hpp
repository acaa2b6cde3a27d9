// SPDX-License-Identifier: MIT
// A piston of speed u drives an elastic, perfectly plastic half-space in uniaxial strain: an elastic precursor and a plastic shock (Udaykumar et al.
// 2003; Maire et al. 2013), both steady jumps. Hypoelastic as in material/material.hpp: ds_xx = (4/3) G dln(rho), pressure from p(rho, e - e_shear),
// e_shear = s:s/(4 G rho).
//   precursor   compressed to |s_xx| = 2Y/3: rho_1 = rho_0 exp(Y/(2G))
//   each jump   rho_a D_rel = rho_b (D_rel - du),  d(-sigma) = rho_a D_rel du,  de = (-sigma_a - sigma_b)/2 (1/rho_a - 1/rho_b)
// with -sigma = p + 2Y/3 behind both. The published figures give the equation of state all of e, elastic shear energy too (shear_heats): 0.8 MPa
// more for aluminium, 0.06 MPa for copper.
#pragma once

#include "bolide/core/contract.hpp"

#include <cmath>

namespace bolide::verify {

struct stressed_state {
  double rho, u, p, minus_sigma, e, speed; // speed: of the wave that leads to it, relative to the material at rest
};

template <class Eos> struct elastic_plastic_piston {
  Eos eos;
  double shear_modulus, yield, rho0;
  bool shear_heats = false;

  double shear_energy(double rho) const { return shear_heats ? 0 : yield * yield / (6 * shear_modulus * rho); } // s:s = (2/3) Y^2
  stressed_state precursor() const {
    const double rho = rho0 * std::exp(yield / (2 * shear_modulus));
    return behind({rho0, 0, 0, 0, 0, 0}, rho);
  }
  /// The plastic wave that brings the material to the piston's speed.
  stressed_state plastic(double u) const {
    const auto ahead = precursor();
    require(u > ahead.u, "piston speed", u, "above that of the precursor", "m/s");
    double low = ahead.rho * (1 + 1e-12), high = 1.5 * ahead.rho;
    for (int i = 0; i < 200; ++i) {
      const double mid = 0.5 * (low + high);
      (behind(ahead, mid).u < u ? low : high) = mid;
    }
    return behind(ahead, 0.5 * (low + high));
  }

private:
  /// Behind a steady jump from `a` to density rho, at yield.
  stressed_state behind(const stressed_state& a, double rho) const {
    const double dv = 1 / a.rho - 1 / rho;
    double p = a.p, e = 0;
    for (int i = 0; i < 100; ++i) { // p and e depend on each other: a contraction, by the factor Gamma (rho - rho_a)/2
      e = a.e + 0.5 * (a.minus_sigma + p + 2.0 / 3 * yield) * dv;
      p = eos.evaluate(rho, e - shear_energy(rho)).pressure;
    }
    const double stress = p + 2.0 / 3 * yield, du = std::sqrt((stress - a.minus_sigma) * dv);
    return {rho, a.u + du, p, stress, e, a.u + du / (a.rho * dv)};
  }
};

template <class Eos> elastic_plastic_piston(Eos, double, double, double) -> elastic_plastic_piston<Eos>;
template <class Eos> elastic_plastic_piston(Eos, double, double, double, bool) -> elastic_plastic_piston<Eos>;

} // namespace bolide::verify
