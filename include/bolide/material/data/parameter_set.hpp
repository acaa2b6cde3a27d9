// SPDX-License-Identifier: MIT
// What the library knows of a named material: the parameters from which equations of state, strength and melting are composed.
//
// A set is a plain constant (one file per material, every number with its unit, source and validity beside it); library.hpp lists them.
// What a set has no parameters for is absent (an empty optional), never guessed: whoever asks for it gets a refusal.
#pragma once

#include "bolide/eos/lindemann.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/grover_parameters.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/strength/johnson_cook.hpp"

#include <optional>
#include <string_view>

namespace bolide::data {

struct parameter_set {
  std::string_view name, description;
  double density;                                      // kg/m3 at 293 K and zero pressure
  eos::mie_grueneisen_parameters mie_grueneisen;       // linear us-up Hugoniot; its rho0 is the density it was measured at
  std::optional<eos::tillotson_parameters> tillotson;
  /// The heat of Grover's phase regions, to go with the cold curve of Cai and Ye, which this library has for aluminium only.
  std::optional<phase::grover_parameters> phases;
  double heat_capacity;                                // J/(kg K), c_v of the temperature of Mie-Grueneisen and Tillotson
  eos::lindemann melting;                              // melting temperature against volume for the same
  strength::johnson_cook strength;
  std::string_view source;                             // where the numbers come from, in a phrase
};

/// Lindemann's law where only the Grueneisen coefficient is known: gamma = g0 - a (1 - x) with GRAY's default slope a = g0 - 1/2.
constexpr eos::lindemann lindemann_of(double melting_temperature, double gamma0) { return {melting_temperature, gamma0, gamma0 - 0.5}; }

} // namespace bolide::data
