// SPDX-License-Identifier: MIT
// What was measured: error and cost of compositions of the solver on problems with known answers, one row per composition, problem and resolution.
//
//   const advise::table measured = advise::measured_table();            // compiled in (measured.hpp, written by examples/tradeoff --docs)
//   const advise::table own = advise::read_table("tradeoff.csv");       // of one's own machine
//
// A row's `cells` count the problem's characteristic length (examples/tradeoff/problems.hpp says which); extent and duration say how large the problem is:
//   particles  ~ extent cells^2 per_axis^2   (extent: area in the plane over length^2;  tube: 4 extent cells per_axis^2, extent: length over length)
//   steps      ~ duration cells / courant    (duration: time x fastest speed over length)
// so that cost carries over to a scene of another size. `strength` is the number that tells problems of one kind apart (of a shock the share of volume that it
// takes, of a bar rho v^2/Y, ...); errors are taken to go with a power of it.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/text_input.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bolide::advise {

/// What is chosen beside the cell size.
struct method {
  std::string shape, transfer, scheme, precision;
  int per_axis = 2; // particles per cell and axis
  double courant = 0.4;
  bool table = false; // the equation of state as a table
  friend bool operator==(const method&, const method&) = default;
};

/// "bspline apic usf double, 2 per axis, CFL 0.4"
inline std::string name(const method& m) {
  std::string text = m.shape + " " + m.transfer + " " + m.scheme + " " + m.precision + ", " + std::to_string(m.per_axis) + " per axis, CFL " + to_text(m.courant);
  return m.table ? text + ", EOS table" : text;
}

struct row {
  std::string problem, kind;
  double extent = 0, duration = 0, strength = 1;
  bool tube = false;
  method how;
  bool skip = true; // what is at rest is left out
  double cells = 0, error = 0, cost = 0; // per length; relative; s
  double spread = 0;                     // of the repeats: half of the interquartile range over the median
  int repeats = 0;
  long steps = 0;
  double particles = 0, particle_steps = 0;
};

/// The same in the form that the compiled-in table has.
struct compact_row {
  const char *problem, *kind;
  double extent, duration, strength;
  bool tube;
  const char *shape, *transfer, *scheme, *precision;
  int per_axis;
  double courant;
  bool table, skip;
  double cells, error, cost, spread;
  int repeats;
  long steps;
  double particles, particle_steps;
};

struct table {
  std::vector<row> rows;
  std::string source; // where it comes from, for messages
};

inline constexpr const char* column_names[] = {"problem",  "kind",       "extent (1)", "duration (1)", "tube", "shape",     "transfer",  "scheme",    "precision", "per_axis",
                                               "courant",  "eos_table",  "skip",       "cells",        "error (1)",         "cost (s)",  "spread (1)", "repeats",  "steps", "particles",
                                               "particle_steps", "strength (1)"};
inline constexpr std::size_t number_of_columns = sizeof column_names / sizeof column_names[0];

/// Refuses a row that no measurement gives.
inline void validate(const row& r, const std::string& where) {
  const auto positive = [&](const char* what, double x, const char* unit = "") { require(x > 0 && x < 1e30, where + ": " + what, x, "positive and finite", unit); };
  require(!r.problem.empty() && !r.kind.empty(), where + ": length of the names of problem and kind", 0, "at least 1");
  positive("extent", r.extent);
  positive("duration", r.duration);
  positive("strength", r.strength);
  positive("cells", r.cells);
  positive("error", r.error);
  positive("cost", r.cost, "s");
  positive("courant", r.how.courant);
  positive("particles", r.particles);
  positive("steps", static_cast<double>(r.steps));
  positive("particle_steps", r.particle_steps);
  require(r.how.per_axis >= 1 && r.how.per_axis <= 16, where + ": per_axis", r.how.per_axis, "1 to 16");
  require(r.spread >= 0, where + ": spread", r.spread, "non-negative");
}

namespace detail {
/// The cells of one line of comma-separated values, quoted ones without their quotes (RFC 4180).
inline std::vector<std::string> split_line(std::string_view line) {
  std::vector<std::string> found(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') found.back() += '"', ++i;
    else if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) found.emplace_back();
    else if (c != '\r') found.back() += c;
  }
  return found;
}
} // namespace detail

/// Reads rows from the text of a CSV file with the columns above, in any order, others between them ignored. Throws bad_parameter with source and line.
inline table parse_table(std::string_view text, const std::string& source) {
  bolide::text::cursor cursor(text, source);
  std::string_view line;
  if (!cursor.next_line(line)) throw bad_parameter("'" + source + "': is empty; expected the CSV that examples/tradeoff writes");
  const auto header = detail::split_line(line);
  std::size_t place[number_of_columns];
  for (std::size_t k = 0; k < number_of_columns; ++k) {
    place[k] = header.size();
    for (std::size_t i = 0; i < header.size(); ++i)
      if (header[i] == column_names[k]) place[k] = i;
    if (place[k] == header.size()) throw bad_parameter("'" + source + "': has no column \"" + column_names[k] + "\"; expected the CSV that examples/tradeoff writes");
  }
  table t{{}, source};
  for (std::size_t number = 2; cursor.next_line(line); ++number) {
    if (line.empty() || line == "\r") continue;
    const std::string where = "'" + source + "' line " + std::to_string(number);
    const auto cells = detail::split_line(line);
    if (cells.size() != header.size()) throw bad_parameter(where + ": has " + std::to_string(cells.size()) + " cells, the header " + std::to_string(header.size()));
    const auto word = [&](std::size_t k) -> const std::string& { return cells[place[k]]; };
    const auto value = [&](std::size_t k) {
      double x = 0;
      if (!bolide::text::parse_number(word(k), x)) throw bad_parameter(where + ", " + column_names[k] + ": expected a number, found " + bolide::text::shown(word(k)));
      return x;
    };
    row r{word(0), word(1), value(2), value(3), value(21), value(4) != 0, {word(5), word(6), word(7), word(8), static_cast<int>(value(9)), value(10), value(11) != 0},
          value(12) != 0, value(13), value(14), value(15), value(16), static_cast<int>(value(17)), static_cast<long>(value(18)), value(19), value(20)};
    validate(r, where);
    t.rows.push_back(std::move(r));
  }
  require(!t.rows.empty(), "rows of '" + source + "'", 0, "at least 1");
  return t;
}
inline table read_table(const std::string& path) { return parse_table(bolide::text::read_file(path), path); }

/// From the compiled-in form.
template <std::size_t N> table expand(const compact_row (&rows)[N], std::string source) {
  table t{{}, std::move(source)};
  for (const compact_row& r : rows)
    t.rows.push_back({r.problem, r.kind, r.extent, r.duration, r.strength, r.tube, {r.shape, r.transfer, r.scheme, r.precision, r.per_axis, r.courant, r.table}, r.skip, r.cells, r.error, r.cost,
                      r.spread, r.repeats, r.steps, r.particles, r.particle_steps});
  return t;
}

} // namespace bolide::advise
