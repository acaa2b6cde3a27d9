// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a scheme, and the library's own.
#include "bolide/concepts/scheme.hpp"
#include "bolide/core/field.hpp"
#include "bolide/scheme/musl.hpp"
#include "bolide/scheme/usf.hpp"
#include "bolide/scheme/usl.hpp"

struct least_scheme {
  using particle_fields = bolide::fields<>;
  static constexpr bool stress_first = true, maps_velocity_back = false, wants_smooth_shape = false;
  static constexpr const char* name = "least";
  template <class Phases> void step(Phases& s) const { s.map_to_nodes(); }
};
struct calls_what_is_not_there : least_scheme {
  void step(bolide::scheme_phases&, int) const {}
};
static_assert(bolide::Scheme<least_scheme> && bolide::Scheme<bolide::scheme::usf> && bolide::Scheme<bolide::scheme::musl> && bolide::Scheme<bolide::scheme::usl>);
static_assert(!bolide::Scheme<calls_what_is_not_there>);
