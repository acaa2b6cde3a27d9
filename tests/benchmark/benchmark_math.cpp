// SPDX-License-Identifier: MIT
// Cost and error of the elementary functions of a pack (core/math.hpp) beside the standard library's, double: per_value in seconds, error as
// the largest relative deviation from long double over the arguments that are timed. log of 1e-5 to 1e5 evenly in the logarithm, exp of -10
// to 10, pow of the same arguments as log with |y log x| <= 10.
#include "run_benchmarks.hpp"

#include "bolide/core/math.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace bolide;
using real = long double;

struct log_of {
  template <class V> static V value(V x, V) { return log(x); }
};
struct exp_of {
  template <class V> static V value(V, V z) { return exp(z); }
};
struct pow_of {
  template <class V> static V value(V x, V y) { return pow(x, y); }
};

/// x, and z (exp) or y with y log x = z (pow).
template <class F> std::vector<double> second_argument(const std::vector<double>& x, const std::vector<double>& z) {
  std::vector<double> y = z;
  if constexpr (std::is_same_v<F, pow_of>)
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = z[i] / std::log(x[i]);
  return y;
}

template <class F, class V> void evaluate(benchmark::State& state) {
  constexpr std::size_t n = 4096;
  std::vector<double> x(n), z(n), r(n);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> log_x(std::log(1e-5), std::log(1e5)), power(-10, 10);
  for (std::size_t i = 0; i < n; ++i) x[i] = std::exp(log_x(random)), z[i] = power(random);
  const std::vector<double> y = second_argument<F>(x, z);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; i += static_cast<std::size_t>(lane_width<V>))
      store(F::value(load<V>(x.data() + i), load<V>(y.data() + i)), r.data() + i);
    benchmark::DoNotOptimize(r.data());
    benchmark::ClobberMemory();
  }
  double error = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const real right = std::is_same_v<F, log_of>   ? std::log(real(x[i]))
                       : std::is_same_v<F, exp_of> ? std::exp(real(y[i]))
                                                   : std::exp(real(y[i]) * std::log(real(x[i])));
    error = std::max(error, static_cast<double>(std::abs((real(r[i]) - right) / right)));
  }
  state.counters["error"] = error;
  state.counters["per_value"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class F> void add(const std::string& name) {
  benchmark::RegisterBenchmark((name + "/libm").c_str(), evaluate<F, double>);
  benchmark::RegisterBenchmark((name + "/pack_2").c_str(), evaluate<F, pack<double, 2>>);
  benchmark::RegisterBenchmark((name + "/pack_4").c_str(), evaluate<F, pack<double, 4>>);
  benchmark::RegisterBenchmark((name + "/pack_8").c_str(), evaluate<F, pack<double, 8>>);
}
} // namespace

int main(int argc, char** argv) {
  add<log_of>("log");
  add<exp_of>("exp");
  add<pow_of>("pow");
  return run_benchmarks(argc, argv);
}
