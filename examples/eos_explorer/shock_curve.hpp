// SPDX-License-Identifier: MIT
// Hugoniot states of a model chosen at run time.
#pragma once

#include "commands.hpp"

#include "bolide/analysis/hugoniot.hpp"

#include <optional>
#include <vector>

namespace explorer {

/// The state behind a shock of particle speed up (m/s); nothing where the model carries none.
std::optional<bolide::analysis::shock_state> shock(const start& s, double up);

/// Even steps of up from `slow` to `fast`, for plots; speeds that the model does not carry are left out.
std::vector<bolide::analysis::shock_state> shocks(const start& s, double slow, double fast, int steps);

} // namespace explorer
