// SPDX-License-Identifier: MIT
// How particles see the nodes along every axis: the factors of weight and gradient, one particle per lane.
//
// Only what a sweep wants is made, and products are taken where they are used. In r-z the hoop terms use N_t / r, N_t = N + (l^2/2) N'' with l half the
// particle size: this is
// (r N)' averaged over the particle less r N', exact for piecewise quadratic N, and makes the sum of a uniform pressure over the
// seeding lattice vanish on every node. Without it a folded B-spline leaves 1/32 of p times the area on the first node off the axis.
// N'' = 0 for linear shapes.
#pragma once

#include "bolide/concepts/shape_function.hpp"
#include "bolide/core/math.hpp"

#include <algorithm>
#include <limits>

namespace bolide {

/// What a sweep wants of its stencils besides the weights: slopes for gradients, moments N (x_n - x_p) for affine fields.
struct wants {
  bool slopes = false, moments = false;
};

template <class T, class Space, class Shape> struct stencil {
  using V = native_pack<T>;
  static constexpr int dim = Space::dim, support = Shape::support;
  static constexpr int nodes = dim == 1 ? support : dim == 2 ? support * support : support * support * support;
  static constexpr bool straight = shape_is_straight<Shape> && support == 2; // slopes are -1 and 1, N_t is N

  V from_first[dim];                           // x - first node, cells
  V weight[dim][support], slope[dim][support]; // of the axes: N, and its derivative in 1/cell
  V hoop_weight[Space::hoop ? support : 1];    // N_t of the radius

  /// `f` is x - first node in cells, `half_size` half a particle over h.
  template <wants Wanted> BOLIDE_INLINE void make(const V (&f)[dim], T half_size) {
    for (int d = 0; d < dim; ++d) {
      from_first[d] = f[d];
      if constexpr (shape_wants_size<Shape>) Shape::value(f[d], weight[d], half_size);
      else Shape::value(f[d], weight[d]);
      if constexpr (Wanted.slopes) {
        if constexpr (shape_wants_size<Shape>) Shape::slope(f[d], slope[d], half_size);
        else Shape::slope(f[d], slope[d]);
        if constexpr (Space::hoop)
          if (d == 0) {
            V change[support];
            if constexpr (straight) std::fill_n(change, support, V(T(0)));
            else mend(f[0], weight[0], half_size, change);
            for (int a = 0; a < support; ++a) hoop_weight[a] = weight[0][a] + change[a];
          }
      }
    }
  }
  /// N (x_n - x_p) of node a along an axis, cells
  BOLIDE_INLINE V moment(int axis, int a) const { return weight[axis][a] * distance(axis, a); }
  /// x_n - x_p, cells
  BOLIDE_INLINE V distance(int axis, int a) const { return T(a) - from_first[axis]; }

private:
  /// N_t - N = (l^2/2) N'', where it raises a weight limited to the weight itself (equal to it on a lattice of 2, 4 ... points per cell): a
  /// node that hardly sees the particle must not take a force without mass. What is raised is taken from the nodes of negative N''.
  static BOLIDE_INLINE void mend(V f, const V* weight, T half_size, V* change) {
    V curvature[support], raised(T(0)), wanted(T(0));
    if constexpr (shape_wants_size<Shape>) Shape::curvature(f, curvature, half_size);
    else Shape::curvature(f, curvature);
    const V factor(T(0.5) * half_size * half_size), zero(T(0));
    for (int a = 0; a < support; ++a) {
      const V whole = factor * max(curvature[a], zero);
      change[a] = min(whole, weight[a]);
      raised += change[a];
      wanted += whole;
    }
    const V share = select(wanted > zero, raised / max(wanted, V(std::numeric_limits<T>::min())), zero);
    for (int a = 0; a < support; ++a) change[a] = select(curvature[a] < zero, factor * curvature[a] * share, change[a]);
  }
};

} // namespace bolide
