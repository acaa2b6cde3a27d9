// SPDX-License-Identifier: MIT
// The energy ledger: what there is (from the state of the particles) and what each channel has done since the start (from its own
// formula, step by step). No channel is a remainder, so the residual tests the book-keeping.
//
//   kinetic + internal - (initial) = transfer + returned_heat + work_mismatch + body_work + boundary_work + contact - left
//   up to the residual
//   kinetic        sum m |v|^2 / 2 (+ the affine part m h^2/8 |C|^2 of APIC)
//   internal       sum m e (its cold, thermal and elastic shear parts: material.thermodynamics and shear_energy, on demand)
//   transfer       kinetic energy change of the particles less the work of the nodal forces
//   returned_heat  APIC's loss put back as heat, particle by particle
//   work_mismatch  energy gained by the particles' stress work plus the work of the nodal forces
//   body_work      work of body forces
//   boundary_work  work of moving walls
//   contact        work of the contact forces between bodies: what friction and inelastic contact take (negative)
//   left           kinetic + internal energy of particles that left through the box
// of-which entries: plastic_work, viscous_heating, failure_release.
#pragma once

#include "bolide/core/floors.hpp"

#include <array>
#include <cstdint>

namespace bolide {

struct energy_state {
  double kinetic = 0, internal = 0; // J
  double total() const { return kinetic + internal; }
};

struct ledger {
  energy_state initial, now;
  double transfer = 0, returned_heat = 0, work_mismatch = 0, body_work = 0, boundary_work = 0, contact = 0, left = 0; // channels, J
  double plastic_work = 0, viscous_heating = 0, failure_release = 0;     // of which, J
  std::array<double, 3> momentum_initial{}, momentum_now{}, momentum_given{}, momentum_left{}; // kg m/s; given: by body forces and moving walls
  double momentum_scale = 0;                                             // sum m |v| at the start
  double mass_left = 0;                                                  // kg
  std::uint64_t particles_left = 0;
  floor_counts floors;

  /// Total energy gained over the initial energy, what left and what came from outside counted.
  double drift() const { return (now.total() + left - body_work - boundary_work - initial.total()) / scale(); }
  /// What the channels do not explain, over the initial energy.
  double residual() const { return (now.total() - initial.total() - (transfer + returned_heat + work_mismatch + body_work + boundary_work + contact - left)) / scale(); }
  /// Momentum gained along an axis over the initial sum of m |v|, what left and what was given counted.
  double momentum_error(std::size_t axis) const {
    return momentum_scale > 0 ? (momentum_now[axis] + momentum_left[axis] - momentum_given[axis] - momentum_initial[axis]) / momentum_scale : 0;
  }
  double scale() const { return initial.total() > 0 ? initial.total() : 1; }

  /// For checkpoints (concepts/archive.hpp). The binding names every member: one more does not compile until it is listed here.
  template <class A> void archive(A& a) {
    auto& [at_start, at_end, transferred, heat, mismatch, given_work, wall_work, contact_work, gone, plastic, viscous, released, p_start, p_end, p_given, p_gone, p_scale, m_gone, n_gone,
           floored] = *this;
    a.value("initial_kinetic", at_start.kinetic);
    a.value("initial_internal", at_start.internal);
    a.value("kinetic", at_end.kinetic);
    a.value("internal", at_end.internal);
    a.value("transfer", transferred);
    a.value("returned_heat", heat);
    a.value("work_mismatch", mismatch);
    a.value("body_work", given_work);
    a.value("boundary_work", wall_work);
    a.value("contact", contact_work);
    a.value("left", gone);
    a.value("plastic_work", plastic);
    a.value("viscous_heating", viscous);
    a.value("failure_release", released);
    a.value("momentum_initial", p_start);
    a.value("momentum_now", p_end);
    a.value("momentum_given", p_given);
    a.value("momentum_left", p_gone);
    a.value("momentum_scale", p_scale);
    a.value("mass_left", m_gone);
    a.value("particles_left", n_gone);
    a.value("floors", floored.count);
  }
};

} // namespace bolide
