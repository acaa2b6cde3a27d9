// SPDX-License-Identifier: MIT
#include "bolide/observe/progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace bolide::observe {
namespace {

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(progress, plain_lines_are_few) {
  std::ostringstream to;
  progress bar(1e-6, to, false);
  for (int i = 0; i <= 10000; ++i) bar.report(i * 1e-3, i * 1e-10, i); // 10 s
  EXPECT_GE(lines(to.str()), 3); // start, 5 s, end
  EXPECT_LE(lines(to.str()), 4);
  EXPECT_EQ(to.str().find('\r'), std::string::npos);
  EXPECT_NE(to.str().find("100.0 %"), std::string::npos);
  EXPECT_NE(to.str().find("done in 10 s"), std::string::npos) << to.str();
}

TEST(progress, a_long_run_is_heard_of_every_minute) {
  std::ostringstream to;
  progress bar(1e-6, to, false);
  for (int i = 0; i < 600; ++i) bar.report(i, i * 1e-12, i); // 0.06 % in ten minutes
  EXPECT_EQ(lines(to.str()), 10);
}

TEST(progress, a_terminal_gets_one_line_drawn_over) {
  std::ostringstream to;
  progress bar(1e-6, to, true);
  for (int i = 0; i <= 1000; ++i) bar.report(i * 1e-2, i * 1e-9, i, i < 500 ? "limited by the sound speed" : "");
  EXPECT_EQ(lines(to.str()), 1);
  EXPECT_EQ(to.str().back(), '\n');
  const std::string text = to.str();
  const long drawn = std::count(text.begin(), text.end(), '\r');
  EXPECT_GE(drawn, 90);
  EXPECT_LE(drawn, 102);
  EXPECT_NE(to.str().find("[############............]"), std::string::npos);
}

TEST(progress, time_left_follows_the_recent_rate) {
  std::ostringstream to;
  progress bar(1.0, to, true);
  // slow at first (0.1 in 10 s), then 0.1 a second: at 15 s done 0.6, so 4 s are left, while the mean rate says 10 s
  for (int i = 0; i <= 100; ++i) bar.report(i * 0.1, i * 1e-3, i);
  for (int i = 1; i <= 50; ++i) bar.report(10 + i * 0.1, 0.1 + i * 0.01, i);
  EXPECT_NE(to.str().rfind("15 s so far, 4 s left"), std::string::npos) << to.str().substr(to.str().rfind('\r'));
}

TEST(progress, an_early_end_leaves_a_clean_line) {
  std::ostringstream to;
  {
    progress bar(1.0, to, true);
    bar.report(1, 0.5, 10);
  }
  EXPECT_EQ(to.str().back(), '\n');
  progress other(1.0, to, true);
  other.report(1, 0.5, 10);
  other.finish();
  const std::string once = to.str();
  other.report(2, 0.6, 11);
  other.finish();
  EXPECT_EQ(to.str(), once);
}

TEST(progress, durations) {
  EXPECT_EQ(progress::duration_text(42.4), "42 s");
  EXPECT_EQ(progress::duration_text(185), "3 min 05 s");
  EXPECT_EQ(progress::duration_text(7620), "2 h 07 min");
  EXPECT_EQ(progress::duration_text(std::nan("")), "?");
  EXPECT_THROW(progress(0), bad_parameter);
}

} // namespace
} // namespace bolide::observe
