// SPDX-License-Identifier: MIT
// Cost of a sort, in ns per particle: blocks rebuilt and 22 columns of a default composition reordered, after the block has moved by one
// cell and every particle by up to a quarter of a cell at random. A run sorts when a particle has drifted out of its block's margin.
#include "run_benchmarks.hpp"

#include "bolide/solver/particle_set.hpp"
#include "bolide/space/axisymmetric.hpp"

#include <random>

namespace {
using namespace bolide;

struct linear_support {
  static constexpr int support = 2;
  static constexpr double offset = 0;
};
struct no_material {};
using stored = fields<field::mass, field::position, field::velocity, field::carrying_velocity, field::volume, field::energy,
                      field::pressure, field::deviator, field::plastic_strain, field::failed, field::material_volume, field::viscous_pressure,
                      field::sound_speed, field::affine_velocity>;

template <class T> void sort(benchmark::State& state) {
  const double h = 1e-4;
  particle_set<T, space::axisymmetric, linear_support, no_material, stored> set{"block", {}, T(0.25), 0, 0, {}, {}, {}};
  const auto n = static_cast<int>(state.range(0));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto k = set.columns.append(static_cast<std::uint32_t>(i * n + j));
      set.columns.template get<field::position>(0)[k] = static_cast<T>((i + 0.5) * h / 2);
      set.columns.template get<field::position>(1)[k] = static_cast<T>((j + 0.5) * h / 2);
    }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.25 * h, 0.25 * h);
  grid::block_map<2> blocks;
  double sign = 1;
  for (auto _ : state) {
    state.PauseTiming();
    for (std::size_t k = 0; k < set.columns.size(); ++k) {
      T& r = set.columns.template get<field::position>(0)[k];
      r = std::abs(r + static_cast<T>(shift(random)));
      set.columns.template get<field::position>(1)[k] += static_cast<T>(sign * h + shift(random));
    }
    sign = -sign;
    state.ResumeTiming();
    std::vector<grid::cell_index<2>> occupied;
    set.collect_blocks(h, occupied);
    blocks.rebuild(std::move(occupied));
    set.sort(blocks, h);
  }
  const auto particles = static_cast<double>(set.columns.size());
  state.counters["per_particle"] =
      benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(sort<double>)->Arg(141)->Arg(240); // 20 thousand and the paper's 58 thousand particles
BENCHMARK(sort<float>)->Arg(141)->Arg(240);
} // namespace

int main(int argc, char** argv) { return run_benchmarks(argc, argv); }
