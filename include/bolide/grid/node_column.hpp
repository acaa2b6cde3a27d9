// SPDX-License-Identifier: MIT
// A column of node values: N components per node, each component contiguous over the nodes, so that the nodes of neighbouring cells fill a
// register by one load.
#pragma once

#include "bolide/core/staggered.hpp"

#include <array>
#include <cstddef>

namespace bolide::grid {

template <class T, int N> class node_column {
public:
  using scalar = T;
  static constexpr int components = N;

  void resize(std::size_t nodes) {
    size_ = nodes;
    for (auto& c : component_) c.resize(nodes + padding);
  }
  std::size_t size() const { return size_; }
  /// Component c of all nodes.
  T* operator[](int c) { return component_[static_cast<std::size_t>(c)].data(); }
  const T* operator[](int c) const { return component_[static_cast<std::size_t>(c)].data(); }

private:
  static constexpr std::size_t padding = 16; // a register may be read from the last node on
  std::size_t size_ = 0;
  std::array<staggered_vector<T>, static_cast<std::size_t>(N)> component_ = staggered_vectors<T, static_cast<std::size_t>(N)>();
};

} // namespace bolide::grid
