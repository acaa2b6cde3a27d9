// SPDX-License-Identifier: MIT
// Cubic B-splines with APIC.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/cubic_bspline.hpp"

namespace tradeoff {
using namespace bolide;
std::unique_ptr<simulation> cubic_apic_usf(const settings& s, const scene& of) { return compose_as<double, shape::cubic_bspline, transfer::apic, scheme::usf>(s, of); }
} // namespace tradeoff
