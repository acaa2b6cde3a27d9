// SPDX-License-Identifier: MIT
// expect: ok
// The least that is an embedded-atom potential, and its cold curve.
#include "bolide/eos/cold/lattice_sum.hpp"

struct least_potential {
  bolide::potential_value pair(double r) const { return {r, 1, 0}; }
  bolide::potential_value density(double r) const { return {r, 1, 0}; }
  bolide::potential_value embedding(double rho) const { return {rho, 1, 0}; }
  double reach() const { return 6; }
  double lattice_constant() const { return 4; }
  bolide::lattice structure() const { return bolide::lattice::bcc; }
  double mass() const { return 27; }
};
static_assert(bolide::EmbeddedAtomPotential<least_potential>);
static_assert(bolide::ColdCurve<bolide::cold::lattice<least_potential>>);
static_assert(bolide::ColdCurve<bolide::cold::lattice<least_potential>, bolide::native_pack<float>>);
