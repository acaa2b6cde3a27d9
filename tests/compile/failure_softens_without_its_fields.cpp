// SPDX-License-Identifier: MIT
// expect: bolide: material: this failure law softens and does not list field::lost_capacity and field::held_tension among its particle_fields
#include "scene.hpp"

struct forgets {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume, bolide::field::lost_capacity>;
  static constexpr bool may_fail = true, wants_temperature = false;
  template <class V> bolide::mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(0); }
  template <class V> V capacity_lost(V before, V, V, bolide::scalar_t<V>, bolide::scalar_t<V>) const { return before; }
};
bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::none{}, forgets{}};
