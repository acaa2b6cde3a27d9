// SPDX-License-Identifier: MIT
// Variant "mixed", the default: the paper's regions with lever-rule melting between solidus E_ms and liquidus E_m.
// p and T are continuous at both melting borders; the jump at V_j is the paper's.
#pragma once

#include "bolide/eos/phase/regions.hpp"

namespace bolide::phase {

struct mixed : regions<published, true, true> {
  using regions::regions;
};
static_assert(PhaseSolver<mixed>);

} // namespace bolide::phase
