// SPDX-License-Identifier: MIT
// Linear shapes with FLIP.
#include "compositions.hpp"

#include "composed.hpp"

#include "bolide/shape/linear.hpp"

namespace tradeoff {
using bolide::shape::linear, bolide::transfer::flip;
std::unique_ptr<simulation> linear_flip_usf(const settings& s, const scene& of) { return compose_as<double, linear, flip, bolide::scheme::usf>(s, of); }
std::unique_ptr<simulation> linear_flip_musl(const settings& s, const scene& of) { return compose_as<double, linear, flip, bolide::scheme::musl>(s, of); }
} // namespace tradeoff
