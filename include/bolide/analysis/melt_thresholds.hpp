// SPDX-License-Identifier: MIT
// Where melting begins and ends: on the Hugoniot, and on release to zero pressure. Found by bisection in the particle speed on the
// melt fraction of the equation of state (a model without a mixed phase has begin = end).
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/release_isentrope.hpp"

namespace bolide::analysis {

struct melt_thresholds {
  shock_state hugoniot_begin, hugoniot_end; // first liquid, last solid in the shocked state
  shock_state release_begin, release_end;   // the shocks whose release to p = 0 ends with the first liquid, the last solid
};

namespace detail {
template <class Fraction> double threshold_speed(const Fraction& fraction, double slow, double fast, bool complete) {
  const auto molten = [&](double up) { return complete ? fraction(up) >= 1 : fraction(up) > 0; };
  require(!molten(slow) && molten(fast), "fast end of the melt threshold search", fast,
          "a particle speed that melts (and the slow end one that does not)", "m/s");
  for (int i = 0; i < 45; ++i) (molten(0.5 * (slow + fast)) ? fast : slow) = 0.5 * (slow + fast);
  return fast;
}
} // namespace detail

/// The thresholds of material that is shocked from `ahead`, looked for between the particle speeds slow and fast (m/s).
template <class Eos> melt_thresholds find_melt_thresholds(const Eos& eos, const eos::material_state& ahead, double slow = 1500,
                                                           double fast = 7000) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: analysis::find_melt_thresholds needs a ThermalEquationOfState.");
  const auto shocked = [&](double up) { return hugoniot(eos, ahead, up).melt_fraction; };
  const auto released = [&](double up) {
    const shock_state s = hugoniot(eos, ahead, up);
    return release_isentrope(eos, s.density, s.energy).melt_fraction;
  };
  const auto state = [&](const auto& fraction, bool complete) {
    return hugoniot(eos, ahead, detail::threshold_speed(fraction, slow, fast, complete));
  };
  return {state(shocked, false), state(shocked, true), state(released, false), state(released, true)};
}

} // namespace bolide::analysis
