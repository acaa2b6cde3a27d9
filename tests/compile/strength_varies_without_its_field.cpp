// SPDX-License-Identifier: MIT
// expect: bolide: material: the shear modulus of this strength varies and it does not list field::shear_modulus among its particle_fields
#include "scene.hpp"

struct stiffens {
  using particle_fields = bolide::fields<bolide::field::deviator, bolide::field::plastic_strain>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  double shear_modulus = 1e9;
  template <class V> V shear_modulus_at(V pressure, V, V, V) const { return V(1e9) + pressure; }
  template <class V> V yield_stress(V, V, V, V, V, V) const { return V(1e8); }
  template <class V> V yield_floor(V, V, V, V) const { return V(1e8); }
};
bolide::material metal{bolide::eos::mie_grueneisen{}, stiffens{}, bolide::failure::none{}};
