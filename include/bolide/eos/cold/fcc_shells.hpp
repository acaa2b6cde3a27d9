// SPDX-License-Identifier: MIT
// The neighbour shells of the face-centred cubic lattice, counted by potential::shells.
#pragma once

#include "bolide/potential/shells.hpp"

#include <vector>

namespace bolide::cold {

using fcc_shell = potential::shell;

/// All shells with distance <= reach (in lattice constants), nearest first, the origin left out.
inline std::vector<fcc_shell> fcc_shells(double reach) { return potential::shells(bolide::lattice::fcc, reach); }

} // namespace bolide::cold
