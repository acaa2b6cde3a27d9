// SPDX-License-Identifier: MIT
// The role "failure": has this point failed?
//
// A model that may fail gives, per lane type V, the mask fails(pressure Pa, temperature K, melting temperature K, melt fraction), and
// lists field::failed and field::material_volume. Failure is for good. What a failed point still carries is the
// material's: compression, and neither shear nor tension.
//
// Two choices:
//   damage_increment(plastic strain increment, equivalent strain rate 1/s, pressure, equivalent stress Pa, temperature, melting temperature)
//                   the law accumulates damage where the material yields, in field::damage, and a point whose damage is 1 fails
//   capacity_lost(lost before, held tension Pa, void over material volume, time step s, cell m)
//                   a failed point loses its capacity by and by: which part of it (0 .. 1, never less than before) is gone now? Such a law
//                   lists field::lost_capacity and field::held_tension. The material shrinks tension and shear with it
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class F, class V = double>
concept Failure = requires { typename F::particle_fields; { F::may_fail } -> std::convertible_to<bool>; { F::wants_temperature } -> std::convertible_to<bool>; } &&
                  (!F::may_fail || requires(const F f, V x) {
                    { f.fails(x, x, x, x) } -> std::convertible_to<mask_t<V>>;
                  });

template <class F, class V = double>
concept AccumulatingFailure = Failure<F, V> && requires(const F f, V x) { { f.damage_increment(x, x, x, x, x, x) } -> std::convertible_to<V>; };

template <class F, class V = double>
concept SofteningFailure = Failure<F, V> && requires(const F f, V x, scalar_t<V> t) { { f.capacity_lost(x, x, x, t, t) } -> std::convertible_to<V>; };

} // namespace bolide
