// SPDX-License-Identifier: MIT
// Elastic: a shear modulus G and no yield. Hypoelastic with the Jaumann rate: the stress turns with the spin of the flow.
// Validity: small elastic strains. In simple shear of gamma the exact answer of the rate is s_xy = G sin(gamma), s_xx = G (1 - cos(gamma)): it
// oscillates beyond gamma = pi/2, where no metal is elastic (tests/unit/strength/simple_shear_test.cpp).
// Cost: the deviator alone is stored; no square root, no yield stress.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"

namespace bolide::strength {
struct elastic {
  using particle_fields = fields<field::deviator>;
  static constexpr bool carries_shear = true;
  static constexpr bool yields = false;
  static constexpr bool wants_temperature = false;
  static constexpr const char* name = "elastic";

  double shear_modulus; // G, Pa

  explicit elastic(double g) : shear_modulus(g) { require(g > 0, "shear modulus", g, "positive", "Pa"); }
};
} // namespace bolide::strength
