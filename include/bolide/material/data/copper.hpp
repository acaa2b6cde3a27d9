// SPDX-License-Identifier: MIT
// Copper, oxygen-free (OFHC).
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set copper{
    .name = "copper",
    .description = "OFHC",
    .density = 8930, // kg/m3
    // LASL, from memory: re-check before quoting. Valid to about 400 GPa.
    .mie_grueneisen = {.rho0 = 8930, .c0 = 3940, .s = 1.489, .gamma0 = 2.0, .constant_gamma = true},
    // Tillotson 1962, from memory: re-check before quoting.
    .tillotson = eos::tillotson_parameters{.rho0 = 8900, .a = 0.5, .b = 1.5, .A = 139e9, .B = 110e9, .E0 = 32.5e6,
                                           .alpha = 5, .beta = 5, .E_iv = 1.38e6, .E_cv = 6.9e6},
    .phases = std::nullopt,
    .heat_capacity = 383,                // J/(kg K), Johnson and Cook 1983, from memory
    .melting = lindemann_of(1356, 2.0),  // K
    // Johnson and Cook 1983, from memory: re-check before quoting.
    .strength = {.shear_modulus = 47.7e9, .a = 90e6, .b = 292e6, .n = 0.31, .c = 0.025, .q = 1.09, .room_temperature = 293},
    .source = "LASL, Tillotson 1962, Johnson-Cook 1983 (from memory)",
};

} // namespace bolide::data
