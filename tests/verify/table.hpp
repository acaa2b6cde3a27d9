// SPDX-License-Identifier: MIT
// One row of docs/verification.md: what was run, what came out, what was asked.
//
//   verify::record({.section = "shocks", .problem = "Sod", .composition = "quadratic FLIP USF", .measure = "L1 error of p, 400 cells",
//                   .value = 4.1e-3, .bound = 6e-3, .order = 0.9, .expected_order = 1, .seconds = 0.4});
//
// prints the row, and appends it as one line of JSON to the file that the environment variable BOLIDE_VERIFY_TABLE names, if it is set: the
// target `verification_table` collects a run of all suites in this way and writes the page from it.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace bolide::verify {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct row {
  std::string section;     // "smooth", "shocks", "solids", "conservation", "symmetry", "extremes", "energy drift", "stable range"
  std::string problem;     // "Noh, spherical (r-z)"
  std::string composition; // "r-z, quadratic B-spline, FLIP, USF, double"
  std::string measure;     // "density in r 0.05-0.15, relative error"
  double value = none;     // what came out; errors are relative unless `unit` says otherwise
  double bound = none;     // what is asked: |value| <= bound; none: reported only
  double order = none;     // observed between the two finest resolutions
  double expected_order = none;
  double seconds = none;   // of the solver at the finest resolution
  std::string unit{};
  std::string note{};      // why a bound is missed, or what limits the order

  bool met() const { return !(std::abs(value) > bound) && !(order < 0.75 * expected_order) && !std::isnan(value); }
};

inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + '"';
}
inline std::string number(double x) {
  if (!std::isfinite(x)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}

inline void record(const row& r) {
  std::printf("[ figures  ] %s | %s | %s | %s: %.4g %s", r.section.c_str(), r.problem.c_str(), r.composition.c_str(), r.measure.c_str(), r.value, r.unit.c_str());
  if (!std::isnan(r.bound)) std::printf(" (bound %.3g)", r.bound);
  if (!std::isnan(r.order)) std::printf(", order %.2f", r.order);
  if (!std::isnan(r.seconds)) std::printf(", %.2f s", r.seconds);
  std::printf("%s%s%s\n", r.met() ? "" : " MISSED", r.note.empty() ? "" : ": ", r.note.c_str());
  const char* file = std::getenv("BOLIDE_VERIFY_TABLE");
  if (!file) return;
  const std::string line = "{\"section\":" + quoted(r.section) + ",\"problem\":" + quoted(r.problem) + ",\"composition\":" + quoted(r.composition) +
                           ",\"measure\":" + quoted(r.measure) + ",\"value\":" + number(r.value) + ",\"bound\":" + number(r.bound) + ",\"order\":" + number(r.order) +
                           ",\"expected_order\":" + number(r.expected_order) + ",\"seconds\":" + number(r.seconds) + ",\"unit\":" + quoted(r.unit) +
                           ",\"note\":" + quoted(r.note) + ",\"met\":" + (r.met() ? "true" : "false") + "}\n";
  const int to = open(file, O_WRONLY | O_CREAT | O_APPEND, 0644); // one write: tests that run side by side do not mix
  if (to < 0 || write(to, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::printf("cannot append to %s\n", file);
  if (to >= 0) close(to);
}

} // namespace bolide::verify
