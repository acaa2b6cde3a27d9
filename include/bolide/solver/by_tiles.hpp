// SPDX-License-Identifier: MIT
// Gathers and scatters of particles that fill tiles (solver/tiles.hpp): one cell per lane.
//
// The node values of all lanes are then consecutive in a window, a dense copy of the touched nodes by component: a gather reads them by plain loads, one per
// node and component, a scatter sums over the tiles of the same cells in registers and adds to the window once for all of them. Nodes of
// different place in a support add to different copies of the window, so that no load waits for a store to a shifted place.
// Sums of the lanes of a tile go densely to the scratch of the chunk.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/node_column.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/chunk.hpp"

#include <array>

namespace bolide {

template <class T, class Space, class Shape> struct by_tiles {
  using V = native_pack<T>;
  using stencil_type = stencil<T, Space, Shape>;
  using chunk_type = chunk<T, Space, Shape>;
  static constexpr int dim = Space::dim, support = Shape::support, nodes = stencil_type::nodes;
  static constexpr int stride = grid::window<dim>::stride;
  template <int N> using scratch = chunk_scratch<T, N>;
  template <int N> using node_sums = std::array<std::array<V, static_cast<std::size_t>(N)>, static_cast<std::size_t>(nodes)>;

  /// Values on the places of a window, N components.
  template <int N> struct window {
    static constexpr int padding = 32; // a register may be read from the last place on
    alignas(64) T value[N][grid::window<dim>::size + padding];
  };
  template <int N> using scatter_window = window<N * support>;

  // ---- windows ------------------------------------------------------------------------------------------------------------------
  template <int N, class Range> static void copy(const grid::node_column<T, N>& column, std::size_t field, const Range& range, window<N>& win) {
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; i += lane_width<V>) { // whole registers: what is too much is written again by the next run, or never read
        V x[grid::node_column<T, N>::width];
        column.lanes(field + static_cast<std::size_t>(node + i), x);
        for (int c = 0; c < N; ++c) store(x[c], win.value[c] + at + i);
      }
    });
  }
  template <int N, class Range> static void clear(const Range& range, scatter_window<N>& win) {
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t, int at, int count) {
      for (int c = 0; c < N * support; ++c)
        for (int i = 0; i < count; i += lane_width<V>) store(V(T(0)), win.value[c] + at + i);
    });
  }
  template <int N, class Range> static void add(const scatter_window<N>& win, grid::node_column<T, N>& column, std::size_t field, const Range& range) {
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; i += lane_width<V>) {
        const std::size_t first = field + static_cast<std::size_t>(node + i);
        V x[grid::node_column<T, N>::width];
        column.lanes(first, x);
        for (int c = 0; c < N; ++c)
          for (int copy = 0; copy < support; ++copy) x[c] += load<V>(win.value[copy * N + c] + at + i);
        column.put_lanes(first, x, count - i);
      }
    });
  }

  // ---- stencils of a tile -----------------------------------------------------------------------------------------------------------
  /// Place of node n of a support relative to the first.
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
  static BOLIDE_INLINE V value(const stencil_type& st, int n) {
    V w = st.weight[0][along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * st.weight[d][along(n, d)];
    return w;
  }
  /// dN/dx along an axis, 1/cell
  static BOLIDE_INLINE V gradient(const stencil_type& st, int axis, int n) {
    V w = (axis == 0 ? st.slope : st.weight)[0][along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * (axis == d ? st.slope : st.weight)[d][along(n, d)];
    return w;
  }
  /// N_t
  static BOLIDE_INLINE V hoop(const stencil_type& st, int n) {
    V w = st.hoop_weight[along(n, 0)];
    for (int d = 1; d < dim; ++d) w = w * st.weight[d][along(n, d)];
    return w;
  }
  static BOLIDE_INLINE V distance(const stencil_type& st, int n, int axis) { return st.distance(axis, along(n, axis)); }

  /// f(tile, its place in the scratch, stencil) for every tile. Lanes without a particle see what a particle in the middle of its cell sees.
  template <wants Wanted, class Columns> static BOLIDE_INLINE stencil_type stencil_of(const Columns& p, const tile& t, const chunk_type& c) {
    const auto present = lanes_of<V>(t.lanes);
    V f[dim];
    std::int32_t rest = t.base;
    for (int d = dim - 1; d >= 0; --d) {
      V first(T(c.origin[static_cast<std::size_t>(d)] + rest % stride - grid::window<dim>::reach));
      if (d == dim - 1) first += lane_numbers<V>();
      rest /= stride;
      const V x = bolide::spread<V>(p.template get<field::position>(d) + t.begin, t.lanes);
      f[d] = select(present, x * c.inverse_h - first, V(T(Shape::offset + 0.5)));
    }
    stencil_type st;
    st.template make<Wanted>(f, c.half_size);
    return st;
  }
  template <wants Wanted, class Columns, class F> static BOLIDE_INLINE void each_tile(const Columns& p, const chunk_type& c, F&& f) {
    for (const tile* t = c.tiles; t != c.tiles_end; ++t) f(*t, static_cast<int>(t->begin - c.begin), stencil_of<Wanted>(p, *t, c));
  }
  /// Component i of the node values that the lanes of a tile see at node n of their supports.
  template <int N> static BOLIDE_INLINE V at_node(const window<N>& win, int i, const tile& t, int n) { return load<V>(win.value[i] + t.base + offset(n)); }

  // ---- from the nodes ---------------------------------------------------------------------------------------------------------------
  template <bool Both, int N, class Columns>
  static void velocity_gradient(const Columns& p, const chunk_type& c, const window<N>& win, T first, T second, scratch<Space::gradient_size>& l) {
    each_tile<wants{true, false}>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V g[dim * dim], around(T(0));
      for (auto& x : g) x = V(T(0));
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        V v[dim];
        for (int i = 0; i < dim; ++i) {
          v[i] = at_node<N>(win, i, t, n);
          if constexpr (Both) v[i] = first * v[i] + second * at_node<N>(win, dim + i, t, n);
        }
        for (int d = 0; d < dim; ++d) {
          const V w = gradient(st, d, n);
          for (int i = 0; i < dim; ++i) g[i * dim + d] += v[i] * w;
        }
        if constexpr (Space::hoop) around += v[0] * hoop(st, n);
      }
      for (int i = 0; i < dim * dim; ++i) squeeze(g[i] * c.inverse_h, t.lanes, l[i] + k);
      if constexpr (Space::hoop) squeeze(around, t.lanes, l[dim * dim] + k);
    });
  }
  template <int N, class Columns> static void mean(const Columns& p, const chunk_type& c, const window<N>& win, scratch<N>& to) {
    each_tile<wants{}>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V sum[N];
      for (auto& x : sum) x = V(T(0));
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = value(st, n);
        for (int i = 0; i < N; ++i) sum[i] += at_node<N>(win, i, t, n) * w;
      }
      for (int i = 0; i < N; ++i) squeeze(sum[i], t.lanes, to[i] + k);
    });
  }
  template <int N, class Columns, class X> static void mean_square(const Columns& p, const chunk_type& c, const window<N>& win, X&& x, T* to) {
    each_tile<wants{}>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V sum(T(0)), own[dim];
      for (int d = 0; d < dim; ++d) own[d] = bolide::spread<V>(x(d) + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        V squares(T(0));
        for (int d = 0; d < dim; ++d) squares += square(at_node<N>(win, d, t, n) - own[d]);
        sum += squares * value(st, n);
      }
      squeeze(sum, t.lanes, to + k);
    });
  }
  template <int Moments, class Columns> static void affine_moments(const Columns& p, const chunk_type& c, const window<2 * dim>& win, scratch<Moments>& to, T cell) {
    each_tile<wants{}>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V own[dim], sum[Moments];
      for (auto& x : sum) x = V(T(0));
      for (int d = 0; d < dim; ++d) own[d] = bolide::spread<V>(p.template get<field::velocity>(d) + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = value(st, n);
        V dx[dim];
        for (int d = 0; d < dim; ++d) dx[d] = distance(st, n, d) * cell;
        for (int i = 0; i < 2 * dim; ++i) {
          const V b = at_node<2 * dim>(win, i, t, n) - own[i % dim], weighted = b * w;
          sum[i] += weighted;
          sum[2 * dim] += weighted * b;
          for (int d = 0; d < dim; ++d) sum[2 * dim + 1 + i * dim + d] += weighted * dx[d];
        }
      }
      for (int i = 0; i < Moments; ++i) squeeze(sum[i], t.lanes, to[i] + k);
    });
  }

  // ---- to the nodes -----------------------------------------------------------------------------------------------------------------
  /// give(tile, its place in the scratch, stencil, sum) adds what the lanes of a tile give to the nodes of their supports, N values each.
  template <wants Wanted, int N, class Columns, class F>
  static BOLIDE_INLINE void accumulate(const Columns& p, const chunk_type& c, scatter_window<N>& win, F&& give) {
    for (const tile* t = c.tiles; t != c.tiles_end;) {
      const std::int32_t base = t->base;
      alignas(64) node_sums<N> sum;
      for (auto& node : sum)
        for (auto& x : node) x = V(T(0));
      do give(*t, static_cast<int>(t->begin - c.begin), stencil_of<Wanted>(p, *t, c), sum);
      while (++t != c.tiles_end && t->base == base);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n)
        for (int i = 0; i < N; ++i) {
          T* const to = win.value[along(n, dim - 1) * N + i] + base + offset(n);
          store(load<V>(to) + sum[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)], to);
        }
    }
  }
  /// sum N q of N values; those from First on change by slopes[(i - First) * dim + d] per cell.
  template <int N, int First, class Columns, class Slopes>
  static void scatter(const Columns& p, const chunk_type& c, const scratch<N>& q, const Slopes& slopes, scatter_window<N>& win) {
    accumulate<wants{}, N>(p, c, win, [&](const tile& t, int k, const stencil_type& st, node_sums<N>& sum) {
      V own[N];
      [[maybe_unused]] V slope[N * dim];
      for (int i = 0; i < N; ++i) own[i] = bolide::spread<V>(q[i] + k, t.lanes);
      for (int i = 0; i < (N - First) * dim; ++i) slope[i] = bolide::spread<V>(slopes[i] + k, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = value(st, n);
        for (int i = 0; i < N; ++i) {
          V here = own[i];
          if (i >= First)
            for (int d = 0; d < dim; ++d) here += slope[(i - First) * dim + d] * distance(st, n, d);
          sum[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)] += here * w;
        }
      }
    });
  }
  /// sum of q_d dN/dx_d (q[i * dim + d], by the cell), and with Hoop of q[dim * dim] N_t in component 0
  template <bool Hoop, class Columns, class Q> static void scatter_gradient(const Columns& p, const chunk_type& c, const Q& q, scatter_window<dim>& win) {
    accumulate<wants{true, false}, dim>(p, c, win, [&](const tile& t, int k, const stencil_type& st, node_sums<dim>& sum) {
      V own[dim * dim + (Hoop ? 1 : 0)];
      for (int i = 0; i < dim * dim + (Hoop ? 1 : 0); ++i) own[i] = bolide::spread<V>(q[i] + k, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        auto& to = sum[static_cast<std::size_t>(n)];
        for (int d = 0; d < dim; ++d) {
          const V w = gradient(st, d, n);
          for (int i = 0; i < dim; ++i) to[static_cast<std::size_t>(i)] += own[i * dim + d] * w;
        }
        if constexpr (Hoop) to[0] += own[dim * dim] * hoop(st, n);
      }
    });
  }
};

} // namespace bolide
