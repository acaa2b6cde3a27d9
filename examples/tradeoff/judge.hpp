// SPDX-License-Identifier: MIT
// Is the advice good? Asked of problems that the table has not seen: for an error of 5, 2 and 1 % the advised composition is run, and so is every measured
// method at every resolution of the problem's ladder. An answer is right if it reaches the asked error at no more than twice the cost of the cheapest run that
// does, or says that nothing reaches it where nothing does. The advisor may choose resolutions between those of the ladder; so a harder judge is asked too, whose
// cheapest may lie between two runs of a method, error and cost interpolated.
#pragma once

#include "matrix.hpp"

#include "bolide/advise/advisor.hpp"

#include <string>
#include <vector>

namespace tradeoff {

struct verdict {
  std::string problem;
  double asked;
  bolide::advise::advice given;
  double error = 0, cost = 0;           // of the advised run; 0: none was needed
  std::string cheapest{};               // the cheapest that reaches it; empty: none
  double cheapest_cost = 0;
  double cheapest_between = 0;          // s, interpolated
  bool right = false, right_between = false;
};

/// Every method of the table on every problem at every resolution of its ladder.
std::vector<task> judge_tasks(const std::vector<problem>& problems);
/// `judged`: the rows of those tasks; an advised run that is not among them is made (and added).
std::vector<verdict> judge(const bolide::advise::advisor& ask, const std::vector<problem>& problems, bolide::advise::table& judged);
/// A section of docs/tradeoff.md.
std::string section(const std::vector<verdict>& all);

} // namespace tradeoff
