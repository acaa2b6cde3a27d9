// SPDX-License-Identifier: MIT
// What a timing was measured on and with: it stands beside the figures of every benchmark.
#pragma once

#include <algorithm>
#include <fstream>
#include <string>

#if !defined(BOLIDE_BENCHMARK_FLAGS)
#define BOLIDE_BENCHMARK_FLAGS "not known to the program"
#endif

namespace machine {

inline constexpr const char* flags = BOLIDE_BENCHMARK_FLAGS; // of the compiler

inline std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  std::string name = "unknown", family, model;
  for (std::string line; std::getline(info, line) && !line.empty();) { // of the first core
    const auto is = [&](const char* key) { return line.rfind(key, 0) == 0 && line.find(": ") != std::string::npos; };
    const std::string value = line.substr(std::min(line.size(), line.find(':') + 2));
    if (is("model name")) name = value;
    else if (is("model")) model = value;
    else if (is("cpu family")) family = value;
  }
  return name + ", family " + family + ", model " + model;
}
inline std::string compiler() {
#if defined(__clang__)
  return std::string("clang++ ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

} // namespace machine
