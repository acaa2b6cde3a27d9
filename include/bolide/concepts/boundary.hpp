// SPDX-License-Identifier: MIT
// The role "boundary": what does a plane do to the sums on the nodes?
//
//   rebuild(grid)             after every rebuild of the blocks: which nodes are concerned
//   spread(touched)           in every step: blocks whose partner is touched are touched too
//   complete(sums, first, offset)  after every sum over particles: the condition on the node values of the column that begins at offset;
//                             components first .. first + dim - 1 are a vector, the others scalars (first < 0: all scalars)
//   is_image(node)            a node that is a copy and must not be counted in sums over nodes
//   axis()                    the axis that it stands across
// What it does to particles that cross it (a mirror reflects, a period moves them on) is the solver's (solver/phases.hpp, move).
// Invariants: mass is kept; of the momentum a boundary takes what its head comment says. Cost: O(nodes near the plane) per sum.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide {

template <class B, class Grid, class Column>
concept Boundary = requires(B boundary, const B& is, const Grid& grid, Column& sums, std::vector<char>& touched, std::size_t node) {
  boundary.rebuild(grid);
  boundary.spread(touched);
  is.complete(sums, 0, node);
  { is.is_image(node) } -> std::convertible_to<bool>;
  { is.axis() } -> std::convertible_to<std::size_t>;
};

} // namespace bolide
