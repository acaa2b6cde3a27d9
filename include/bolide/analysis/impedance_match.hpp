// SPDX-License-Identifier: MIT
// Impedance matching: the velocity and pressure that two materials share after a plane impact, or after a shock has come to their contact.
//
//   impedance_match   a projectile at speed V hits a target at rest: p_projectile(V - u) = p_target(u)
//   transmitted       a shock in one material arrives at its contact with another: it goes on there, and a shock (target of larger
//                     impedance) or a release (of smaller, a free surface at the limit) runs back into what it has left behind
// Both are analysis::meet (wave.hpp: assumptions, cost, status). Plane, no strength, materials stay in contact.
#pragma once

#include "bolide/analysis/wave.hpp"
#include "bolide/eos/state.hpp"

namespace bolide::analysis {

/// The projectile (the left one of the answer) comes at speed V > 0 (m/s).
template <class P, class T>
meeting impedance_match(const P& projectile, const eos::material_state& p, const T& target, const eos::material_state& t, double V) {
  static_assert(EquationOfState<P> && EquationOfState<T>, "bolide: analysis::impedance_match needs two EquationOfState.");
  require(V > 0, "impact speed", V, "> 0", "m/s");
  return meet(wave_curve<P>(projectile, p.density, p.energy), V, wave_curve<T>(target, t.density, t.energy), 0);
}

/// `arriving` is a shock in the first material (into material at rest); the second is at rest in state `ahead`.
template <class F, class S> meeting transmitted(const F& first, const shock_state& arriving, const S& second, const eos::material_state& ahead) {
  static_assert(EquationOfState<F> && EquationOfState<S>, "bolide: analysis::transmitted needs two EquationOfState.");
  return meet(wave_curve<F>(first, arriving.density, arriving.energy), arriving.particle_speed,
              wave_curve<S>(second, ahead.density, ahead.energy), 0);
}

} // namespace bolide::analysis
