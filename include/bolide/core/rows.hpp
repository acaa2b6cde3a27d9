// SPDX-License-Identifier: MIT
// Rows and lanes: what belongs to one thing (a node, a particle) side by side in memory, or one number of many things in a register.
//
// W rows of R numbers in memory are R registers of W lanes after log2 R rounds of pairwise shuffles, and the other way round.
#pragma once

#include "bolide/core/lane.hpp"

#include <bit>
#include <utility>

namespace bolide {

/// Numbers that a row of n has: a power of two, so that it is one register.
constexpr int row_width(int n) { return n <= 2 ? 2 : static_cast<int>(std::bit_ceil(static_cast<unsigned>(n))); }

namespace detail {
/// Every second number of a and b from `From` on.
template <int From, class T, int W> BOLIDE_INLINE pack<T, W> every_second(pack<T, W> a, pack<T, W> b) {
  return [&]<int... I>(std::integer_sequence<int, I...>) { return pack<T, W>(__builtin_shufflevector(a.v, b.v, (2 * I + From)...)); }(std::make_integer_sequence<int, W>{});
}
/// Numbers of a and b in turn, of their first halves (From = 0) or second (From = W/2).
template <int From, class T, int W> BOLIDE_INLINE pack<T, W> in_turn(pack<T, W> a, pack<T, W> b) {
  return [&]<int... I>(std::integer_sequence<int, I...>) { return pack<T, W>(__builtin_shufflevector(a.v, b.v, (I / 2 + From + (I % 2) * W)...)); }(std::make_integer_sequence<int, W>{});
}
} // namespace detail

/// lanes[c][k] is number c of row k, for the W rows of R numbers that begin at `rows`.
template <int R, class V> BOLIDE_INLINE void rows_to_lanes(const scalar_t<V>* rows, V (&lanes)[R]) {
  static_assert((R & (R - 1)) == 0);
  for (int c = 0; c < R; ++c) lanes[c] = load<V>(rows + c * lane_width<V>);
#pragma GCC unroll 4
  for (int round = 1; round < R; round *= 2) {
    V next[R];
    for (int j = 0; j < R / 2; ++j) {
      next[j] = detail::every_second<0>(lanes[2 * j], lanes[2 * j + 1]);
      next[R / 2 + j] = detail::every_second<1>(lanes[2 * j], lanes[2 * j + 1]);
    }
    for (int c = 0; c < R; ++c) lanes[c] = next[c];
  }
}
/// The reverse, for the first n rows. `lanes` are shuffled.
template <int R, class V> BOLIDE_INLINE void lanes_to_rows(V (&lanes)[R], scalar_t<V>* rows, int n = lane_width<V>) {
  static_assert((R & (R - 1)) == 0);
#pragma GCC unroll 4
  for (int round = 1; round < R; round *= 2) {
    V next[R];
    for (int j = 0; j < R / 2; ++j) {
      next[2 * j] = detail::in_turn<0>(lanes[j], lanes[R / 2 + j]);
      next[2 * j + 1] = detail::in_turn<lane_width<V> / 2>(lanes[j], lanes[R / 2 + j]);
    }
    for (int c = 0; c < R; ++c) lanes[c] = next[c];
  }
  for (int c = 0; c < R && c * lane_width<V> < n * R; ++c) store_first(lanes[c], rows + c * lane_width<V>, n * R - c * lane_width<V>);
}

} // namespace bolide
