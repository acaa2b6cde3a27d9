// SPDX-License-Identifier: MIT
// No failure: the material carries any tension that its equation of state gives. Stores nothing.
#pragma once

#include "bolide/core/field.hpp"

namespace bolide::failure {
struct none {
  using particle_fields = fields<>;
  static constexpr bool may_fail = false;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "none";
};
} // namespace bolide::failure
