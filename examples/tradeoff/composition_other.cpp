// SPDX-License-Identifier: MIT
// XPIC of second order, and GIMP.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/gimp.hpp"
#include "bolide/shape/quadratic_bspline.hpp"

namespace tradeoff {
using namespace bolide;
std::unique_ptr<simulation> bspline_xpic2_usf(const settings& s, const scene& of) {
  return compose_as<double, shape::quadratic_bspline, transfer::xpic<2>, scheme::usf>(s, of);
}
std::unique_ptr<simulation> gimp_flip_usf(const settings& s, const scene& of) { return compose_as<double, shape::gimp, transfer::flip, scheme::usf>(s, of); }
} // namespace tradeoff
