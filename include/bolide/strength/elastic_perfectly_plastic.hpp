// SPDX-License-Identifier: MIT
// Elastic, perfectly plastic: shear modulus G and a constant yield stress Y (von Mises). Y = infinity is elastic.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/lane.hpp"

namespace bolide::strength {
struct elastic_perfectly_plastic {
  using particle_fields = fields<field::deviator, field::plastic_strain>;
  static constexpr bool carries_shear = true;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "elastic_perfectly_plastic";

  double shear_modulus; // G, Pa
  double yield;         // Y, Pa

  elastic_perfectly_plastic(double g, double y) : shear_modulus(g), yield(y) {
    require(g > 0, "shear modulus", g, "positive", "Pa");
    require(y > 0, "yield stress", y, "positive", "Pa");
  }
  template <class V> BOLIDE_INLINE V yield_floor(V, V) const { return V(scalar_t<V>(yield)); }
  template <class V> BOLIDE_INLINE V yield_stress(V, V, V, V) const { return V(scalar_t<V>(yield)); }
};
} // namespace bolide::strength
