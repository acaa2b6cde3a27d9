// SPDX-License-Identifier: MIT
// The role "boundary": what does a plane do to the sums on the nodes and to particles that cross it?
//
//   rebuild(grid)             after every rebuild of the blocks: which nodes are concerned
//   complete(sums, first)     after every sum over particles: the condition on the node values; components first .. first + dim - 1
//                             are a vector, the others scalars (first < 0: all scalars)
//   is_image(node)            a node that is a copy and must not be counted in sums over nodes
//   axis(), line(), material_above()   the plane, for the reflection of particles
// Invariants: the momentum that a boundary takes is normal to its plane; mass is kept. Cost: O(nodes near the plane) per sum.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide {

template <class B, class Grid, class Values>
concept Boundary = requires(B boundary, const B& is, const Grid& grid, std::vector<Values>& sums, std::size_t node) {
  boundary.rebuild(grid);
  is.complete(sums, 0);
  { is.is_image(node) } -> std::convertible_to<bool>;
  { is.axis() } -> std::convertible_to<std::size_t>;
  { is.line() } -> std::convertible_to<std::int32_t>;
  { is.material_above() } -> std::convertible_to<bool>;
};

} // namespace bolide
