// SPDX-License-Identifier: MIT
// The critical point of the liquid of eos::reference: the temperature above which p falls with V at every volume. Set-up work.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/eos/reference/coexistence.hpp"

namespace bolide::eos {

/// The end of the line between liquid and vapour.
struct critical_point {
  double temperature, density, pressure; // K, kg/m3, Pa
};

namespace detail {

/// Looked for between 500 and 50 000 K and 1.35 and 30 V0: the smallest F_LL - F_L over the volume is 0 there.
inline critical_point find_critical_point(const reference_phases& phases) {
  const auto softest = [&](double temperature, double& log_x) {
    const auto at = [&](double l) { return state_of(phases, true, l, temperature).stiffness; };
    double best = at(log_x = 0.3);
    for (double l = 0.32; l < 3.4; l += 0.02)
      if (const double k = at(l); k < best) best = k, log_x = l;
    const double a = at(log_x - 0.02), c = at(log_x + 0.02);
    log_x += 0.01 * (a - c) / (a - 2 * best + c);
    return at(log_x);
  };
  double low = 500, high = 50000, log_x = 0;
  require(softest(low, log_x) < 0 && softest(high, log_x) > 0, "reference b0", phases.parameters().b0,
          "such that liquid and vapour have a critical point between 500 and 50 000 K", "J/kg");
  while (high - low > 1e-9 * high) (softest(0.5 * (low + high), log_x) < 0 ? low : high) = 0.5 * (low + high);
  softest(high, log_x);
  const auto s = state_of(phases, true, log_x, high);
  return {high, 1 / s.volume, s.pressure};
}

} // namespace detail
} // namespace bolide::eos
