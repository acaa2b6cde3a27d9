// SPDX-License-Identifier: MIT
// Tungsten, pure.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set tungsten{
    .name = "tungsten",
    .description = "pure",
    .density = 19224, // kg/m3
    // LASL, from memory: re-check before quoting. Valid to about 300 GPa.
    .mie_grueneisen = {.rho0 = 19224, .c0 = 4029, .s = 1.237, .gamma0 = 1.54, .constant_gamma = true},
    .tillotson = std::nullopt,
    .phases = std::nullopt,
    .heat_capacity = 132,                 // J/(kg K), handbook, from memory
    .melting = lindemann_of(3695, 1.54),  // K
    // G and yield stress: the deck of a public MPM code (161 GPa, 0.55 GPa, perfectly plastic; read). Softening taken linear.
    .strength = {.shear_modulus = 161e9, .a = 550e6, .b = 0, .n = 1.0, .c = 0.0, .q = 1.0, .room_temperature = 293},
    .source = "LASL (from memory); public MPM deck",
};

} // namespace bolide::data
