// SPDX-License-Identifier: MIT
// The compositions that are compiled, each in a unit of its own or with one beside it.
#pragma once

#include "simulation.hpp"

namespace tradeoff {
using maker = std::unique_ptr<simulation>(const settings&, const scene&);
maker linear_flip_usf, linear_flip_musl, linear_flip_usf_float, bspline_flip_usf, bspline_flip_usl, bspline_flip_usf_float, bspline_apic_usf, bspline_apic_musl,
    bspline_apic_usf_float, bspline_xpic2_usf, cubic_apic_usf, gimp_flip_usf;
} // namespace tradeoff
