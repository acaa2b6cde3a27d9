// SPDX-License-Identifier: MIT
// What material_paper.cpp, material_mixed.cpp and material_helm.cpp share: a cold curve and a phase solver become a material.
#pragma once

#include "assemble_material.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/regions.hpp"
#include "bolide/eos/scaled_density.hpp"

namespace impact {

/// The thermal energy of Grover's regions from the temperature, at density ratio x = V/V0.
template <class Phase> double thermal_energy_of(const Phase& phase, double x, double density, const bolide::thermal_point<double>& at) {
  using namespace bolide::phase;
  const auto v = phase.at(x, density);
  const auto& q = phase.parameters();
  const branch::solid solid{q};
  switch (bolide::to_region(at.region)) {
  case bolide::region::mixed:
    return solid.end(v) + at.melt_fraction * v.melting * (q.dS - q.al); // lever rule
  case bolide::region::liquid:
    return branch::liquid{q}.energy(v, at.temperature);
  case bolide::region::hot_liquid:
    return branch::hot_liquid{q}.energy(v, at.temperature);
  case bolide::region::gas:
    return branch::gas{q}.energy(v, at.temperature);
  default:
    return solid.energy(v, at.temperature);
  }
}

/// The cold curve is a lattice sum: tabulated once for the process, whichever variants ask for it.
inline const bolide::cold::tabulated& aluminium_cold_curve() {
  static const bolide::cold::tabulated table{bolide::cold::cai_ye{}};
  return table;
}

/// The paper's equation of state with one of its phase solvers, its density scaled so that the body starts at the material's density.
template <class T, class Phase> chosen_material<T> assemble_grover(const bolide::data::parameter_set& set, const settings& s) {
  using namespace bolide;
  const eos::grover base{aluminium_cold_curve(), Phase{*set.phases}};
  const double unscaled = s.initial == "cold" ? base.reference_density() : eos::ambient_state(base, room_temperature).density;
  const eos::scaled_density scaled{base, set.density / unscaled};
  const auto thermal = [phase = base.phase, rho0 = base.reference_density(), factor = scaled.factor()](double density,
                                                                                                       const thermal_point<double>& at) {
    const double own = density / factor;
    return thermal_energy_of(phase, rho0 / own, own, at);
  };
  return assemble<T>(scaled, set, s, thermal);
}

} // namespace impact
