// SPDX-License-Identifier: MIT
// What a material tells of an update beside the new state: who limits the time step, what was dissipated, which floors acted.
#pragma once

#include "bolide/core/floors.hpp"

#include <cstdint>

namespace bolide {

/// Why the time step is as long as it is.
enum class step_cause { sound, velocity, viscosity, strain, growth, end };
inline const char* name(step_cause c) {
  constexpr const char* names[] = {"sound", "velocity", "viscosity", "strain", "growth", "end"};
  return names[static_cast<int>(c)];
}

/// The particle that asks for the shortest step: `rate` is 1/dt in 1/s at Courant number 1 (or of the strain-rate limit).
struct step_limit {
  double rate = 0;
  step_cause cause = step_cause::sound;
  std::uint32_t particle = 0;
};

struct update_report {
  step_limit limit;
  double plastic_work = 0;    // J
  double failure_release = 0; // J, elastic energy turned to heat where points failed
  double viscous_heating = 0; // J
  double work_energy = 0;     // J, sum of m de over the particles
  double kinetic_gain = 0;    // J, of the particles
  double returned_heat = 0;   // J, transfer loss put back as heat
  bool moved_out = false;     // a particle left the reach of its block
  floor_counts floors;

  update_report& operator+=(const update_report& o) {
    if (o.limit.rate > limit.rate || !(o.limit.rate == o.limit.rate)) limit = o.limit;
    plastic_work += o.plastic_work;
    failure_release += o.failure_release;
    viscous_heating += o.viscous_heating;
    work_energy += o.work_energy;
    kinetic_gain += o.kinetic_gain;
    returned_heat += o.returned_heat;
    moved_out = moved_out || o.moved_out;
    floors += o.floors;
    return *this;
  }
};

/// What the scheme tells the material of the step.
template <class T> struct step_context {
  T dt;             // s
  T cell;           // m
  T courant;        // Courant number, divides the rates of sound, viscosity and velocity
  double ignore_below; // rates (1/s) that cannot limit the next step, because it may not grow so much
  bool gradient_at_end; // is the gradient taken at the end of the step's motion (USF) or at its beginning (MUSL)?
};

inline constexpr int chunk_size = 64; // particles that go through a sweep together: their scratch stays in the first-level cache

} // namespace bolide
