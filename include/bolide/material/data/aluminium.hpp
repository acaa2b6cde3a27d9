// SPDX-License-Identifier: MIT
// The paper's aluminium: equation of state of pure aluminium, strength of 2024-T351, density of 2024.
#pragma once

#include "bolide/material/data/parameter_set.hpp"

namespace bolide::data {

inline constexpr parameter_set aluminium{
    .name = "aluminium",
    .description = "the paper's: EOS of pure Al, strength of 2024-T351",
    .density = 2785, // kg/m3, 2024; the cold curve's own density at 293 K is 2638
    // LASL shock data of 2024-T4, from memory: re-check before quoting. Valid to about 100 GPa (us to 1 %), used to 500 GPa.
    .mie_grueneisen = {.rho0 = 2785, .c0 = 5328, .s = 1.338, .gamma0 = 2.0, .constant_gamma = true},
    // Read in public codes (E_cv also printed as 15 MJ/kg). Its own density, 2700: not scaled.
    .tillotson = eos::tillotson_parameters{.rho0 = 2700, .a = 0.5, .b = 1.63, .A = 75.2e9, .B = 65e9, .E0 = 5.0e6,
                                           .alpha = 5, .beta = 5, .E_iv = 3.0e6, .E_cv = 13.9e6},
    .phases = phase::grover_parameters{}, // the paper, section 3; within its regions x = 0.3 to 5, T to some 50,000 K
    .heat_capacity = 875,                 // J/(kg K), handbook
    .melting = {933, 2.18, 1.7},          // K, -, -: melting at zero pressure; gamma of the paper
    // The paper's constants: G 27.6 GPa; A 265 MPa, B 426 MPa, n 0.34, C 0.015, q 1. Fitted below 1e4 /s and below melting.
    .strength = {.shear_modulus = 27.6e9, .a = 265e6, .b = 426e6, .n = 0.34, .c = 0.015, .q = 1.0, .room_temperature = 293},
    .source = "the paper; LASL (from memory)",
};

} // namespace bolide::data
