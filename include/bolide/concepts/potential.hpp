// SPDX-License-Identifier: MIT
// The role "embedded-atom potential": the energy of an atom among its neighbours.
//
//   E_i = F(rho_i) + 1/2 sum_j phi(r_ij),  rho_i = sum_j f(r_ij)
//
// Lengths in angstrom, energies in eV (what the literature and the files speak); rho is in the model's own unit. A model gives
//     potential_value pair(double r) const;          // phi and its first two derivatives with respect to r, r > 0
//     potential_value density(double r) const;       // f, the same
//     potential_value embedding(double rho) const;   // F and its first two derivatives with respect to rho, rho >= 0
//     double reach() const;                          // angstrom: beyond it pair and density count as nothing; uncut_reach where there is no cut-off
//     double lattice_constant() const;               // angstrom: the cubic cell's edge a0, where x = V/V0 = 1
//     lattice structure() const;                     // the crystal that has this lattice constant
//     double mass() const;                           // of an atom, in atomic mass units
// Invariants: `first` and `second` are the derivatives of `value`. F(0) is the energy of a free atom: 0, or near it in a fit or a file;
// where F' is not finite there, the model answers 0 for it. pair and density are not cut here: whoever sums drops what lies beyond
// reach(), so a cut-off with a jump ("sharp") keeps both sides. Cost: set-up work, plain double.
#pragma once

#include <concepts>

namespace bolide {

/// A function's value with its first two derivatives.
struct potential_value {
  double value;
  double first;
  double second;
};

/// What reach() answers where there is no cut-off, angstrom.
inline constexpr double uncut_reach = 20;

/// The cubic crystals: face-centred (4 atoms in the cell) and body-centred (2).
enum class lattice { fcc, bcc };
constexpr const char* name(lattice structure) { return structure == lattice::fcc ? "fcc" : "bcc"; }
constexpr int atoms_per_cell(lattice structure) { return structure == lattice::fcc ? 4 : 2; }

template <class P>
concept EmbeddedAtomPotential = requires(const P potential, double x) {
  { potential.pair(x) } -> std::convertible_to<potential_value>;
  { potential.density(x) } -> std::convertible_to<potential_value>;
  { potential.embedding(x) } -> std::convertible_to<potential_value>;
  { potential.reach() } -> std::convertible_to<double>;
  { potential.lattice_constant() } -> std::convertible_to<double>;
  { potential.structure() } -> std::convertible_to<lattice>;
  { potential.mass() } -> std::convertible_to<double>;
};

} // namespace bolide
