// SPDX-License-Identifier: MIT
// The cold curve of any embedded-atom potential (concepts/potential.hpp): the energy of its perfect crystal, fcc or bcc, summed over
// the neighbour shells.
//
//   E(a) = F(rho) + 1/2 sum phi(r),  rho = sum f(r),  r = d a                    energy per atom, d of potential::shells
// With D = d/d ln a and V_a = a^3/(atoms per cell):  p_c = -DE/(3 V_a),  dp_c/dx = -(D^2 E - 3 DE)/(9 V_a x); all derivatives are
// those of the potential, analytic. e_c = (E - E(1))/mass, so e_c(1) = 0. x = 1 is a = a0 exactly, and p_c(1) is the small value that
// the potential has there. Free atoms have E = F(0).
//
// Where the potential has a cut-off, what lies beyond it is dropped: p_c and e_c jump wherever a shell crosses a cut that has a jump. Where it
// has none (reach() = uncut_reach), the nearest shell always counts, so that the curve stays smooth for any x. Shells are kept for
// x >= 0.05; below that the outermost are missing.
// Cost without cut-off: about 1 microsecond at x = 1, 3 at x = 0.2. For the time loop wrap it in cold::tabulated.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/concepts/potential.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/unit.hpp"
#include "bolide/eos/cold/each_lane.hpp"
#include "bolide/potential/shells.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bolide::cold {

/// The three elastic constants of a cubic crystal, Pa. Under pressure they are the stress-strain coefficients: those of the sound
/// speeds (rho c^2 along [100]: C11 longitudinal, C44 transverse), and (C11 + 2 C12)/3 is the bulk modulus at any x.
struct cubic_elastic_constants {
  double C11, C12, C44;
};

template <EmbeddedAtomPotential Potential> class lattice {
public:
  explicit lattice(Potential potential) : potential_(std::move(potential)), reach_(potential_.reach()), uncut_(reach_ >= uncut_reach) {
    const double a0 = potential_.lattice_constant(), smallest_x = 0.05;
    require(a0 > 0, "cold::lattice lattice_constant", a0, "> 0", "angstrom");
    require(potential_.mass() > 0, "cold::lattice mass", potential_.mass(), "> 0", "u");
    require(reach_ > 0 && reach_ < 20 * a0, "cold::lattice reach", reach_, "> 0 and below 20 lattice constants", "angstrom");
    shells_ = bolide::potential::shells(potential_.structure(), std::fmax(1.0, reach_ / (a0 * std::cbrt(smallest_x))));
    energy_at_one_ = sum(1.0).energy;
  }

  /// Exact to round-off. A pack or a float is answered lane by lane in double.
  template <class V> cold_point<V> evaluate(V x) const {
    return detail::each_lane(x, [this](double one) { return exact(one); });
  }

  double reference_density() const { return atom_mass() / atom_volume(1.0); } // kg/m3
  double energy_per_atom(double x) const { return sum(x).energy; }            // eV, on the potential's own scale
  double cohesive_energy_per_atom() const { return potential_.embedding(0).value - energy_at_one_; } // eV
  double cohesive_energy() const { return cohesive_energy_per_atom() * unit::eV / atom_mass(); }     // J/kg, e_c for x -> infinity

  /// B = -V dp_c/dV, Pa.
  double bulk_modulus(double x = 1) const { return -x * exact(x).slope; }
  /// B' = dB/dp_c, by fourth-order central differences of the analytic B over x (1 +- 0.02): steps so wide that a tabulated potential's
  /// roughness does not drown it (error 2e-4 for the analytic ones).
  double bulk_modulus_derivative(double x = 1) const {
    const double h = 1e-2 * x;
    const double dB_dx = (8 * (bulk_modulus(x + h) - bulk_modulus(x - h)) - (bulk_modulus(x + 2 * h) - bulk_modulus(x - 2 * h))) / (12 * h);
    return dB_dx / exact(x).slope;
  }
  /// From the second derivatives of E under a homogeneous strain, the embedding term included.
  cubic_elastic_constants elastic_constants(double x = 1) const;
  /// Energy to take an atom out and put it back at a site of the bulk, eV, the others left where they are (unrelaxed).
  double vacancy_energy(double x = 1) const;

  const Potential& potential() const { return potential_; }

private:
  struct lattice_sum {
    double energy, first, second; // eV; E, DE, D^2 E
  };

  double atom_mass() const { return potential_.mass() * unit::u; }
  double atom_volume(double x) const {
    const double a0 = potential_.lattice_constant() * unit::angstrom;
    return a0 * a0 * a0 * x / atoms_per_cell(potential_.structure());
  }

  /// take(shell, r) for every shell that counts at x.
  template <class Take> void each_shell(double x, const Take& take) const {
    const double a = potential_.lattice_constant() * std::cbrt(x);
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      const double r = shells_[i].distance * a;
      if (r > reach_ && (i > 0 || !uncut_)) break;
      take(shells_[i], r);
    }
  }

  lattice_sum sum(double x) const {
    double rho = 0, rho1 = 0, rho2 = 0, pair = 0, pair1 = 0, pair2 = 0;
    each_shell(x, [&](const bolide::potential::shell& s, double r) { // D = r d/dr
      const potential_value f = potential_.density(r), phi = potential_.pair(r);
      rho += s.atoms * f.value;
      rho1 += s.atoms * r * f.first;
      rho2 += s.atoms * r * (f.first + r * f.second);
      pair += 0.5 * s.atoms * phi.value;
      pair1 += 0.5 * s.atoms * r * phi.first;
      pair2 += 0.5 * s.atoms * r * (phi.first + r * phi.second);
    });
    const potential_value F = potential_.embedding(rho);
    return {F.value + pair, F.first * rho1 + pair1, F.second * rho1 * rho1 + F.first * rho2 + pair2};
  }

  cold_point<double> exact(double x) const {
    const lattice_sum s = sum(x);
    const double pascal = unit::eV / (3 * atom_volume(x));
    return {(s.energy - energy_at_one_) * unit::eV / atom_mass(), -s.first * pascal, -(s.second - 3 * s.first) * pascal / (3 * x)};
  }

  Potential potential_;
  double reach_; // angstrom
  bool uncut_;   // the potential has no cut-off
  std::vector<bolide::potential::shell> shells_;
  double energy_at_one_ = 0; // eV
};

// With the Lagrangian strain eta, r^2 = X.(1 + 2 eta).X: d phi = (phi'/r) X_i X_j d eta_ij, and the second derivative of a pair function
// is (phi'' - phi'/r)/r^2 X_i X_j X_k X_l. The stress-strain coefficients follow with -p, +p, -p.
template <EmbeddedAtomPotential Potential> cubic_elastic_constants lattice<Potential>::elastic_constants(double x) const {
  double rho = 0, rho1 = 0, rho_xxxx = 0, rho_xxyy = 0, pair1 = 0, pair_xxxx = 0, pair_xxyy = 0;
  each_shell(x, [&](const bolide::potential::shell& s, double r) {
    const potential_value f = potential_.density(r), phi = potential_.pair(r);
    const double xxxx = s.fourth * r * r, xxyy = (s.atoms - 3 * s.fourth) / 6 * r * r;
    rho += s.atoms * f.value;
    rho1 += s.atoms * r * f.first;
    rho_xxxx += xxxx * (f.second - f.first / r);
    rho_xxyy += xxyy * (f.second - f.first / r);
    pair1 += 0.5 * s.atoms * r * phi.first;
    pair_xxxx += 0.5 * xxxx * (phi.second - phi.first / r);
    pair_xxyy += 0.5 * xxyy * (phi.second - phi.first / r);
  });
  const potential_value F = potential_.embedding(rho);
  const double pascal = unit::eV / atom_volume(x), p = -(F.first * rho1 + pair1) / 3 * pascal, bend = F.second * rho1 * rho1 / 9;
  const double xxxx = (pair_xxxx + F.first * rho_xxxx) * pascal, xxyy = (pair_xxyy + F.first * rho_xxyy) * pascal;
  return {xxxx + bend * pascal - p, xxyy + bend * pascal + p, xxyy - p};
}

template <EmbeddedAtomPotential Potential> double lattice<Potential>::vacancy_energy(double x) const {
  double rho = 0, energy = 0;
  each_shell(x, [&](const bolide::potential::shell& s, double r) {
    rho += s.atoms * potential_.density(r).value;
    energy -= 0.5 * s.atoms * potential_.pair(r).value;
  });
  const double F = potential_.embedding(rho).value;
  each_shell(x, [&](const bolide::potential::shell& s, double r) {
    energy += s.atoms * (potential_.embedding(rho - potential_.density(r).value).value - F);
  });
  return energy;
}

} // namespace bolide::cold
