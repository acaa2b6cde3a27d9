// SPDX-License-Identifier: MIT
// The role "shape function": how does a particle see the nodes along one axis? (Axes multiply.)
//
// `support` nodes from floor(x - offset), x in cells; value(f, N), slope(f, dN/dx) and curvature(f, d2N/dx2) for f = x - first node,
// per lane type. Invariants (tested for every model): partition of unity, sum N i = x (linear completeness), N >= 0,
// the derivatives are the derivatives.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class S, class V = double>
concept ShapeFunction = requires(V f, V* n) {
  { S::support } -> std::convertible_to<int>;
  { S::offset } -> std::convertible_to<double>;
  { S::smooth } -> std::convertible_to<bool>;
  S::value(f, n);
  S::slope(f, n);
  S::curvature(f, n);
};

} // namespace bolide
