// SPDX-License-Identifier: MIT
// A column of node values: the N components of a node side by side, as one row of a register's width (core/rows.hpp), so that a particle reads or
// adds to a node by one instruction, wherever the node is.
#pragma once

#include "bolide/core/rows.hpp"
#include "bolide/core/staggered.hpp"

#include <cstddef>

namespace bolide::grid {

template <class T, int N> class node_column {
public:
  using scalar = T;
  static constexpr int components = N;
  static constexpr int width = row_width(N); // numbers from one node to the next; those beyond N are of no meaning

  void resize(std::size_t nodes) {
    size_ = nodes;
    values_.resize((nodes + padding) * static_cast<std::size_t>(width));
  }
  std::size_t size() const { return size_; }
  /// The components of node i.
  T* row(std::size_t i) { return values_.data() + i * static_cast<std::size_t>(width); }
  const T* row(std::size_t i) const { return values_.data() + i * static_cast<std::size_t>(width); }
  T& operator()(int c, std::size_t i) { return row(i)[c]; }
  T operator()(int c, std::size_t i) const { return row(i)[c]; }

  /// to[c] is component c of a register of nodes from i on.
  template <class V> BOLIDE_INLINE void lanes(std::size_t i, V (&to)[width]) const { rows_to_lanes<width>(row(i), to); }
  /// The reverse, for the first n of them.
  template <class V> BOLIDE_INLINE void put_lanes(std::size_t i, V (&from)[width], int n) { lanes_to_rows<width>(from, row(i), n); }

private:
  static constexpr std::size_t padding = 16; // as many nodes as a register has lanes may be read from the last one on
  std::size_t size_ = 0;
  staggered_vector<T> values_;
};

} // namespace bolide::grid
