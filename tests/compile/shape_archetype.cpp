// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a shape function: nearest node, which no solver could use but which the concept must take.
#include "bolide/concepts/shape_function.hpp"

struct nearest_node {
  static constexpr int support = 1;
  static constexpr double offset = -0.5;
  static constexpr bool smooth = false;
  template <class V> static void value(V, V* n) { n[0] = V(1); }
  template <class V> static void slope(V, V* d) { d[0] = V(0); }
  template <class V> static void curvature(V, V* c) { c[0] = V(0); }
};
static_assert(bolide::ShapeFunction<nearest_node> && bolide::ShapeFunction<nearest_node, bolide::native_pack<float>>);
