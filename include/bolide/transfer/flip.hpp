// SPDX-License-Identifier: MIT
// FLIP: a particle keeps its own velocity and adds the change that it sees on the grid.
//   P_I = sum N m v_p,   v_p += sum N dv_I,   x_p += dt sum N (v_I + dv_I)
// Conserves momentum exactly. The work of the nodal forces is taken with the change mapped back to the nodes,
//   dv~_I = sum N m dv_p / m_I,   energy += sigma : grad(v + dv~/2),
// for which the kinetic energy gained by the particles equals the nodal work exactly (sum f.dv~ dt = sum m |dv_p|^2), and in which a
// node of vanishing mass does no harm. Velocity modes that the grid does not see stay in the particles as noise.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::transfer {
struct flip {
  using particle_fields = fields<>;
  static constexpr bool affine = false;            // does a particle carry a velocity gradient?
  static constexpr bool wants_smooth_shape = false;
  static constexpr int filter_order = 0;           // how often the map there and back is applied to what the grid does not see
  static constexpr const char* name = "flip";
};
} // namespace bolide::transfer
