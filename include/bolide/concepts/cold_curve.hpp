// SPDX-License-Identifier: MIT
// The role "cold curve": energy and pressure of the lattice at 0 K against compression.
//
// A model gives, for a lane type V and x = V/V0 > 0 (specific volume over its value at the zero of the scale),
//     template <class V> cold_point<V> evaluate(V x) const;
//     double reference_density() const;    // kg/m3, 1/V0
// Invariants: p_c = -de_c/dV (V = x / reference_density), slope = dp_c/dx, e_c(1) = 0. Whether p_c(1) is exactly 0 is the model's.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class V> struct cold_point {
  V energy;   // e_c, J/kg
  V pressure; // p_c, Pa
  V slope;    // dp_c/dx, Pa
};

template <class C, class V = double>
concept ColdCurve = requires(const C cold, V x) {
  { cold.evaluate(x).energy } -> std::convertible_to<V>;
  { cold.evaluate(x).pressure } -> std::convertible_to<V>;
  { cold.evaluate(x).slope } -> std::convertible_to<V>;
  { cold.reference_density() } -> std::convertible_to<double>;
};

} // namespace bolide
