// SPDX-License-Identifier: MIT
// No artificial viscosity: right for smooth flow; wrong at a shock, where the material would miss the Hugoniot's entropy.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::viscosity {
struct none {
  using particle_fields = fields<>;
  static constexpr bool present = false;
  template <class V> BOLIDE_INLINE V pressure(V, V, V, scalar_t<V>) const { return V(scalar_t<V>(0)); }
  template <class V> BOLIDE_INLINE V signal_speed(V, V, scalar_t<V>) const { return V(scalar_t<V>(0)); }
};
} // namespace bolide::viscosity
