// SPDX-License-Identifier: MIT
// How a chunk of particles sees the nodes of its window: first node, and weight and slope of each node of the support per axis.
//
// Made once per sweep for up to chunk_size particles, lanes at a time; then the transfers walk over particles and nodes with constant
// offsets. In r-z the hoop terms use N_t = N + (l^2/2) N'' with l half the particle size: this is N_t = (r N)' averaged over the
// particle less r N', exact for piecewise quadratic N, and makes the sum of a uniform pressure over the seeding lattice vanish on every
// node. Without it a folded B-spline leaves 1/32 of p times the area on the first node off the axis. N'' = 0 for linear shapes.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/material/report.hpp"

namespace bolide {

template <class T, class Space, class Shape> struct stencil {
  static constexpr int dim = Space::dim, support = Shape::support;
  using map = grid::block_map<dim>;

  std::int32_t base[chunk_size];              // offset of the first node in the window
  T weight[dim][support][chunk_size];
  T slope[dim][support][chunk_size];          // 1/m
  T hoop[Space::hoop ? support : 1][chunk_size]; // N_t / r, 1/m
  T from_first[dim][chunk_size];              // x - first node, cells

  /// Particles begin .. begin + n of columns p, in the block whose first cell is `origin`; they touch the nodes `touched` of it (the first
  /// node is held inside, so that a rounding of x / h on a cell face reads no foreign node). `half_size` is half a particle over h.
  template <class Columns>
  void make(const Columns& p, std::size_t begin, int n, const grid::cell_index<dim>& origin, const grid::node_range<dim>& touched, double h, T half_size) {
    using V = native_pack<T>;
    const T inverse_h = static_cast<T>(1 / h);
    for (int k = 0; k < n; k += lane_width<V>) {
      std::int32_t offset[lane_width<V>] = {};
      for (int d = 0; d < dim; ++d) {
        const V x = load<V>(p.template get<field::position>(d) + begin + static_cast<std::size_t>(k));
        const V cells = x * inverse_h;
        const auto at = static_cast<std::size_t>(d);
        const V first = clip(floor(cells - T(Shape::offset)), V(T(origin[at] + touched.low[at])), V(T(origin[at] + touched.high[at] - support + 1)));
        const V f = cells - first;
        store(f, from_first[d] + k);
        V n_values[support], d_values[support];
        Shape::value(f, n_values);
        Shape::slope(f, d_values);
        for (int a = 0; a < support; ++a) {
          store(n_values[a], weight[d][a] + k);
          store(d_values[a] * inverse_h, slope[d][a] + k);
        }
        if constexpr (Space::hoop) {
          if (d == 0) {
            V curvature[support];
            Shape::curvature(curvature);
            const V inverse_r = T(1) / max(x, V(smallest_radius));
            for (int a = 0; a < support; ++a) store((n_values[a] + T(0.5) * half_size * half_size * curvature[a]) * inverse_r, hoop[a] + k);
          }
        }
        std::int32_t i[lane_width<V>];
        floor_to_int(first, i);
        for (int lane_i = 0; lane_i < lane_width<V>; ++lane_i)
          offset[lane_i] = offset[lane_i] * grid::window<dim, T>::stride + (i[lane_i] - origin[static_cast<std::size_t>(d)] + grid::window<dim, T>::reach);
      }
      for (int lane_i = 0; lane_i < lane_width<V>; ++lane_i) base[k + lane_i] = offset[lane_i];
    }
  }

  /// f(node offset, indices per axis) for every node of particle k. The loops have constant bounds and unroll.
  template <class F> BOLIDE_INLINE void for_each_node(int k, F&& f) const {
    constexpr int stride = grid::window<dim, T>::stride;
    const int b = base[k];
    if constexpr (dim == 1) {
      for (int i = 0; i < support; ++i) f(b + i, std::array<int, 1>{i});
    } else {
      for (int i = 0; i < support; ++i)
        for (int j = 0; j < support; ++j) f(b + i * stride + j, std::array<int, 2>{i, j});
    }
  }
  BOLIDE_INLINE T value(int k, const std::array<int, dim>& a) const {
    T w = weight[0][a[0]][k];
    for (int d = 1; d < dim; ++d) w *= weight[d][a[static_cast<std::size_t>(d)]][k];
    return w;
  }
  /// dN/dx_axis
  BOLIDE_INLINE T gradient(int k, const std::array<int, dim>& a, int axis) const {
    T w = axis == 0 ? slope[0][a[0]][k] : weight[0][a[0]][k];
    for (int d = 1; d < dim; ++d) w *= axis == d ? slope[d][a[static_cast<std::size_t>(d)]][k] : weight[d][a[static_cast<std::size_t>(d)]][k];
    return w;
  }
  /// N_t / r
  BOLIDE_INLINE T hoop_value(int k, const std::array<int, dim>& a) const {
    T w = hoop[a[0]][k];
    for (int d = 1; d < dim; ++d) w *= weight[d][a[static_cast<std::size_t>(d)]][k];
    return w;
  }
  /// (x_I - x_p) / h along an axis
  BOLIDE_INLINE T distance(int k, const std::array<int, dim>& a, int axis) const { return T(a[static_cast<std::size_t>(axis)]) - from_first[axis][k]; }

private:
  static constexpr T smallest_radius = T(1e-30); // a particle at r = 0: N/r of the node off the axis is finite there
};

} // namespace bolide
