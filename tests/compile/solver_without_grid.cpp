// SPDX-License-Identifier: MIT
// expect: bolide: solver: the second argument is no grid: it must have spacing, map<Dim> and make<Dim>(): see grid/sparse.hpp
#include "scene.hpp"

struct no_grid {
  double spacing = 1;
};
void f() {
  bolide::solver sim{bolide::space::planar_1d{}, no_grid{}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usf{}, bolide::controls<>{},
                     scene::slab(scene::metal())};
}
