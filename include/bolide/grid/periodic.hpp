// SPDX-License-Identifier: MIT
// Periodic boundary between two grid lines: what leaves at one comes in at the other.
//
// Nodes one period apart are the same node: after every sum over particles both hold the sum of both. A particle that crosses a line is
// moved by a period. Momentum along the axis is kept, position is not.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/grid/node_pairs.hpp"
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
    pairs_.clear(map.size() * Map::nodes_per_block);
    for (std::size_t b = 0; b < map.size(); ++b)
      for (int local = 0; local < Map::nodes_per_block; ++local) {
        auto at = map.node_at(b, local);
        if (at[axis_] < low_ - reach || at[axis_] > low_ + reach) continue;
        const auto node = static_cast<std::int32_t>(b) * Map::nodes_per_block + local;
        const bool below = at[axis_] < low_;
        at[axis_] += high_ - low_;
        const auto other = map.node(at);
        if (other < 0) continue;
        pairs_.add(node, other);
        pairs_.mark_image(below ? node : other); // one of the two is counted
      }
  }
  void spread(std::vector<char>& touched) { pairs_.spread(touched); }
  /// Completes sums over particles of the node column that begins at `offset`.
  template <class Column> void complete(Column& sums, int, std::size_t offset = 0) const {
    for (int c = 0; c < Column::components; ++c)
      for (const auto& pair : pairs_.active()) {
        auto &a = sums(c, offset + static_cast<std::size_t>(pair.first)), &b = sums(c, offset + static_cast<std::size_t>(pair.second));
        a += b;
        b = a;
      }
  }
  bool is_image(std::size_t node) const { return pairs_.is_image(node); }
  std::size_t axis() const { return axis_; }
  std::int32_t low() const { return low_; }   // grid lines
  std::int32_t high() const { return high_; }

private:
  static constexpr int reach = 2; // nodes deeper than this beyond a line are touched by no shape function of the library
  std::size_t axis_;
  std::int32_t low_ = 0, high_ = 0;
  node_pairs<Dim> pairs_; // the second node is a period further
};

} // namespace bolide::grid
