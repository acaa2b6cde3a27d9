// SPDX-License-Identifier: MIT
// APIC (Jiang et al. 2015): a particle carries an affine velocity field and takes all of it from the grid.
//   P_I = sum N m (v_p + C_p (x_I - x_p)),   v_p = sum N v_I,   C_p = sum N v_I (x_I - x_p)^T / (h^2/4)
// Conserves momentum and angular momentum; keeps nothing that the grid does not see, so it is free of FLIP's noise and dissipates.
// What a particle loses on the way to the grid and back, m/2 sum N |v_p + C_p dx - v_I|^2 each way, is local and not negative;
// it is returned to that particle as heat, as a viscosity would, so that total energy holds (`heat` = 1), or dropped (0).
//
// Wants a shape function with a continuous slope: with linear shapes the affine field is amplified at nodes of tiny mass whenever a
// particle changes cell, and the run blows up.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::transfer {
struct apic {
  using particle_fields = fields<field::affine_velocity>;
  static constexpr bool affine = true;
  static constexpr bool wants_smooth_shape = true;
  static constexpr int filter_order = 0;
  static constexpr const char* name = "apic";

  double heat = 1; // fraction of the transfer loss that is returned as heat
};
} // namespace bolide::transfer
