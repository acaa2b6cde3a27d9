// SPDX-License-Identifier: MIT
// The least composition: a fluid slab in 1-D, linear shapes, FLIP, USF.
#include "../compile/scene.hpp"

void f() { scene::run(bolide::space::planar_1d{}, bolide::shape::linear{}); }
