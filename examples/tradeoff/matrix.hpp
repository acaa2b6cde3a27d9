// SPDX-License-Identifier: MIT
// Which cells of the matrix are run, and how often.
//
// A cost is the median of its repeats. A row is repeated at least three times and until it is firm, half of the interquartile range at most 2 % of the median,
// but no more than nine times, and no more than twice once 8 s are spent on it. The error must be the same, bit for bit, in every repeat.
#pragma once

#include "problems.hpp"

#include "bolide/advise/table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tradeoff {

struct task {
  std::size_t problem; // of the list
  settings how;
};

/// Every composition at every resolution, and the axes that are set at run time (particles per cell, CFL, table, skipping) for one fast, one exact and one
/// noisy composition at all resolutions but the finest, where of them only CFL 0.8 is run: does it hold? The coarse ones come first: what a time limit leaves
/// out are the finest.
std::vector<task> all_tasks(const std::vector<problem>& problems);
/// A few cheap ones.
std::vector<task> quick_tasks(const std::vector<problem>& problems);

struct measured {
  std::vector<bolide::advise::row> rows;
  std::vector<std::string> failures; // sentences: runs that came to no end
  std::size_t left_out = 0;          // tasks that the time limit left out
  double seconds = 0;                // of CPU, all of it
};

/// Those that `known` has no row of.
std::vector<task> missing(const std::vector<problem>& problems, const std::vector<task>& tasks, const bolide::advise::table& known);

/// Runs the tasks. What failed is noted, not measured. `keep`: called with the rows so far, every ten seconds of CPU time or so.
measured run(const std::vector<problem>& problems, const std::vector<task>& tasks, double most_minutes, const std::function<void(const measured&)>& keep);

/// One row: the task repeated until firm.
bolide::advise::row measure(const problem& p, const settings& s);

} // namespace tradeoff
