// SPDX-License-Identifier: MIT
// The role "strength": how much shear stress can a point carry?
//
// A model lists its particle_fields and says whether it carries shear at all and whether it wants a temperature. One that carries
// shear gives, per lane type V, yield_stress(plastic strain, equivalent strain rate 1/s, temperature K, melting temperature K) and a
// cheap lower bound yield_floor(temperature, melting temperature), both in Pa, and shear_modulus (Pa). The radial return
// itself is the material's (material/material.hpp). A strength never sees an equation of state.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class S, class V = double>
concept Strength = requires { typename S::particle_fields; { S::carries_shear } -> std::convertible_to<bool>; { S::wants_temperature } -> std::convertible_to<bool>; } &&
                   (!S::carries_shear || requires(const S s, V x) {
                     { s.shear_modulus } -> std::convertible_to<double>;
                     { s.yield_stress(x, x, x, x) } -> std::convertible_to<V>;
                     { s.yield_floor(x, x) } -> std::convertible_to<V>;
                   });

} // namespace bolide
