// SPDX-License-Identifier: MIT
// What the library's equations of state violate, with size and reason: shared by the conformance tests.
#pragma once

#include "bolide/conformance/report.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"

#include <vector>

namespace bolide::test {
using violations = std::vector<conformance::stated_violation>;

inline const cold::tabulated& table() {
  static const cold::tabulated t{cold::cai_ye{}};
  return t;
}

/// What the paper's equation of state violates: its electrons, and the jump at V_j = 1.3471 V0.
inline violations of_the_paper() {
  const double gas = 1 / 1.3471;
  return {{"maxwell", 0.18, "constant G' with the electrons' Grueneisen coefficient 2/3"},
          {"pressure_jump", 0.4, "V_j", gas * (1 - 1e-9), gas * (1 + 1e-9)},
          {"temperature_jump", 1, "V_j", gas * (1 - 1e-9), gas * (1 + 1e-9)}};
}
/// What Tillotson's formula violates.
inline violations of_tillotson() { return {{"thin_limit", 1e11, "cold expanded material pulls, with 10 GPa however thin"}}; }
} // namespace bolide::test
