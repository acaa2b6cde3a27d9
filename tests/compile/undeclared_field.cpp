// SPDX-License-Identifier: MIT
// expect: bolide: this particle field is not stored: no model of the composition declares it
#include "scene.hpp"

// A fluid without strength stores no deviator.
void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usf{}, bolide::controls<>{},
                     scene::slab(scene::metal())};
  sim.for_each_body([](const auto& s) { return s.columns.template get<bolide::field::deviator>(); });
}
