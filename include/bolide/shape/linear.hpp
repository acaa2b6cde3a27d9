// SPDX-License-Identifier: MIT
// Linear (tent) shape function: N = 1 - |x - i| in units of the cell size; two nodes per axis. Continuous, its slope jumps at cell
// faces (the cell-crossing noise of the original material point method). Exact for linear fields; second order on a lattice.
// A particle exactly on a face would put a force on a node that has no mass, and that force would be lost: the far node keeps a
// share of a few machine epsilons instead, which leaves partition of unity exact and momentum whole.
#pragma once

#include "bolide/core/math.hpp"

#include <limits>

namespace bolide::shape {

struct linear {
  static constexpr int support = 2;       // nodes per axis
  static constexpr double offset = 0;     // first node = floor(x - offset)
  static constexpr bool smooth = false;   // is the slope continuous?
  static constexpr bool straight = true;  // no curvature between nodes
  static constexpr const char* name = "linear";

  /// f = x - first node, in [0, 1]: 1 is what rounding makes of a coordinate just below a face (x = -1e-18).
  template <class V> BOLIDE_INLINE static void value(V f, V* n) {
    constexpr auto least = 4 * std::numeric_limits<scalar_t<V>>::epsilon();
    n[1] = clip(f, V(least), V(1 - least));
    n[0] = V(1) - n[1];
  }
  template <class V> BOLIDE_INLINE static void slope(V, V* d) {
    d[0] = V(-1);
    d[1] = V(1);
  }
  template <class V> BOLIDE_INLINE static void curvature(V, V* c) { c[0] = c[1] = V(0); }
};

} // namespace bolide::shape
