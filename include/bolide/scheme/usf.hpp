// SPDX-License-Identifier: MIT
// Update stress first (paper section 1.3): the stress follows the velocities that the particles bring to the grid, then the forces act.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::scheme {
struct usf {
  using particle_fields = fields<>;
  static constexpr bool stress_first = true;
  static constexpr bool maps_velocity_back = false;
  static constexpr bool wants_smooth_shape = false;
  static constexpr const char* name = "usf";

  template <class Phases> void step(Phases& s) const {
    s.map_to_nodes();        // m_I = sum N m,  P_I = sum N m v          (7) (8)
    s.update_stress_first(); // L = sum v_I grad N;  V, s, q, p, T;  f_I = -sum V sigma grad N   (9) (10) (11) (16)-(19)
    s.accelerate_nodes();    // dv_I = f_I dt / m_I
    s.map_to_particles();    // v_p += sum N dv_I
    s.work_and_move();       // e += sigma : grad(v + dv/2) V dt / m;  x_p += dt sum N (v_I + dv_I)
  }
};
} // namespace bolide::scheme
