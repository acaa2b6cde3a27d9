// SPDX-License-Identifier: MIT
// The role "shape function": how does a particle see the nodes along one axis? (Axes multiply.)
//
// `support` nodes from floor(x - offset), x in cells; value(f, N), slope(f, dN/dx) and curvature(f, d2N/dx2) for f = x - first node,
// per lane type. A shape that depends on the particle's size says so, `wants_size`, and takes half of it in cells as a third argument.
// Invariants (tested for every model): partition of unity, sum N i = x (linear completeness), N >= 0,
// the derivatives are the derivatives.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class S, class V = double>
concept ShapeFunction = requires {
  { S::support } -> std::convertible_to<int>;
  { S::offset } -> std::convertible_to<double>;
  { S::smooth } -> std::convertible_to<bool>;
} && (requires(V f, V* n) {
  S::value(f, n);
  S::slope(f, n);
  S::curvature(f, n);
} || requires(V f, V* n, scalar_t<V> half_size) {
  requires S::wants_size;
  S::value(f, n, half_size);
  S::slope(f, n, half_size);
  S::curvature(f, n, half_size);
});

/// Does a shape function depend on the particle's size?
template <class S> inline constexpr bool shape_wants_size = requires { requires S::wants_size; };
/// Does it say that it is straight between nodes, `straight`? Its curvature is then not asked for.
template <class S> inline constexpr bool shape_is_straight = requires { requires S::straight; };

} // namespace bolide
