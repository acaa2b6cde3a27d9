// SPDX-License-Identifier: MIT
// expect: bolide: solver: no contact: it must have multi_field and name and, if it is multi-field, correction(u, n)
#include "scene.hpp"

struct no_contact {
  static constexpr bool multi_field = true;
  static constexpr const char* name = "none";
};
void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usf{}, no_contact{},
                     bolide::controls<>{}, scene::slab(scene::metal())};
}
