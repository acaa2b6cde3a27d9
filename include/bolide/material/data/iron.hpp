// SPDX-License-Identifier: MIT
// Iron (Armco). Its us-up line is that of the high-pressure phase: below about 13 GPa, and near its transition, it is only a guide.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set iron{
    .name = "iron",
    .description = "Armco",
    .density = 7850, // kg/m3
    // LASL, from memory: re-check before quoting. Valid from about 40 to 400 GPa.
    .mie_grueneisen = {.rho0 = 7850, .c0 = 3574, .s = 1.92, .gamma0 = 1.69, .constant_gamma = true},
    // Tillotson 1962 as tabulated by Melosh 1989, from memory: re-check before quoting.
    .tillotson = eos::tillotson_parameters{.rho0 = 7800, .a = 0.5, .b = 1.5, .A = 128e9, .B = 105e9, .E0 = 9.5e6,
                                           .alpha = 5, .beta = 5, .E_iv = 2.4e6, .E_cv = 8.67e6},
    .phases = std::nullopt,
    .heat_capacity = 452,                 // J/(kg K), Johnson and Cook 1983, from memory
    .melting = lindemann_of(1811, 1.69),  // K
    // Johnson and Cook 1983, from memory: re-check before quoting.
    .strength = {.shear_modulus = 80.0e9, .a = 175e6, .b = 380e6, .n = 0.32, .c = 0.060, .q = 0.55, .room_temperature = 293},
    .source = "LASL, Melosh 1989, Johnson-Cook 1983 (from memory)",
};

} // namespace bolide::data
