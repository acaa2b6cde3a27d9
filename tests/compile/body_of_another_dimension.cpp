// SPDX-License-Identifier: MIT
// expect: bolide: solver: the geometry of a body has another number of axes than the space
#include "scene.hpp"

void f() { scene::run(bolide::space::axisymmetric{}, bolide::shape::linear{}); }
