// SPDX-License-Identifier: MIT
// Follows chosen particles through a run: one row per particle and sample in a table of comma-separated values.
//
//   observe::tracer gauge("gauge.csv", {17, 4711}, 0.05 * us);
//   sim.run(6.6 * us, gauge);
//
// A particle keeps its id (the order in which it was seeded) through every sort. Samples lie at the first step on or after every multiple
// of `every` (0: after each step), and at the end. Columns: time, step, id, body, position, velocity, density (of the material,
// without the void), energy, pressure, and the temperature (empty where the equation of state has none). A particle that left through
// the box has no further rows. A row is on disk as soon as it is written.
// Cost: a sample looks through all ids once, O(particles); between samples one comparison per step.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/observe/csv.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

class tracer {
 public:
  tracer(std::filesystem::path path, std::vector<std::uint32_t> ids, double every = 0)
      : path_(std::move(path)), ids_(std::move(ids)), every_(every) {
    require(!ids_.empty(), "particles of the tracer " + path_.string(), 0, "at least 1");
    require(every >= 0, "interval of the tracer " + path_.string(), every, "non-negative", "s");
    std::sort(ids_.begin(), ids_.end());
    const auto twice = std::adjacent_find(ids_.begin(), ids_.end());
    require(twice == ids_.end(), "particle of the tracer " + path_.string(), twice == ids_.end() ? 0 : *twice, "named once");
  }

  template <class Solver> void watch(const Solver& sim) {
    if (!table_) open(sim);
    if (sim.steps() == last_step_ || sim.time() < next_ * (1 - 1e-12)) return;
    sample(sim);
    while (every_ > 0 && next_ <= sim.time() * (1 + 1e-12)) next_ += every_;
  }
  template <class Solver> void finish(const Solver& sim) {
    if (sim.steps() != last_step_) sample(sim);
  }
  std::size_t rows() const { return table_ ? table_->rows() : 0; }

 private:
  template <class Solver> void open(const Solver& sim) {
    require(ids_.back() < sim.particle_count(), "particle of the tracer " + path_.string(), ids_.back(),
            "below the number of particles, " + std::to_string(sim.particle_count()));
    using names = std::vector<std::string>;
    const names axes = Solver::space::hoop ? names{"r", "z"} : names{"x", "y", "z"};
    std::vector<std::string> header{"time (s)", "step", "id", "body"};
    for (std::size_t d = 0; d < Solver::dim; ++d) header.push_back(axes[d] + " (m)");
    for (std::size_t d = 0; d < Solver::dim; ++d) header.push_back("v_" + axes[d] + " (m/s)");
    for (const char* name : {"density (kg/m3)", "energy (J/kg)", "pressure (Pa)", "temperature (K)"}) header.push_back(name);
    table_.emplace(path_, header);
  }

  template <class Solver> void sample(const Solver& sim) {
    last_step_ = sim.steps();
    sim.for_each_body([&](const auto& set) {
      const auto& p = set.columns;
      for (std::size_t i = 0; i < p.size(); ++i)
        if (std::binary_search(ids_.begin(), ids_.end(), p.id()[i])) row(sim, set, i);
    });
  }

  template <class Solver, class Set> void row(const Solver& sim, const Set& set, std::size_t i) {
    const auto& p = set.columns;
    std::vector<csv_cell> cells{sim.time(), sim.steps(), p.id()[i], set.name};
    for (int d = 0; d < Solver::dim; ++d) cells.emplace_back(p.template get<field::position>(d)[i]);
    for (int d = 0; d < Solver::dim; ++d) cells.emplace_back(p.template get<field::velocity>(d)[i]);
    cells.emplace_back(static_cast<double>(p.template get<field::mass>()[i]) / set.material.material_volume(p, i));
    cells.emplace_back(p.template get<field::energy>()[i]);
    cells.emplace_back(p.template get<field::pressure>()[i]);
    if constexpr (std::remove_cvref_t<decltype(set.material)>::thermal) cells.emplace_back(set.material.thermodynamics(p, i).temperature);
    else cells.emplace_back("");
    table_->row(cells);
  }

  std::filesystem::path path_;
  std::vector<std::uint32_t> ids_; // ascending
  double every_, next_ = 0;        // s
  long last_step_ = -1;
  std::optional<csv_table> table_; // opened at the first look, when the number of axes is known
};

} // namespace bolide::observe
