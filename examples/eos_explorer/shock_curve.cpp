// SPDX-License-Identifier: MIT
#include "shock_curve.hpp"

namespace explorer {

using bolide::analysis::shock_state;

std::optional<shock_state> shock(const start& s, double up) {
  try {
    return with_model(*s.eos, [&](const auto& model) { return bolide::analysis::hugoniot(model, s.density, s.energy, s.pressure, up); });
  } catch (const bolide::bad_parameter&) {
    return std::nullopt;
  }
}

std::vector<shock_state> shocks(const start& s, double slow, double fast, int steps) {
  std::vector<shock_state> all;
  for (int i = 0; i <= steps; ++i)
    if (const auto state = shock(s, slow + (fast - slow) * i / steps)) all.push_back(*state);
  return all;
}

} // namespace explorer
