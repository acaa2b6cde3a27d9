// SPDX-License-Identifier: MIT
// What the particles of a chunk do with the nodes around them: gathers and scatters, by one of two engines.
//
// Where particles fill tiles, as a lattice does that deforms smoothly, one lane per cell is fastest (solver/by_tiles.hpp); where they do not, as in debris,
// one particle after the other with the components of a node side by side (solver/by_rows.hpp). Each range of particles has its engine
// (solver/particle_set.hpp). What particles do alone is the same loop over full registers for both.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/node_column.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/by_rows.hpp"
#include "bolide/solver/by_tiles.hpp"
#include "bolide/solver/chunk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolide {

template <class T, class Space, class Shape, class Transfer> struct kernels {
  using V = native_pack<T>;
  using tiled = by_tiles<T, Space, Shape>;
  using rowed = by_rows<T, Space, Shape>;
  using chunk_type = chunk<T, Space, Shape>;
  static constexpr int dim = Space::dim;
  template <int N> using scratch = chunk_scratch<T, N>;

  // ---- nodes of a range -------------------------------------------------------------------------------------------------------------
  /// N values of the nodes that a range reads, or that it adds to.
  template <int N> struct source {
    static constexpr int components = N;
    const T* rows;                               // of all nodes
    const typename tiled::template window<N>* window; // a copy of the touched ones, for tiles
  };
  template <int N> struct sink {
    T* rows;
    typename tiled::template scatter_window<N>* window;
  };
  /// f(source) for a range.
  template <int N, class Range, class F> static BOLIDE_INLINE void gather(const grid::node_column<T, N>& column, std::size_t field, const Range& range, F&& f) {
    typename tiled::template window<N> window;
    if (!range.tiles.empty()) tiled::template copy<N>(column, field, range, window);
    f(source<N>{column.row(field), &window});
  }
  /// f(sink) for a range; what it gives to the sink is added to the nodes.
  template <int N, class Range, class F> static BOLIDE_INLINE void scatter(grid::node_column<T, N>& column, std::size_t field, const Range& range, F&& f) {
    typename tiled::template scatter_window<N> window;
    if (!range.tiles.empty()) tiled::template clear<N>(range, window);
    f(sink<N>{column.row(field), &window});
    if (!range.tiles.empty()) tiled::template add<N>(window, column, field, range);
  }
  /// f(chunk) for the particles of a range.
  template <wants Wanted, class Set, class Range, class F> static BOLIDE_INLINE void chunks(const Set& set, const Range& range, double h, F&& f) {
    chunk_type c;
    c.inverse_h = static_cast<T>(1 / h);
    c.half_size = set.half_size;
    c.origin = range.origin;
    c.tiles = c.tiles_end = nullptr;
    const tile *next = range.tiles.data(), *const end = next + range.tiles.size();
    for (c.begin = range.begin; c.begin < range.end; c.begin += static_cast<std::size_t>(c.n)) {
      if (range.tiles.empty()) {
        c.n = static_cast<int>(std::min<std::size_t>(chunk_size, range.end - c.begin));
        rowed::template make_stencils<Wanted>(set.columns, range, c);
      } else {
        c.n = 0;
        c.tiles = next;
        do c.n += next->count;
        while (++next != end && c.n + next->count <= chunk_size - lane_width<V>); // a squeeze may write a register from the last particle on
        c.tiles_end = next;
      }
      if constexpr (Wanted.slopes) inverse_radius(set.columns, c);
      f(c);
    }
  }
  /// f(k, particle, how many) for the registers of particles of a chunk, k the first's place in it.
  template <class F> static BOLIDE_INLINE void each_register(const chunk_type& c, F&& f) {
    for (int k = 0; k < c.n; k += lane_width<V>) f(k, c.begin + static_cast<std::size_t>(k), std::min(c.n - k, lane_width<V>));
  }

  // ---- from the nodes ---------------------------------------------------------------------------------------------------------------
  /// Gradient of `first` times components 0 .. dim - 1 of the nodes plus `second` times components dim .. 2 dim - 1.
  template <int N, class Columns>
  static BOLIDE_INLINE void velocity_gradient(const Columns& p, const chunk_type& c, const source<N>& nodes, T first, T second, scratch<Space::gradient_size>& l) {
    static_assert(N == 2 * dim);
    gradient<true>(p, c, nodes, first, second, l);
  }
  /// Gradient of components 0 .. dim - 1.
  template <int N, class Columns> static BOLIDE_INLINE void velocity_gradient(const Columns& p, const chunk_type& c, const source<N>& nodes, scratch<Space::gradient_size>& l) {
    gradient<false>(p, c, nodes, T(1), T(0), l);
  }
  /// sum N b of N values b of the nodes.
  template <int N, class Columns> static BOLIDE_INLINE void mean(const Columns& p, const chunk_type& c, const source<N>& nodes, scratch<N>& to) {
    if (c.tiles) tiled::template mean<N>(p, c, *nodes.window, to);
    else rowed::template mean<N>(c, nodes.rows, to);
  }
  /// sum N |b - x|^2 over the first dim values b of the nodes, x(component) a column of the particles.
  template <int N, class Columns, class X> static BOLIDE_INLINE void mean_square(const Columns& p, const chunk_type& c, const source<N>& nodes, X&& x, T* to) {
    if (c.tiles) tiled::template mean_square<N>(p, c, *nodes.window, x, to);
    else rowed::template mean_square<N>(c, nodes.rows, x, to);
  }
  /// Moments of both velocities of the nodes relative to the particle's, b = v_I - v_p: to[0 ..] sum N b; to[2 dim] sum N |b|^2 over both; to[2 dim + 1 + c dim + d]
  /// sum N b_c dx_d.
  static constexpr int moments = 2 * dim + 1 + 2 * dim * dim;
  template <class Columns> static BOLIDE_INLINE void affine_moments(const Columns& p, const chunk_type& c, const source<2 * dim>& nodes, scratch<moments>& to, T cell) {
    if (c.tiles) tiled::template affine_moments<moments>(p, c, *nodes.window, to, cell);
    else rowed::template affine_moments<moments>(p, c, nodes.rows, to, cell);
  }

  // ---- to the nodes -----------------------------------------------------------------------------------------------------------------
  /// sum N q of N values per particle; those from First on change by slopes[(i - First) * dim + d] per cell.
  template <int N, int First, class Columns, class Slopes>
  static BOLIDE_INLINE void scatter_values(const Columns& p, const chunk_type& c, const scratch<N>& q, const Slopes& slopes, const sink<N>& to) {
    if (c.tiles) tiled::template scatter<N, First>(p, c, q, slopes, *to.window);
    else rowed::template scatter<N, First>(c, q, slopes, to.rows);
  }
  template <int N, class Columns> static BOLIDE_INLINE void scatter_values(const Columns& p, const chunk_type& c, const scratch<N>& q, const sink<N>& to) {
    scatter_values<N, N>(p, c, q, q, to);
  }
  /// sum N m (v + C (x_I - x_p)), after the sum N m where N = dim + 1.
  template <int N, class Columns> static BOLIDE_INLINE void scatter_momentum(const Columns& p, const chunk_type& c, const sink<N>& to) {
    constexpr int first = N - dim;
    scratch<N> momentum;
    [[maybe_unused]] scratch<Transfer::affine ? dim * dim : 1> slope; // m C h: change of the momentum per cell
    const T cell = T(1) / c.inverse_h;
    each_register(c, [&](int k, std::size_t at, int) {
      const V m = load<V>(p.template get<field::mass>() + at);
      if constexpr (first == 1) store(m, momentum[0] + k);
      for (int i = 0; i < dim; ++i) store(m * load<V>(p.template get<field::velocity>(i) + at), momentum[first + i] + k);
      if constexpr (Transfer::affine)
        for (int i = 0; i < dim * dim; ++i) store(m * cell * load<V>(p.template get<field::affine_velocity>(i) + at), slope[i] + k);
    });
    if constexpr (Transfer::affine) scatter_values<N, first>(p, c, momentum, slope, to);
    else scatter_values<N>(p, c, momentum, to);
  }
  /// -V (sigma grad N), in r-z with the hoop stress.
  template <class Columns> static BOLIDE_INLINE void scatter_force(const Columns& p, const chunk_type& c, const sink<dim>& to) {
    scratch<dim * dim + 1> stress; // -V sigma by the cell, and -V sigma_tt / r
    each_register(c, [&](int k, std::size_t at, int) {
      V pressure = load<V>(p.template get<field::pressure>() + at);
      if constexpr (Columns::template has<field::viscous_pressure>) pressure = pressure + load<V>(p.template get<field::viscous_pressure>() + at);
      const V minus_volume = -load<V>(p.template get<field::volume>() + at), per_cell = minus_volume * c.inverse_h;
      typename Space::template deviator<V> s{};
      if constexpr (Columns::template has<field::deviator>)
        for (int i = 0; i < Space::deviator_size; ++i) s[static_cast<std::size_t>(i)] = load<V>(p.template get<field::deviator>(i) + at);
      const auto sigma = Space::in_plane(pressure, s);
      for (int i = 0; i < dim * dim; ++i) store(per_cell * sigma[static_cast<std::size_t>(i)], stress[i] + k);
      if constexpr (Space::hoop) store(minus_volume * Space::hoop_stress(pressure, s) * load<V>(c.inverse_r + k), stress[dim * dim] + k);
    });
    if (c.tiles) tiled::template scatter_gradient<Space::hoop>(p, c, stress, *to.window);
    else rowed::template scatter_gradient<Space::hoop>(c, stress, to.rows);
  }
  /// sum V grad N: points from the particles of a body to the node.
  template <class Columns> static BOLIDE_INLINE void scatter_normal(const Columns& p, const chunk_type& c, const sink<dim>& to) {
    scratch<dim * dim> volume;
    each_register(c, [&](int k, std::size_t at, int) {
      const V per_cell = load<V>(p.template get<field::volume>() + at) * c.inverse_h;
      for (int i = 0; i < dim * dim; ++i) store(i % dim == i / dim ? per_cell : V(T(0)), volume[i] + k);
    });
    if (c.tiles) tiled::template scatter_gradient<false>(p, c, volume, *to.window);
    else rowed::template scatter_gradient<false>(c, volume, to.rows);
  }

private:
  template <bool Both, int N, class Columns>
  static BOLIDE_INLINE void gradient(const Columns& p, const chunk_type& c, const source<N>& nodes, T first, T second, scratch<Space::gradient_size>& l) {
    if (c.tiles) tiled::template velocity_gradient<Both, N>(p, c, *nodes.window, first, second, l);
    else rowed::template velocity_gradient<Both, N>(c, nodes.rows, first, second, l);
    if constexpr (Space::hoop) // so near to the axis that sum N_t v_r is round-off of its terms, v_r / r is dv_r/dr
      each_register(c, [&](int k, std::size_t, int) {
        const V too_near(c.inverse_h / std::sqrt(std::numeric_limits<T>::epsilon())), inverse = load<V>(c.inverse_r + k);
        store(select(inverse > too_near, load<V>(l[0] + k), load<V>(l[dim * dim] + k) * inverse), l[dim * dim] + k);
      });
  }
  /// At r = 0 it is finite, so that N/r of the node off the axis is.
  template <class Columns> static BOLIDE_INLINE void inverse_radius(const Columns& p, chunk_type& c) {
    if constexpr (Space::hoop)
      each_register(c, [&](int k, std::size_t at, int) { store(V(T(1)) / max(load<V>(p.template get<field::position>(0) + at), V(T(1e-30))), c.inverse_r + k); });
  }
};

} // namespace bolide
