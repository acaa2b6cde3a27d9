// SPDX-License-Identifier: MIT
// Aluminium 6061-T6, the plate of the experiment. The equation of state is that of pure aluminium at the alloy's density.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set aluminium_6061{
    .name = "aluminium_6061",
    .description = "6061-T6",
    .density = 2703, // kg/m3
    // LASL, from memory: re-check before quoting (a public table has 2683, 5349, 1.338). Valid to about 100 GPa (us to 1 %).
    .mie_grueneisen = {.rho0 = 2703, .c0 = 5350, .s = 1.34, .gamma0 = 2.0, .constant_gamma = true},
    .tillotson = std::nullopt, // the published set is pure aluminium's: material `aluminium`
    .phases = phase::grover_parameters{}, // pure aluminium's (the paper)
    .heat_capacity = 885,                 // J/(kg K), handbook, from memory
    .melting = {855, 2.18, 1.7},          // K: solidus, handbook, from memory; gamma of pure aluminium
    // Lesuer, Kay and LeBlanc 2001 (LLNL), from memory: re-check before quoting. Split Hopkinson bar, to 1e4 /s.
    .strength = {.shear_modulus = 26.0e9, .a = 324e6, .b = 114e6, .n = 0.42, .c = 0.002, .q = 1.34, .room_temperature = 293},
    .source = "LASL, Lesuer 2001 (from memory)",
};

} // namespace bolide::data
