// SPDX-License-Identifier: MIT
// Follows chosen particles through a run: one row per particle and sample in a table of comma-separated values.
//
//   observe::tracer gauge("gauge.csv", {17, 4711}, 0.05 * us);
//   observe::tracer more("more.csv", {17}, 0.0, {"pressure", "von_mises", "plastic_strain"});
//   sim.run(6.6 * us, gauge, more);
//
// A particle keeps its id (the order in which it was seeded) through every sort. Samples lie at the first step on or after every multiple
// of `when` (0: after each step) and at the end, or at a list of times. Columns: time, step, id, body, position, velocity, and the chosen
// fields (observe/selection.hpp); if none are chosen density (of the material, without the void), energy, pressure, temperature. What the
// material of a particle does not know is an empty cell. A particle that left through
// the box has no further rows. A row is on disk as soon as it is written.
// Cost: a sample looks through all ids once, O(particles); between samples one comparison per step.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/observe/csv.hpp"
#include "bolide/observe/every.hpp"
#include "bolide/observe/selection.hpp"

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
  tracer(std::filesystem::path path, std::vector<std::uint32_t> ids, schedule when = 0.0, selection chosen = {})
      : path_(std::move(path)), ids_(std::move(ids)), when_(std::move(when)), chosen_(std::move(chosen)) {
    require(!ids_.empty(), "particles of the tracer " + path_.string(), 0, "at least 1");
    std::sort(ids_.begin(), ids_.end());
    const auto twice = std::adjacent_find(ids_.begin(), ids_.end());
    require(twice == ids_.end(), "particle of the tracer " + path_.string(), twice == ids_.end() ? 0 : *twice, "named once");
  }

  template <class Solver> void watch(const Solver& sim) {
    if (!table_) open(sim);
    if (sim.steps() != last_step_ && when_.due(sim.time())) sample(sim);
  }
  template <class Solver> void finish(const Solver& sim) {
    if (sim.steps() != last_step_ && when_.with_end()) sample(sim);
  }
  std::size_t rows() const { return table_ ? table_->rows() : 0; }
  /// For the message of a run that stops.
  std::string last_output() const { return rows() > 0 ? path_.string() : ""; }
  /// For checkpoints (concepts/archive.hpp): the table goes on where it stood, without a row twice.
  template <class A> void archive(A& a) {
    if (table_ && !A::reading) from_ = table_->mark();
    a.value("table", from_);
    a.value("last_step", last_step_);
    a.value("when", when_);
    if (A::reading) table_.reset();
  }

 private:
  template <class Solver> field_reader<Solver> reader(const Solver& sim) const {
    selection all{"position", "velocity"};
    const selection rest = chosen_.empty() ? selection{"density", "energy", "pressure", "temperature"} : chosen_;
    for (const chosen_field& f : rest)
      if (f.name != "position" && f.name != "velocity") all.push_back(f);
    return {sim, std::move(all), !chosen_.empty()};
  }

  template <class Solver> void open(const Solver& sim) {
    require(from_.rows > 0 || ids_.back() < sim.particle_count(), "particle of the tracer " + path_.string(), ids_.back(),
            "below the number of particles, " + std::to_string(sim.particle_count()));
    std::vector<std::string> header{"time (s)", "step", "id", "body"};
    for (std::string& name : reader(sim).column_names()) header.push_back(std::move(name));
    table_.emplace(path_, header, from_);
  }

  template <class Solver> void sample(const Solver& sim) {
    last_step_ = sim.steps();
    const auto fields = reader(sim);
    std::size_t body = 0;
    sim.for_each_body([&](const auto& set) {
      auto particle = particles_of<Solver>(set);
      for (std::size_t i = 0; i < set.columns.size(); ++i) {
        if (!std::binary_search(ids_.begin(), ids_.end(), set.columns.id()[i])) continue;
        particle.move_to(i);
        std::vector<csv_cell> cells{sim.time(), sim.steps(), set.columns.id()[i], set.name};
        std::vector<csv_cell> values(table_->columns() - cells.size(), csv_cell(""));
        fields.read(particle, body, [&](std::size_t c, int component, double x) {
          values[fields.first_cell(c) + static_cast<std::size_t>(component)] = x;
        });
        cells.insert(cells.end(), values.begin(), values.end());
        table_->row(cells);
      }
      ++body;
    });
  }

  std::filesystem::path path_;
  std::vector<std::uint32_t> ids_; // ascending
  schedule when_;
  selection chosen_;
  long last_step_ = -1;
  csv_mark from_; // of a checkpoint
  std::optional<csv_table> table_; // opened at the first look, when the number of axes is known
};

} // namespace bolide::observe
