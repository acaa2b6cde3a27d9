// SPDX-License-Identifier: MIT
// No strength: a fluid. Stores nothing and costs nothing.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::strength {
struct none {
  using particle_fields = fields<>;
  static constexpr bool carries_shear = false;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "none";
};
} // namespace bolide::strength
