// SPDX-License-Identifier: MIT
// Quadratic B-spline shape function: three nodes per axis, continuous slope, no cell-crossing noise (Steffen, Kirby, Berzins 2008).
//   N = (3/2 - f)^2/2, 3/4 - (f - 1)^2, (f - 1/2)^2/2   with f = x - first node in [1/2, 3/2).
// Exact for linear fields; sum N (x_i - x)^2 = 1/4 at every x, which is what makes APIC's inertia a constant.
#pragma once

#include "bolide/core/math.hpp"

namespace bolide::shape {

struct quadratic_bspline {
  static constexpr int support = 3;
  static constexpr double offset = 0.5;
  static constexpr bool smooth = true;
  static constexpr double inertia = 0.25; // sum N (x_i - x)^2 in cells^2
  static constexpr const char* name = "bspline";

  template <class V> BOLIDE_INLINE static void value(V f, V* n) {
    using T = scalar_t<V>;
    n[0] = T(0.5) * square(T(1.5) - f);
    n[1] = T(0.75) - square(f - T(1));
    n[2] = T(0.5) * square(f - T(0.5));
  }
  template <class V> BOLIDE_INLINE static void slope(V f, V* d) {
    using T = scalar_t<V>;
    d[0] = f - T(1.5);
    d[1] = T(-2) * (f - T(1));
    d[2] = f - T(0.5);
  }
  template <class V> BOLIDE_INLINE static void curvature(V, V* c) {
    c[0] = c[2] = V(1);
    c[1] = V(-2);
  }
};

} // namespace bolide::shape
