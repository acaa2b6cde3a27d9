// SPDX-License-Identifier: MIT
// How hard must a shock be for the release from it to begin vaporising the material, and to vaporise all of it?
//
// Definition: a release vaporises at least as much as the isentrope through a marked state does: that is, when it comes to the density of
// that state it has the state's energy or more. Isentropes do not cross, so that this is the entropy criterion of the impact literature
// (S behind the shock against S of the boiling liquid and of the saturated vapour) without a need for S. The marked states are
//   boiling_states(eos, p, ...)        a model with a liquid-vapour dome: the boiling liquid and the saturated vapour at pressure p
//   heating_states(eos, T, latent)     a model with a temperature, no dome: the liquid of p = 0 at the boiling temperature; and the same
//                                      density with the heat of vaporisation (J/kg) more, both given by the user
//   energy_states(rho, E_iv, E_cv)     a model without temperature: energies at the normal density rho; Tillotson's E_iv and E_cv are those
//                                      (tillotson_states), the borders of its own regions where the release comes to rho0
// The last two are estimates: the energy that a release still has at (nearly) its normal density, not that after full expansion.
// A release that meets c^2 <= 0 before that density does not reach the state.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/isentrope.hpp"
#include "bolide/analysis/saturation.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tillotson.hpp"

namespace bolide::analysis {

/// The marked states: where vaporisation begins, and where it is complete.
struct vaporisation_states {
  double begin_density, begin_energy; // kg/m3, J/kg
  double end_density, end_energy;
};

struct vaporisation_thresholds {
  shock_state begin, end; // the shocks whose release passes through the marked states
};

inline vaporisation_states energy_states(double rho, double E_iv, double E_cv) {
  require(rho > 0, "normal density of a vaporisation criterion", rho, "> 0", "kg/m3");
  require(E_cv >= E_iv, "energy of complete vaporisation", E_cv, "not below that of incipient vaporisation", "J/kg");
  return {rho, E_iv, rho, E_cv};
}

inline vaporisation_states tillotson_states(const eos::tillotson& eos) {
  return energy_states(eos.values().rho0, eos.values().E_iv, eos.values().E_cv);
}

/// T: boiling temperature (K), latent: heat of vaporisation (J/kg).
template <class Eos> vaporisation_states heating_states(const Eos& eos, double T, double latent) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: analysis::heating_states needs a ThermalEquationOfState.");
  require(latent > 0, "heat of vaporisation", latent, "> 0", "J/kg");
  const auto liquid = eos::ambient_state(eos, T);
  return energy_states(liquid.density, liquid.energy, liquid.energy + latent);
}

/// The dome's states at pressure p (Pa), whose temperature is looked for between T_low and T_high (K).
template <class Eos> vaporisation_states boiling_states(const Eos& eos, double p, double T_low, double T_high) {
  const saturation_state s = saturation_at_pressure(eos, p, T_low, T_high);
  require(s.what == eos::status::ok, "pressure of boiling", p, "one at which liquid and vapour coexist between the temperatures given", "Pa");
  return {s.liquid_density, s.liquid_energy, s.vapour_density, s.vapour_energy};
}

namespace detail {
/// Does the release from the shock of speed up come to density rho with energy e or more?
template <class Eos> bool release_passes(const Eos& eos, const eos::material_state& ahead, double up, double rho, double e) {
  const shock_state s = hugoniot(eos, ahead, up);
  if (s.density <= rho) return s.energy >= e;
  const isentrope_curve path = isentrope_at(eos, s.density, s.energy, {rho});
  return path.end == isentrope_end::reached && path.states.back().energy >= e;
}
} // namespace detail

/// The thresholds of material that is shocked from `ahead`, looked for between the particle speeds slow and fast (m/s).
template <class Eos>
vaporisation_thresholds find_vaporisation_thresholds(const Eos& eos, const eos::material_state& ahead, const vaporisation_states& marked,
                                                     double slow = 2000, double fast = 20000) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::find_vaporisation_thresholds needs an EquationOfState.");
  const auto threshold = [&](double rho, double e) {
    const auto passes = [&](double up) { return detail::release_passes(eos, ahead, up, rho, e); };
    require(!passes(slow) && passes(fast), "fast end of the vaporisation threshold search", fast,
            "a particle speed that vaporises (and the slow end one that does not)", "m/s");
    double low = slow, high = fast;
    for (int i = 0; i < 45; ++i) (passes(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return hugoniot(eos, ahead, high);
  };
  return {threshold(marked.begin_density, marked.begin_energy), threshold(marked.end_density, marked.end_energy)};
}

} // namespace bolide::analysis
