// SPDX-License-Identifier: MIT
// Update stress last: the stress follows the node velocities v_I + dv_I as the forces left them, nothing is mapped back.
// Cheaper by a sweep than MUSL and less damped than it, but a node of tiny mass has a velocity of its own: with linear shapes, whose slope does
// not vanish where the weight does, a particle that has just entered a cell is strained by that node alone. On the paper's case it
// lost half of the energy within the run. It is refused with such shapes (accept_unsound opens the door).
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::scheme {
struct usl {
  using particle_fields = fields<>;
  static constexpr bool stress_first = false;
  static constexpr bool maps_velocity_back = false;
  static constexpr bool wants_smooth_shape = true;
  static constexpr const char* name = "usl";

  template <class Phases> void step(Phases& s) const {
    s.map_to_nodes();     // m_I, P_I, and f_I = -sum V sigma grad N from the stress that the particles carry
    s.accelerate_nodes(); // dv_I = f_I dt / m_I
    s.map_to_particles(); // v_p += sum N dv_I
    s.work_and_move();    // e += sigma : grad(v + dv/2) V dt / m;  L = sum (v_I + dv_I) grad N;  V, s, q, p, T;  x_p
  }
};
} // namespace bolide::scheme
