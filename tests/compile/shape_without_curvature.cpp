// SPDX-License-Identifier: MIT
// expect: bolide: solver: the third argument is no shape function: it must have support, offset, smooth, value, slope and curvature
// expect: curvature
#include "scene.hpp"

struct tent {
  static constexpr int support = 2;
  static constexpr double offset = 0;
  static constexpr bool smooth = false;
  static constexpr const char* name = "tent";
  template <class V> static void value(V f, V* n) { n[1] = f, n[0] = V(1) - f; }
  template <class V> static void slope(V, V* d) { d[0] = V(-1), d[1] = V(1); }
};
void f() { scene::run(bolide::space::planar_1d{}, tent{}); }
