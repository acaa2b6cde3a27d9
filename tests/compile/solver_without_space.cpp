// SPDX-License-Identifier: MIT
// expect: bolide: solver: the first argument is no space: see concepts/space.hpp
#include "scene.hpp"

struct nowhere {
  static constexpr int dim = 1;
};
void f() { scene::run(nowhere{}, bolide::shape::linear{}); }
