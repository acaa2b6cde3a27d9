// SPDX-License-Identifier: MIT
// Cold curve from the embedded-atom potential of Cai and Ye (Phys. Rev. B 54 (1996) 8398), potential/cai_ye.hpp, summed over the shells of
// the fcc lattice by cold::lattice.
//
// p_c(1) is the small value that the potential has there: -20.6 MPa without cut-off, +4.5 MPa with the sharp one.
// Cut-off: `none` sums to 20 angstrom, which has converged to round-off for x >= 0.05; `sharp` drops r > 1.65 a0 as published: p_c
// then jumps by 9 to 150 MPa and e_c by 0.9 to 7 kJ/kg wherever a shell crosses the cut.
// Validity: against static data about 17 % stiff at x = 0.5 (docs/eos.md). Cost: that of cold::lattice.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/potential/cai_ye.hpp"

namespace bolide::cold {

using potential::cai_ye_parameters;
using potential::cutoff;

class cai_ye : public lattice<potential::cai_ye> {
public:
  explicit cai_ye(cutoff reach = cutoff::none, const cai_ye_parameters& parameters = {})
      : lattice(potential::cai_ye(reach, parameters, "cold::cai_ye")) {}

  /// The electron density of the lattice at x = 1 with f_e = 1, which is rho_e.
  double density_at_one() const { return potential().equilibrium_density(); }
  const cai_ye_parameters& parameters() const { return potential().parameters(); }
};

static_assert(ColdCurve<cai_ye>);

} // namespace bolide::cold
