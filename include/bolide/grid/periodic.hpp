// SPDX-License-Identifier: MIT
// Periodic boundary between two grid lines: what leaves at one comes in at the other.
//
// Nodes one period apart are the same node: after every sum over particles both hold the sum of both. A particle that crosses a line is
// moved by a period. Momentum along the axis is kept, position is not.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/grid/sparse.hpp"

#include <cmath>
#include <string>

namespace bolide::grid {

/// The user's choice: material between `low` and `high` (m) along `axis`.
struct periodic {
  int axis = 0;
  double low = 0, high = 0;
};

/// A period on a particular grid: the node pairs that are one node. Made anew with every rebuild of the blocks.
template <int Dim> class periodic_nodes {
public:
  periodic_nodes(const periodic& p, double spacing) : axis_(static_cast<std::size_t>(p.axis)) {
    require(p.axis >= 0 && p.axis < Dim, "periodic axis", p.axis, "an axis of the space, 0 to " + std::to_string(Dim - 1));
    low_ = on_grid_line(p.low, spacing, "low end of the period");
    high_ = on_grid_line(p.high, spacing, "high end of the period");
    require(high_ - low_ >= 2 * reach + 2, "period", p.high - p.low, "at least " + std::to_string(2 * reach + 2) + " cells", "m");
  }

  template <class Map> void rebuild(const Map& map) {
    pairs_.clear();
    image_.assign(map.size() * Map::nodes_per_block, 0);
    for (std::size_t b = 0; b < map.size(); ++b)
      for (int local = 0; local < Map::nodes_per_block; ++local) {
        auto at = map.node_at(b, local);
        if (at[axis_] < low_ - reach || at[axis_] > low_ + reach) continue;
        const auto node = static_cast<std::int32_t>(b) * Map::nodes_per_block + local;
        const bool below = at[axis_] < low_;
        at[axis_] += high_ - low_;
        const auto other = map.node(at);
        if (other < 0) continue;
        pairs_.push_back({node, other});
        image_[static_cast<std::size_t>(below ? node : other)] = 1; // one of the two is counted
      }
    active_ = pairs_;
  }
  /// As mirror_nodes::spread.
  void spread(std::vector<char>& touched) {
    const auto block_of = [&](std::int32_t node) -> char& { return touched[static_cast<std::size_t>(node / block_map<Dim>::nodes_per_block)]; };
    active_.clear();
    for (const auto& pair : pairs_) {
      if (!block_of(pair.first) && !block_of(pair.second)) continue;
      block_of(pair.first) = block_of(pair.second) = block_map<Dim>::holds_images;
    }
    for (const auto& pair : pairs_)
      if (block_of(pair.first) && block_of(pair.second)) active_.push_back(pair);
  }
  /// Completes sums over particles of the node column that begins at `offset`.
  template <class Values> void complete(std::vector<Values>& sums, int, std::size_t offset = 0) const {
    for (const auto& pair : active_) {
      Values& a = sums[offset + static_cast<std::size_t>(pair.first)];
      Values& b = sums[offset + static_cast<std::size_t>(pair.second)];
      a += b;
      b = a;
    }
  }
  bool is_image(std::size_t node) const { return image_[node] != 0; }
  std::size_t axis() const { return axis_; }
  std::int32_t low() const { return low_; }   // grid lines
  std::int32_t high() const { return high_; }

private:
  static constexpr int reach = 2; // nodes deeper than this beyond a line are touched by no shape function of the library
  struct node_pair {
    std::int32_t first, second; // the second is a period further
  };
  std::size_t axis_;
  std::int32_t low_ = 0, high_ = 0;
  std::vector<node_pair> pairs_, active_;
  std::vector<char> image_;
};

} // namespace bolide::grid
