// SPDX-License-Identifier: MIT
// --accuracy, --budget and --preset: the discretisation by measured rows (bolide/advise) instead of by hand.
#pragma once

#include "settings.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace impact {

/// As given on the command line; at most one of the three.
struct wish {
  std::string accuracy, budget, preset; // "1%" or 0.01; "10s"; draft, standard, reference
  bool any() const { return !accuracy.empty() || !budget.empty() || !preset.empty(); }
};

/// Chooses shape, transfer, scheme, precision, CFL, cell and spacing for the scene of `s` and returns what was chosen, why, and how sure it is. What was given on
/// the command line, given("shape") and so on, is kept and bounds the choice. Throws bad_parameter.
std::string take_advice(settings& s, const wish& w, const std::function<bool(std::string_view)>& given);

} // namespace impact
