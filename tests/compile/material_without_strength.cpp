// SPDX-License-Identifier: MIT
// expect: bolide: material: the second argument is no strength: it must have particle_fields, carries_shear, wants_temperature and, if it carries shear, shear_modulus, yield_stress and yield_floor
#include "scene.hpp"

struct yield_only { // says that it carries shear and gives no shear modulus
  using particle_fields = bolide::fields<bolide::field::deviator, bolide::field::plastic_strain>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  template <class V> V yield_stress(V, V, V, V) const { return V(1e8); }
};
bolide::material metal{bolide::eos::mie_grueneisen{}, yield_only{}, bolide::failure::none{}};
