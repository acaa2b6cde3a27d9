// SPDX-License-Identifier: MIT
// Uniform GIMP (Bardenhagen and Kober 2004): the linear tent averaged over the particle, a box of its seeding size 2 l (in cells).
//   |x| < l         N = 1 - (x^2 + l^2)/(2 l)         N' = -x/l
//   l .. 1 - l      N = 1 - |x|                       N' = -sign x
//   1 - l .. 1 + l  N = (1 + l - |x|)^2/(4 l)         N' = -sign x (1 + l - |x|)/(2 l)
// Three nodes per axis (one has no weight where the particle touches two cells' nodes only), continuous slope, exact for linear fields; as
// local as the tent where a particle is small. l -> 0 is linear, l = 1/2 (one particle per cell) the quadratic B-spline.
// Validity: 0 < l <= 1/2. The box keeps its seeding size (uGIMP): stretched by more than the particle spacing, boxes no longer touch and
// cell-crossing noise comes back. sum N (x_i - x)^2 is not constant, so that APIC does not take it.
// In r-z the hoop terms want the average over the particle's ends, (tent(x - l) + tent(x + l))/2, which makes a uniform pressure over the
// seeding lattice vanish on every node; `curvature` is the second difference that solver/stencil.hpp adds as (l^2/2) N'' to get it.
#pragma once

#include "bolide/concepts/shape_function.hpp"
#include "bolide/core/math.hpp"

namespace bolide::shape {

struct gimp {
  static constexpr int support = 3;
  static constexpr double offset = 0.5;
  static constexpr bool smooth = true;
  static constexpr bool wants_size = true; // half the particle size in cells is an argument
  static constexpr const char* name = "gimp";

  template <class V> BOLIDE_INLINE static void value(V f, V* n, scalar_t<V> l) {
    using T = scalar_t<V>;
    for (int i = 0; i < support; ++i) {
      const V x = abs(f - T(i)), beyond = max(T(1) + l - x, V(T(0)));
      n[i] = select(x < V(l), T(1) - (x * x + l * l) * (T(0.5) / l), select(x < V(T(1) - l), T(1) - x, beyond * beyond * (T(0.25) / l)));
    }
  }
  template <class V> BOLIDE_INLINE static void slope(V f, V* d, scalar_t<V> l) {
    using T = scalar_t<V>;
    for (int i = 0; i < support; ++i) {
      const V x = f - T(i), beyond = max(T(1) + l - abs(x), V(T(0))) * (T(0.5) / l);
      const V falling = select(abs(x) < V(T(1) - l), V(T(1)), beyond);
      d[i] = select(abs(x) < V(l), -x / l, select(x > V(T(0)), -falling, falling));
    }
  }
  template <class V> BOLIDE_INLINE static void curvature(V f, V* c, scalar_t<V> l) {
    using T = scalar_t<V>;
    V n[support];
    value(f, n, l);
    for (int i = 0; i < support; ++i) {
      const V x = f - T(i);
      const V ends = T(0.5) * (max(T(1) - abs(x - l), V(T(0))) + max(T(1) - abs(x + l), V(T(0))));
      c[i] = (ends - n[i]) * (T(2) / (l * l));
    }
  }
};

static_assert(ShapeFunction<gimp> && ShapeFunction<gimp, pack<float, 4>>);

} // namespace bolide::shape
