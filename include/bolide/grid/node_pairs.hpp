// SPDX-License-Identifier: MIT
// Pairs of nodes that a boundary couples (grid/mirror.hpp, grid/periodic.hpp): one of the two is a copy, and in a step only those count whose
// blocks particles touch.
#pragma once

#include "bolide/grid/sparse.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide::grid {

template <int Dim> class node_pairs {
public:
  struct pair {
    std::int32_t first, second;
  };
  /// Begins anew, on a grid of this many nodes.
  void clear(std::size_t nodes) {
    all_.clear();
    active_.clear();
    image_.assign(nodes, 0);
  }
  void add(std::int32_t first, std::int32_t second) {
    all_.push_back({first, second});
    active_.push_back({first, second});
  }
  /// A copy that must not be counted in sums over nodes.
  void mark_image(std::int32_t node) { image_[static_cast<std::size_t>(node)] = 1; }
  bool is_image(std::size_t node) const { return image_[node] != 0; }

  /// A block whose partner is touched is touched, and marked as holding images. From now to the next clear() only such pairs are active.
  void spread(std::vector<char>& touched) {
    const auto block_of = [&](std::int32_t node) -> char& { return touched[static_cast<std::size_t>(node / block_map<Dim>::nodes_per_block)]; };
    active_.clear();
    for (const auto& p : all_) {
      if (!block_of(p.first) && !block_of(p.second)) continue;
      block_of(p.first) = block_of(p.second) = block_map<Dim>::holds_images;
    }
    for (const auto& p : all_)
      if (block_of(p.first) && block_of(p.second)) active_.push_back(p);
  }
  const std::vector<pair>& active() const { return active_; }

private:
  std::vector<pair> all_, active_;
  std::vector<char> image_;
};

} // namespace bolide::grid
