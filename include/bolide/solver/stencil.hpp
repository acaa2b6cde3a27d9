// SPDX-License-Identifier: MIT
// How the particles of a tile see the nodes: weight and gradient of every node of the support, one particle per lane (solver/tiles.hpp).
//
// Made anew for every tile of every sweep, and only what the sweep wants: the factors of the axes live in registers, the products are taken where they
// are used. In r-z the hoop terms use N_t / r, N_t = N + (l^2/2) N'' with l half the particle size: this is
// (r N)' averaged over the particle less r N', exact for piecewise quadratic N, and makes the sum of a uniform pressure over the
// seeding lattice vanish on every node. Without it a folded B-spline leaves 1/32 of p times the area on the first node off the axis.
// N'' = 0 for linear shapes.
#pragma once

#include "bolide/concepts/shape_function.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/tiles.hpp"

#include <algorithm>
#include <limits>

namespace bolide {

/// What a sweep wants of its stencil.
enum class wants { values, gradients, both };

template <class T, class Space, class Shape> struct stencil {
  using V = native_pack<T>;
  static constexpr int dim = Space::dim, support = Shape::support;
  static constexpr int nodes = dim == 1 ? support : dim == 2 ? support * support : support * support * support;
  static constexpr int stride = grid::window<dim, T>::stride;

  V from_first[dim];                             // x - first node, cells
  V weight[dim][support], slope[dim][support];   // of the axes: N, and dN/dx in 1/m
  V hoop_weight[Space::hoop ? support : 1];      // N_t of the radius

  /// Window offset of node n of a support relative to the first.
  static constexpr int offset(int n) {
    int o = 0;
    for (int axis = 0; axis < dim; ++axis) o = o * stride + along(n, axis);
    return o;
  }
  /// Index of node n along an axis.
  static constexpr int along(int n, int axis) {
    for (int last = dim - 1; last > axis; --last) n /= support;
    return n % support;
  }
  /// N of node n
  BOLIDE_INLINE V value(int n) const {
    V w = weight[0][along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * weight[d][along(n, d)];
    return w;
  }
  /// dN/dx along an axis, 1/m
  BOLIDE_INLINE V gradient(int axis, int n) const {
    V w = (axis == 0 ? slope : weight)[0][along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * (axis == d ? slope : weight)[d][along(n, d)];
    return w;
  }
  /// N_t
  BOLIDE_INLINE V hoop(int n) const {
    V w = hoop_weight[along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * weight[d][along(n, d)];
    return w;
  }
  /// (x_n - x_p) / h along an axis
  BOLIDE_INLINE V distance(int n, int axis) const { return T(along(n, axis)) - from_first[axis]; }

  /// The particles of tile t of columns p, in the block whose first cell is `origin`. `half_size` is half a particle over h. Lanes without a particle
  /// see what a particle in the middle of its cell sees.
  template <wants Wanted, class Columns>
  BOLIDE_INLINE void make(const Columns& p, const tile& t, const grid::cell_index<dim>& origin, T inverse_h, T half_size) {
    const auto present = lanes_of<V>(t.lanes);
    std::int32_t rest = t.base;
    for (int d = dim - 1; d >= 0; --d) {
      const auto axis = static_cast<std::size_t>(d);
      V first(T(origin[axis] + rest % stride - grid::window<dim, T>::reach));
      if (d == dim - 1) first += lane_numbers<V>();
      rest /= stride;
      const V x = spread<V>(p.template get<field::position>(d) + t.begin, t.lanes);
      const V f = select(present, x * inverse_h - first, V(T(Shape::offset + 0.5)));
      from_first[d] = f;
      if constexpr (shape_wants_size<Shape>) Shape::value(f, weight[d], half_size);
      else Shape::value(f, weight[d]);
      if constexpr (Wanted != wants::values) {
        if constexpr (shape_wants_size<Shape>) Shape::slope(f, slope[d], half_size);
        else Shape::slope(f, slope[d]);
        for (int a = 0; a < support; ++a) slope[d][a] = slope[d][a] * inverse_h;
        if constexpr (Space::hoop)
          if (d == 0) {
            V change[support];
            if constexpr (shape_is_straight<Shape>) std::fill_n(change, support, V(T(0)));
            else mend(f, weight[0], half_size, change);
            for (int a = 0; a < support; ++a) hoop_weight[a] = weight[0][a] + change[a];
          }
      }
    }
  }

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
