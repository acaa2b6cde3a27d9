// SPDX-License-Identifier: MIT
// Uniform (dense) background grid: every block of the rectangle around the material exists, found by arithmetic instead of a search.
//
// It grows with the material at every sort, and nothing is swept where nothing is: the sweeps run over what particles touch, as on grid::sparse. What
// it costs is memory for the empty part of the rectangle, so that one particle that flies far is expensive; a rectangle of more nodes than
// `most_nodes` is refused with its size. For compact scenes, and to compare with.
#pragma once

#include "bolide/grid/sparse.hpp"

#include <limits>

namespace bolide::grid {

/// All blocks between two corners, in lexicographic order. The same members as block_map.
template <int Dim> class dense_map : public block_map<Dim> {
public:
  using base = block_map<Dim>;
  using typename base::index;
  explicit dense_map(double most_nodes = 1e8) : most_nodes_(most_nodes) {}

  void rebuild(std::vector<index> occupied) {
    low_.fill(0);
    count_.fill(0);
    total_ = 0;
    if (occupied.empty()) return;
    index low = occupied.front(), high = low;
    for (const auto& b : occupied)
      for (std::size_t d = 0; d < Dim; ++d) {
        low[d] = std::min(low[d], b[d]);
        high[d] = std::max(high[d], b[d]);
      }
    double nodes = base::nodes_per_block;
    for (std::size_t d = 0; d < Dim; ++d) nodes *= double(high[d]) - double(low[d]) + 3;
    require(nodes <= most_nodes_, "nodes of the uniform grid around all material", nodes, "at most " + to_text(most_nodes_) + "; take grid::sparse, or let far particles leave");
    total_ = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      low_[d] = low[d] - 1;
      count_[d] = high[d] - low[d] + 3;
      total_ *= static_cast<std::size_t>(count_[d]);
    }
  }

  std::size_t size() const { return total_; }
  index coordinate(std::size_t block) const {
    index at;
    for (int d = Dim - 1; d >= 0; --d) {
      const auto k = static_cast<std::size_t>(d), n = static_cast<std::size_t>(count_[k]);
      at[k] = low_[k] + static_cast<std::int32_t>(block % n);
      block /= n;
    }
    return at;
  }
  std::int32_t find(const index& block) const {
    std::int32_t at = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      if (block[d] < low_[d] || block[d] >= low_[d] + count_[d]) return -1;
      at = at * count_[d] + (block[d] - low_[d]);
    }
    return at;
  }
  index node_at(std::size_t block, int local) const { return base::node_index(coordinate(block), local); }
  std::array<std::int32_t, base::neighbours> neighbourhood(const index& block) const { return base::neighbourhood_in(*this, block); }
  std::int32_t node(const index& at) const { return base::node_in(*this, at); }

private:
  double most_nodes_;
  index low_{}, count_{};
  std::size_t total_ = 0;
};

/// The user's choice: cells of one size h (m), node (0, 0, ...) at the origin of coordinates, and the most nodes that may be made.
struct uniform {
  double spacing;
  double most_nodes;
  explicit uniform(double h, double nodes = 1e8) : spacing(h), most_nodes(nodes) {
    require(h > 0 && h < 1e9, "grid spacing", h, "positive and finite", "m");
    require(nodes >= 1 && nodes <= double(std::numeric_limits<std::int32_t>::max()), "most nodes of a uniform grid", nodes, "in [1, 2147483647]");
  }
  static constexpr const char* name = "uniform";
  template <int Dim> using map = dense_map<Dim>;
  template <int Dim> dense_map<Dim> make() const { return dense_map<Dim>(most_nodes); }
};

} // namespace bolide::grid
