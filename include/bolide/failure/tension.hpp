// SPDX-License-Identifier: MIT
// Tension cut-off alone: a point fails for good when its tension exceeds a limit. Wants no temperature.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::failure {

struct tension {
  using particle_fields = fields<field::failed, field::material_volume>;
  static constexpr bool may_fail = true;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "tension";

  double limit; // of -p, Pa

  explicit tension(double p) : limit(p) { require(p > 0, "tension limit", p, "positive", "Pa"); }

  template <class V> BOLIDE_INLINE mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(scalar_t<V>(-limit)); }
};

} // namespace bolide::failure
