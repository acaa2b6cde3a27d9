// SPDX-License-Identifier: MIT
// expect: bolide: solver: a body force must be callable as acceleration(position, time) and give a vector of the space
#include "scene.hpp"

void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usf{}, bolide::controls<>{},
                     scene::slab(scene::metal())};
  sim.add(bolide::body_force{[](const bolide::vec<double, 1>& x) { return x; }});
}
