// SPDX-License-Identifier: MIT
// expect: ok
// The door for a study of what goes wrong.
#include "scene.hpp"

#include "bolide/concepts/accept_unsound.hpp"

void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{},
                     bolide::accept_unsound<bolide::scheme::usl>{}, bolide::controls<>{}, scene::slab(scene::metal())};
  sim.step();
}
