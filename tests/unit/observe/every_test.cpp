// SPDX-License-Identifier: MIT
#include "bolide/observe/every.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace bolide;

namespace {
struct clock_only {
  double now = 0;
  double time() const { return now; }
};
} // namespace

TEST(every, calls_at_the_start_past_each_multiple_and_at_the_end) {
  std::vector<double> called;
  observe::every watch(1.0, [&](const clock_only& c) { called.push_back(c.time()); });
  for (const double t : {0.0, 0.3, 0.9, 1.2, 1.9, 3.5, 3.9}) watch.watch(clock_only{t});
  watch.finish(clock_only{3.9});
  EXPECT_EQ(called, (std::vector<double>{0.0, 1.2, 3.5, 3.9}));
}

TEST(every, does_not_call_twice_for_the_last_time) {
  int calls = 0;
  observe::every watch(1.0, [&](const clock_only&) { ++calls; });
  watch.watch(clock_only{0});
  watch.watch(clock_only{2});
  watch.finish(clock_only{2});
  EXPECT_EQ(calls, 2);
}

TEST(every, a_period_that_is_no_time_is_refused) {
  EXPECT_THROW(observe::every(0.0, [](const clock_only&) {}), bad_parameter);
}

TEST(at_end, calls_once) {
  int calls = 0;
  observe::at_end watch([&](const clock_only&) { ++calls; });
  watch.watch(clock_only{0});
  watch.finish(clock_only{1});
  EXPECT_EQ(calls, 1);
}

TEST(every, keeps_the_path_of_what_was_written) {
  observe::every watch(1.0, [](const clock_only& c) { return "frame_" + std::to_string(static_cast<int>(c.time())) + ".png"; });
  EXPECT_EQ(watch.last_output(), "");
  watch.watch(clock_only{0});
  watch.watch(clock_only{2.5});
  EXPECT_EQ(watch.last_output(), "frame_2.png");
}

TEST(schedule, period_and_list) {
  observe::schedule each(0.0), tenth(0.1), list(std::vector{0.5, 0.2});
  std::vector<double> a, b, c;
  for (const double t : {0.0, 0.05, 0.1, 0.35, 0.36, 0.5, 0.9}) {
    if (each.due(t)) a.push_back(t);
    if (tenth.due(t)) b.push_back(t);
    if (list.due(t)) c.push_back(t);
  }
  EXPECT_EQ(a.size(), 7u);
  EXPECT_EQ(b, (std::vector<double>{0.0, 0.1, 0.35, 0.5, 0.9}));
  EXPECT_EQ(c, (std::vector<double>{0.35, 0.5}));
  EXPECT_TRUE(each.with_end());
  EXPECT_FALSE(list.with_end());
  EXPECT_THROW(observe::schedule(-1.0), bad_parameter);
  EXPECT_THROW(observe::schedule(std::vector{0.1, -1.0}), bad_parameter);
}
