// SPDX-License-Identifier: MIT
// Cold curve from the embedded-atom potential of Cai and Ye (Phys. Rev. B 54 (1996) 8398), summed over the shells of the fcc lattice.
//
//   E = F(rho) + 1/2 sum phi(r),  rho = sum f(r)                                    energy per atom
//   f(r)   = exp[-chi (r - r_e)],  r_e = a0/sqrt 2                                  (f_e = 1: only rho/rho_e enters)
//   phi(r) = -alpha (1 + u) e^-u,  u = beta (r/r_a - 1)
//   F(rho) = -F0 (1 - n ln y) y^n + F1 y,  y = rho/rho_e,  rho_e = the sum at x = 1 with the same cut-off
// With D = d/d ln a and V_a = a^3/4 per atom:  p_c = -DE/(3 V_a),  dp_c/dx = -(D^2 E - 3 DE)/(9 V_a x); all derivatives are analytic.
// e_c = (E - E(1))/mass, so e_c(1) = 0. x = 1 is a = a0 exactly, and p_c(1) is the small value that the potential has there
// (-20.6 MPa without cut-off, +4.5 MPa with the sharp one).
//
// Cut-off: `none` sums to 20 angstrom, which has converged to round-off for x >= 0.05 (the nearest shell always counts, so that the
// curve stays smooth for any x); `sharp` drops r > 1.65 a0 as published: p_c then jumps by 9 to 150 MPa and e_c by 0.9 to 7 kJ/kg
// wherever a shell crosses the cut. Validity: against static data about 17 % stiff at x = 0.5 (docs/eos.md).
// Cost: about 2 microseconds at x = 1, 40 at x = 0.2. For the time loop wrap it in cold::tabulated.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/unit.hpp"
#include "bolide/eos/cold/fcc_shells.hpp"

#include <cmath>
#include <vector>

namespace bolide::cold {

enum class cutoff { none, sharp };

/// Defaults: aluminium.
struct cai_ye_parameters {
  double alpha = 0.0834, beta = 7.5995, r_a = 3.0169; // eV, -, angstrom: the pair term
  double F0 = 2.61, F1 = -0.1392, n = 0.5;            // eV, eV, -: the embedding term
  double chi = 2.5;                                   // 1/angstrom: the density term
  double a0 = 4.05;                                   // angstrom, lattice constant at x = 1
  double mass = 26.982;                               // atomic mass unit
  double sharp_cutoff = 1.65;                         // in a0
};

class cai_ye {
public:
  explicit cai_ye(cutoff reach = cutoff::none, const cai_ye_parameters& parameters = {}) : q_(parameters) {
    require(q_.alpha > 0, "cold::cai_ye alpha", q_.alpha, "> 0", "eV");
    require(q_.beta > 0, "cold::cai_ye beta", q_.beta, "> 0");
    require(q_.r_a > 0, "cold::cai_ye r_a", q_.r_a, "> 0", "angstrom");
    require(q_.chi > 0, "cold::cai_ye chi", q_.chi, "> 0", "1/angstrom");
    require(q_.n > 0 && q_.n < 1, "cold::cai_ye n", q_.n, "between 0 and 1");
    require(q_.a0 > 0, "cold::cai_ye a0", q_.a0, "> 0", "angstrom");
    require(q_.mass > 0, "cold::cai_ye mass", q_.mass, "> 0", "u");
    require(q_.sharp_cutoff > 0.71, "cold::cai_ye sharp_cutoff", q_.sharp_cutoff, "> 0.71 (the nearest neighbours)", "a0");
    const double smallest_x = 0.05;
    reach_ = reach == cutoff::none ? 20.0 : q_.sharp_cutoff * q_.a0;
    shells_ = fcc_shells(reach_ / (q_.a0 * std::cbrt(smallest_x)));
    density_scale_ = 1;
    density_scale_ = sum(1.0).density;
    energy_at_one_ = sum(1.0).energy;
  }

  /// Exact to round-off. A pack or a float is answered lane by lane in double.
  template <class V> cold_point<V> evaluate(V x) const {
    if constexpr (lane_width<V> == 1) {
      const cold_point<double> r = exact(static_cast<double>(x));
      return {static_cast<V>(r.energy), static_cast<V>(r.pressure), static_cast<V>(r.slope)};
    } else {
      cold_point<V> r{};
      for (int i = 0; i < lane_width<V>; ++i) {
        const cold_point<double> one = exact(static_cast<double>(lane(x, i)));
        r.energy.set(i, static_cast<scalar_t<V>>(one.energy));
        r.pressure.set(i, static_cast<scalar_t<V>>(one.pressure));
        r.slope.set(i, static_cast<scalar_t<V>>(one.slope));
      }
      return r;
    }
  }

  double reference_density() const { return atom_mass() / atom_volume(1.0); } // kg/m3
  double cohesive_energy() const { return -energy_at_one_ * unit::eV / atom_mass(); } // J/kg, e_c for x -> infinity
  double energy_per_atom(double x) const { return sum(x).energy; }                    // eV, 0 for free atoms
  /// The electron density of the lattice at x = 1 with f_e = 1, which is rho_e.
  double density_at_one() const { return density_scale_; }
  const cai_ye_parameters& parameters() const { return q_; }

private:
  struct lattice_sum {
    double energy, first, second; // eV; E, DE, D^2 E
    double density;               // rho/rho_e
  };

  double atom_mass() const { return q_.mass * unit::u; }
  double atom_volume(double x) const {
    const double a0 = q_.a0 * unit::angstrom;
    return 0.25 * a0 * a0 * a0 * x;
  }

  lattice_sum sum(double x) const {
    const double a = q_.a0 * std::cbrt(x), r_e = q_.a0 / std::sqrt(2.0);
    double rho = 0, rho1 = 0, rho2 = 0, pair = 0, pair1 = 0, pair2 = 0;
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      const double r = shells_[i].distance * a, atoms = shells_[i].atoms;
      if (r > reach_ && (i > 0 || reach_ < 20.0)) break;
      const double f = atoms * std::exp(-q_.chi * (r - r_e)), k = q_.chi * r;
      rho += f;
      rho1 -= k * f;
      rho2 += k * (k - 1) * f;
      const double w = q_.beta * r / q_.r_a, u = w - q_.beta, g = 0.5 * atoms * q_.alpha * std::exp(-u);
      pair -= (1 + u) * g;
      pair1 += w * u * g;
      pair2 += w * (u + w * (1 - u)) * g;
    }
    const double y = rho / density_scale_, y1 = rho1 / density_scale_, y2 = rho2 / density_scale_;
    if (!(y > 1e-300)) return {pair, pair1, pair2, y}; // free atoms: the embedding energy is 0
    const double log_y = std::log(y), y_n = std::pow(y, q_.n), n2 = q_.F0 * q_.n * q_.n;
    const double F = -q_.F0 * (1 - q_.n * log_y) * y_n + q_.F1 * y;
    const double F_1 = n2 * log_y * y_n / y + q_.F1;                            // dF/dy
    const double F_2y1 = n2 * (1 + (q_.n - 1) * log_y) * (y_n / y) * (y1 / y);  // d2F/dy2 * Dy
    return {F + pair, F_1 * y1 + pair1, F_2y1 * y1 + F_1 * y2 + pair2, y};
  }

  cold_point<double> exact(double x) const {
    const lattice_sum s = sum(x);
    const double pascal = unit::eV / (3 * atom_volume(x));
    return {(s.energy - energy_at_one_) * unit::eV / atom_mass(), -s.first * pascal, -(s.second - 3 * s.first) * pascal / (3 * x)};
  }

  cai_ye_parameters q_;
  std::vector<fcc_shell> shells_;
  double reach_ = 0, density_scale_ = 1, energy_at_one_ = 0; // angstrom, -, eV
};

static_assert(ColdCurve<cai_ye>);

} // namespace bolide::cold
