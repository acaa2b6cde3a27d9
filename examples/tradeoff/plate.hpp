// SPDX-License-Identifier: MIT
// Plate impact: two slabs of one material meet at speed V in a tube of four cells' radius between the axis and a slip wall.
//
// Exact (analysis::hugoniot): two shocks leave the contact plane, between them p_H, rho_H and V/2. The run ends when the shocks have crossed 0.85 of the
// slabs; nothing has come from the free ends. `length` is that of the shocked material at the end, 10 mm.
// Error: mean of three, sum V_p |q_p - q_exact(z_p)| / (Q V_shocked) over all particles p of volume V_p, with q = pressure, density, velocity and Q = p_H,
// rho_H - rho_0, V/2. It holds the width of the fronts, the scatter of the particles behind them, and what is wrong at the contact.
#pragma once

#include "problems.hpp"
#include "simulation.hpp"

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/material.hpp"
#include "bolide/solver/body.hpp"
#include "bolide/strength/none.hpp"

#include <cmath>
#include <memory>

namespace tradeoff {

inline constexpr double shocked_length = 0.01; // m

struct plate_figures {
  double speed, end, slab; // m/s, s, m
  bolide::analysis::shock_state shock;
  double density;
};
template <class Eos> plate_figures figures_of_plates(const Eos& eos, const bolide::initial_state& at, double speed) {
  plate_figures f{speed, 0, 0, bolide::analysis::hugoniot(eos, at.density, at.energy, eos.evaluate(at.density, at.energy).pressure, speed / 2), at.density};
  f.end = shocked_length / (2 * (f.shock.shock_speed - f.shock.particle_speed));
  f.slab = f.shock.shock_speed * f.end / 0.85;
  return f;
}
template <class Eos> chosen_material fluid(const Eos& eos, const bolide::initial_state& at) {
  return choose(bolide::material{eos, bolide::strength::none{}, bolide::failure::none{}}, at.density, at.energy);
}

/// The run, whichever the material.
outcome measure_plates(const settings& s, const plate_figures& f, const chosen_material& material);
problem plate_problem(std::string name, const plate_figures& f, double sound_speed_behind);

template <class Eos> problem plate_problem_of(std::string name, const Eos& eos, const bolide::initial_state& at, double speed) {
  const auto f = figures_of_plates(eos, at, speed);
  problem p = plate_problem(std::move(name), f, std::sqrt(eos.evaluate(f.shock.density, f.shock.energy).sound_speed_squared));
  p.measure = [f, material = fluid(eos, at)](const settings& s) { return measure_plates(s, f, material); };
  return p;
}

} // namespace tradeoff
