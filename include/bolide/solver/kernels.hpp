// SPDX-License-Identifier: MIT
// What the particles of a chunk do with the nodes of their window: gathers and scatters, tile by tile (solver/tiles.hpp).
//
// A gather reads the nodes of the support of all lanes by plain loads, one per node and component, and leaves its sums densely in the scratch of the
// chunk; what particles do with them is then a plain loop over full registers. A scatter goes the other way: it reads scratch or columns into
// lanes, sums over the tiles of the same cells in registers and adds to the window once for all of them. Nodes of different place in a support
// add to different copies of the window, so that no load waits for a store to a shifted place.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/node_column.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/material/report.hpp"
#include "bolide/solver/stencil.hpp"
#include "bolide/solver/tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace bolide {

/// Tiles of consecutive particles that go through a sweep together, few enough for the scratch of a chunk.
template <class T, int Dim> struct tile_chunk {
  std::size_t begin; // first particle
  int n;             // particles
  const tile *first, *last;
  const grid::cell_index<Dim>& origin;
  T half_size, inverse_h;
};

/// N numbers for every particle of a chunk. A squeeze may write a register past the last one.
template <class T, int N> struct chunk_scratch {
  alignas(64) T value[N][chunk_size];
  T* operator[](int c) { return value[c]; }
  const T* operator[](int c) const { return value[c]; }
};

template <class T, class Space, class Shape, class Transfer> struct kernels {
  using V = native_pack<T>;
  using stencil_type = stencil<T, Space, Shape>;
  using chunk = tile_chunk<T, Space::dim>;
  static constexpr int dim = Space::dim, nodes = stencil_type::nodes;
  static constexpr int chunk_particles = chunk_size - lane_width<V>;
  template <int N> using scratch = chunk_scratch<T, N>;
  template <int N> using gather_window = grid::window<dim, T, N>;
  template <int N> using scatter_window = grid::window<dim, T, N * Shape::support>;
  template <int N> using node_sums = std::array<std::array<V, static_cast<std::size_t>(N)>, static_cast<std::size_t>(nodes)>;

  // ---- windows ----------------------------------------------------------------------------------------------------------------
  /// Runs f on a window that holds a copy of the touched nodes.
  template <int N, class Range, class F> static BOLIDE_INLINE void gather(const grid::node_column<T, N>& column, std::size_t field, const Range& range, F&& f) {
    gather_window<N> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int c = 0; c < N; ++c) { // whole registers: what is too much is written again by the next run, or never read
        const T* const from = column[c] + field + static_cast<std::size_t>(node);
        for (int i = 0; i < count; i += lane_width<V>) store(load<V>(from + i), win[c] + at + i);
      }
    });
    f(win);
  }
  /// Runs f on a zeroed window and adds it to the touched nodes.
  template <int N, class Range, class F> static BOLIDE_INLINE void scatter(grid::node_column<T, N>& column, std::size_t field, const Range& range, F&& f) {
    scatter_window<N> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t, int at, int count) {
      for (int c = 0; c < N * Shape::support; ++c)
        for (int i = 0; i < count; i += lane_width<V>) store(V(T(0)), win[c] + at + i);
    });
    f(win);
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int c = 0; c < N; ++c) {
        T* const to = column[c] + field + static_cast<std::size_t>(node);
        for (int i = 0; i < count; i += lane_width<V>) {
          V sum = load<V>(win[c] + at + i);
          for (int copy = 1; copy < Shape::support; ++copy) sum += load<V>(win[copy * N + c] + at + i);
          store_first(load<V>(to + i) + sum, to + i, count - i);
        }
      }
    });
  }
  /// f(chunk) for the particles of a range.
  template <class Set, class Range, class F> static BOLIDE_INLINE void chunks(const Set& set, const Range& range, double h, F&& f) {
    const tile* const end = range.tiles.data() + range.tiles.size();
    for (const tile* t = range.tiles.data(); t != end;) {
      chunk c{t->begin, 0, t, t, range.origin, set.half_size, static_cast<T>(1 / h)};
      do c.n += t->count;
      while (++t != end && c.n + t->count <= chunk_particles);
      c.last = t;
      f(c);
    }
  }

  /// 1/r of the particles of a chunk. At r = 0 it is finite, so that N/r of the node off the axis is.
  template <class Columns> static BOLIDE_INLINE void inverse_radius(const Columns& p, const chunk& c, T* to) {
    if constexpr (Space::hoop)
      for (int k = 0; k < c.n; k += lane_width<V>)
        store(V(T(1)) / max(load<V>(p.template get<field::position>(0) + c.begin + static_cast<std::size_t>(k)), V(T(1e-30))), to + k);
  }

  // ---- from the nodes -----------------------------------------------------------------------------------------------------------
  /// f(tile, its place in the scratch, stencil) for every tile.
  template <wants Wanted, class Columns, class F> static BOLIDE_INLINE void each_tile(const Columns& p, const chunk& c, F&& f) {
    for (const tile* t = c.first; t != c.last; ++t) {
      stencil_type st;
      st.template make<Wanted>(p, *t, c.origin, c.inverse_h, c.half_size);
      f(*t, static_cast<int>(t->begin - c.begin), st);
    }
  }
  /// The components of the node values that the lanes of a tile see at node n of their supports.
  template <int N> static BOLIDE_INLINE V at_node(const gather_window<N>& win, int component, const tile& t, int n) {
    return load<V>(win[component] + t.base + stencil_type::offset(n));
  }

  /// Gradient of a velocity u, given as u(component, tile, node).
  template <class Columns, class U>
  static BOLIDE_INLINE void velocity_gradient(const Columns& p, const chunk& c, const T* inverse_r, scratch<Space::gradient_size>& l, U&& u) {
    each_tile<wants::gradients>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V g[dim * dim], hoop(T(0));
      for (auto& x : g) x = V(T(0));
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        V v[dim];
        for (int i = 0; i < dim; ++i) v[i] = u(i, t, n);
        for (int d = 0; d < dim; ++d) {
          const V w = st.gradient(d, n);
          for (int i = 0; i < dim; ++i) g[i * dim + d] += v[i] * w;
        }
        if constexpr (Space::hoop) hoop += v[0] * st.hoop(n);
      }
      for (int i = 0; i < dim * dim; ++i) squeeze(g[i], t.lanes, l[i] + k);
      if constexpr (Space::hoop) squeeze(hoop, t.lanes, l[dim * dim] + k);
    });
    if constexpr (Space::hoop) { // so near to the axis that sum N_t v_r is round-off of its terms, v_r / r is dv_r/dr
      const V too_near(c.inverse_h / std::sqrt(std::numeric_limits<T>::epsilon()));
      for (int k = 0; k < c.n; k += lane_width<V>) {
        const V inverse = load<V>(inverse_r + k);
        store(select(inverse > too_near, load<V>(l[0] + k), load<V>(l[dim * dim] + k) * inverse), l[dim * dim] + k);
      }
    }
  }

  /// sum N b of N values b of the nodes.
  template <int N, class Columns> static BOLIDE_INLINE void mean(const Columns& p, const chunk& c, const gather_window<N>& win, scratch<N>& to) {
    each_tile<wants::values>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V sum[N];
      for (auto& x : sum) x = V(T(0));
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = st.value(n);
        for (int i = 0; i < N; ++i) sum[i] += at_node<N>(win, i, t, n) * w;
      }
      for (int i = 0; i < N; ++i) squeeze(sum[i], t.lanes, to[i] + k);
    });
  }
  /// sum N |b - x|^2 over the first dim values b of the nodes, x(component) a value of the particles.
  template <int N, class Columns, class X> static BOLIDE_INLINE void mean_square(const Columns& p, const chunk& c, const gather_window<N>& win, X&& x, T* to) {
    each_tile<wants::values>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V sum(T(0)), own[dim];
      for (int d = 0; d < dim; ++d) own[d] = spread<V>(x(d) + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        V squares(T(0));
        for (int d = 0; d < dim; ++d) squares += square(at_node<N>(win, d, t, n) - own[d]);
        sum += squares * st.value(n);
      }
      squeeze(sum, t.lanes, to + k);
    });
  }
  /// Moments of both velocities of the nodes relative to the particle's, b = v_I - v_p: to[0 ..] sum N b; to[2 dim] sum N |b|^2 over both; to[2 dim + 1 + c dim + d]
  /// sum N b_c dx_d.
  static constexpr int moments = 2 * dim + 1 + 2 * dim * dim;
  template <class Columns> static BOLIDE_INLINE void affine_moments(const Columns& p, const chunk& c, const gather_window<2 * dim>& win, scratch<moments>& to, T cell) {
    each_tile<wants::values>(p, c, [&](const tile& t, int k, const stencil_type& st) {
      V own[dim], sum[moments];
      for (auto& x : sum) x = V(T(0));
      for (int d = 0; d < dim; ++d) own[d] = spread<V>(p.template get<field::velocity>(d) + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = st.value(n);
        V dx[dim];
        for (int d = 0; d < dim; ++d) dx[d] = st.distance(n, d) * cell;
        for (int i = 0; i < 2 * dim; ++i) {
          const V b = at_node<2 * dim>(win, i, t, n) - own[i % dim], weighted = b * w;
          sum[i] += weighted;
          sum[2 * dim] += weighted * b;
          for (int d = 0; d < dim; ++d) sum[2 * dim + 1 + i * dim + d] += weighted * dx[d];
        }
      }
      for (int i = 0; i < moments; ++i) squeeze(sum[i], t.lanes, to[i] + k);
    });
  }

  // ---- to the nodes -------------------------------------------------------------------------------------------------------------
  /// add(tile, its place in the scratch, stencil, sum) adds what the lanes of a tile give to the nodes of their supports, N values each.
  template <wants Wanted, int N, class Columns, class F>
  static BOLIDE_INLINE void accumulate(const Columns& p, const chunk& c, scatter_window<N>& win, F&& add) {
    for (const tile* t = c.first; t != c.last;) {
      const std::int32_t base = t->base;
      alignas(64) node_sums<N> sum;
      for (auto& node : sum)
        for (auto& x : node) x = V(T(0));
      do {
        stencil_type st;
        st.template make<Wanted>(p, *t, c.origin, c.inverse_h, c.half_size);
        add(*t, static_cast<int>(t->begin - c.begin), st, sum);
      } while (++t != c.last && t->base == base);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n)
        for (int i = 0; i < N; ++i) {
          T* const to = win[stencil_type::along(n, dim - 1) * N + i] + base + stencil_type::offset(n);
          store(load<V>(to) + sum[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)], to);
        }
    }
  }
  /// sum N q of N values per particle, q(component) an array that begins at the first particle of the chunk.
  template <int N, class Columns, class Q> static BOLIDE_INLINE void scatter_values(const Columns& p, const chunk& c, scatter_window<N>& win, Q&& q) {
    accumulate<wants::values, N>(p, c, win, [&](const tile& t, int k, const stencil_type& st, node_sums<N>& sum) {
      V own[N];
      for (int i = 0; i < N; ++i) own[i] = spread<V>(q(i) + k, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = st.value(n);
        for (int i = 0; i < N; ++i) sum[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)] += own[i] * w;
      }
    });
  }
  /// sum N m (v + C (x_I - x_p)), after the sum N m where N = dim + 1.
  template <int N, class Columns> static BOLIDE_INLINE void scatter_momentum(const Columns& p, const chunk& c, scatter_window<N>& win) {
    constexpr int first = N - dim;
    const T cell = T(1) / c.inverse_h;
    accumulate<wants::values, N>(p, c, win, [&](const tile& t, int, const stencil_type& st, node_sums<N>& sum) {
      const V m = spread<V>(p.template get<field::mass>() + t.begin, t.lanes);
      V momentum[dim];
      for (int d = 0; d < dim; ++d) momentum[d] = m * spread<V>(p.template get<field::velocity>(d) + t.begin, t.lanes);
      [[maybe_unused]] V slope[dim * dim]; // m C h: change of the momentum per cell
      if constexpr (Transfer::affine)
        for (int i = 0; i < dim * dim; ++i) slope[i] = m * cell * spread<V>(p.template get<field::affine_velocity>(i) + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        const V w = st.value(n);
        auto& to = sum[static_cast<std::size_t>(n)];
        if constexpr (first == 1) to[0] += m * w;
        for (int i = 0; i < dim; ++i) {
          V here = momentum[i];
          if constexpr (Transfer::affine)
            for (int d = 0; d < dim; ++d) here += slope[i * dim + d] * st.distance(n, d);
          to[static_cast<std::size_t>(first + i)] += here * w;
        }
      }
    });
  }
  /// -V (sigma grad N), in r-z with the hoop stress.
  template <class Set> static BOLIDE_INLINE void scatter_force(const Set& set, const chunk& c, const T* inverse_r, scatter_window<dim>& win) {
    using columns = std::remove_cvref_t<decltype(set.columns)>;
    const auto& p = set.columns;
    scratch<dim * dim + 1> stress; // -V sigma, and -V sigma_tt / r
    for (int k = 0; k < c.n; k += lane_width<V>) {
      const std::size_t at = c.begin + static_cast<std::size_t>(k);
      V pressure = load<V>(p.template get<field::pressure>() + at);
      if constexpr (columns::template has<field::viscous_pressure>) pressure = pressure + load<V>(p.template get<field::viscous_pressure>() + at);
      const V minus_volume = -load<V>(p.template get<field::volume>() + at);
      typename Space::template deviator<V> s{};
      if constexpr (columns::template has<field::deviator>)
        for (int i = 0; i < Space::deviator_size; ++i) s[static_cast<std::size_t>(i)] = load<V>(p.template get<field::deviator>(i) + at);
      const auto sigma = Space::in_plane(pressure, s);
      for (int i = 0; i < dim * dim; ++i) store(minus_volume * sigma[static_cast<std::size_t>(i)], stress[i] + k);
      if constexpr (Space::hoop) store(minus_volume * Space::hoop_stress(pressure, s) * load<V>(inverse_r + k), stress[dim * dim] + k);
    }
    accumulate<wants::gradients, dim>(p, c, win, [&](const tile& t, int k, const stencil_type& st, node_sums<dim>& sum) {
      V own[dim * dim + 1];
      for (int i = 0; i < dim * dim + (Space::hoop ? 1 : 0); ++i) own[i] = spread<V>(stress[i] + k, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n) {
        auto& to = sum[static_cast<std::size_t>(n)];
        for (int d = 0; d < dim; ++d) {
          const V w = st.gradient(d, n);
          for (int i = 0; i < dim; ++i) to[static_cast<std::size_t>(i)] += own[i * dim + d] * w;
        }
        if constexpr (Space::hoop) to[0] += own[dim * dim] * st.hoop(n);
      }
    });
  }
  /// sum V grad N: points from the particles of a body to the node.
  template <class Columns> static BOLIDE_INLINE void scatter_normal(const Columns& p, const chunk& c, scatter_window<dim>& win) {
    accumulate<wants::gradients, dim>(p, c, win, [&](const tile& t, int, const stencil_type& st, node_sums<dim>& sum) {
      const V volume = spread<V>(p.template get<field::volume>() + t.begin, t.lanes);
#pragma GCC unroll 64
      for (int n = 0; n < nodes; ++n)
        for (int d = 0; d < dim; ++d) sum[static_cast<std::size_t>(n)][static_cast<std::size_t>(d)] += volume * st.gradient(d, n);
    });
  }
};

} // namespace bolide
