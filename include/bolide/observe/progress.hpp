// SPDX-License-Identifier: MIT
// How far a run is: on a terminal a bar that is drawn over itself, ten times a second at most; elsewhere plain lines, one every 5 s
// or 5 % of the way, whichever comes later, but one a minute. Always on standard error, so that standard output stays the program's.
//
// The time left is (1 - done) / rate with the rate of progress of the last third of the time so far: the step of an impact is small
// while the shocks run and grows later, so the mean since the start would promise too much time.
// Call it every step or every few: a call that is not due costs one look at the clock.
#pragma once

#include "bolide/core/contract.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

class progress {
 public:
  /// `end` is the time (s) at which the run ends. Writes to standard error.
  explicit progress(double end) : progress(end, std::cerr, isatty(STDERR_FILENO) != 0) {}

  /// For another stream; `terminal` chooses between bar and lines.
  progress(double end, std::ostream& to, bool terminal) : end_(end), to_(&to), terminal_(terminal) {
    require(end > 0 && std::isfinite(end), "end of the run", end, "more than 0", "s");
  }

  /// Reports if it is due. `note` may say more, such as what limits the time step.
  void operator()(double time, long step, const std::string& note = {}) { report(seconds_since_start(), time, step, note); }

  /// The same with the wall time given, in seconds since the start (for tests and for restarts).
  void report(double wall, double time, long step, const std::string& note = {}) {
    const double done = std::clamp(time / end_, 0.0, 1.0);
    if (finished_ || !due(wall, done)) return;
    last_wall_ = wall, last_done_ = done;
    history_.emplace_back(wall, done);
    const std::string text = line(wall, done, time, step, note);
    if (terminal_) {
      // blanks wipe out what a longer line left
      *to_ << '\r' << text << std::string(width_ > text.size() ? width_ - text.size() : 0, ' ');
      width_ = text.size();
      open_line_ = true;
    } else {
      *to_ << text << '\n';
    }
    if (done >= 1) finish();
    to_->flush();
  }

  /// Ends the bar's line, so that what follows stands below it. Called at the end of time, or by hand when a run stops early.
  void finish() {
    if (open_line_) *to_ << '\n' << std::flush;
    open_line_ = false, finished_ = true;
  }
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;
  ~progress() {
    if (open_line_) *to_ << '\n' << std::flush;
  }

  /// "42 s", "3 min 05 s", "2 h 07 min".
  static std::string duration_text(double seconds) {
    if (!std::isfinite(seconds)) return "?";
    char buffer[64];
    const long s = std::lround(seconds);
    if (s < 60) std::snprintf(buffer, sizeof buffer, "%ld s", s);
    else if (s < 3600) std::snprintf(buffer, sizeof buffer, "%ld min %02ld s", s / 60, s % 60);
    else std::snprintf(buffer, sizeof buffer, "%ld h %02ld min", s / 3600, s / 60 % 60);
    return buffer;
  }

 private:
  double seconds_since_start() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  bool due(double wall, double done) const {
    if (done >= 1) return true;
    if (terminal_) return wall - last_wall_ >= 0.1;
    return (wall - last_wall_ >= 5 && done - last_done_ >= 0.05) || wall - last_wall_ >= 60;
  }

  /// Seconds left, from the progress of the last third of the wall time.
  double left(double wall, double done) const {
    double from_wall = 0, from_done = 0;
    for (const auto& [w, d] : history_)
      if (w <= wall * 2 / 3) from_wall = w, from_done = d;
    const double rate = (done - from_done) / (wall - from_wall);
    return rate > 0 ? (1 - done) / rate : std::nan("");
  }

  std::string line(double wall, double done, double time, long step, const std::string& note) const {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, "%5.1f %%  t = %.3f us  step %ld  ", 100 * done, time / 1e-6, step);
    std::string text;
    if (terminal_) {
      constexpr int cells = 24;
      const int full = static_cast<int>(done * cells);
      text = "[" + std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(cells - full), '.') + "] ";
    }
    text += numbers;
    text += done >= 1 ? "done in " + duration_text(wall) : duration_text(wall) + " so far, " + duration_text(left(wall, done)) + " left";
    return note.empty() ? text : text + "  " + note;
  }

  double end_;
  std::ostream* to_;
  bool terminal_, open_line_ = false, finished_ = false;
  std::size_t width_ = 0;
  double last_wall_ = -1e30, last_done_ = -1e30; // the first call is always due
  std::vector<std::pair<double, double>> history_; // wall time, share done
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace bolide::observe
