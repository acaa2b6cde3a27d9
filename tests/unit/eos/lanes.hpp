// SPDX-License-Identifier: MIT
// Calls a per-particle function with every lane type and compares with the scalar answer.
#pragma once

#include "bolide/core/lane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bolide::test {

/// |a - b| <= relative * (|b| + scale).
inline void expect_close(double a, double b, double relative, double scale, const std::string& what) {
  EXPECT_TRUE(std::abs(a - b) <= relative * (std::abs(b) + scale)) << what << ": " << a << " is not " << b << " within " << relative;
}

/// A lane value whose lanes are first, first + step, ...
template <class V> V ramp(double first, double step) {
  if constexpr (lane_width<V> == 1) return static_cast<V>(first);
  else {
    V v;
    for (int i = 0; i < lane_width<V>; ++i) v.set(i, static_cast<scalar_t<V>>(first + step * i));
    return v;
  }
}

/// Round-off of the lane's number type times `times`.
template <class V> double epsilon(double times) { return times * (sizeof(scalar_t<V>) == 8 ? 2.3e-16 : 1.2e-7); }

using every_lane = ::testing::Types<float, pack<double, 2>, pack<double, 4>, pack<double, 8>, pack<float, 4>, pack<float, 8>,
                                    pack<float, 16>>;

} // namespace bolide::test
