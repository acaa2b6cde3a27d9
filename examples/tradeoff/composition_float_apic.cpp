// SPDX-License-Identifier: MIT
// Float: B-splines with APIC.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/quadratic_bspline.hpp"

namespace tradeoff {
using namespace bolide;
std::unique_ptr<simulation> bspline_apic_usf_float(const settings& s, const scene& of) {
  return compose_as<float, shape::quadratic_bspline, transfer::apic, scheme::usf>(s, of);
}
} // namespace tradeoff
