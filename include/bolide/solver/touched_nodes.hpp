// SPDX-License-Identifier: MIT
// The nodes that particles touch in a step, and loops over them.
//
// Only they are cleared and looped over: empty halo costs nothing. Loops run in parallel over the blocks; what they sum is kept block by block and
// added in the order of the blocks, so the number of threads does not change a bit. A node with several velocity fields has a number in each:
// those of a field follow all of the field before.
#pragma once

#include "bolide/grid/sparse.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bolide {

template <int Dim, int Fields> class touched_nodes {
public:
  using map = grid::block_map<Dim>;
  static constexpr std::int64_t worth_threads = 4096; // nodes below which threads cost more than they give

  /// Begins a step on a grid of so many blocks. each_range(f) calls f(range) for the ranges whose particles bring something to the nodes;
  /// boundaries are lists of mirrors or periods, which touch the images of what is touched.
  template <class F, class... Boundaries> void find(std::size_t blocks, int threads, F&& each_range, Boundaries&... boundaries) {
    threads_ = threads;
    node_count_ = blocks * map::nodes_per_block;
    const grid::node_range<Dim> whole = map::whole_block();
    std::vector<grid::node_range<Dim>> nodes(blocks, grid::node_range<Dim>{whole.high, whole.low}); // of no node
    std::vector<char> touched(blocks, 0);
    each_range([&](const auto& range) {
      for (int n = 0; n < map::neighbours; ++n) {
        const auto seen = range.part_in_neighbour(n);
        if (seen.empty()) continue;
        const auto b = static_cast<std::size_t>(range.near[static_cast<std::size_t>(n)]);
        if (!touched[b]) nodes[b] = seen;
        else nodes[b].merge(seen);
        touched[b] = 1;
      }
    });
    const auto spread = [&](auto& list) {
      for (auto& boundary : list) boundary.spread(touched);
    };
    (spread(boundaries), ...);
    parts_.clear();
    std::size_t total = 0;
    for (std::size_t b = 0; b < blocks; ++b)
      if (touched[b]) {
        const bool images = touched[b] == map::holds_images;
        parts_.push_back({b, images ? whole : nodes[b], images, total, 0});
        each_run_of(parts_.back(), [&](std::size_t first, std::size_t last) { total += last - first; });
      }
    with_mass_.resize(total);
  }

  /// Makes room in the columns for all nodes, and zeros for the touched ones.
  template <class... Columns> void clear(Columns&... columns) {
    (columns.resize(Fields * node_count_), ...);
    sum_over_parts([&](const part& p) {
      each_run_of(p, [&](std::size_t first, std::size_t last) {
        (std::fill(columns.row(first), columns.row(last), typename Columns::scalar(0)), ...);
      });
      return 0.0;
    });
  }
  /// f(i) -> has it mass? for every node.
  template <class F> void find_mass(F&& f) {
    sum_over_parts([&](part& p) {
      std::uint32_t* next = with_mass_.data() + p.first; // every node is written there, and overwritten where it has none
      each_run_of(p, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          *next = static_cast<std::uint32_t>(i);
          next += f(i) ? 1 : 0;
        }
      });
      p.with_mass = static_cast<std::size_t>(next - with_mass_.data()) - p.first;
      return 0.0;
    });
  }
  /// f(i) for the nodes that have mass.
  template <class F> void each_with_mass(F&& f) {
    sum_over_parts([&](const part& p) {
      for (std::size_t k = p.first; k < p.first + p.with_mass; ++k) f(std::size_t{with_mass_[k]});
      return 0.0;
    });
  }
  /// Sum of what f(i) returns for them; is_image(i) are left out.
  template <class F, class Image> double sum_with_mass(F&& f, Image&& is_image) {
    return sum_over_parts([&](const part& p) {
      double total = 0;
      for (std::size_t k = p.first; k < p.first + p.with_mass; ++k) {
        const std::size_t i = with_mass_[k];
        const auto x = f(i);
        if (!p.images || !is_image(i)) total += static_cast<double>(x);
      }
      return total;
    });
  }
  /// Sum of what f(i) returns for every node.
  template <class F> double sum(F&& f) {
    return sum_over_parts([&](const part& p) {
      double total = 0;
      each_run_of(p, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) total += f(i);
      });
      return total;
    });
  }
  /// f(block, node of the block) for every node of the first field, one after the other.
  template <class F> void each_place(F&& f) const {
    for (const part& p : parts_)
      map::for_each_row(p.nodes, [&](int local, int count) {
        for (int n = local; n < local + count; ++n) f(p.block, n);
      });
  }

private:
  /// Of one block.
  struct part {
    std::size_t block;
    grid::node_range<Dim> nodes;  // relative to the block
    bool images;                  // may some of them be images?
    std::size_t first, with_mass; // those of them that have mass, in with_mass_
  };
  std::size_t node_count_ = 0; // of a field
  int threads_ = 1;
  std::vector<part> parts_;
  std::vector<std::uint32_t> with_mass_;
  std::vector<double> sums_; // of a loop, one per part

  /// f(first, last) for every run of nodes of a part, in every field.
  template <class F> void each_run_of(const part& p, F&& f) const {
    map::for_each_row(p.nodes, [&](int local, int count) {
      const std::size_t first = p.block * map::nodes_per_block + static_cast<std::size_t>(local);
      for (std::size_t at = first; at < Fields * node_count_; at += node_count_) f(at, at + static_cast<std::size_t>(count));
    });
  }
  template <class F> double sum_over_parts(F&& f) {
    const auto n = static_cast<std::int64_t>(parts_.size());
    sums_.assign(parts_.size(), 0);
#if defined(_OPENMP)
#pragma omp parallel for num_threads(threads_) schedule(static) if (n * map::nodes_per_block > worth_threads)
#endif
    for (std::int64_t b = 0; b < n; ++b) sums_[static_cast<std::size_t>(b)] = f(parts_[static_cast<std::size_t>(b)]);
    double total = 0;
    for (const double one : sums_) total += one;
    return total;
  }
};

} // namespace bolide
