// SPDX-License-Identifier: MIT
// expect: bolide: material: this failure law may fail and does not list field::failed and field::material_volume among its particle_fields
#include "scene.hpp"

struct forgets {
  using particle_fields = bolide::fields<bolide::field::failed>;
  static constexpr bool may_fail = true, wants_temperature = false;
  template <class V> bolide::mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(0); }
};
bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::none{}, forgets{}};
