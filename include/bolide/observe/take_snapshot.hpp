// SPDX-License-Identifier: MIT
// Copies the particles of a solver into a snapshot: the columns that its materials know, in the order in which they were seeded.
//
//   take_snapshot(sim)                               everything that the pictures and measures of this room understand
//   take_snapshot(sim, {"pressure", "von_mises"})    position, velocity and mass (which every observer needs) and what is asked for
//
// A body whose material does not know a column that another one knows has zeros there.
// Cost: 0.7 us per particle for everything (one evaluation of the equation of state each), 0.2 us for the pressure alone.
#pragma once

#include "bolide/observe/selection.hpp"
#include "bolide/observe/snapshot.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

/// The columns of a snapshot for which nothing is chosen, as far as the materials know them.
inline selection everything_drawn() {
  return {"volume", "density", "energy", "pressure", "temperature", "melting_temperature", "melt_fraction", "region", "failed", "plastic_strain",
          "peak_pressure", "void_fraction"};
}

template <class Solver> snapshot take_snapshot(const Solver& sim, const selection& chosen = {}) {
  selection wanted{"position", "velocity", "mass"};
  for (const chosen_field& f : chosen.empty() ? everything_drawn() : chosen)
    if (f.name != "position" && f.name != "velocity" && f.name != "mass") wanted.push_back(f);
  const field_reader<Solver> fields(sim, std::move(wanted), !chosen.empty());

  snapshot shot;
  shot.time = sim.time();
  shot.step = sim.steps();
  shot.dimension = Solver::dim;
  shot.axisymmetric = Solver::space::hoop;
  const std::size_t total = sim.particle_count();
  std::vector<std::vector<double>> data;
  for (const auto& h : fields.headings()) data.emplace_back(total * static_cast<std::size_t>(h.components()), 0.0);

  std::size_t row = 0, body = 0;
  std::vector<std::size_t> order;
  sim.for_each_body([&](const auto& set) {
    const auto& p = set.columns;
    shot.spacing = std::max(shot.spacing, 2 * static_cast<double>(set.half_size) * sim.cell());
    order.resize(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id()[a] < p.id()[b]; });
    auto particle = particles_of<Solver>(set);
    for (const std::size_t i : order) {
      particle.move_to(i);
      shot.id.push_back(p.id()[i]);
      shot.body.push_back(static_cast<int>(body));
      fields.read(particle, body, [&](std::size_t c, int component, double x) {
        data[c][row * static_cast<std::size_t>(fields.headings()[c].components()) + static_cast<std::size_t>(component)] = x;
      });
      ++row;
    }
    shot.body_names.push_back(set.name);
    ++body;
  });
  for (std::size_t c = 0; c < data.size(); ++c) {
    const auto& h = fields.headings()[c];
    if (fields.known(c)) shot.add(h.name, h.unit, h.components(), std::move(data[c]));
  }
  return shot;
}

} // namespace bolide::observe
