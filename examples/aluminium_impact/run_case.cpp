// SPDX-License-Identifier: MIT
// One run from the first step to the files: history.csv row by row, ParaView frames, then summary.json and the pictures.
#include "interrupt.hpp"
#include "materials.hpp"
#include "options.hpp"
#include "outcome.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/observe/csv.hpp"
#include "bolide/observe/progress.hpp"
#include "bolide/observe/vtk.hpp"
#if defined(BOLIDE_HDF5)
#include "bolide/hdf5/checkpoint.hpp"
#endif

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace impact {
namespace {

using namespace bolide;
namespace fs = std::filesystem;

constexpr int history_rows = 200;

/// The columns of history.csv.
const std::vector<std::string> header{"time (s)",
                                      "step",
                                      "dt (s)",
                                      "cause",
                                      "particles",
                                      "kinetic (J)",
                                      "internal (J)",
                                      "cold (J)",
                                      "thermal (J)",
                                      "elastic_shear (J)",
                                      "transfer (J)",
                                      "returned_heat (J)",
                                      "work_mismatch (J)",
                                      "left (J)",
                                      "plastic_work (J)",
                                      "viscous_heating (J)",
                                      "failure_release (J)",
                                      "drift (1)",
                                      "residual (1)",
                                      "momentum_r (kg m/s)",
                                      "momentum_z (kg m/s)",
                                      "momentum_z_left (kg m/s)",
                                      "mass (kg)",
                                      "mass_left (kg)",
                                      "least_pressure (Pa)",
                                      "most_pressure (Pa)",
                                      "most_speed (m/s)",
                                      "most_temperature (K)",
                                      "least_density (kg/m3)",
                                      "most_density (kg/m3)",
                                      "floors (1)"};

/// history.csv: one row every two-hundredth of the run.
class history {
public:
  explicit history(fs::path path) : path_(std::move(path)) {}

  void row(simulation& sim) {
    if (!table_) table_.emplace(path_, header, from_);
    const ledger& l = sim.energies();
    const census c = sim.count();
    std::uint64_t floors = 0;
    for (const auto n : l.floors.count) floors += n;
    table_->row({sim.time(),
                 sim.steps(),
                 sim.dt(),
                 bolide::name(sim.cause()),
                 sim.particle_count(),
                 l.now.kinetic,
                 l.now.internal,
                 c.cold,
                 c.thermal,
                 c.shear,
                 l.transfer,
                 l.returned_heat,
                 l.work_mismatch,
                 l.left,
                 l.plastic_work,
                 l.viscous_heating,
                 l.failure_release,
                 l.drift(),
                 l.residual(),
                 l.momentum_now[0],
                 l.momentum_now[1],
                 l.momentum_left[1],
                 c.mass,
                 l.mass_left,
                 c.least_pressure,
                 c.most_pressure,
                 c.most_speed,
                 c.most_temperature,
                 c.least_density,
                 c.most_density,
                 floors});
    step_ = sim.steps();
  }
  void last_row(simulation& sim) {
    if (sim.steps() != step_) row(sim);
  }
  /// For checkpoints: the table goes on where it stood.
  template <class A> void archive(A& a) {
    if (table_) from_ = table_->mark();
    a.value("table", from_);
    a.value("step", step_);
  }

private:
  fs::path path_;
  observe::csv_mark from_;                  // of a checkpoint
  std::optional<observe::csv_table> table_; // opened at the first row
  long step_ = -1;
};

/// ParaView frames at the start, at even times and at the end. A frame is taken at the first step at or after its time: steps are not cut.
class frames {
public:
  frames(const settings& s, const fs::path& folder) : wanted_(!s.frames || *s.frames > 0), series_(folder, "particles", options(s)) {
    interval_ = s.frames && *s.frames > 0 ? s.until / *s.frames : 0.6 * unit::us;
  }
  void look(const simulation& sim, bool at_end = false) {
    if (!wanted_ || sim.steps() == step_ || !(at_end || sim.time() >= static_cast<double>(next_) * interval_ * (1 - 1e-12))) return;
    series_.write(sim.snapshot());
    step_ = sim.steps();
    while (static_cast<double>(next_) * interval_ * (1 - 1e-12) <= sim.time()) ++next_;
  }
  /// For checkpoints: the numbering goes on.
  template <class A> void archive(A& a) {
    a.value("series", series_);
    a.value("next", next_);
    a.value("step", step_);
  }

private:
  static observe::vtk_options options(const settings& s) {
    observe::vtk_options o;
    if (s.fields == "all") return o;
    std::string_view rest = s.fields;
    for (;;) {
      const auto comma = rest.find(',');
      o.columns.emplace_back(rest.substr(0, comma));
      if (comma == rest.npos) return o;
      rest.remove_prefix(comma + 1);
    }
  }
  bool wanted_;
  observe::vtk_series series_;
  double interval_ = 0;
  long next_ = 0, step_ = -1;
};

/// When is a checkpoint due? After every so many steps, or at the first step past each multiple of a time.
class checkpoint_clock {
public:
  checkpoint_clock(const settings& s, const simulation& sim) : every_(s.checkpoint_every), last_(sim.time()) {}
  bool due(const simulation& sim) {
    if (!every_) return false;
    const double before = std::exchange(last_, sim.time());
    if (every_->steps > 0) return sim.steps() % every_->steps == 0;
    return std::floor(before / every_->time) < std::floor(sim.time() / every_->time);
  }

private:
  std::optional<checkpoint_interval> every_;
  double last_; // s
};

/// May a run go on with another value of this setting? It changes nothing of what was computed so far.
[[maybe_unused]] bool may_change(std::string_view setting) {
  for (const auto* name : {"until", "threads", "step-cap", "frames", "fields", "pictures"})
    if (setting == name) return true;
  return false;
}

template <class State> void keep([[maybe_unused]] const fs::path& folder, [[maybe_unused]] State& state) {
#if defined(BOLIDE_HDF5)
  hdf5::save(folder / "checkpoint.h5", state);
#endif
}
template <class State> void go_on([[maybe_unused]] const settings& s, [[maybe_unused]] State& state) {
#if defined(BOLIDE_HDF5)
  try {
    hdf5::restore(s.restart, state);
  } catch (const hdf5::checkpoint_error& e) { throw bad_parameter(std::string("--restart: ") + e.what()); }
#endif
}

/// The step loop. Fills status and message.
void advance(simulation& sim, const settings& s, const fs::path& folder, outcome& o) {
  history table(folder / "history.csv");
  frames paraview(s, folder);
  observe::progress progress(s.until);
  int rows = 0;
  const auto state = [&](auto& a) { // what a checkpoint holds
    a.group("settings", [&] {
      for (const auto& [name, text] : echo(s))
        if (!may_change(name)) a.same(name, text);
    });
    a.value("simulation", sim);
    a.value("history", table);
    a.value("frames", paraview);
    a.value("rows", rows);
    a.value("steps_by_cause", o.steps_by_cause);
  };
  if (s.restart.empty()) {
    table.row(sim);
    paraview.look(sim);
  } else {
    go_on(s, state);
    std::cerr << "aluminium_impact: goes on from step " << sim.steps() << ", " << readable(sim.time(), quantity::dimension::time) << "\n";
    progress(sim.time(), sim.steps());
  }
  checkpoint_clock checkpoint(s, sim);
  try {
    // The last step ends at `until` but for the rounding of its length, which in float must not ask for a step of its own.
    while (s.until - sim.time() > 1e-6 * sim.dt() && !interrupted()) {
      sim.step(s.until - sim.time());
      ++o.steps_by_cause[static_cast<std::size_t>(sim.cause())];
      progress(sim.time(), sim.steps(), std::string("dt by ") + bolide::name(sim.cause()));
      if (sim.time() * history_rows >= s.until * (rows + 1)) {
        rows = static_cast<int>(sim.time() / s.until * history_rows);
        table.row(sim);
      }
      paraview.look(sim);
      if (checkpoint.due(sim)) keep(folder, state);
    }
    if (interrupted() && s.checkpoint_every) keep(folder, state);
    if (interrupted()) o.status = run_status::interrupted, o.message = "interrupted by signal " + std::to_string(interrupted());
  } catch (const stopped& stop) {
    o.status = run_status::stopped;
    o.message = stop.what();
  }
  progress.finish();
  table.last_row(sim);
  paraview.look(sim, true);
}

/// What must hold of every run that came to its end: checked, and said.
void check_outcome(outcome& o) {
  char text[240];
  const auto say = [&](bool holds) { (holds ? o.checks : o.failed_checks).emplace_back(text); };
  const double residual = std::abs(o.energies.residual()), bound = o.used.precision == "float" ? 1e-4 : 1e-9;
  std::snprintf(text, sizeof text, "the energy ledger closes: residual %.1e of the initial energy, bound %.0e", residual, bound);
  say(residual <= bound);
  const settings d;
  const bool lattice = o.used.diameter == d.diameter && o.used.thickness == d.thickness && o.used.plate_radius == d.plate_radius &&
                       o.used.spacing == d.spacing && !o.used.coarse_beyond;
  if (lattice) {
    std::snprintf(text, sizeof text, "the lattice has %zu particles, expected 58010", o.particles);
    say(o.particles == 58010);
  }
}

} // namespace

outcome run_case(const settings& s, const fs::path& folder, bool draw) {
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  outcome o;
  o.used = s;
  const auto sim = make_simulation(s);
  sim->start();
  o.reference_pressure = contact_line_reference(s.projectile, s.target, s.velocity);
  o.first = sim->count();
  o.particles = sim->particle_count();
  o.geometric_mass = sim->geometric_mass();
  o.threads = sim->threads();
  std::cerr << "aluminium_impact: " << title(s) << ", " << s.eos << "; " << s.shape << " " << s.transfer << " " << s.scheme << " "
            << s.precision << "; " << o.particles << " particles, " << o.threads << (o.threads == 1 ? " thread\n" : " threads\n");

  if (const double short_by = 1 - o.first.mass / o.geometric_mass; std::abs(short_by) > 0.03)
    std::cerr << "aluminium_impact: the particles' mass is " << std::lround(100 * short_by)
              << " % less than that of the shapes: take a spacing that divides the thickness of the plate\n";

  advance(*sim, s, folder, o);

  o.steps = sim->steps();
  o.simulated = sim->time();
  o.solver = sim->solver_seconds();
  o.particle_steps = static_cast<double>(sim->particle_steps());
  o.energies = sim->energies();
  o.final = sim->count();
  o.last = sim->snapshot();
  observe::impact_scene scene;
  scene.plate_rear_z = s.thickness;
  scene.impact_speed = s.velocity;
  scene.reference_pressure = o.reference_pressure;
  o.cloud = observe::debris_cloud(o.last, scene);
  if (o.status == run_status::done) check_outcome(o);
  o.wall = seconds();
  write_summary(folder / "summary.json", o);
  if (!draw || s.pictures == "none") return o;
  try {
    write_pictures(folder, o);
  } catch (const bad_parameter& e) { // a run that stopped may leave nothing that can be drawn
    if (o.status == run_status::done) throw;
    std::cerr << "aluminium_impact: no pictures: " << e.what() << "\n";
  }
  o.wall = seconds();
  write_summary(folder / "summary.json", o);
  return o;
}

int exit_code_of(const outcome& o) {
  if (o.status == run_status::interrupted) return 128 + interrupted();
  if (o.status == run_status::stopped) return 3;
  return o.failed_checks.empty() ? 0 : 1;
}

} // namespace impact
