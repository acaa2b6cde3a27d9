// SPDX-License-Identifier: MIT
// main() of the Google Benchmark programs: their JSON names compiler, flags and processor beside what Google Benchmark says of the machine.
#pragma once

#include "machine.hpp"

#include <benchmark/benchmark.h>

inline int run_benchmarks(int argc, char** argv) {
  benchmark::AddCustomContext("cpu", machine::cpu_model());
  benchmark::AddCustomContext("compiler", machine::compiler());
  benchmark::AddCustomContext("flags", machine::flags);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
