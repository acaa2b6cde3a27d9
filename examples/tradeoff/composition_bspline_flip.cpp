// SPDX-License-Identifier: MIT
// Quadratic B-splines with FLIP.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/quadratic_bspline.hpp"

namespace tradeoff {
using bolide::shape::quadratic_bspline, bolide::transfer::flip;
std::unique_ptr<simulation> bspline_flip_usf(const settings& s, const scene& of) { return compose_as<double, quadratic_bspline, flip, bolide::scheme::usf>(s, of); }
std::unique_ptr<simulation> bspline_flip_usl(const settings& s, const scene& of) { return compose_as<double, quadratic_bspline, flip, bolide::scheme::usl>(s, of); }
} // namespace tradeoff
