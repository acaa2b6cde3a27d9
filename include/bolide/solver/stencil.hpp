// SPDX-License-Identifier: MIT
// How a chunk of particles sees the nodes of its window: the first node, and weight and gradient of every node of the support.
//
// Made once per sweep for up to chunk_size particles, lanes at a time, and only what the sweep wants; then the transfers walk over
// particles and nodes with constant offsets. In r-z the hoop terms use N_t = N + (l^2/2) N'' with l half the particle size: this is
// (r N)' averaged over the particle less r N', exact for piecewise quadratic N, and makes the sum of a uniform pressure over the
// seeding lattice vanish on every node. Without it a folded B-spline leaves 1/32 of p times the area on the first node off the axis.
// N'' = 0 for linear shapes.
#pragma once

#include "bolide/concepts/shape_function.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/material/report.hpp"

#include <limits>

namespace bolide {

/// What a sweep wants of its stencil.
enum class wants { values, gradients, both };

template <class T, class Space, class Shape> struct stencil {
  static constexpr int dim = Space::dim, support = Shape::support;
  static constexpr int nodes = dim == 1 ? support : dim == 2 ? support * support : support * support * support;
  static constexpr int stride = grid::window<dim, T>::stride;

  std::int32_t base[chunk_size];         // offset of the first node in the window
  alignas(64) T value[nodes][chunk_size];            // N
  alignas(64) T gradient[dim][nodes][chunk_size];    // dN/dx, 1/m
  alignas(64) T hoop[Space::hoop ? nodes : 1][chunk_size]; // N_t / r, 1/m
  alignas(64) T from_first[dim][chunk_size];         // x - first node, cells

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
  /// (x_n - x_p) / h of particle k along an axis.
  BOLIDE_INLINE T distance(int k, int n, int axis) const { return T(along(n, axis)) - from_first[axis][k]; }

  /// Particles begin .. begin + n of columns p, in the block whose first cell is `origin`; they touch the nodes `touched` of it (the first
  /// node is held inside, so that a rounding of x / h on a cell face reads no foreign node). `half_size` is half a particle over h.
  template <wants Wanted, class Columns>
  void make(const Columns& p, std::size_t begin, int n, const grid::cell_index<dim>& origin, const grid::node_range<dim>& touched, double h, T half_size) {
    for (int k = 0; k < n; k += lane_width<native_pack<T>>) make_lane<Wanted>(p, begin + static_cast<std::size_t>(k), k, origin, touched, static_cast<T>(1 / h), half_size);
  }

  /// N_t - N = (l^2/2) N'', where it raises a weight limited to the weight itself (equal to it on a lattice of 2, 4 ... points per cell): a
  /// node that hardly sees the particle must not take a force without mass. What is raised is taken from the nodes of negative N''.
  template <class V> static BOLIDE_INLINE void mend(V f, const V* weight, T half_size, V* change) {
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

private:
  static constexpr T smallest_radius = T(1e-30); // a particle at r = 0: N/r of the node off the axis is finite there

  template <wants Wanted, class Columns>
  BOLIDE_INLINE void make_lane(const Columns& p, std::size_t at, int k, const grid::cell_index<dim>& origin, const grid::node_range<dim>& touched, T inverse_h,
                               T half_size) {
    using V = native_pack<T>;
    V weight[dim][support], slope[dim][support], hoop_weight[support];
    V offset_sum(T(0));
    for (std::size_t d = 0; d < dim; ++d) {
      const V x = load<V>(p.template get<field::position>(static_cast<int>(d)) + at);
      const V cells = x * inverse_h;
      const V first = clip(floor(cells - T(Shape::offset)), V(T(origin[d] + touched.low[d])), V(T(origin[d] + touched.high[d] - support + 1)));
      const V f = cells - first;
      store(f, from_first[d] + k);
      if constexpr (shape_wants_size<Shape>) Shape::value(f, weight[d], half_size);
      else Shape::value(f, weight[d]);
      if constexpr (Wanted != wants::values) {
        if constexpr (shape_wants_size<Shape>) Shape::slope(f, slope[d], half_size);
        else Shape::slope(f, slope[d]);
        for (int a = 0; a < support; ++a) slope[d][a] = slope[d][a] * inverse_h;
        if constexpr (Space::hoop)
          if (d == 0) {
            V change[support];
            mend(f, weight[0], half_size, change);
            const V inverse_r = V(T(1)) / max(x, V(smallest_radius));
            for (int a = 0; a < support; ++a) hoop_weight[a] = (weight[0][a] + change[a]) * inverse_r;
          }
      }
      offset_sum = offset_sum * T(stride) + (first - T(origin[d] - grid::window<dim, T>::reach));
    }
    store_whole(offset_sum, base + k);
    for (int node = 0; node < nodes; ++node) {
      // products of the axes, the first axis first
      const auto product = [&](const V* first, int sloped) {
        V w = first[along(node, 0)];
        for (int d = 1; d < dim; ++d) w = w * (d == sloped ? slope : weight)[d][along(node, d)];
        return w;
      };
      if constexpr (Wanted != wants::gradients) store(product(weight[0], dim), value[node] + k);
      if constexpr (Wanted != wants::values) {
        for (int d = 0; d < dim; ++d) store(product(d == 0 ? slope[0] : weight[0], d), gradient[d][node] + k);
        if constexpr (Space::hoop) store(product(hoop_weight, dim), hoop[node] + k);
      }
    }
  }
};

} // namespace bolide
