// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include "front.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tradeoff {
namespace {

using bolide::advise::row;

settings settings_of(const bolide::advise::advice& a) {
  settings s;
  for (std::size_t c = 0; c < number_of_compositions; ++c)
    if (compositions[c].shape == a.how.shape && compositions[c].transfer == a.how.transfer && compositions[c].scheme == a.how.scheme && compositions[c].precision == a.how.precision)
      s.composition = c;
  s.cells = a.cells;
  s.per_axis = a.how.per_axis;
  s.courant = a.how.courant;
  s.table = a.how.table;
  return s;
}

const row* find(const bolide::advise::table& t, const std::string& problem, const bolide::advise::advice& a) {
  for (const row& r : t.rows)
    if (r.problem == problem && r.how == a.how && r.cells == a.cells) return &r;
  return nullptr;
}

/// The least cost at which a method reaches the error between two of its runs, or at one; 0: nowhere.
double cheapest_between(const bolide::advise::table& t, const std::string& problem, double asked) {
  double least = 0;
  const auto consider = [&](double cost) { least = least > 0 ? std::min(least, cost) : cost; };
  for (const row& b : t.rows) {
    if (b.problem != problem || b.error > asked) continue;
    consider(b.cost);
    const row* a = nullptr; // the next coarser run
    for (const row& r : t.rows)
      if (r.problem == problem && r.how == b.how && r.cells < b.cells && (!a || r.cells > a->cells)) a = &r;
    if (a && a->error > asked) consider(b.cost * std::pow(a->cost / b.cost, std::log(asked / b.error) / std::log(a->error / b.error)));
  }
  return least;
}

std::string percent(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * x);
  return text;
}
} // namespace

std::vector<task> judge_tasks(const std::vector<problem>& problems) {
  std::vector<task> all;
  for (task t : all_tasks(problems)) {
    if (!t.how.skip) continue;
    all.push_back(t);
  }
  // the axes that are set at run time, at the finest resolution too
  for (std::size_t k = 0; k < problems.size(); ++k) {
    std::vector<task> finest;
    for (const task& t : all)
      if (t.problem == k && t.how.cells == problems[k].ladder.front() && (t.how.per_axis != 2 || t.how.courant < 0.4)) finest.push_back(t);
    for (task& t : finest) t.how.cells = problems[k].ladder.back(), all.push_back(t);
  }
  return all;
}

std::vector<verdict> judge(const bolide::advise::advisor& ask, const std::vector<problem>& problems, bolide::advise::table& judged) {
  std::vector<verdict> all;
  for (const problem& p : problems)
    for (const double asked : {0.05, 0.02, 0.01}) {
      verdict v{p.name, asked, ask.for_accuracy({p.kind, p.extent, p.duration, p.strength, p.tube}, asked)};
      const auto advised = [&] { return find(judged, p.name, v.given); };
      if (v.given.reaches && !advised()) try {
          judged.rows.push_back(measure(p, settings_of(v.given)));
        } catch (const failed_run&) {} // reaches nothing
      if (v.given.reaches) v.error = advised() ? advised()->error : 1, v.cost = advised() ? advised()->cost : 0;
      const row* cheapest = nullptr;
      for (const row& r : judged.rows)
        if (r.problem == p.name && r.error <= asked && (!cheapest || r.cost < cheapest->cost)) cheapest = &r;
      if (cheapest) v.cheapest = name_of(*cheapest) + ", " + bolide::to_text(cheapest->cells) + " cells", v.cheapest_cost = cheapest->cost;
      v.right = v.given.reaches ? v.error <= asked && v.cost <= 2 * v.cheapest_cost : !cheapest;
      v.cheapest_between = cheapest_between(judged, p.name, asked);
      v.right_between = v.given.reaches ? v.error <= asked && v.cost <= 2 * v.cheapest_between : !cheapest;
      all.push_back(std::move(v));
    }
  return all;
}

std::string section(const std::vector<verdict>& all) {
  std::string text = "| problem | asked | advised | predicted | error | CPU s | cheapest that reaches it | CPU s | right |\n|---|---|---|---|---|---|---|---|---|\n";
  std::size_t right = 0, right_between = 0, refused = 0;
  for (const verdict& v : all) {
    char line[600];
    if (v.given.reaches)
      std::snprintf(line, sizeof line, "| %s | %s | %s, %g cells | %s | %s | %.3g | %s | %.3g | %s |\n", v.problem.c_str(), percent(v.asked).c_str(), name(v.given.how).c_str(), v.given.cells,
                    percent(v.given.error).c_str(), percent(v.error).c_str(), v.cost, v.cheapest.c_str(), v.cheapest_cost, v.right ? "yes" : v.error > v.asked ? "**no: misses it**" : "**no: too dear**");
    else
      std::snprintf(line, sizeof line, "| %s | %s | says: none | %s | | | %s | %.3g | %s |\n", v.problem.c_str(), percent(v.asked).c_str(), percent(v.given.error).c_str(),
                    v.cheapest.empty() ? "none" : v.cheapest.c_str(), v.cheapest_cost, v.right ? "yes" : "**no**");
    text += line;
    right += v.right, right_between += v.right_between;
    refused += v.right && !v.given.reaches;
  }
  char line[300];
  std::snprintf(line, sizeof line, "\n**%zu of %zu right**, %zu of them by saying that nothing measured reaches it. Where the cheapest may lie between two measured resolutions (interpolated): %zu of %zu.\n",
                right, all.size(), refused, right_between, all.size());
  return text + line;
}

} // namespace tradeoff
