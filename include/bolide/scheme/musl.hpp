// SPDX-License-Identifier: MIT
// Modified update stress last (Sulsky, Zhou, Schreyer 1995): the stress follows the updated particle velocities, mapped back to the nodes.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::scheme {
struct musl {
  using particle_fields = fields<>;
  static constexpr bool stress_first = false;
  static constexpr bool maps_velocity_back = true;
  static constexpr bool wants_smooth_shape = false;
  static constexpr const char* name = "musl";

  template <class Phases> void step(Phases& s) const {
    s.map_to_nodes();     // m_I, P_I, and f_I = -sum V sigma grad N from the stress that the particles carry
    s.accelerate_nodes(); // dv_I = f_I dt / m_I
    s.map_to_particles(); // v_p += sum N dv_I, and back: v'_I = sum N m v_p / m_I
    s.work_and_move();    // e += sigma : grad(v + dv/2) V dt / m;  L = sum v'_I grad N;  V, s, q, p, T;  x_p
  }
};
} // namespace bolide::scheme
