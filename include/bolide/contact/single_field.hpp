// SPDX-License-Identifier: MIT
// The plain contact of the material point method: all bodies share one velocity per node. They stick together while they touch, part only by
// failure, and never penetrate. Costs nothing; what hypervelocity impact wants, where what touches melts together.
#pragma once

#include "bolide/concepts/contact.hpp"

namespace bolide::contact {
struct single_field {
  static constexpr bool multi_field = false;
  static constexpr const char* name = "single_field";
};
static_assert(Contact<single_field>);
} // namespace bolide::contact
