// SPDX-License-Identifier: MIT
#include "matrix.hpp"

#include "simulation.hpp"

#include "bolide/core/contract.hpp"

#include <algorithm>
#include <cstdio>

namespace tradeoff {
namespace {

/// The value below which the share lies, interpolated.
double quantile(std::vector<double> of, double share) {
  std::sort(of.begin(), of.end());
  const double place = share * static_cast<double>(of.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double above = below + 1 < of.size() ? of[below + 1] : of[below];
  return of[below] + (place - static_cast<double>(below)) * (above - of[below]);
}
double spread_of(const std::vector<double>& costs) { return 0.5 * (quantile(costs, 0.75) - quantile(costs, 0.25)) / quantile(costs, 0.5); }

/// Is another repeat needed?
bool firm(const std::vector<double>& costs) {
  double sum = 0;
  for (const double c : costs) sum += c;
  if (costs.size() >= 2 && sum > 8) return true;
  return costs.size() >= 9 || (costs.size() >= 3 && spread_of(costs) <= 0.02);
}

settings base(std::size_t composition, double cells) {
  settings s;
  s.composition = composition;
  s.cells = cells;
  return s;
}

/// The settings that differ from the base in one axis.
std::vector<settings> variations(const problem& p, const settings& of) {
  std::vector<settings> all;
  const auto add = [&](auto&& change) { change(all.emplace_back(of)); };
  if (p.kind != "impact") add([](settings& s) { s.per_axis = 3; }); // three per axis do not divide the paper's plate
  add([](settings& s) { s.courant = 0.2; });
  add([](settings& s) { s.courant = 0.8; });
  add([](settings& s) { s.skip = false; });
  if (p.has_table) add([](settings& s) { s.table = true; });
  return all;
}

} // namespace

std::vector<task> all_tasks(const std::vector<problem>& problems) {
  std::vector<task> all;
  for (std::size_t rung = 0; rung < 6; ++rung)
    for (std::size_t k = 0; k < problems.size(); ++k) {
      const auto& ladder = problems[k].ladder;
      if (rung >= ladder.size()) continue;
      for (std::size_t c = 0; c < number_of_compositions; ++c) {
        all.push_back({k, base(c, ladder[rung])});
        if (c != 0 && c != 3 && c != default_composition) continue;
        for (const auto& s : variations(problems[k], all.back().how))
          if (rung + 1 < ladder.size() || s.courant > 0.4) all.push_back({k, s});
      }
    }
  return all;
}

std::vector<task> quick_tasks(const std::vector<problem>& problems) {
  std::vector<task> all;
  for (std::size_t k = 0; k < problems.size(); ++k)
    if (problems[k].kind == "shock" || problems[k].kind == "wave")
      for (std::size_t rung = 0; rung < 2; ++rung)
        for (const std::size_t c : {std::size_t(0), std::size_t(3), default_composition, std::size_t(8)}) all.push_back({k, base(c, problems[k].ladder[rung])});
  return all;
}

namespace {
bolide::advise::method method_of(const settings& s) {
  const composition& c = compositions[s.composition];
  return {std::string(c.shape), std::string(c.transfer), std::string(c.scheme), std::string(c.precision), s.per_axis, s.courant, s.table};
}
} // namespace

std::vector<task> missing(const std::vector<problem>& problems, const std::vector<task>& tasks, const bolide::advise::table& known) {
  std::vector<task> all;
  for (const task& t : tasks)
    if (std::none_of(known.rows.begin(), known.rows.end(), [&](const auto& r) {
          return r.problem == problems[t.problem].name && r.cells == t.how.cells && r.skip == t.how.skip && r.how == method_of(t.how);
        }))
      all.push_back(t);
  return all;
}

bolide::advise::row measure(const problem& p, const settings& s) {
  std::vector<double> costs;
  outcome first;
  while (!firm(costs)) {
    const outcome o = p.measure(s);
    if (costs.empty()) first = o;
    if (o.error != first.error) throw failed_run{"the error changed from one repeat to the next"};
    costs.push_back(o.cost);
  }
  bolide::advise::row r{p.name, p.kind, p.extent, p.duration, p.strength, p.tube, method_of(s), s.skip, s.cells, first.error, quantile(costs, 0.5), spread_of(costs), static_cast<int>(costs.size()), first.steps,
                        static_cast<double>(first.particles), first.particle_steps};
  bolide::advise::validate(r, p.name + ", " + name(s));
  return r;
}

measured run(const std::vector<problem>& problems, const std::vector<task>& tasks, double most_minutes, const std::function<void(const measured&)>& keep) {
  measured all;
  const double begin = cpu_seconds();
  double kept = begin;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const task& t = tasks[k];
    const problem& p = problems[t.problem];
    if (cpu_seconds() - begin > 60 * most_minutes) {
      all.left_out = tasks.size() - k;
      break;
    }
    const std::string what = p.name + ", " + bolide::to_text(t.how.cells) + " cells, " + name(t.how);
    try {
      all.rows.push_back(measure(p, t.how));
      std::fprintf(stderr, "%4zu/%zu  %-100s error %8.3f %%  cost %8.4f s +- %.1f %%\n", k + 1, tasks.size(), what.c_str(), 100 * all.rows.back().error, all.rows.back().cost,
                   100 * all.rows.back().spread);
    } catch (const failed_run& f) {
      all.failures.push_back(what + ": " + f.why);
      std::fprintf(stderr, "%4zu/%zu  %s\n", k + 1, tasks.size(), all.failures.back().c_str());
    }
    if (cpu_seconds() - kept > 10) keep(all), kept = cpu_seconds();
  }
  all.seconds = cpu_seconds() - begin;
  return all;
}

} // namespace tradeoff
