// SPDX-License-Identifier: MIT
// Copies the particles of a solver into a snapshot: the columns that its materials know, in the order in which they were seeded.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/field.hpp"
#include "bolide/observe/snapshot.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

template <class Solver> snapshot take_snapshot(const Solver& sim) {
  constexpr auto dim = static_cast<std::size_t>(Solver::dim);
  snapshot shot;
  shot.time = sim.time();
  shot.step = sim.steps();
  shot.dimension = Solver::dim;
  shot.axisymmetric = Solver::space::hoop;
  const std::size_t total = sim.particle_count();
  std::vector<double> position(total * dim), velocity(total * dim);
  const char* const names[] = {"mass", "volume", "density", "energy", "pressure", "temperature", "melting_temperature", "melt_fraction", "region",
                               "failed", "plastic_strain", "peak_pressure", "void_fraction"};
  const char* const units[] = {"kg", "m3", "kg/m3", "J/kg", "Pa", "K", "K", "1", "1", "1", "1", "Pa", "1"};
  constexpr std::size_t count = std::size(names);
  std::vector<std::vector<double>> data(count);
  bool known[count] = {true, true, true, true, true};

  std::size_t row = 0;
  sim.for_each_body([&](const auto& set) {
    using columns = std::remove_cvref_t<decltype(set.columns)>;
    const auto& p = set.columns;
    shot.spacing = std::max(shot.spacing, 2 * static_cast<double>(set.half_size) * sim.cell());
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id()[a] < p.id()[b]; });
    for (const std::size_t i : order) {
      shot.id.push_back(p.id()[i]);
      shot.body.push_back(static_cast<int>(shot.body_names.size()));
      for (std::size_t d = 0; d < dim; ++d) {
        position[row * dim + d] = static_cast<double>(p.template get<field::position>(static_cast<int>(d))[i]);
        velocity[row * dim + d] = static_cast<double>(p.template get<field::velocity>(static_cast<int>(d))[i]);
      }
      ++row;
      const auto put = [&](std::size_t c, double x) {
        known[c] = true;
        data[c].resize(row - 1, 0); // bodies whose material does not know this column: zero
        data[c].push_back(x);
      };
      const double mass = static_cast<double>(p.template get<field::mass>()[i]), volume = static_cast<double>(p.template get<field::volume>()[i]);
      const double own = set.material.material_volume(p, i);
      put(0, mass);
      put(1, volume);
      put(2, mass / own);
      put(3, static_cast<double>(p.template get<field::energy>()[i]));
      put(4, static_cast<double>(p.template get<field::pressure>()[i]));
      if constexpr (std::remove_cvref_t<decltype(set.material)>::thermal) {
        const auto t = set.material.thermodynamics(p, i);
        put(5, t.temperature);
        put(6, t.melting_temperature);
        put(7, t.melt_fraction);
        put(8, t.region);
      }
      if constexpr (columns::template has<field::failed>) {
        put(9, p.template get<field::failed>()[i] > 0 ? 1 : 0);
        put(12, 1 - own / volume);
      }
      if constexpr (columns::template has<field::plastic_strain>) put(10, static_cast<double>(p.template get<field::plastic_strain>()[i]));
      if constexpr (columns::template has<field::peak_pressure>) put(11, static_cast<double>(p.template get<field::peak_pressure>()[i]));
    }
    shot.body_names.push_back(set.name);
  });
  shot.add("position", "m", Solver::dim, std::move(position));
  shot.add("velocity", "m/s", Solver::dim, std::move(velocity));
  for (std::size_t c = 0; c < count; ++c) {
    if (!known[c]) continue;
    data[c].resize(total, 0);
    shot.add(names[c], units[c], 1, std::move(data[c]));
  }
  return shot;
}

} // namespace bolide::observe
