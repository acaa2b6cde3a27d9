// SPDX-License-Identifier: MIT
// Observers made of a function: `every(0.6 * us, f)` calls f(sim) at the start, at the first step past each multiple of the period, and at
// the end; `at_end(f)` calls it once the run is over. The steps themselves are not cut to hit the times, so that a run does not
// depend on who watches it.
#pragma once

#include "bolide/core/contract.hpp"

#include <cmath>
#include <utility>

namespace bolide::observe {

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

private:
  template <class Sim> void call(const Sim& sim) {
    f_(sim);
    called_ = true;
    last_ = sim.time();
    next_ = period_ * (std::floor(last_ / period_ * (1 + 1e-12)) + 1);
  }
  double period_, next_ = 0, last_ = 0;
  bool called_ = false;
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
