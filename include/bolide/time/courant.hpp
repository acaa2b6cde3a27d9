// SPDX-License-Identifier: MIT
// Time-step control from what the particles ask for: dt = 1 / max over particles of the wanted rate (material/material.hpp,
// limit_step: Courant number times h / (Q + sqrt(Q^2 + c^2 + 4G/3rho) + |v|), and 0.25 / |L|), growing by at most `growth` per step.
// Stable range, measured (docs/verification.md): an elastic bar runs at 1.3 to 1.5 with every composition. Where metal flows (Taylor's bar, 8
// cells per radius) linear FLIP with USF ends at 0.7 (16 cells: 0.5), APIC at 1.3; FLIP with MUSL or B-splines runs at 1.5. The default 0.4
// holds in all.
#pragma once

#include "bolide/core/contract.hpp"

namespace bolide {

/// Settings of a run, all checked at the door.
template <class T = double> struct controls {
  using scalar = T;              // precision of particles and nodes
  double courant = 0.4;
  double first_step = 0.1;       // first step over the one that the initial state allows
  double growth = 1.1;           // most a step may grow over the one before
  double dt_floor = 1e-6;        // least step over the first one: below it the run stops with a message
  double energy_bound = 0.5;     // largest |total energy change| over the initial energy
  long step_cap = 10'000'000;
  bool accept_one_particle_per_cell = false; // material seeded so wide fractures numerically: refused unless asked for
  bool skip_quiet = true;        // leave out particles at rest and without stress: the same answer for less work
  double quiet_speed = 0;        // m/s: what is slower, under a stress below rho c times that, counts as at rest. It stays where it is:
                                 // displacements below quiet_speed times the time asleep are left out. 0: the same bits as without skipping
  int threads = 1;               // 0: as many as the machine has; on a machine that is busy with other work threads wait for each other

  void validate() const {
    require(courant > 0 && courant <= 1.5, "Courant number", courant, "in (0, 1.5]");
    require(first_step > 0 && first_step <= 1, "first step", first_step, "in (0, 1] of the allowed step");
    require(growth > 1 && growth <= 10, "growth", growth, "in (1, 10]");
    require(dt_floor > 0 && dt_floor < 1, "dt floor", dt_floor, "in (0, 1) of the first step");
    require(energy_bound > 0, "energy bound", energy_bound, "positive");
    require(quiet_speed >= 0 && quiet_speed < 1e3, "quiet speed", quiet_speed, "in [0, 1000)", "m/s");
    require(quiet_speed == 0 || skip_quiet, "quiet speed", quiet_speed, "0 where skip_quiet is off", "m/s");
    require(step_cap > 0, "step cap", static_cast<double>(step_cap), "positive");
    require(threads >= 0 && threads <= 1024, "threads", threads, "in [0, 1024]");
  }
};

} // namespace bolide
