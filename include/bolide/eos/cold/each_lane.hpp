// SPDX-License-Identifier: MIT
// A cold curve that is exact in double, answered for any lane type: lane by lane.
#pragma once

#include "bolide/concepts/cold_curve.hpp"

namespace bolide::cold::detail {

/// exact(double) -> cold_point<double>.
template <class V, class Exact> cold_point<V> each_lane(V x, const Exact& exact) {
  if constexpr (lane_width<V> == 1) {
    const cold_point<double> r = exact(static_cast<double>(x));
    return {static_cast<V>(r.energy), static_cast<V>(r.pressure), static_cast<V>(r.slope)};
  } else {
    cold_point<V> r{};
    for (int i = 0; i < lane_width<V>; ++i) {
      const cold_point<double> one = exact(static_cast<double>(lane(x, i)));
      r.energy.set(i, static_cast<scalar_t<V>>(one.energy));
      r.pressure.set(i, static_cast<scalar_t<V>>(one.pressure));
      r.slope.set(i, static_cast<scalar_t<V>>(one.slope));
    }
    return r;
  }
}

} // namespace bolide::cold::detail
