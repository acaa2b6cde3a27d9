// SPDX-License-Identifier: MIT
// Variant "paper": the phase regions exactly as the paper has them, its misprints mended.
// Solid to the liquidus E_m (superheated to 1.32 T_m), liquid, hot liquid; gas for x >= xj. p jumps up and T down at E_m, and both
// jump at V_j (docs/eos.md has the figures), which makes the Hugoniot multi-valued near 80 to 90 GPa when it starts at 300 K.
#pragma once

#include "bolide/eos/phase/regions.hpp"

namespace bolide::phase {

struct paper : regions<published, false, true> {
  using regions::regions;
};
static_assert(PhaseSolver<paper>);

} // namespace bolide::phase
