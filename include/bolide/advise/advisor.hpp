// SPDX-License-Identifier: MIT
// Which composition for which accuracy, or for which time? Answered from measured rows (table.hpp), not from taste.
//
//   const advise::advisor ask(advise::measured_table());
//   const advise::scene what{.kind = "impact", .extent = 30, .duration = 36};        // extent and duration as in table.hpp
//   const auto a = ask.for_accuracy(what, 0.01);     // the cheapest that reaches 1 %:  a.how, a.cells, a.error, a.cost, a.sure, a.why
//   const auto b = ask.for_budget(what, 10);         // the most accurate within 10 s
//   const auto c = ask.preset(what, "standard");     // draft, standard, reference
//
// Error of a method on n cells per length: the geometric mean over the measured problems of the scene's kind. Between measured resolutions ln(error) is linear
// in ln n; beyond the finest it goes on with the lesser of the orders fitted to all resolutions and to the last two, and no further than twice as fine.
// Cost: that measured, scaled by particles and steps of the scene (table.hpp), the geometric mean over the problems; on the machine of the table, one thread.
// Accuracies are answered at measured resolutions (and one twice as fine), budgets at any between.
// sure: the probability that the error stays below the asked one, when ln(true/predicted) is normal with variance s^2 (1 + 1/problems); s is the scatter that
// problems of one kind show among each other (all kinds together where the kind has one problem; 0.1 is the least). Beyond the measured resolutions 0.25 is
// added to s. An accuracy counts as reached where sure is at least `confidence`.
// Presets, from the scene's front of error against cost: "draft" its cheapest point within 5 %, "standard" within 2 %, "reference" its most accurate
// measured point. Validity: a scene is as good as its kind; an error of another measure than the table's is another number.
// Cost of a question: some 10,000 logarithms.
#pragma once

#include "bolide/advise/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bolide::advise {

/// What is to be computed, in the units of the table.
struct scene {
  std::string kind;
  double extent = 0, duration = 0;
  bool tube = false;
};

struct advice {
  method how;
  double cells = 0;     // per length
  double error = 0;     // predicted
  double cost = 0;      // s, predicted
  double sure = 0;      // probability that the error (for_budget: the predicted one, give or take a fifth) is not exceeded
  bool reaches = false; // what was asked; if not, this is what comes nearest
  bool beyond = false;  // finer than measured
  std::string why;
};

class advisor {
public:
  explicit advisor(table t) : table_(std::move(t)) {
    for (const row& r : table_.rows)
      if (r.skip) add(r);
    require(!curves_.empty(), "rows of '" + table_.source + "' with skipping", 0, "at least 1");
    for (curve& c : curves_) std::sort(c.points.begin(), c.points.end(), [](const point& a, const point& b) { return a.cells < b.cells; });
    for (const std::string& kind : kinds()) scatter_[kind] = scatter_of(kind);
  }

  /// Only methods for which offered(method) holds, from now on: what a program cannot compose is not advised.
  template <class F> void offer(F&& offered) {
    std::erase_if(curves_, [&](const curve& c) { return !offered(c.how); });
    require(!curves_.empty(), "measured methods that can be offered", 0, "at least 1");
  }

  static constexpr double usual_confidence = 0.75;

  /// The cheapest that reaches a relative error with this probability.
  advice for_accuracy(const scene& what, double accuracy, double confidence = usual_confidence) const {
    require(accuracy > 0 && accuracy < 1, "accuracy", accuracy, "more than 0 and less than 1 (1 % is 0.01)");
    require(confidence > 0 && confidence < 1, "confidence", confidence, "more than 0 and less than 1");
    check(what);
    const auto all = candidates(what);
    const candidate* best = nullptr;
    std::size_t reaching = 0;
    for (const candidate& c : all) {
      if (sure(what, c, accuracy) < confidence) continue;
      ++reaching;
      if (!best || c.cost < best->cost) best = &c;
    }
    const bool reaches = best != nullptr;
    if (!best) best = &*std::max_element(all.begin(), all.end(), [&](const candidate& a, const candidate& b) { return sure(what, a, accuracy) < sure(what, b, accuracy); });
    advice a = answer(what, *best, accuracy);
    a.reaches = reaches;
    a.why = reaches ? "the cheapest of " + std::to_string(reaching) + " measured or extrapolated points, of " + std::to_string(all.size()) + ", that reach " + percent(accuracy) + " with " + percent(confidence) + " confidence"
                    : "none of " + std::to_string(all.size()) + " points reaches " + percent(accuracy) + " with " + percent(confidence) + " confidence; this comes nearest";
    a.why += basis(what, *best);
    return a;
  }

  /// The most accurate within so many seconds.
  advice for_budget(const scene& what, double seconds) const {
    require(seconds > 0 && seconds < 1e12, "budget", seconds, "positive and finite", "s");
    check(what);
    candidate best, cheapest;
    best.error = cheapest.cost = std::numeric_limits<double>::infinity();
    for (const method& how : methods(what.kind)) {
      const auto of = curves(what.kind, how);
      double low = coarsest(of), high = 2 * finest(of);
      const candidate least = at(what, how, low);
      if (least.cost < cheapest.cost) cheapest = least;
      if (least.cost > seconds) continue;
      if (at(what, how, high).cost <= seconds) low = high;
      for (int i = 0; i < 60 && low < high; ++i) {
        const double middle = std::sqrt(low * high);
        (at(what, how, middle).cost <= seconds ? low : high) = middle;
      }
      // finer is not always better: the best of the resolutions up to there
      for (const double cells : resolutions(what.kind, how))
        if (cells < low)
          if (const candidate c = at(what, how, cells); c.error < best.error) best = c;
      if (const candidate c = at(what, how, low); c.error < best.error) best = c;
    }
    const bool reaches = std::isfinite(best.error);
    const candidate& chosen = reaches ? best : cheapest;
    advice a = answer(what, chosen, 1.2 * chosen.error);
    a.reaches = reaches;
    a.why = reaches ? "the most accurate of " + std::to_string(methods(what.kind).size()) + " measured methods within " + to_text(seconds) + " s"
                    : "none of the measured points takes less than " + to_text(seconds) + " s; this is the cheapest";
    a.why += basis(what, chosen);
    return a;
  }

  /// "draft", "standard" or "reference".
  advice preset(const scene& what, std::string_view name) const {
    if (name == "draft") return for_accuracy(what, 0.05);
    if (name == "standard") return for_accuracy(what, 0.02);
    if (name != "reference") throw bad_parameter("preset = '" + std::string(name) + "': must be draft, standard or reference");
    const auto points = front(what);
    return points.back();
  }

  /// The measured points that no other beats in both error and cost, the cheapest first.
  std::vector<advice> front(const scene& what) const {
    check(what);
    auto all = candidates(what);
    std::erase_if(all, [](const candidate& c) { return c.beyond; });
    std::sort(all.begin(), all.end(), [](const candidate& a, const candidate& b) { return a.cost < b.cost || (a.cost == b.cost && a.error < b.error); });
    std::vector<advice> found;
    for (const candidate& c : all) {
      if (!found.empty() && c.error >= found.back().error) continue;
      found.push_back(answer(what, c, 1.2 * c.error));
      found.back().reaches = true;
      found.back().why = "on the front of error against cost" + basis(what, c);
    }
    return found;
  }

  std::vector<std::string> kinds() const {
    std::vector<std::string> all;
    for (const curve& c : curves_)
      if (std::find(all.begin(), all.end(), c.kind) == all.end()) all.push_back(c.kind);
    return all;
  }

  /// Standard deviation of ln(error) among the problems of a kind (same method, same resolution); of all kinds together where it has one; 0.5 where none has more.
  double scatter(const std::string& kind) const {
    const auto known = scatter_.find(kind);
    return known != scatter_.end() ? known->second : 0.5;
  }

private:
  double scatter_of(const std::string& kind) const {
    double sum = 0, n = 0, all_sum = 0, all_n = 0;
    for (const curve& c : curves_)
      for (const point& p : c.points) {
        double mean = 0, count = 0;
        for (const curve* other : curves(c.kind, c.how))
          if (const double e = measured_error(*other, p.cells); e > 0) mean += std::log(e), count += 1;
        if (count < 2) continue;
        const double off = square_of(std::log(p.error) - mean / count) * count / (count - 1);
        all_sum += off, all_n += 1;
        if (c.kind == kind) sum += off, n += 1;
      }
    if (n > 0) return std::max(0.1, std::sqrt(sum / n));
    return all_n > 0 ? std::max(0.1, std::sqrt(all_sum / all_n)) : 0.5;
  }
  struct point {
    double cells, error, cost;
  };
  /// One method on one problem.
  struct curve {
    std::string problem, kind;
    double extent, duration;
    bool tube;
    method how;
    std::vector<point> points;
  };
  struct candidate {
    method how;
    double cells = 0, error = 0, cost = 0;
    bool beyond = false;
  };

  table table_;
  std::vector<curve> curves_;
  std::map<std::string, double> scatter_; // by kind, of all measured methods

  static double square_of(double x) { return x * x; }
  static std::string percent(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %%", 100 * x);
    return text;
  }
  void add(const row& r) {
    validate(r, "'" + table_.source + "', " + r.problem);
    for (curve& c : curves_)
      if (c.problem == r.problem && c.how == r.how) {
        for (const point& p : c.points) require(p.cells != r.cells, "'" + table_.source + "', " + r.problem + ", " + name(r.how) + ": rows of cells", r.cells, "one");
        c.points.push_back({r.cells, r.error, r.cost});
        return;
      }
    curves_.push_back({r.problem, r.kind, r.extent, r.duration, r.tube, r.how, {{r.cells, r.error, r.cost}}});
  }
  void check(const scene& what) const {
    require(what.extent > 0 && what.extent < 1e15, "extent of the scene", what.extent, "positive and finite");
    require(what.duration > 0 && what.duration < 1e15, "duration of the scene", what.duration, "positive and finite");
    const auto known = kinds();
    if (std::find(known.begin(), known.end(), what.kind) != known.end()) return;
    std::string list;
    for (const auto& k : known) list += (list.empty() ? "" : ", ") + k;
    throw bad_parameter("kind of the scene = '" + what.kind + "': was not measured; there are " + list);
  }

  std::vector<const curve*> curves(const std::string& kind, const method& how) const {
    std::vector<const curve*> all;
    for (const curve& c : curves_)
      if (c.kind == kind && c.how == how) all.push_back(&c);
    return all;
  }
  std::size_t problems(const std::string& kind) const {
    std::vector<std::string> all;
    for (const curve& c : curves_)
      if (c.kind == kind && std::find(all.begin(), all.end(), c.problem) == all.end()) all.push_back(c.problem);
    return all.size();
  }
  /// Those measured on every problem of the kind that could have them (a table only where there is one).
  std::vector<method> methods(const std::string& kind) const {
    std::vector<method> all;
    for (const curve& c : curves_)
      if (c.kind == kind && std::find(all.begin(), all.end(), c.how) == all.end() && (curves(kind, c.how).size() == problems(kind) || c.how.table)) all.push_back(c.how);
    return all;
  }
  static double coarsest(const std::vector<const curve*>& of) {
    double cells = 0;
    for (const curve* c : of) cells = std::max(cells, c->points.front().cells);
    return cells;
  }
  static double finest(const std::vector<const curve*>& of) {
    double cells = std::numeric_limits<double>::infinity();
    for (const curve* c : of) cells = std::min(cells, c->points.back().cells);
    return cells;
  }
  std::vector<double> resolutions(const std::string& kind, const method& how) const {
    std::vector<double> all;
    const auto of = curves(kind, how);
    for (const curve* c : of)
      for (const point& p : c->points)
        if (p.cells >= coarsest(of) && p.cells <= finest(of)) all.push_back(p.cells);
    all.push_back(2 * finest(of));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }
  static double measured_error(const curve& c, double cells) {
    for (const point& p : c.points)
      if (p.cells == cells) return p.error;
    return 0;
  }

  /// ln of a measured value at ln(cells): linear between points, beyond the last one with `last_slope`.
  template <class F> static double interpolate(const curve& c, double cells, double last_slope, F&& value) {
    const auto& p = c.points;
    const double x = std::log(cells);
    if (p.size() == 1 || cells >= p.back().cells) return std::log(value(p.back())) + last_slope * (x - std::log(p.back().cells));
    std::size_t k = 0;
    while (k + 2 < p.size() && cells > p[k + 1].cells) ++k;
    const double x0 = std::log(p[k].cells), x1 = std::log(p[k + 1].cells), share = (x - x0) / (x1 - x0);
    return (1 - share) * std::log(value(p[k])) + share * std::log(value(p[k + 1]));
  }
  /// The order of convergence to go on with: the lesser of those of all points (least squares) and of the last two.
  static double order(const curve& c) {
    const auto& p = c.points;
    if (p.size() < 2) return 0;
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (const point& q : p) mean_x += std::log(q.cells), mean_y += std::log(q.error);
    mean_x /= static_cast<double>(p.size()), mean_y /= static_cast<double>(p.size());
    for (const point& q : p) xx += square_of(std::log(q.cells) - mean_x), xy += (std::log(q.cells) - mean_x) * (std::log(q.error) - mean_y);
    const point &a = p[p.size() - 2], &b = p.back();
    return std::min(-xy / xx, -std::log(b.error / a.error) / std::log(b.cells / a.cells));
  }
  /// Particles times steps, but for a constant.
  static double work(double extent, double duration, bool tube, double cells) { return extent * duration * cells * (tube ? 4 * cells : cells * cells); }

  candidate at(const scene& what, const method& how, double cells) const {
    candidate c{how, cells, 0, 0, false};
    const auto of = curves(what.kind, how);
    double log_cost = 0, log_error = 0;
    for (const curve* one : of) {
      log_error += interpolate(*one, cells, -order(*one), [](const point& p) { return p.error; });
      const double grows = one->tube ? 2 : 3; // cost with cells
      log_cost += interpolate(*one, cells, grows, [](const point& p) { return p.cost; }) +
                  std::log(work(what.extent, what.duration, what.tube, cells) / work(one->extent, one->duration, one->tube, cells));
    }
    c.error = std::exp(log_error / static_cast<double>(of.size()));
    c.cost = std::exp(log_cost / static_cast<double>(of.size()));
    c.beyond = cells > finest(of) * (1 + 1e-9);
    return c;
  }
  std::vector<candidate> candidates(const scene& what) const {
    std::vector<candidate> all;
    for (const method& how : methods(what.kind))
      for (const double cells : resolutions(what.kind, how)) all.push_back(at(what, how, cells));
    return all;
  }
  /// The probability that the error is at most `asked`.
  double sure(const scene& what, const candidate& c, double asked) const {
    const double s = (scatter(what.kind) + (c.beyond ? 0.25 : 0)) * std::sqrt(1 + 1 / static_cast<double>(curves(what.kind, c.how).size()));
    return 0.5 * std::erfc(-std::log(asked / c.error) / s / std::sqrt(2.0));
  }
  advice answer(const scene& what, const candidate& c, double asked) const { return {c.how, c.cells, c.error, c.cost, sure(what, c, asked), false, c.beyond, {}}; }
  std::string basis(const scene& what, const candidate& c) const {
    const std::size_t n = problems(what.kind);
    std::string text = ", by the " + std::string(n == 1 ? "one problem" : std::to_string(n) + " problems") + " of kind " + what.kind + ":";
    for (const curve* one : curves(what.kind, c.how))
      text += (text.back() == ':' ? " " : ", ") + one->problem + " " + percent(std::exp(interpolate(*one, c.cells, -order(*one), [](const point& p) { return p.error; })));
    return c.beyond ? text + " (beyond the finest measured)" : text;
  }
};

} // namespace bolide::advise
