// SPDX-License-Identifier: MIT
// One cell of the matrix: what is composed at compile time (a name of `compositions`) and what is set at run time; and what came out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tradeoff {

struct composition {
  std::string_view shape, transfer, scheme, precision;
};

/// All that are compiled, by index (composition_*.cpp define them).
inline constexpr composition compositions[] = {
    {"linear", "flip", "usf", "double"},    {"linear", "flip", "musl", "double"},  {"linear", "flip", "usf", "float"},
    {"bspline", "flip", "usf", "double"},   {"bspline", "flip", "usl", "double"},  {"bspline", "flip", "usf", "float"},
    {"bspline", "apic", "usf", "double"},   {"bspline", "apic", "musl", "double"}, {"bspline", "apic", "usf", "float"},
    {"bspline", "xpic2", "usf", "double"},  {"cubic", "apic", "usf", "double"},    {"gimp", "flip", "usf", "double"}};
inline constexpr std::size_t number_of_compositions = sizeof compositions / sizeof compositions[0];
inline constexpr std::size_t default_composition = 6; // the library's default: of it the reference runs are made

struct settings {
  std::size_t composition = default_composition;
  double cells = 32;   // per characteristic length of the problem
  int per_axis = 2;    // particles per cell and axis
  double courant = 0.4;
  bool table = false;  // the equation of state as a table (problems whose equation of state is worth one)
  bool skip = true;    // what is at rest is left out
};

/// "bspline apic usf double, 2 per axis, CFL 0.4"
std::string name(const settings& s);

/// What a run gives. The error is what the problem's file says; the same settings give the same error, bit for bit.
struct outcome {
  double error = 0;
  double cost = 0; // s of thread CPU time inside the solver's steps
  long steps = 0;
  double particle_steps = 0;
  std::size_t particles = 0;
};

/// A run of a problem that came to no end: it stopped itself (what() says why), or the answer has no number.
struct failed_run {
  std::string why;
};

} // namespace tradeoff
