// SPDX-License-Identifier: MIT
// Checkpoints: the state of a run in one HDF5 file, from which it goes on to the same bits as if it had never stopped.
//
//   const auto state = [&](auto& a) { a.value("simulation", sim); a.value("gauge", gauge); };   // the solver, and observers that keep a state
//   if (restart) hdf5::restore("run.h5", state);
//   sim.run(6.6 * us, gauge, observe::every{0.5 * us, [&](const auto&) { hdf5::save("run.h5", state); }});
//
// save   writes aside, flushes to the disk and renames (observe/durable_file.hpp): whenever the program is killed, run.h5 is a whole
//        checkpoint. The one before stays as run_previous.h5. Throws observe::output_error and leaves both as they were.
// restore   takes a solver that was composed as the one that was saved, before or after its first step. A file that is damaged, foreign,
//        of another version or of another composition is refused with a checkpoint_error that says what is there and what is here; the solver must not be used then.
// Saving changes nothing of a run. Cost: bytes per particle are those of its columns, and of its block ranges; see docs/checkpoint.md.
#pragma once

#include "bolide/hdf5/archive.hpp"
#include "bolide/observe/durable_file.hpp"

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace bolide::hdf5 {

/// Where save() keeps the checkpoint before the last one: run.h5 -> run_previous.h5.
inline std::filesystem::path previous(const std::filesystem::path& path) {
  return path.parent_path() / (path.stem().string() + "_previous" + path.extension().string());
}

namespace detail {
/// The state is a list of entries, or one object with archive().
template <class A, class State> void list(A& a, State& state) {
  if constexpr (requires { state.archive(a); }) a.value("state", state);
  else state(a);
}
} // namespace detail

template <class State> void save(const std::filesystem::path& path, State&& state) {
  observe::make_folder_of(path);
  try {
    writer a(observe::aside(path));
    detail::list(a, state);
    a.finish();
  } catch (const observe::output_error&) {
    std::error_code ignored;
    std::filesystem::remove(observe::aside(path), ignored);
    throw;
  }
  observe::replace_keeping_previous(path, previous(path));
}

template <class State> void restore(const std::filesystem::path& path, State&& state) {
  reader a(path);
  detail::list(a, state);
  a.finish();
}

} // namespace bolide::hdf5
