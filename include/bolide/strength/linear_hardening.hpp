// SPDX-License-Identifier: MIT
// Elastic-plastic with linear isotropic hardening: Y = Y0 + H eps, eps the equivalent plastic strain (von Mises).
// The radial return is exact for it: d(eps) = (s_trial - Y(eps)) / (3 G + H), s = Y(eps + d(eps)). No rate, no heat.
// Cost: that of perfect plasticity and one division in packs where a point yields.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/lane.hpp"

namespace bolide::strength {
struct linear_hardening {
  using particle_fields = fields<field::deviator, field::plastic_strain>;
  static constexpr bool carries_shear = true;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "linear_hardening";

  double shear_modulus;     // G, Pa
  double yield;             // Y0, Pa
  double hardening_modulus; // H, Pa

  linear_hardening(double g, double y0, double h) : shear_modulus(g), yield(y0), hardening_modulus(h) {
    require(g > 0, "shear modulus", g, "positive", "Pa");
    require(y0 > 0, "yield stress", y0, "positive", "Pa");
    require(h >= 0, "hardening modulus", h, "non-negative", "Pa");
  }
  template <class V> BOLIDE_INLINE V yield_floor(V, V) const { return V(scalar_t<V>(yield)); }
  template <class V> BOLIDE_INLINE V yield_stress(V plastic_strain, V, V, V) const {
    using T = scalar_t<V>;
    return T(yield) + T(hardening_modulus) * plastic_strain;
  }
};
} // namespace bolide::strength
