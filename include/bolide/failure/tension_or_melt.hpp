// SPDX-License-Identifier: MIT
// The paper's combined failure (section 2): a point fails for good when its tension exceeds a limit or when it melts.
// A failed point carries no deviator and no tension; a void opens around it instead (material/material.hpp).
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <limits>

namespace bolide::failure {

struct tension_or_melt {
  using particle_fields = fields<field::failed, field::material_volume>;
  static constexpr bool may_fail = true;
  static constexpr bool wants_temperature = true;
  static constexpr const char* name = "tension_or_melt";

  double tension; // limit of -p, Pa; infinity: melting alone fails

  explicit tension_or_melt(double limit = 1.5e9) : tension(limit) { require(limit > 0, "tension limit", limit, "positive", "Pa"); }
  static tension_or_melt melt_only() { return tension_or_melt(std::numeric_limits<double>::infinity()); }

  /// Does a point of this pressure and melt state fail now?
  template <class V> BOLIDE_INLINE mask_t<V> fails(V pressure, V temperature, V melting_temperature, V melt_fraction) const {
    using T = scalar_t<V>;
    return pressure < V(T(-tension)) || temperature > melting_temperature || melt_fraction > V(T(0));
  }
};

} // namespace bolide::failure
