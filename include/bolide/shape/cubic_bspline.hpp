// SPDX-License-Identifier: MIT
// Cubic B-spline shape function: four nodes per axis, continuous curvature. With t = x - second node in [0, 1):
//   N = (1 - t)^3/6, (4 - 6 t^2 + 3 t^3)/6, (1 + 3 t + 3 t^2 - 3 t^3)/6, t^3/6
// Exact for linear fields; sum N (x_i - x)^2 = 1/3 at every x. Smoother than the quadratic one and wider: a shock takes about one cell
// more, a transfer 16 instead of 9 nodes (Steffen, Kirby, Berzins 2008).
// Limit: the hoop quadrature of solver/stencil.hpp is exact for quadratic pieces. Here it leaves l^2/6 (l half the particle size in cells:
// 1/96 at two particles per cell) of p times the cell's area on the first node off the axis of r-z.
#pragma once

#include "bolide/concepts/shape_function.hpp"
#include "bolide/core/math.hpp"

namespace bolide::shape {

struct cubic_bspline {
  static constexpr int support = 4;
  static constexpr double offset = 1;
  static constexpr bool smooth = true;
  static constexpr double inertia = 1.0 / 3; // sum N (x_i - x)^2 in cells^2
  static constexpr const char* name = "cubic_bspline";

  template <class V> BOLIDE_INLINE static void value(V f, V* n) {
    using T = scalar_t<V>;
    const V t = f - T(1), u = T(2) - f;
    n[0] = T(1.0 / 6) * u * u * u;
    n[1] = T(2.0 / 3) - t * t * (T(1) - T(0.5) * t);
    n[2] = T(2.0 / 3) - u * u * (T(1) - T(0.5) * u);
    n[3] = T(1.0 / 6) * t * t * t;
  }
  template <class V> BOLIDE_INLINE static void slope(V f, V* d) {
    using T = scalar_t<V>;
    const V t = f - T(1), u = T(2) - f;
    d[0] = T(-0.5) * u * u;
    d[1] = t * (T(1.5) * t - T(2));
    d[2] = u * (T(2) - T(1.5) * u);
    d[3] = T(0.5) * t * t;
  }
  template <class V> BOLIDE_INLINE static void curvature(V f, V* c) {
    using T = scalar_t<V>;
    const V t = f - T(1), u = T(2) - f;
    c[0] = u;
    c[1] = T(3) * t - T(2);
    c[2] = T(3) * u - T(2);
    c[3] = t;
  }
};

static_assert(ShapeFunction<cubic_bspline> && ShapeFunction<cubic_bspline, pack<float, 4>>);

} // namespace bolide::shape
