// SPDX-License-Identifier: MIT
// Steel 4340. Its us-up line is that of the high-pressure phase of iron: below about 13 GPa it is only a guide.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set steel_4340{
    .name = "steel_4340",
    .description = "4340",
    .density = 7830, // kg/m3, Johnson and Cook 1985, from memory
    // c0, gamma0, s: the deck of a public MPM code (read). Valid from about 40 to 400 GPa.
    .mie_grueneisen = {.rho0 = 7830, .c0 = 3574, .s = 1.92, .gamma0 = 1.69, .constant_gamma = true},
    .tillotson = std::nullopt,
    .phases = std::nullopt,
    .heat_capacity = 477,                 // J/(kg K), Johnson and Cook 1985, from memory
    .melting = lindemann_of(1793, 1.69),  // K
    // A, B, C, n, q: the same deck (792/510/0.014/0.26/1.03). G: handbook, from memory.
    .strength = {.shear_modulus = 81.8e9, .a = 792e6, .b = 510e6, .n = 0.26, .c = 0.014, .q = 1.03, .room_temperature = 293},
    .source = "public MPM deck; Johnson-Cook 1985 (from memory)",
};

} // namespace bolide::data
