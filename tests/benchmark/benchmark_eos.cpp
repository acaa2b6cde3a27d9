// SPDX-License-Identifier: MIT
// Cost of one evaluation of an equation of state, in ns per state, for double, float and the widest pack of each. 4096 states between
// 0.75 and 2 times the reference density and 0.02 and 8 MJ/kg, in an order that mixes the phases within a pack, as a debris cloud does.
#include "run_benchmarks.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/eos/tillotson.hpp"

#include <random>
#include <vector>

namespace {
using namespace bolide;

template <class Eos, class V> void evaluate(benchmark::State& state, const Eos& eos) {
  using T = scalar_t<V>;
  constexpr std::size_t n = 4096;
  std::vector<T> rho(n), e(n), p(n), c2(n);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> ratio(0.75, 2), energy(0.02e6, 8e6);
  for (std::size_t i = 0; i < n; ++i) {
    rho[i] = static_cast<T>(ratio(random) * eos.reference_density());
    e[i] = static_cast<T>(energy(random));
  }
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; i += static_cast<std::size_t>(lane_width<V>)) {
      const auto at = eos.evaluate(load<V>(rho.data() + i), load<V>(e.data() + i));
      store(at.pressure, p.data() + i);
      store(at.sound_speed_squared, c2.data() + i);
      if constexpr (ThermalEquationOfState<Eos, V>) benchmark::DoNotOptimize(at.temperature); // else the compiler would leave it out
    }
    benchmark::DoNotOptimize(p.data());
    benchmark::DoNotOptimize(c2.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_state"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Eos> void add(const std::string& name, const Eos& eos) {
  benchmark::RegisterBenchmark((name + "/double").c_str(), [eos](benchmark::State& s) { evaluate<Eos, double>(s, eos); });
  benchmark::RegisterBenchmark((name + "/pack_double").c_str(), [eos](benchmark::State& s) { evaluate<Eos, native_pack<double>>(s, eos); });
  benchmark::RegisterBenchmark((name + "/float").c_str(), [eos](benchmark::State& s) { evaluate<Eos, float>(s, eos); });
  benchmark::RegisterBenchmark((name + "/pack_float").c_str(), [eos](benchmark::State& s) { evaluate<Eos, native_pack<float>>(s, eos); });
}
} // namespace

int main(int argc, char** argv) {
  // Exact lattice sum, exact binding curve, and tables: of the cold curve, and of the whole surface.
  const cold::tabulated table{cold::cai_ye{}};
  const eos::grover mixed{table, phase::mixed{}};
  const eos::grover helm{table, phase::helm{}};
  add("mixed_of_cold_table", mixed);
  add("paper_of_cold_table", eos::grover{table, phase::paper{}});
  add("helm_of_cold_table", helm);
  add("helm_of_rose", eos::grover{cold::rose{}, phase::helm{}});
  add("helm_of_lattice_sum", eos::grover{cold::cai_ye{}, phase::helm{}});
  add("mixed_tabulated", eos::tabulated{mixed});
  add("helm_tabulated", eos::tabulated{helm});
  add("reference", eos::reference{});
  add("reference_tabulated", eos::tabulated{eos::reference{}});
  add("mie_grueneisen", eos::mie_grueneisen{});
  add("mie_grueneisen_fading", eos::mie_grueneisen({.fading_expansion = true}));
  add("mie_grueneisen_with_temperature", eos::isentrope_temperature{eos::mie_grueneisen{}});
  add("tillotson", eos::tillotson{});
  add("tillotson_with_temperature", eos::isentrope_temperature{eos::tillotson{}});
  add("tillotson_tabulated", eos::tabulated{eos::tillotson{}});
  add("jwl", eos::jwl{{.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.30}}); // TNT
  add("ideal_gas", eos::ideal_gas{});
  add("stiffened_gas", eos::stiffened_gas{});
  return run_benchmarks(argc, argv);
}
