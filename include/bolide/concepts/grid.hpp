// SPDX-License-Identifier: MIT
// The role "grid": which nodes exist, and where does a node lie in the columns of node values?
//
// A grid is made of blocks of nodes. Cell indices are arrays of dim integers; nodes carry consecutive numbers, block by block.
//   rebuild(occupied blocks)   the blocks that hold material, with all their direct neighbours, exist afterwards
//   block_of(cell), colour_of(block)   two blocks of one colour share no neighbour that a particle of both could touch
//   size(), coordinate(b), find(block), neighbourhood(block), node(cell)   -1 where there is none
// Invariants: the order of blocks depends on their coordinates alone, so that sums over nodes are reproducible; node(cell) is the
// number that the sweeps use. Cost: find and node are searches, O(log blocks): set-up and boundaries, never per particle and step.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

namespace bolide {

template <class G>
concept Grid = requires(G grid, const G& is, const typename G::index& cell, std::vector<typename G::index> occupied, std::size_t b) {
  { G::side } -> std::convertible_to<int>;
  { G::margin } -> std::convertible_to<int>;
  { G::nodes_per_block } -> std::convertible_to<int>;
  { G::neighbours } -> std::convertible_to<int>;
  { G::colours } -> std::convertible_to<int>;
  { G::block_of(cell) } -> std::convertible_to<typename G::index>;
  { G::colour_of(cell) } -> std::convertible_to<int>;
  grid.rebuild(occupied);
  { is.size() } -> std::convertible_to<std::size_t>;
  { is.coordinate(b) } -> std::convertible_to<typename G::index>;
  { is.find(cell) } -> std::convertible_to<std::int32_t>;
  { is.neighbourhood(cell)[b] } -> std::convertible_to<std::int32_t>;
  { is.node(cell) } -> std::convertible_to<std::int32_t>;
};

} // namespace bolide
