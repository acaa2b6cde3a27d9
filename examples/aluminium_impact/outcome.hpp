// SPDX-License-Identifier: MIT
// What is known of a run when it is over, and how it is written.
#pragma once

#include "settings.hpp"
#include "simulation.hpp"

#include "bolide/core/quantity.hpp"
#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/snapshot.hpp"
#include "bolide/solver/ledger.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace impact {

enum class run_status { done, interrupted, stopped };
constexpr const char* name(run_status s) {
  constexpr const char* names[] = {"done", "interrupted", "stopped"};
  return names[static_cast<int>(s)];
}

struct outcome {
  settings used;
  run_status status = run_status::done;
  std::string message; // why it stopped
  bolide::observe::snapshot last;
  bolide::observe::debris_cloud cloud;
  bolide::ledger energies;
  census first, final;                      // at the start and at the end
  double reference_pressure = std::nan(""); // Pa, contact_line_reference()
  std::size_t particles = 0;                // at the start
  long steps = 0;
  double simulated = 0, wall = 0, solver = 0; // s
  double particle_steps = 0, geometric_mass = 0;
  int threads = 1;
  std::array<long, 6> steps_by_cause{};   // index: bolide::step_cause
  std::vector<std::string> failed_checks; // sentences
  std::vector<std::string> checks;        // sentences of what held
  std::vector<std::filesystem::path> pictures;

  double ns_per_particle_step() const { return particle_steps > 0 ? 1e9 * solver / particle_steps : 0; }
  /// Everything that is a number of the physics: what ensembles average and compare tables show.
  std::vector<bolide::observe::measure> measures() const;
};

/// What the paper prints: length and width in mm.
struct printed_cloud {
  double length, width;
};
inline constexpr printed_cloud experiment{37.7, 34.2};
/// The paper's row for this equation of state.
printed_cloud printed_for(const std::string& eos);
/// Is it the paper's shot, whatever the resolution and the models?
bool is_the_papers_case(const settings& s);

/// "9.5 mm": a quantity for people.
std::string readable(double si, bolide::quantity::dimension d);
/// "9.5 mm aluminium sphere at 6.64 km/s on 2.2 mm aluminium".
std::string title(const settings& s);

/// Writes summary.json whole.
void write_summary(const std::filesystem::path& path, const outcome& o);

/// Draws and writes the pictures of a run, and notes their paths.
void write_pictures(const std::filesystem::path& folder, outcome& o);
/// One sheet: the clouds of several runs by phase, with their outlines.
void write_comparison_picture(const std::filesystem::path& path, const std::vector<outcome>& runs);

/// Runs one scene with all its files in `folder`; `draw`: pictures too. Throws bad_parameter before anything is written.
outcome run_case(const settings& s, const std::filesystem::path& folder, bool draw = true);

/// The table on standard output.
void print_table(const outcome& o);

/// Mean and standard deviation (of one member; NaN for a single run) of a measure over the members of an ensemble.
struct statistic {
  std::string name, unit;
  double mean, deviation;
};
std::vector<statistic> statistics(const std::vector<outcome>& members);
/// Writes compare.json or ensemble.json whole: one group of members per equation of state.
void write_statistics(const std::filesystem::path& path, const std::vector<std::vector<outcome>>& groups);

/// Several runs: every equation of state (--compare), every seed (--ensemble), or both. Returns the exit code.
int run_many(const settings& s);

/// The exit code that this run alone deserves.
int exit_code_of(const outcome& o);

} // namespace impact
