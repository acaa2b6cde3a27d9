// SPDX-License-Identifier: MIT
// PIC/FLIP blend: a fraction of what the grid does not see of a particle's velocity is taken away every step.
//   v_p += sum N dv_I - (1 - flip) (v_p - sum N v_I)
// flip = 1 is FLIP, flip = 0 is PIC (v_p = sum N (v_I + dv_I)): the damping is per step, so that shorter steps damp more. The loss,
//   (1 - flip) m sum N |v_p - v_I|^2 - (1 - flip)^2 m/2 |v_p - sum N v_I|^2   (and a product with dv_p, of either sign),
// is returned to the particle as heat (`heat` = 1, total energy holds to round-off) or dropped (0).
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"

namespace bolide::transfer {
struct pic {
  using particle_fields = fields<>;
  static constexpr bool affine = false;
  static constexpr bool wants_smooth_shape = false;
  static constexpr int filter_order = 1;
  static constexpr const char* name = "pic";

  double flip = 0; // fraction of FLIP
  double heat = 1; // fraction of the transfer loss that is returned as heat

  double filter() const { return 1 - flip; } // how much of the residual velocity is taken away
  void validate() const {
    require(flip >= 0 && flip <= 1, "fraction of FLIP in the PIC blend", flip, "in [0, 1]");
    require(heat >= 0 && heat <= 1, "returned fraction of the transfer loss", heat, "in [0, 1]");
  }
};
} // namespace bolide::transfer
