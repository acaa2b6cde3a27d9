// SPDX-License-Identifier: MIT
// The role "strength": how much shear stress can a point carry?
//
// A model lists its particle_fields and says whether it carries shear at all and whether it wants a temperature. One that carries
// shear gives shear_modulus (Pa) and, per lane type V, yield_stress(plastic strain, equivalent strain rate 1/s, temperature K, melting
// temperature K) and a cheap lower bound yield_floor(temperature, melting temperature), both in Pa. The radial return
// itself is the material's (material/material.hpp). A strength never sees an equation of state.
//
// Two choices, and one refinement:
//   yields = false     elastic: no yield stress is asked for, and no plastic strain is stored
//   shear_modulus_at   (pressure Pa, density kg/m3, temperature, melting temperature): the modulus varies. Such a model lists
//                      field::shear_modulus, and pressure and density follow as last arguments of yield_stress and of yield_floor
//   hardening_modulus  dY/d(plastic strain) (Pa), constant: the return is then exact instead of one step late
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

/// Does the strength bound the shear stress? Yes unless it says yields = false.
template <class S> inline constexpr bool strength_yields = [] {
  if constexpr (requires { S::yields; }) return S::carries_shear && S::yields;
  else return S::carries_shear;
}();

template <class S, class V = double>
concept VariableShearModulus = requires(const S s, V x) {
  { s.shear_modulus_at(x, x, x, x) } -> std::convertible_to<V>;
  { s.yield_stress(x, x, x, x, x, x) } -> std::convertible_to<V>;
  { s.yield_floor(x, x, x, x) } -> std::convertible_to<V>;
};

template <class S, class V = double>
concept Strength = requires { typename S::particle_fields; { S::carries_shear } -> std::convertible_to<bool>; { S::wants_temperature } -> std::convertible_to<bool>; } &&
                   (!S::carries_shear || requires(const S s) { { s.shear_modulus } -> std::convertible_to<double>; }) &&
                   (!strength_yields<S> || VariableShearModulus<S, V> || requires(const S s, V x) {
                     { s.yield_stress(x, x, x, x) } -> std::convertible_to<V>;
                     { s.yield_floor(x, x) } -> std::convertible_to<V>;
                   });

} // namespace bolide
