// SPDX-License-Identifier: MIT
// Observers made of a function: `every(0.6 * us, f)` calls f(sim) at the start, at the first step past each multiple of the period, and at
// the end; `at_end(f)` calls it once the run is over. The steps themselves are not cut to hit the times, so that a run does not
// depend on who watches it. If f returns the path of what it wrote, a run that stops names it as the last good output.
#pragma once

#include "bolide/core/contract.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bolide::observe {

/// When a table takes its samples: a period in seconds (0: after every step), or a list of times. Each is due at the first step on or after it.
class schedule {
public:
  schedule(double period) : period_(period) { require(period >= 0, "interval of samples", period, "non-negative", "s"); }
  schedule(std::vector<double> times) : times_(std::move(times)) {
    require(!times_.empty(), "number of sample times", 0, "at least 1");
    std::sort(times_.begin(), times_.end());
    for (const double t : times_) require(std::isfinite(t) && t >= 0, "sample time", t, "non-negative and finite", "s");
  }

  /// Is a sample due at this time? Asking moves on to the next.
  bool due(double time) {
    if (time < next() * (1 - 1e-12)) return false;
    if (times_.empty())
      while (period_ > 0 && next_ <= time * (1 + 1e-12)) next_ += period_;
    else
      while (at_ < times_.size() && times_[at_] <= time * (1 + 1e-12)) ++at_;
    return true;
  }
  /// Does the end of the run belong to it? A list of times says all of them.
  bool with_end() const { return times_.empty(); }
  /// For checkpoints (concepts/archive.hpp): where it stands, not what it is.
  template <class A> void archive(A& a) {
    a.value("next", next_);
    a.value("taken", at_);
  }

private:
  double next() const { return times_.empty() ? next_ : at_ < times_.size() ? times_[at_] : std::numeric_limits<double>::infinity(); }
  double period_ = 0, next_ = 0;
  std::vector<double> times_; // s, ascending; empty: by the period
  std::size_t at_ = 0;
};

template <class F> class every {
public:
  every(double period, F f) : period_(period), f_(std::move(f)) { require(period > 0, "period of an observer", period, "positive", "s"); }

  template <class Sim> void watch(const Sim& sim) {
    if (called_ && sim.time() < next_) return;
    call(sim);
  }
  template <class Sim> void finish(const Sim& sim) {
    if (!called_ || sim.time() > last_) call(sim);
  }
  /// What f said that it wrote.
  std::string last_output() const { return output_; }
  /// For checkpoints (concepts/archive.hpp).
  template <class A> void archive(A& a) {
    a.value("called", called_);
    a.value("last", last_);
    a.value("next", next_);
    a.value("output", output_);
  }

private:
  template <class Sim> void call(const Sim& sim) {
    called_ = true; // before the call, which may save a checkpoint
    last_ = sim.time();
    next_ = period_ * (std::floor(last_ / period_ * (1 + 1e-12)) + 1);
    if constexpr (std::is_convertible_v<decltype(f_(sim)), std::filesystem::path>) output_ = std::filesystem::path(f_(sim)).string();
    else f_(sim);
  }
  double period_, next_ = 0, last_ = 0;
  bool called_ = false;
  std::string output_;
  F f_;
};

template <class F> class at_end {
public:
  explicit at_end(F f) : f_(std::move(f)) {}
  template <class Sim> void watch(const Sim&) {}
  template <class Sim> void finish(const Sim& sim) { f_(sim); }

private:
  F f_;
};

} // namespace bolide::observe
