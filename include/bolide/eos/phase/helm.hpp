// SPDX-License-Identifier: MIT
// Variant "helm": one free energy F(V, T) for solid, mixed, liquid and hot liquid; no gas branch and no jump.
// Differs from "mixed" by G = G0 x^ge (electrons consistent) and, for x > 1, by gamma -> 2/3, so that the hot liquid becomes the ideal
// gas by itself. Validity: the electron term does not fade, so at 10 000 K it equals the ideal-gas pressure at x = 5: use to about there.
#pragma once

#include "bolide/eos/phase/regions.hpp"

namespace bolide::phase {

struct helm : regions<helmholtz, true, false> {
  using regions::regions;
  double largest_volume_ratio() const { return 5; } // x, where the electrons have taken over
  std::vector<double> border_volume_ratios() const { return {1.0}; } // the slope of gamma has a kink there
};
static_assert(PhaseSolver<helm>);

} // namespace bolide::phase
