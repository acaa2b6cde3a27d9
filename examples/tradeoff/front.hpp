// SPDX-License-Identifier: MIT
// Rows of one problem, and those that no other beats in both error and cost.
#pragma once

#include "bolide/advise/table.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tradeoff {

using rows = std::vector<const bolide::advise::row*>;

inline std::vector<std::string> problem_names(const bolide::advise::table& t) {
  std::vector<std::string> all;
  for (const auto& r : t.rows)
    if (std::find(all.begin(), all.end(), r.problem) == all.end()) all.push_back(r.problem);
  return all;
}
inline rows rows_of(const bolide::advise::table& t, const std::string& problem) {
  rows all;
  for (const auto& r : t.rows)
    if (r.problem == problem) all.push_back(&r);
  return all;
}
/// The cheapest first.
inline rows front_of(rows all) {
  std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->cost < b->cost || (a->cost == b->cost && a->error < b->error); });
  rows front;
  for (const auto* r : all)
    if (front.empty() || r->error < front.back()->error) front.push_back(r);
  return front;
}
/// "bspline apic usf double, 2 per axis, CFL 0.4, nothing skipped"
inline std::string name_of(const bolide::advise::row& r) { return name(r.how) + (r.skip ? "" : ", nothing skipped"); }

} // namespace tradeoff
