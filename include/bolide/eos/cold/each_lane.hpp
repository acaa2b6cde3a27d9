// SPDX-License-Identifier: MIT
// A cold curve that is exact in double, answered for any lane type: lane by lane.
#pragma once

#include "bolide/concepts/cold_curve.hpp"

namespace bolide::cold::detail {

/// exact(double) -> cold_point<double>.
template <class V, class Exact> cold_point<V> each_lane(V x, const Exact& exact) {
  using T = scalar_t<V>;
  cold_point<V> r{};
  for (int i = 0; i < lane_width<V>; ++i) {
    const cold_point<double> one = exact(static_cast<double>(lane(x, i)));
    set_lane(r.energy, i, static_cast<T>(one.energy));
    set_lane(r.pressure, i, static_cast<T>(one.pressure));
    set_lane(r.slope, i, static_cast<T>(one.slope));
  }
  return r;
}

} // namespace bolide::cold::detail
