// SPDX-License-Identifier: MIT
// Aluminium 1100 (99 % pure). The equation of state is that of pure aluminium at the alloy's density.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set aluminium_1100{
    .name = "aluminium_1100",
    .description = "1100-H12",
    .density = 2712, // kg/m3
    // Mitchell and Nellis 1981, from memory: re-check before quoting. Valid to about 200 GPa.
    .mie_grueneisen = {.rho0 = 2712, .c0 = 5386, .s = 1.339, .gamma0 = 2.25, .constant_gamma = true},
    .tillotson = std::nullopt, // the published set is pure aluminium's: material `aluminium`
    .phases = phase::grover_parameters{}, // pure aluminium's (the paper)
    .heat_capacity = 904,                 // J/(kg K), handbook, from memory
    .melting = {916, 2.18, 1.7},          // K: solidus, handbook, from memory; gamma of pure aluminium
    // 1100-H12, Gupta, Iqbal and Sekhon 2006, from memory: re-check before quoting. Tension tests, low rates.
    .strength = {.shear_modulus = 25.9e9, .a = 148e6, .b = 346e6, .n = 0.183, .c = 0.001, .q = 0.859, .room_temperature = 293},
    .source = "Mitchell-Nellis 1981, Gupta 2006 (from memory)",
};

} // namespace bolide::data
