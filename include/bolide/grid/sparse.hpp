// SPDX-License-Identifier: MIT
// Block-sparse background grid: blocks of nodes exist where material is and one block around, and nowhere else.
//
// There is no box to guess: a particle may fly as far as 2^30 cells. A block has `side`^dim nodes. Particles are kept sorted by the
// block of their cell; between two sorts they may drift by `margin` cells out of it, so that a block's particles touch nodes of
// that block and of its direct neighbours only, its `window`.
// Blocks of one colour (parity of their coordinates: 2^dim colours) touch disjoint nodes, so particles of one colour may be added
// to them by any number of threads in any order with the same bits.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/lane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bolide::grid {

template <int Dim> using cell_index = std::array<std::int32_t, static_cast<std::size_t>(Dim)>;

/// A rectangle of nodes relative to a block's first node, both ends included.
template <int Dim> struct node_range {
  std::array<int, static_cast<std::size_t>(Dim)> low, high;

  bool empty() const {
    for (std::size_t d = 0; d < Dim; ++d)
      if (low[d] > high[d]) return true;
    return false;
  }
  void merge(const node_range& o) { // the smallest rectangle around both
    for (std::size_t d = 0; d < Dim; ++d) {
      low[d] = std::min(low[d], o.low[d]);
      high[d] = std::max(high[d], o.high[d]);
    }
  }
};

/// The blocks that exist, in lexicographic order (so that every sum over nodes has a fixed order), with their neighbour tables.
template <int Dim> class block_map {
public:
  static constexpr int side = Dim == 3 ? 8 : 16;
  static constexpr int margin = 2; // cells that a particle may at least drift out of its block between two sorts (more with narrow shapes)
  static constexpr int nodes_per_block = Dim == 1 ? side : Dim == 2 ? side * side : side * side * side;
  static constexpr int neighbours = Dim == 1 ? 3 : Dim == 2 ? 9 : 27;
  static constexpr int colours = 1 << Dim;
  using index = cell_index<Dim>;

  static index block_of(const index& cell) {
    index b;
    for (std::size_t d = 0; d < Dim; ++d) b[d] = floor_div(cell[d]);
    return b;
  }
  static int colour_of(const index& block) {
    int c = 0;
    for (std::size_t d = 0; d < Dim; ++d) c = 2 * c + (block[d] & 1);
    return c;
  }

  /// Makes the occupied blocks and all their direct neighbours exist, and no other.
  void rebuild(std::vector<index> occupied) {
    std::sort(occupied.begin(), occupied.end());
    occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    blocks_.clear();
    for (const auto& b : occupied)
      for (int n = 0; n < neighbours; ++n) blocks_.push_back(shifted(b, n));
    std::sort(blocks_.begin(), blocks_.end());
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
  }

  std::size_t size() const { return blocks_.size(); }
  const index& coordinate(std::size_t block) const { return blocks_[block]; }
  /// Position of a block in the list, -1 where there is none.
  std::int32_t find(const index& block) const {
    const auto it = std::lower_bound(blocks_.begin(), blocks_.end(), block);
    return it != blocks_.end() && *it == block ? static_cast<std::int32_t>(it - blocks_.begin()) : -1;
  }
  std::array<std::int32_t, neighbours> neighbourhood(const index& block) const { return neighbourhood_in(*this, block); }
  /// Global number of a node given by its cell index, -1 where its block does not exist.
  std::int32_t node(const index& at) const { return node_in(*this, at); }

  /// Cell index of a node given by its block and its number there.
  index node_at(std::size_t block, int local) const { return node_index(coordinate(block), local); }

  static constexpr char holds_images = 2; // a block that mirror nodes couple (grid/mirror.hpp)

  static node_range<Dim> whole_block() {
    node_range<Dim> r;
    r.low.fill(0);
    r.high.fill(side - 1);
    return r;
  }
  /// f(first node of the row in the block, count) for every row of a part of a block.
  template <class F> static void for_each_row(const node_range<Dim>& part, F&& f) {
    constexpr auto last = static_cast<std::size_t>(Dim - 1);
    const int count = part.high[last] - part.low[last] + 1;
    if constexpr (Dim == 1) f(part.low[0], count);
    else if constexpr (Dim == 2)
      for (int i = part.low[0]; i <= part.high[0]; ++i) f(i * side + part.low[last], count);
    else
      for (int i = part.low[0]; i <= part.high[0]; ++i)
        for (int j = part.low[1]; j <= part.high[1]; ++j) f((i * side + j) * side + part.low[last], count);
  }

protected:
  static index node_index(index block, int local) {
    for (int d = Dim - 1; d >= 0; --d) {
      const auto k = static_cast<std::size_t>(d);
      block[k] = block[k] * side + local % side;
      local /= side;
    }
    return block;
  }
  template <class Map> static std::array<std::int32_t, neighbours> neighbourhood_in(const Map& map, const index& block) {
    std::array<std::int32_t, neighbours> n;
    for (int i = 0; i < neighbours; ++i) n[static_cast<std::size_t>(i)] = map.find(shifted(block, i));
    return n;
  }
  template <class Map> static std::int32_t node_in(const Map& map, const index& at) {
    const auto b = map.find(block_of(at));
    if (b < 0) return -1;
    std::int32_t local = 0;
    for (std::size_t d = 0; d < Dim; ++d) local = local * side + (at[d] - side * floor_div(at[d]));
    return b * nodes_per_block + local;
  }

private:
  static std::int32_t floor_div(std::int32_t i) { return i >= 0 ? i / side : -((side - 1 - i) / side); }
  static index shifted(index b, int n) { // n-th of the 3^Dim neighbours, the block itself in the middle; last axis fastest
    for (int d = Dim - 1; d >= 0; --d) {
      b[static_cast<std::size_t>(d)] += n % 3 - 1;
      n /= 3;
    }
    return b;
  }
  std::vector<index> blocks_;
};

/// The user's choice: cells of one size h (m), node (0, 0, ...) at the origin of coordinates.
struct sparse {
  double spacing;
  explicit sparse(double h) : spacing(h) { require(h > 0 && h < 1e9, "grid spacing", h, "positive and finite", "m"); }
  static constexpr const char* name = "sparse";
  template <int Dim> using map = block_map<Dim>;
  template <int Dim> block_map<Dim> make() const { return {}; }
};

/// The grid line at a position (m); throws bad_parameter where there is none.
inline std::int32_t on_grid_line(double position, double spacing, const std::string& what) {
  const double line = position / spacing;
  const auto nearest = static_cast<std::int32_t>(std::lround(line));
  require(std::abs(line - nearest) < 1e-9 * std::max(1.0, std::abs(line)), what, position,
          "on a grid line (a multiple of the grid spacing " + to_text(spacing) + " m)", "m");
  return nearest;
}

/// Places around a block, as far as its particles reach, in rows of a fixed length: the place of a node of a support relative to the first is a
/// constant.
template <int Dim> struct window {
  using map = block_map<Dim>;
  static constexpr int stride = 2 * map::side;
  static constexpr int reach = map::side / 2; // place 0 is the node at -reach on every axis
  static constexpr int size = Dim == 1 ? stride : Dim == 2 ? stride * stride : stride * stride * stride;

  static int offset(const std::array<int, static_cast<std::size_t>(Dim)>& at) {
    int o = 0;
    for (std::size_t d = 0; d < Dim; ++d) o = o * stride + (at[d] + reach);
    return o;
  }
  /// Global number of the node at every place.
  static std::vector<std::int32_t> nodes(const std::array<std::int32_t, map::neighbours>& near);
};

/// Calls f(first node in the column, its place in the window, count) for every run of nodes of `range` that is contiguous in a block.
template <int Dim, class F>
inline void for_each_run(const std::array<std::int32_t, block_map<Dim>::neighbours>& near, const node_range<Dim>& range, F&& f) {
  using map = block_map<Dim>;
  using win = window<Dim>;
  constexpr int side = map::side;
  constexpr auto last = static_cast<std::size_t>(Dim - 1);
  std::array<int, static_cast<std::size_t>(Dim)> at = range.low;
  for (;;) {
    int block = 0, local = 0; // of the row, without the last axis
    for (std::size_t d = 0; d < last; ++d) {
      block = block * 3 + (at[d] + side) / side;
      local = local * side + (at[d] + side) % side;
    }
    for (int j = range.low[last]; j <= range.high[last];) {
      const int bj = (j + side) / side, lj = (j + side) % side;
      const int run = std::min(range.high[last] - j + 1, side - lj);
      at[last] = j;
      f(near[static_cast<std::size_t>(block * 3 + bj)] * map::nodes_per_block + local * side + lj, win::offset(at), run);
      j += run;
    }
    at[last] = range.low[last];
    int d = Dim - 2;
    for (; d >= 0; --d) {
      if (++at[static_cast<std::size_t>(d)] <= range.high[static_cast<std::size_t>(d)]) break;
      at[static_cast<std::size_t>(d)] = range.low[static_cast<std::size_t>(d)];
    }
    if (d < 0) return;
  }
}

template <int Dim> std::vector<std::int32_t> window<Dim>::nodes(const std::array<std::int32_t, map::neighbours>& near) {
  std::vector<std::int32_t> node(static_cast<std::size_t>(size), -1);
  node_range<Dim> all;
  all.low.fill(-reach);
  all.high.fill(stride - reach - 1);
  for_each_run<Dim>(near, all, [&](std::int32_t first, int place, int count) {
    for (int i = 0; i < count; ++i) node[static_cast<std::size_t>(place + i)] = first + i;
  });
  return node;
}

} // namespace bolide::grid
