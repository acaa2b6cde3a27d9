// SPDX-License-Identifier: MIT
// Modifiers: a failed point loses its load-carrying capacity over a time or over an opening instead of in one step.
//
//   softening{law, t}       the part d of the capacity that is gone grows from 0 at failure to 1 after the time t: d += dt/t
//   cohesive{law, G_f}      d = w/w_c with the opening w = h V_void/V_m of the crack in a cell of size h, w_c = 2 G_f/sigma_f: the traction
//                           falls linearly with the opening and G_f (J/m2) is spent per area of crack, whatever the cell. Crack closes: d stays.
//                           A point that fails without tension (sheared, molten) has no opening to spend energy in: it loses all at once.
// sigma_f is the tension that the point bears when `law` says that it fails. From then on it bears tension up to (1 - d) sigma_f and shear
// with modulus (1 - d) G and yield stress (1 - d) Y; a void opens where more is asked for (material/material.hpp).
// What it is for: with a failure in one step the released wave and what fails next depend on the step; over several steps they do not
// (tests/verify/softening_test.cpp). t should be some steps long and short against the passage of the wave: h/c and more.
// cohesive: below G_f = h sigma_f^2/(2 rho c^2) the elastic energy of the cell exceeds G_f and the fall is as sudden as the step allows.
// Cost: 16 bytes more per particle.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::failure {

template <class Law> struct softening : Law {
  static_assert(Law::may_fail, "bolide: failure::softening wants a law that may fail");
  using particle_fields = field_union_t<typename Law::particle_fields, fields<field::lost_capacity, field::held_tension>>;
  double time; // s

  softening(Law law, double t) : Law(law), time(t) { require(t > 0, "softening time", t, "positive", "s"); }
  template <class V> BOLIDE_INLINE V capacity_lost(V before, V, V, scalar_t<V> dt, scalar_t<V>) const {
    return min(before + dt / scalar_t<V>(time), V(scalar_t<V>(1)));
  }
};

template <class Law> struct cohesive : Law {
  static_assert(Law::may_fail, "bolide: failure::cohesive wants a law that may fail");
  using particle_fields = field_union_t<typename Law::particle_fields, fields<field::lost_capacity, field::held_tension>>;
  double fracture_energy; // G_f, J/m2

  cohesive(Law law, double energy) : Law(law), fracture_energy(energy) { require(energy > 0, "fracture energy", energy, "positive", "J/m2"); }
  template <class V> BOLIDE_INLINE V capacity_lost(V before, V held_tension, V opening, scalar_t<V>, scalar_t<V> cell) const {
    using T = scalar_t<V>;
    const V one(T(1)), open = opening * held_tension * (cell / T(2 * fracture_energy));
    return select(held_tension > V(T(0)), max(before, min(open, one)), one);
  }
};

template <class Law> softening(Law, double) -> softening<Law>;
template <class Law> cohesive(Law, double) -> cohesive<Law>;

} // namespace bolide::failure
