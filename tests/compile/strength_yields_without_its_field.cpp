// SPDX-License-Identifier: MIT
// expect: bolide: material: this strength yields and does not list field::plastic_strain among its particle_fields
#include "scene.hpp"

struct forgets {
  using particle_fields = bolide::fields<bolide::field::deviator>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  double shear_modulus = 1e9;
  template <class V> V yield_stress(V, V, V, V) const { return V(1e8); }
  template <class V> V yield_floor(V, V) const { return V(1e8); }
};
bolide::material metal{bolide::eos::mie_grueneisen{}, forgets{}, bolide::failure::none{}};
