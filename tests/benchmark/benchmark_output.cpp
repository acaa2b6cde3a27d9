// SPDX-License-Identifier: MIT
// Cost of output, in ns per particle, and its size: a snapshot of 20 and of 58 thousand particles, and what is made of one: a VTK file, a CSV table, a
// picture of 1100 pixels (drawn, not compressed). Files go to the temporary folder and replace the one before, flushed to the disk as in a run.
#include "run_benchmarks.hpp"

#include "block_scene.hpp"

#include "bolide/observe/picture.hpp"
#include "bolide/observe/snapshot_csv.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/observe/vtk.hpp"

#include <filesystem>

namespace {
using namespace bolide;

auto simulation(const benchmark::State& state) {
  auto sim = scenes::composed<double, shape::linear>(scenes::block<2>{static_cast<int>(state.range(0))});
  sim.step();
  return sim;
}
void per_particle(benchmark::State& state, std::size_t particles) {
  state.counters["per_particle"] =
      benchmark::Counter(static_cast<double>(particles), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void snapshot(benchmark::State& state) {
  const auto sim = simulation(state);
  for (auto _ : state) benchmark::DoNotOptimize(observe::take_snapshot(sim).time);
  per_particle(state, sim.particle_count());
}
/// write(path, snapshot) makes a file.
template <class Write> void file(benchmark::State& state, const char* name, Write&& write) {
  const auto shot = observe::take_snapshot(simulation(state));
  const auto path = std::filesystem::temp_directory_path() / name;
  for (auto _ : state) write(path, shot);
  per_particle(state, shot.id.size());
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(path)) / static_cast<double>(shot.id.size());
  std::filesystem::remove(path);
}
void vtk(benchmark::State& state) {
  file(state, "bolide_benchmark.vtu", [](const auto& path, const auto& shot) { observe::write_vtu(path, shot); });
}
void csv(benchmark::State& state) {
  file(state, "bolide_benchmark.csv", [](const auto& path, const auto& shot) { observe::write_csv(path, shot); });
}
void picture(benchmark::State& state) {
  const auto shot = observe::take_snapshot(simulation(state));
  const auto window = observe::cloud_window(shot);
  for (auto _ : state) benchmark::DoNotOptimize(observe::draw_panel({&shot, observe::paint::pressure(), "pressure"}, window).width());
  per_particle(state, shot.id.size());
}
BENCHMARK(snapshot)->Arg(71)->Arg(120)->Unit(benchmark::kMillisecond); // 20 thousand and the paper's 58 thousand particles
BENCHMARK(vtk)->Arg(71)->Arg(120)->Unit(benchmark::kMillisecond);
BENCHMARK(csv)->Arg(71)->Arg(120)->Unit(benchmark::kMillisecond);
BENCHMARK(picture)->Arg(71)->Arg(120)->Unit(benchmark::kMillisecond);
} // namespace

int main(int argc, char** argv) { return run_benchmarks(argc, argv); }
