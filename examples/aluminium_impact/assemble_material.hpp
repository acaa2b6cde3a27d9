// SPDX-License-Identifier: MIT
// What the units material_*.cpp share: an equation of state becomes a material in its initial state.
#pragma once

#include "chosen_material.hpp"

#include "bolide/eos/state.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/material/material.hpp"

#include <utility>

namespace impact {

/// EOS, strength, failure and viscosity by the settings, at p = 0 and 293 K (ambient) or at the scale point of the EOS (cold).
template <class T, class Eos, class Thermal>
chosen_material<T> assemble(const Eos& eos, const bolide::data::parameter_set& set, const settings& s, Thermal thermal_energy) {
  using namespace bolide;
  const auto start = s.initial == "cold" ? eos::cold_state(eos) : eos::ambient_state(eos, room_temperature);
  const auto fails = s.tension ? failure::tension_or_melt{*s.tension} : failure::tension_or_melt::melt_only();
  material whole{eos, set.strength, fails, viscosity::bulk{s.viscosity_quadratic, s.viscosity_linear}, record::peak_pressure{}};
  return {any_material<T, space::axisymmetric>{std::move(whole)}, start.density, start.energy, std::move(thermal_energy)};
}

} // namespace impact
