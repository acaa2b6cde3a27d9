// SPDX-License-Identifier: MIT
// Aluminium 2024-T351. The equation of state is that of pure aluminium at the alloy's density; it melts at the alloy's solidus.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set aluminium_2024{
    .name = "aluminium_2024",
    .description = "2024-T351",
    .density = 2785, // kg/m3
    // LASL, 2024-T4, from memory: re-check before quoting. Valid to about 100 GPa.
    .mie_grueneisen = {.rho0 = 2785, .c0 = 5328, .s = 1.338, .gamma0 = 2.0, .constant_gamma = true},
    .tillotson = std::nullopt, // the published set is pure aluminium's: material `aluminium`
    .phases = phase::grover_parameters{}, // pure aluminium's (the paper)
    .heat_capacity = 875,                 // J/(kg K), Johnson and Cook 1983, from memory
    .melting = {775, 2.18, 1.7},          // K: solidus, Johnson and Cook 1983, from memory; gamma of pure aluminium
    // Johnson and Cook 1983 as printed in the paper (there for 2024-T351). Below 1e4 /s.
    .strength = {.shear_modulus = 27.6e9, .a = 265e6, .b = 426e6, .n = 0.34, .c = 0.015, .q = 1.0, .room_temperature = 293},
    .source = "LASL, Johnson-Cook 1983 (from memory)",
};

} // namespace bolide::data
