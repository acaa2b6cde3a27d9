// SPDX-License-Identifier: MIT
// expect: bolide: solver: USL with linear shape functions is unsound (a particle is strained by nodes of tiny mass that it has just reached); take scheme::musl, a smooth shape, or accept_unsound<scheme::usl>
#include "scene.hpp"

void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usl{}, bolide::controls<>{},
                     scene::slab(scene::metal())};
  sim.step();
}
