// SPDX-License-Identifier: MIT
// Which composition for which accuracy, or for which time? Answered from measured rows (table.hpp), not from taste.
//
//   const advise::advisor ask(advise::measured_table());
//   const advise::scene what{.kind = "impact", .extent = 30, .duration = 36};        // extent and duration as in table.hpp
//   const auto a = ask.for_accuracy(what, 0.01);     // the cheapest that reaches 1 %:  a.how, a.cells, a.error, a.cost, a.sure, a.why
//   const auto b = ask.for_budget(what, 10);         // the most accurate within 10 s
//   const auto c = ask.preset(what, "standard");     // draft, standard, reference
//
// Error of a method on n cells per length: e_p (x/x_p)^b, the geometric mean over the measured problems p of the scene's kind, x their and the scene's strength.
// b is one number per kind: the median of the slopes of ln e over ln x of all methods and resolutions; x is taken no further than 1.5 times beyond those measured.
// A coarser run that happened to be better than a finer one of its method counts as no better. Between measured resolutions ln e is linear in ln n; beyond the finest it goes on with the lesser of the orders fitted to all resolutions and to the last two,
// and no further than twice as fine.
// Cost: that measured, scaled by particles and steps of the scene (table.hpp), the geometric mean over the problems; on the machine of the table, one thread.
// Accuracies and budgets are answered at resolutions with a whole number of particles per length, measured or between.
// sure: the probability that the error stays below the asked one, when ln(true/predicted) is normal with variance s^2 (1 + 1/problems); s is the scatter that
// problems of one kind show about e_p (x/x_p)^b: the method's own, with the weight of its figures, and the kind's, with a weight of 4 (all kinds together where
// the kind has one problem; 0.1 is the least). Beyond the measured resolutions 0.25 is added to s for every halving of the cells. An accuracy counts as reached where sure is at least
// `confidence`, 0.8 unless asked otherwise.
// Presets: "draft" is for_accuracy(scene, 0.05), "standard" 0.02, "reference" the most accurate measured point of the front of error against cost.
// Validity: a scene is as good as its kind; an error of another measure than the table's is another number.
// Cost of a question: some 100,000 logarithms.
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
  double extent = 0, duration = 0, strength = 1;
  bool tube = false;
};

struct advice {
  method how;
  double cells = 0;     // per length
  double error = 0;     // predicted
  double cost = 0;      // s, predicted
  double sure = 0;      // probability that the error (for_budget: the predicted one, give or take a fifth) is not exceeded
  bool reaches = false; // what was asked; if not, this comes nearest (least error that one of six exceeds)
  bool beyond = false;  // finer than measured
  std::string why;
};

class advisor {
public:
  explicit advisor(table t) : table_(std::move(t)) {
    for (const row& r : table_.rows)
      if (r.skip) add(r);
    require(!curves_.empty(), "rows of '" + table_.source + "' with skipping", 0, "at least 1");
    for (curve& c : curves_) {
      std::sort(c.points.begin(), c.points.end(), [](const point& a, const point& b) { return a.cells < b.cells; });
      for (std::size_t k = c.points.size() - 1; k-- > 0;) c.points[k].error = std::max(c.points[k].error, c.points[k + 1].error); // what a coarser run has less is luck
    }
    learn();
  }

  /// Only methods for which offered(method) holds, from now on: what a program cannot compose is not advised.
  template <class F> void offer(F&& offered) {
    std::erase_if(curves_, [&](const curve& c) { return !offered(c.how); });
    require(!curves_.empty(), "measured methods that can be offered", 0, "at least 1");
  }

  static constexpr double usual_confidence = 0.8;

  /// The cheapest that reaches a relative error with this probability.
  advice for_accuracy(const scene& what, double accuracy, double confidence = usual_confidence) const {
    require(accuracy > 0 && accuracy < 1, "accuracy", accuracy, "more than 0 and less than 1 (1 % is 0.01)");
    require(confidence > 0 && confidence < 1, "confidence", confidence, "more than 0 and less than 1");
    check(what);
    candidate best, nearest;
    std::size_t reaching = 0, all = 0;
    for (const method& how : methods(what.kind)) {
      ++all;
      for (const double cells : resolutions(what.kind, how)) {
        const candidate c = at(what, how, cells);
        if (nearest.cells == 0 || std::log(c.error) + spread(what, c) < std::log(nearest.error) + spread(what, nearest)) nearest = c; // exceeded by one of six
        if (sure(what, c, accuracy) < confidence) continue;
        ++reaching;
        if (best.cells == 0 || c.cost < best.cost) best = c;
        break;
      }
    }
    const candidate& chosen = reaching > 0 ? best : nearest;
    advice a = answer(what, chosen, accuracy);
    a.reaches = reaching > 0;
    a.why = a.reaches ? "the cheapest of " + std::to_string(reaching) + " methods, of " + std::to_string(all) + ", that reach " + percent(accuracy) + " with " + percent(confidence) + " confidence"
                      : "none of " + std::to_string(all) + " methods reaches " + percent(accuracy) + " with " + percent(confidence) + " confidence; this comes nearest";
    a.why += basis(what, chosen);
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
      const candidate least = at(what, how, coarsest(of));
      if (least.cost < cheapest.cost) cheapest = least;
      for (const double cells : resolutions(what.kind, how)) {
        const candidate c = at(what, how, cells);
        if (c.cost <= seconds && c.error < best.error) best = c;
      }
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
    return front(what).back();
  }

  /// The measured points that no other beats in both error and cost, the cheapest first.
  std::vector<advice> front(const scene& what) const {
    check(what);
    auto all = candidates(what);
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

  /// The power of the strength that errors of a kind go with; 0 where the kind has one problem.
  double exponent(const std::string& kind) const { return find_kind(kind).exponent; }
  /// Standard deviation of ln(error) among the problems of a kind (same method and resolution, the power of the strength taken out); that of all kinds together where
  /// the kind has one problem, 0.5 where none has more.
  double scatter(const std::string& kind) const { return find_kind(kind).scatter; }

private:
  struct point {
    double cells, error, cost;
  };
  /// One method on one problem.
  struct curve {
    std::string problem, kind;
    double extent, duration, strength;
    bool tube;
    method how;
    std::vector<point> points;
  };
  struct candidate {
    method how;
    double cells = 0, error = 0, cost = 0;
    double finer = 1; // than measured, so many times
    bool beyond() const { return finer > 1 + 1e-9; }
  };

  /// What the problems of a kind have in common.
  struct kind_facts {
    double exponent = 0, scatter = 0.5, weakest = 0, strongest = 0;
    std::vector<std::pair<method, double>> scatter_of_method{};
  };

  table table_;
  std::vector<curve> curves_;
  std::map<std::string, kind_facts> facts_; // of all measured methods

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
    curves_.push_back({r.problem, r.kind, r.extent, r.duration, r.strength, r.tube, r.how, {{r.cells, r.error, r.cost}}});
  }
  void check(const scene& what) const {
    require(what.extent > 0 && what.extent < 1e15, "extent of the scene", what.extent, "positive and finite");
    require(what.duration > 0 && what.duration < 1e15, "duration of the scene", what.duration, "positive and finite");
    require(what.strength > 0 && what.strength < 1e15, "strength of the scene", what.strength, "positive and finite");
    const auto known = kinds();
    if (std::find(known.begin(), known.end(), what.kind) != known.end()) return;
    std::string list;
    for (const auto& k : known) list += (list.empty() ? "" : ", ") + k;
    throw bad_parameter("kind of the scene = '" + what.kind + "': was not measured; there are " + list);
  }

  const kind_facts& find_kind(const std::string& kind) const {
    const auto at = facts_.find(kind);
    if (at == facts_.end()) throw bad_parameter("kind = '" + kind + "': was not measured");
    return at->second;
  }

  /// f(strengths, logarithms of the errors) for every method and resolution of a kind that several problems have.
  template <class F> void each_group(const std::string& kind, F&& f) const {
    std::vector<double> x, y;
    for (const curve& c : curves_) {
      if (c.kind != kind) continue;
      const auto all = curves(kind, c.how);
      if (all.size() < 2 || all.front() != &c) continue; // each method once
      for (const point& p : c.points) {
        x.clear(), y.clear();
        for (const curve* other : all)
          if (const double e = measured_error(*other, p.cells); e > 0) x.push_back(std::log(other->strength)), y.push_back(std::log(e));
        if (x.size() > 1) f(c.how, x, y);
      }
    }
  }
  static double mean(const std::vector<double>& x) {
    double sum = 0;
    for (const double v : x) sum += v;
    return sum / static_cast<double>(x.size());
  }
  /// Exponents and scatters of all kinds.
  void learn() {
    double all_sum = 0, all_n = 0;
    for (const std::string& kind : kinds()) {
      kind_facts& k = facts_[kind];
      for (const curve& c : curves_)
        if (c.kind == kind) k.weakest = k.weakest > 0 ? std::min(k.weakest, c.strength) : c.strength, k.strongest = std::max(k.strongest, c.strength);
      std::vector<double> slopes;
      each_group(kind, [&](const method&, const std::vector<double>& x, const std::vector<double>& y) {
        double xx = 0, xy = 0;
        for (std::size_t i = 0; i < x.size(); ++i) xx += square_of(x[i] - mean(x)), xy += (x[i] - mean(x)) * (y[i] - mean(y));
        if (xx > 1e-4) slopes.push_back(xy / xx);
      });
      std::sort(slopes.begin(), slopes.end());
      if (!slopes.empty()) k.exponent = slopes[slopes.size() / 2];
      double sum = 0, n = 0;
      std::vector<std::pair<method, std::pair<double, double>>> own; // of each method: sum of squares, number
      each_group(kind, [&](const method& how, const std::vector<double>& x, const std::vector<double>& y) {
        double squares = 0;
        for (std::size_t i = 0; i < x.size(); ++i) squares += square_of(y[i] - mean(y) - k.exponent * (x[i] - mean(x)));
        const double freedom = static_cast<double>(x.size() - 1);
        sum += squares, n += freedom;
        if (own.empty() || own.back().first != how) own.push_back({how, {0, 0}});
        own.back().second.first += squares, own.back().second.second += freedom;
      });
      if (n > 0) k.scatter = std::max(0.1, std::sqrt(sum / n));
      constexpr double weight = 4; // that of the kind's scatter against the method's own figures
      for (const auto& [how, figures] : own)
        k.scatter_of_method.emplace_back(how, std::max(0.1, std::sqrt((figures.first + weight * square_of(k.scatter)) / (figures.second + weight))));
      all_sum += sum, all_n += n;
    }
    for (auto& [kind, k] : facts_)
      if (k.scatter_of_method.empty() && all_n > 0) k.scatter = std::max(0.1, std::sqrt(all_sum / all_n));
  }
  double scatter(const std::string& kind, const method& how) const {
    const kind_facts& k = find_kind(kind);
    for (const auto& [known, s] : k.scatter_of_method)
      if (known == how) return s;
    return k.scatter;
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
  /// That most of the problems were measured on (a problem that was not goes on with its order).
  static double finest(const std::vector<const curve*>& of) {
    std::vector<double> cells;
    for (const curve* c : of) cells.push_back(c->points.back().cells);
    std::sort(cells.begin(), cells.end());
    return cells[(cells.size() - 1) / 2];
  }
  /// From the coarsest measured to twice the finest in steps of a sixth or less where whole numbers of particles per length allow it, and the measured ones.
  std::vector<double> resolutions(const std::string& kind, const method& how) const {
    std::vector<double> all;
    const auto of = curves(kind, how);
    const double low = coarsest(of), high = 2 * finest(of);
    for (double layers = std::ceil(low * how.per_axis - 1e-9); layers <= high * how.per_axis + 1e-9; layers = std::max(layers + 1, std::floor(layers * 7 / 6)))
      all.push_back(layers / how.per_axis);
    for (const curve* c : of)
      for (const point& p : c->points)
        if (p.cells >= low && p.cells <= high) all.push_back(p.cells);
    all.push_back(high);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < 1e-9 * b; }), all.end());
    return all;
  }
  /// The measured ones of the kind that the method has.
  std::vector<double> measured_resolutions(const std::string& kind, const method& how) const {
    std::vector<double> all;
    const auto of = curves(kind, how);
    for (const double cells : resolutions(kind, how))
      if (cells <= finest(of) && std::any_of(of.begin(), of.end(), [&](const curve* c) { return measured_error(*c, cells) > 0; })) all.push_back(cells);
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

  /// What a problem's curve says of the scene.
  double log_error_of(const curve& c, const scene& what, double cells) const {
    const kind_facts& k = find_kind(what.kind);
    const double strength = std::min(std::max(what.strength, k.weakest / 1.5), 1.5 * k.strongest);
    return interpolate(c, cells, -order(c), [](const point& p) { return p.error; }) + k.exponent * std::log(strength / c.strength);
  }
  candidate at(const scene& what, const method& how, double cells) const {
    candidate c{how, cells, 0, 0, 1};
    const auto of = curves(what.kind, how);
    double log_cost = 0, log_error = 0;
    for (const curve* one : of) {
      log_error += log_error_of(*one, what, cells);
      const double grows = one->tube ? 2 : 3; // cost with cells
      log_cost += interpolate(*one, cells, grows, [](const point& p) { return p.cost; }) +
                  std::log(work(what.extent, what.duration, what.tube, cells) / work(one->extent, one->duration, one->tube, cells));
    }
    c.error = std::exp(log_error / static_cast<double>(of.size()));
    c.cost = std::exp(log_cost / static_cast<double>(of.size()));
    c.finer = std::max(1.0, cells / finest(of));
    return c;
  }
  std::vector<candidate> candidates(const scene& what) const {
    std::vector<candidate> all;
    for (const method& how : methods(what.kind))
      for (const double cells : measured_resolutions(what.kind, how)) all.push_back(at(what, how, cells));
    return all;
  }
  /// Standard deviation of ln(true/predicted error).
  double spread(const scene& what, const candidate& c) const {
    return (scatter(what.kind, c.how) + 0.25 * std::log2(c.finer)) * std::sqrt(1 + 1 / static_cast<double>(curves(what.kind, c.how).size()));
  }
  /// The probability that the error is at most `asked`.
  double sure(const scene& what, const candidate& c, double asked) const {
    return 0.5 * std::erfc(-std::log(asked / c.error) / spread(what, c) / std::sqrt(2.0));
  }
  advice answer(const scene& what, const candidate& c, double asked) const { return {c.how, c.cells, c.error, c.cost, sure(what, c, asked), false, c.beyond(), {}}; }
  std::string basis(const scene& what, const candidate& c) const {
    const std::size_t n = problems(what.kind);
    std::string text = ", by the " + std::string(n == 1 ? "one problem" : std::to_string(n) + " problems") + " of kind " + what.kind + ":";
    for (const curve* one : curves(what.kind, c.how))
      text += (text.back() == ':' ? " " : ", ") + one->problem + " " + percent(std::exp(interpolate(*one, c.cells, -order(*one), [](const point& p) { return p.error; })));
    return c.beyond() ? text + " (beyond the finest measured)" : text;
  }
};

} // namespace bolide::advise
