// SPDX-License-Identifier: MIT
// Variant "paper": the phase regions exactly as the paper has them, its misprints mended.
// Solid to the liquidus E_m (superheated to 1.32 T_m), liquid, hot liquid; gas for x >= xj. p jumps up and T down at E_m, and both
// jump at V_j (docs/eos.md has the figures). The Hugoniot then has three roots over a stretch of particle speeds (4.6 to 4.8 km/s, 145
// to 155 GPa, from 300 K), and the release from about 80 GPa jumps from superheated solid to liquid.
#pragma once

#include "bolide/eos/phase/regions.hpp"

namespace bolide::phase {

struct paper : regions<published, false, true> {
  using regions::regions;
};
static_assert(PhaseSolver<paper>);

} // namespace bolide::phase
