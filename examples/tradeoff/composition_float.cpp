// SPDX-License-Identifier: MIT
// Float: linear shapes and B-splines with FLIP.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"

namespace tradeoff {
using namespace bolide;
std::unique_ptr<simulation> linear_flip_usf_float(const settings& s, const scene& of) { return compose_as<float, shape::linear, transfer::flip, scheme::usf>(s, of); }
std::unique_ptr<simulation> bspline_flip_usf_float(const settings& s, const scene& of) {
  return compose_as<float, shape::quadratic_bspline, transfer::flip, scheme::usf>(s, of);
}
} // namespace tradeoff
