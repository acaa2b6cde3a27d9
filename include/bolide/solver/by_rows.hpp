// SPDX-License-Identifier: MIT
// Gathers and scatters of particles in any order: one particle after the other, the components of a node in one register.
//
// A particle reads or adds to the rows of the nodes of its support (grid/node_column.hpp), wherever they are: nothing depends on how many particles
// are in a cell. Stencils, and what particles do alone, are made in lanes; chunks go from lanes to rows and back by shuffles (core/rows.hpp).
// Sums over a support are taken axis by axis, those along the last axis first, so that the factors of an axis multiply once per row of nodes.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/core/rows.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/chunk.hpp"

namespace bolide {

template <class T, class Space, class Shape> struct by_rows {
  using V = native_pack<T>;
  using stencil_type = stencil<T, Space, Shape>;
  using chunk_type = chunk<T, Space, Shape>;
  static constexpr int dim = Space::dim, support = Shape::support;
  static constexpr bool straight = stencil_type::straight;
  template <int N> using scratch = chunk_scratch<T, N>;

  /// N numbers for every particle of a chunk, particle by particle.
  template <int N> struct rows {
    static constexpr int width = row_width(N);
    using row = pack<T, width>;
    alignas(64) T value[chunk_size * width];
    BOLIDE_INLINE row at(int k) const { return row::load(value + k * width); }
    BOLIDE_INLINE void put(int k, row x) { x.store(value + k * width); }
    /// The first N components of a register of particles.
    BOLIDE_INLINE void lanes(int k, V (&to)[width]) const { rows_to_lanes<width>(value + k * width, to); }
    /// Components component(i), i < N.
    template <class F> BOLIDE_INLINE void put_lanes(int k, F&& component) {
      V x[width];
      for (int i = 0; i < width; ++i) x[i] = V(T(0));
      for (int i = 0; i < N; ++i) x[i] = component(i);
      lanes_to_rows<width>(x, value + k * width);
    }
  };

  template <wants Wanted, class Columns, class Range> static void make_stencils(const Columns& p, const Range& range, chunk_type& c) {
    using win = grid::window<dim>;
    c.node = range.nodes.data();
    each_register(c, [&](int k) {
      V f[dim], place(T(0));
      for (int d = 0; d < dim; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        const V x = load<V>(p.template get<field::position>(d) + c.begin + static_cast<std::size_t>(k)) * c.inverse_h;
        // held among the touched nodes, so that no rounding of x / h on a cell face names a foreign node
        const V low(T(range.origin[axis] + range.touched.low[axis])), high(T(range.origin[axis] + range.touched.high[axis] - support + 1));
        const V node = clip(floor(x - T(Shape::offset)), low, high);
        f[d] = x - node;
        place = place * T(win::stride) + (node - T(range.origin[axis] - win::reach));
      }
      store_whole(place, c.first + k);
      stencil_type st;
      st.template make<Wanted>(f, c.half_size);
      for (int d = 0; d < dim; ++d)
        for (int a = 0; a < support; ++a) {
          store(st.weight[d][a], c.weight[d][a] + k);
          if constexpr (Wanted.slopes && !straight) store(st.slope[d][a], c.slope[d][a] + k);
          if constexpr (Wanted.moments) store(st.moment(d, a), c.moment[d][a] + k);
        }
      if constexpr (Wanted.slopes && Space::hoop && !straight)
        for (int a = 0; a < support; ++a) store(st.hoop_weight[a], c.hoop_weight[a] + k);
    });
  }
  template <class F> static BOLIDE_INLINE void each_register(const chunk_type& c, F&& f) {
    for (int k = 0; k < c.n; k += lane_width<V>) f(k);
  }
  /// f(k, first node of its support in the window) for the particles of a chunk.
  template <class F> static BOLIDE_INLINE void each_particle(const chunk_type& c, F&& f) {
    const std::int32_t *const node = c.node, n = c.n;
    for (std::int32_t k = 0; k < n; ++k) f(k, node + c.first[k]);
  }

  // ---- sums over the support of a particle ----------------------------------------------------------------------------------------
  /// Places in the window from one node to the next along an axis.
  static constexpr int pitch(int axis) {
    int p = 1;
    for (int d = dim - 1; d > axis; --d) p *= grid::window<dim>::stride;
    return p;
  }
  /// sum N b with b = value(node). Values are weighted one by one: on a face the far node of linear shapes has a weight of a few epsilons and a velocity change
  /// so many times larger, and b_0 + N_1 (b_1 - b_0) would lose what cancels it.
  template <int Axis, class F> static BOLIDE_INLINE auto mean_over(const chunk_type& c, int k, const std::int32_t* node, F&& value) {
    const auto b = [&](int a) __attribute__((always_inline)) {
      if constexpr (Axis == dim - 1) return value(node[a]);
      else return mean_over<Axis + 1>(c, k, node + a * pitch(Axis), value);
    };
    auto sum = b(0) * c.weight[Axis][0][k];
#pragma GCC unroll 4
    for (int a = 1; a < support; ++a) sum += b(a) * c.weight[Axis][a][k];
    return sum;
  }
  /// What takes the place of N along one axis: its slope (1/cell), or its moment N (x_n - x_p) (cells).
  struct by_slope {
    template <class Row> static BOLIDE_INLINE Row times(const chunk_type& c, int k, int axis, int a, const Row& b) {
      if constexpr (straight) return a == 0 ? -b : b;
      else return b * c.slope[axis][a][k];
    }
  };
  struct by_moment {
    template <class Row> static BOLIDE_INLINE Row times(const chunk_type& c, int k, int axis, int a, const Row& b) { return b * c.moment[axis][a][k]; }
  };
  /// sum N b, for every axis from Axis on the sum with the factor's along it, and the one with N_t along the first.
  template <class Row, int Axes> struct value_and_slopes {
    Row value, along[Axes], hoop;
  };
  template <class Factor, int Axis, class F> static BOLIDE_INLINE auto slopes_over(const chunk_type& c, int k, const std::int32_t* node, F&& value) {
    using Row = decltype(value(node[0]));
    constexpr int axes = dim - Axis;
    constexpr bool hoop = Space::hoop && Axis == 0 && !straight;
    value_and_slopes<Row, axes> sum;
#pragma GCC unroll 4
    for (int a = 0; a < support; ++a) {
      const T weight = c.weight[Axis][a][k];
      value_and_slopes<Row, (axes > 1 ? axes - 1 : 1)> b;
      if constexpr (Axis == dim - 1) b.value = value(node[a]);
      else b = slopes_over<Factor, Axis + 1>(c, k, node + a * pitch(Axis), value);
      sum.value = a == 0 ? b.value * weight : sum.value + b.value * weight;
      const Row slope = Factor::times(c, k, Axis, a, b.value);
      sum.along[0] = a == 0 ? slope : sum.along[0] + slope;
      for (int d = 1; d < axes; ++d) sum.along[d] = a == 0 ? b.along[d - 1] * weight : sum.along[d] + b.along[d - 1] * weight;
      if constexpr (hoop) sum.hoop = a == 0 ? b.value * c.hoop_weight[a][k] : sum.hoop + b.value * c.hoop_weight[a][k];
    }
    if constexpr (!hoop) sum.hoop = sum.value;
    return sum;
  }
  /// The reverse of mean_over: add(node, N value).
  template <int Axis, class Row, class Add> static BOLIDE_INLINE void spread_value(const chunk_type& c, int k, const std::int32_t* node, const Row& value, Add&& add) {
#pragma GCC unroll 4
    for (int a = 0; a < support; ++a) {
      const Row b = value * c.weight[Axis][a][k];
      if constexpr (Axis == dim - 1) add(node[a], b);
      else spread_value<Axis + 1>(c, k, node + a * pitch(Axis), b, add);
    }
  }
  /// What of a spread is constant along the first axis.
  enum class base { none, by_weight, by_hoop_weight };
  /// The reverse of slopes_over: add(node, N value + sum over the axes of the factor's along).
  template <class Factor, int Axis, base Base, class Row, class Add>
  static BOLIDE_INLINE void spread_slopes(const chunk_type& c, int k, const std::int32_t* node, const Row& value, const Row* along, Add&& add) {
    constexpr int axes = dim - Axis;
#pragma GCC unroll 4
    for (int a = 0; a < support; ++a) {
      const T weight = c.weight[Axis][a][k];
      Row b = Factor::times(c, k, Axis, a, along[0]);
      if constexpr (Base == base::by_weight || (Base == base::by_hoop_weight && straight)) b += value * weight;
      else if constexpr (Base == base::by_hoop_weight) b += value * c.hoop_weight[a][k];
      if constexpr (Axis == dim - 1) add(node[a], b);
      else {
        Row rest[axes > 1 ? axes - 1 : 1];
        for (int d = 1; d < axes; ++d) rest[d - 1] = along[d] * weight;
        spread_slopes<Factor, Axis + 1, base::by_weight>(c, k, node + a * pitch(Axis), b, rest, add);
      }
    }
  }
  template <int N> static BOLIDE_INLINE auto adder(T* column) {
    return [column](std::int32_t node, const typename rows<N>::row& b) __attribute__((always_inline)) {
      T* const to = column + static_cast<std::ptrdiff_t>(node) * rows<N>::width;
      (rows<N>::row::load(to) + b).store(to);
    };
  }
  /// The first M of N components.
  template <int N, int M = N> static BOLIDE_INLINE auto reader(const T* column) {
    return [column](std::int32_t node) __attribute__((always_inline)) { return rows<M>::row::load(column + static_cast<std::ptrdiff_t>(node) * rows<N>::width); };
  }

  // ---- from the nodes ---------------------------------------------------------------------------------------------------------------
  template <bool Both, int N> static void velocity_gradient(const chunk_type& c, const T* column, T first, T second, scratch<Space::gradient_size>& l) {
    constexpr int M = Both ? N : dim;
    rows<M> along[dim];
    rows<Space::hoop ? M : 1> hoop;
    each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) {
      const auto g = slopes_over<by_slope, 0>(c, k, node, reader<N, M>(column));
      for (int d = 0; d < dim; ++d) along[d].put(k, g.along[d]);
      if constexpr (Space::hoop) hoop.put(k, g.hoop);
    });
    const auto combined = [&](const V* b, int i) __attribute__((always_inline)) {
      if constexpr (Both) return first * b[i] + second * b[dim + i];
      else return b[i];
    };
    each_register(c, [&](int k) __attribute__((always_inline)) {
      V b[rows<M>::width];
      for (int d = 0; d < dim; ++d) {
        along[d].lanes(k, b);
        for (int i = 0; i < dim; ++i) store(combined(b, i) * c.inverse_h, l[i * dim + d] + k);
      }
      if constexpr (Space::hoop) {
        hoop.lanes(k, b);
        store(combined(b, 0), l[dim * dim] + k);
      }
    });
  }
  template <int N> static void mean(const chunk_type& c, const T* column, scratch<N>& to) {
    rows<N> sum;
    each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) { sum.put(k, mean_over<0>(c, k, node, reader<N>(column))); });
    to_scratch<N>(c, sum, [&](int i) { return to[i]; });
  }
  template <int N, class X> static void mean_square(const chunk_type& c, const T* column, X&& x, T* to) {
    rows<N> own, sum;
    each_register(c, [&](int k) { own.put_lanes(k, [&](int i) { return i < dim ? load<V>(x(i) + c.begin + static_cast<std::size_t>(k)) : V(T(0)); }); });
    each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) {
      const auto b = own.at(k);
      sum.put(k, mean_over<0>(c, k, node, [&](std::int32_t i) __attribute__((always_inline)) { return square(reader<N>(column)(i) - b); }));
    });
    each_register(c, [&](int k) {
      V b[rows<N>::width];
      sum.lanes(k, b);
      for (int d = 1; d < dim; ++d) b[0] += b[d];
      store(b[0], to + k);
    });
  }
  template <int Moments, class Columns> static void affine_moments(const Columns& p, const chunk_type& c, const T* column, scratch<Moments>& to, T cell) {
    constexpr int N = 2 * dim;
    rows<N> own, sum, squares, along[dim];
    each_register(c, [&](int k) { own.put_lanes(k, [&](int i) { return load<V>(p.template get<field::velocity>(i % dim) + c.begin + static_cast<std::size_t>(k)); }); });
    each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) {
      const auto v = own.at(k);
      const auto relative = [&](std::int32_t i) __attribute__((always_inline)) { return reader<N>(column)(i) - v; };
      const auto s = slopes_over<by_moment, 0>(c, k, node, relative);
      sum.put(k, s.value);
      for (int d = 0; d < dim; ++d) along[d].put(k, s.along[d]);
      squares.put(k, mean_over<0>(c, k, node, [&](std::int32_t i) __attribute__((always_inline)) { return square(relative(i)); }));
    });
    to_scratch<N>(c, sum, [&](int i) { return to[i]; });
    each_register(c, [&](int k) {
      V b[rows<N>::width];
      squares.lanes(k, b);
      for (int i = 1; i < N; ++i) b[0] += b[i];
      store(b[0], to[N] + k);
      for (int d = 0; d < dim; ++d) {
        along[d].lanes(k, b);
        for (int i = 0; i < N; ++i) store(b[i] * cell, to[N + 1 + i * dim + d] + k);
      }
    });
  }

  // ---- to the nodes -----------------------------------------------------------------------------------------------------------------
  template <int N, int First, class Slopes> static void scatter(const chunk_type& c, const scratch<N>& q, const Slopes& slopes, T* column) {
    rows<N> value;
    each_register(c, [&](int k) { value.put_lanes(k, [&](int i) { return load<V>(q[i] + k); }); });
    const auto add = adder<N>(column);
    if constexpr (First == N) each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) { spread_value<0>(c, k, node, value.at(k), add); });
    else {
      rows<N> slope[dim];
      each_register(c, [&](int k) {
        for (int d = 0; d < dim; ++d) slope[d].put_lanes(k, [&](int i) { return i >= First ? load<V>(slopes[(i - First) * dim + d] + k) : V(T(0)); });
      });
      each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) {
        typename rows<N>::row along[dim];
        for (int d = 0; d < dim; ++d) along[d] = slope[d].at(k);
        spread_slopes<by_moment, 0, base::by_weight>(c, k, node, value.at(k), along, add);
      });
    }
  }
  template <bool Hoop, class Q> static void scatter_gradient(const chunk_type& c, const Q& q, T* column) {
    rows<dim> slope[dim], hoop;
    each_register(c, [&](int k) {
      for (int d = 0; d < dim; ++d) slope[d].put_lanes(k, [&](int i) { return load<V>(q[i * dim + d] + k); });
      if constexpr (Hoop) hoop.put_lanes(k, [&](int i) { return i == 0 ? load<V>(q[dim * dim] + k) : V(T(0)); });
    });
    const auto add = adder<dim>(column);
    each_particle(c, [&](int k, const std::int32_t* node) __attribute__((always_inline)) {
      typename rows<dim>::row along[dim], around(T(0));
      for (int d = 0; d < dim; ++d) along[d] = slope[d].at(k);
      if constexpr (Hoop) around = hoop.at(k);
      spread_slopes<by_slope, 0, Hoop ? base::by_hoop_weight : base::none>(c, k, node, around, along, add);
    });
  }

private:
  template <int N, class To> static BOLIDE_INLINE void to_scratch(const chunk_type& c, const rows<N>& from, To&& to) {
    each_register(c, [&](int k) __attribute__((always_inline)) {
      V b[rows<N>::width];
      from.lanes(k, b);
      for (int i = 0; i < N; ++i) store(b[i], to(i) + k);
    });
  }
};

} // namespace bolide
