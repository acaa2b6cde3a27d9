// SPDX-License-Identifier: MIT
// Lead, as in the lead-on-lead case of a public MPM code (after Anderson 1990).
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set lead{
    .name = "lead",
    .description = "pure",
    .density = 11350, // kg/m3
    // The deck of a public MPM code (read). LASL has c0 2051, s 1.46, gamma0 2.77 (from memory).
    .mie_grueneisen = {.rho0 = 11350, .c0 = 2092, .s = 1.45, .gamma0 = 2.0, .constant_gamma = true},
    .tillotson = std::nullopt,
    .phases = std::nullopt,
    .heat_capacity = 129,                // J/(kg K), handbook, from memory
    .melting = lindemann_of(600.6, 2.0), // K
    // A, B, n: the same deck (12 MPa, 125 MPa, 1). G: handbook, from memory. No rate term is known; softening taken linear.
    .strength = {.shear_modulus = 5.6e9, .a = 12e6, .b = 125e6, .n = 1.0, .c = 0.0, .q = 1.0, .room_temperature = 293},
    .source = "public MPM deck; handbook (from memory)",
};

} // namespace bolide::data
