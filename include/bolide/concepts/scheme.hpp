// SPDX-License-Identifier: MIT
// The role "scheme": in which order are the phases of a step done?
//
// A model gives step(phases), a few lines that call the phases of solver/phases.hpp in order, and says whether the stress is updated before
// the forces (stress_first); where it is updated last, whether from node velocities that the particles map back (maps_velocity_back) or from
// those that the forces left; and whether it needs a shape function whose slope is continuous (wants_smooth_shape). `scheme_phases` below is the list of what it may call; the concept is checked against it, so that
// a scheme needs no solver to be checked.
// Invariants: every phase that the others rely on is called once, map_to_nodes first and work_and_move last; momentum and the
// ledger are the phases' own and hold for any scheme that does so.
#pragma once

#include <concepts>

namespace bolide {

/// The phases that a scheme puts in order, as an archetype (never run).
struct scheme_phases {
  void map_to_nodes();        // m_I, P_I (and the forces of the stress that the particles carry, where it is updated last)
  void update_stress_first(); // velocity gradient, constitutive update, forces; only where stress_first
  void accelerate_nodes();    // dv_I = f_I dt/m_I, boundary conditions
  void map_to_particles();    // particle velocities, and what is needed of them back on the nodes
  void work_and_move();       // work of the nodal forces, the stress where it is updated last, positions
};

template <class X>
concept Scheme = requires(const X scheme, scheme_phases& phases) {
  typename X::particle_fields;
  { X::stress_first } -> std::convertible_to<bool>;
  { X::maps_velocity_back } -> std::convertible_to<bool>;
  { X::wants_smooth_shape } -> std::convertible_to<bool>;
  { X::name } -> std::convertible_to<const char*>;
  scheme.step(phases);
};

} // namespace bolide
