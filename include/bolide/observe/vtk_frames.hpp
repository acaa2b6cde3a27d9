// SPDX-License-Identifier: MIT
// An observer that writes ParaView frames of chosen fields while a run goes on.
//
//   observe::vtk_frames movie("out/vtk", 0.2 * us, {"pressure", "von_mises", "temperature"});
//   sim.run(6.6 * us, movie);
//
// Frames lie at the first step on or after every multiple of the period and at the end, or at a list of times; they and the list of them
// (observe/vtk.hpp) are whole at any moment. Only the chosen fields are computed and written, beside position, velocity, mass, id and body; none
// chosen: all that take_snapshot knows. A run that stops writes the state in which it stopped as a last frame.
#pragma once

#include "bolide/observe/every.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/observe/vtk.hpp"

#include <filesystem>
#include <string>
#include <utility>

namespace bolide::observe {

class vtk_frames {
 public:
  vtk_frames(std::filesystem::path folder, schedule when, selection chosen = {}, std::string name = "particles", vtk_options options = {})
      : series_(std::move(folder), std::move(name), std::move(options)), when_(std::move(when)), chosen_(std::move(chosen)) {}

  template <class Solver> void watch(const Solver& sim) {
    if (sim.steps() != last_step_ && when_.due(sim.time())) write(sim);
  }
  template <class Solver> void finish(const Solver& sim) {
    if (sim.steps() != last_step_ && when_.with_end()) write(sim);
  }
  template <class Solver> void stopped(const Solver& sim, const std::string&) {
    if (sim.steps() != last_step_) write(sim);
  }
  std::size_t frames() const { return series_.frames(); }
  std::string last_output() const { return series_.last_frame().string(); }
  /// For checkpoints (concepts/archive.hpp).
  template <class A> void archive(A& a) {
    a.value("series", series_);
    a.value("when", when_);
    a.value("last_step", last_step_);
  }

 private:
  template <class Solver> void write(const Solver& sim) {
    series_.write(take_snapshot(sim, chosen_));
    last_step_ = sim.steps();
  }
  vtk_series series_;
  schedule when_;
  selection chosen_;
  long last_step_ = -1;
};

} // namespace bolide::observe
