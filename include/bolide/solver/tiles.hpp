// SPDX-License-Identifier: MIT
// Tiles: how particles are put into SIMD lanes so that what they share with the grid needs no gather and no conflict is possible (solver/by_tiles.hpp).
//
// Lane l of a tile is the l-th of W neighbouring cells of a row (along the last axis), and holds at most one particle of that cell. Node values of
// all lanes are then W consecutive entries of a window, and two lanes never add to the same node at once (docs/performance.md).
// Storage stays dense: the particles of a tile follow each other in the columns in the order of their lanes, and `lanes` says which lanes are
// there (core/lane.hpp: spread, squeeze). Tiles are found anew after every motion from the order that the particles happen to have; particles
// that fly side by side change cells side by side and keep their tiles. Where the order has decayed, the range is arranged anew.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide {

struct tile {
  std::uint32_t begin; // first particle
  std::int32_t base;   // offset in the window of the first node of lane 0
  std::uint32_t lanes; // bit l: a particle in lane l
  std::int32_t count;  // of particles
};

/// Puts tiles over particles that come by the window offsets of their first nodes.
template <int Lanes, int Stride> class tile_layer {
public:
  explicit tile_layer(std::vector<tile>& tiles) : tiles_(tiles) { tiles_.clear(); }
  /// n particles from `begin` on; what follows the last of `first` may be read.
  void add(std::uint32_t begin, int n, const std::int32_t* first) {
    tile t = open_; // in registers
    std::int32_t last = last_;
    for (int k = 0; k < n;) {
      const std::int32_t node = first[k], lane = node - t.base;
      if (lane > last && lane < Lanes && node / Stride == t.base / Stride) {
        t.lanes |= 1u << lane;
        ++t.count;
        last = lane;
        ++k;
        continue;
      }
      if (t.count > 0) tiles_.push_back(t);
      t = {begin + static_cast<std::uint32_t>(k), node, 1, 1};
      last = 0;
      if (k + Lanes <= n && is_full(first + k)) {
        t.lanes = static_cast<std::uint32_t>((std::uint64_t{1} << Lanes) - 1);
        t.count = Lanes;
        last = Lanes - 1;
        k += Lanes;
      } else ++k;
    }
    open_ = t;
    last_ = last;
  }
  /// After the last particle.
  void close() {
    if (open_.count > 0) tiles_.push_back(open_);
    open_.count = 0;
  }

private:
  /// Do the particles of a tile stand in neighbouring cells, one in each?
  static bool is_full(const std::int32_t* first) {
    std::int32_t wrong = (first[0] % Stride + Lanes > Stride) ? 1 : 0;
    for (int i = 1; i < Lanes; ++i) wrong |= first[i] - first[0] - i;
    return wrong == 0;
  }
  std::vector<tile>& tiles_;
  tile open_{0, -1, 0, 0};
  std::int32_t last_ = Lanes;
};

/// From an order in which the particles of a key (a cell) follow each other, start[k] .. start[k + 1], the one that fills tiles: of every `group` keys
/// first the first particle of each, then the second of each ...
inline void interleave(const std::vector<std::uint32_t>& start, std::size_t group, std::vector<std::uint32_t>& order) {
  const std::size_t keys = start.size() - 1;
  std::vector<std::uint32_t> part;
  for (std::size_t g = 0; g < keys; g += group) {
    const std::size_t end = g + group < keys ? g + group : keys, total = start[end] - start[g];
    if (total < 2) continue;
    part.resize(total);
    for (std::uint32_t rank = 0, done = 0; done < total; ++rank)
      for (std::size_t k = g; k < end; ++k)
        if (start[k] + rank < start[k + 1]) part[done++] = order[start[k] + rank];
    std::copy(part.begin(), part.end(), order.begin() + start[g]);
  }
}

} // namespace bolide
