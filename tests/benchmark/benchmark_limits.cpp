// SPDX-License-Identifier: MIT
// The ceilings of one core (limits.hpp): fused multiply-adds in the widest pack, flop/s, and read-and-write bandwidth, bytes/s, by the size of the
// array: first-level cache, second level, third level, memory. The best of the repetitions counts; others on the machine only take away.
#include "limits.hpp"
#include "run_benchmarks.hpp"

namespace {
using namespace bolide;

template <class T> void fma(benchmark::State& state) {
  constexpr long rounds = 200'000;
  for (auto _ : state) benchmark::DoNotOptimize(limits::fma_chains<T>(rounds, T(0.999), T(1e-3)));
  const double flops = limits::flops_per_round<T> * static_cast<double>(rounds);
  state.counters["flops"] = benchmark::Counter(flops, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(fma<double>);
BENCHMARK(fma<float>);

void update(benchmark::State& state) {
  std::vector<double> x(static_cast<std::size_t>(state.range(0)) / sizeof(double), 1.0);
  for (auto _ : state) {
    limits::update(x, 0.999, 1e-3);
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = benchmark::Counter(2.0 * static_cast<double>(x.size() * sizeof(double)), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(update)->Arg(16 << 10)->Arg(512 << 10)->Arg(8 << 20)->Arg(256 << 20);

void clock_rate(benchmark::State& state) {
  double rate = 0;
  for (auto _ : state) rate = std::max(rate, limits::clock_rate());
  state.counters["hertz"] = rate;
}
BENCHMARK(clock_rate)->Iterations(3);
} // namespace

int main(int argc, char** argv) { return run_benchmarks(argc, argv); }
