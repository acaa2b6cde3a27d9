// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a contact, of either kind, and the library's own.
#include "scene.hpp"

#include "bolide/concepts/contact.hpp"

struct least_contact {
  static constexpr bool multi_field = false;
  static constexpr const char* name = "least";
};
struct least_multi_field {
  static constexpr bool multi_field = true;
  static constexpr const char* name = "least";
  template <class V> V correction(const V& u, const V&) const { return u; }
};
static_assert(bolide::Contact<least_contact> && bolide::Contact<least_multi_field> && !bolide::Contact<int>);
static_assert(bolide::Contact<bolide::contact::single_field> && bolide::Contact<bolide::contact::frictional>);

void f() {
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::uniform{1e-4}, bolide::shape::linear{}, bolide::transfer::flip{}, bolide::scheme::usf{}, least_multi_field{},
                     bolide::controls<>{}, scene::slab(scene::metal()), scene::slab(scene::metal())};
  sim.step();
}
