// SPDX-License-Identifier: MIT
// Quadratic B-splines with APIC.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/quadratic_bspline.hpp"

namespace tradeoff {
using bolide::shape::quadratic_bspline, bolide::transfer::apic;
std::unique_ptr<simulation> bspline_apic_usf(const settings& s, const scene& of) { return compose_as<double, quadratic_bspline, apic, bolide::scheme::usf>(s, of); }
std::unique_ptr<simulation> bspline_apic_musl(const settings& s, const scene& of) { return compose_as<double, quadratic_bspline, apic, bolide::scheme::musl>(s, of); }
} // namespace tradeoff
