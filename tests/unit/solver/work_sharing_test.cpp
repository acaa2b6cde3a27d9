// SPDX-License-Identifier: MIT
// Every place of every list is done once, whatever the number of threads and places, and lists after each other.
#include "bolide/solver/work_sharing.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace {

void expect_each_once(int threads, std::size_t places) {
  constexpr std::size_t lists = 3;
  bolide::work_sharing work;
  for (int round = 0; round < 5; ++round) {
    std::vector<std::atomic<int>> done(lists * places), before(places);
    work.begin(lists, threads);
#if defined(_OPENMP)
#pragma omp parallel num_threads(threads)
#endif
    for (std::size_t list = 0; list < lists; ++list)
      work.run(list, places, [&](std::size_t i) {
        ++done[list * places + i];
        if (list == 1) // all of the list before are done
          for (std::size_t k = 0; k < places; ++k) before[i] += done[k];
      });
    for (const auto& d : done) ASSERT_EQ(d, 1) << threads << " threads, " << places << " places";
    for (const auto& b : before) ASSERT_EQ(b, static_cast<int>(places)) << threads << " threads, " << places << " places";
  }
}

TEST(WorkSharing, EveryPlaceOfAListIsDoneOnceAndBeforeTheNextList) {
  for (const int threads : {1, 2, 3, 7})
    for (const std::size_t places : {0, 1, 2, 5, 64}) expect_each_once(threads, places);
}
TEST(WorkSharing, ACopyBeginsAnew) {
  bolide::work_sharing work;
  work.begin(1, 1);
  const auto count = [](bolide::work_sharing& w) {
    int n = 0;
    w.run(0, 4, [&](std::size_t) { ++n; });
    return n;
  };
  EXPECT_EQ(count(work), 4);
  auto copy = work;
  EXPECT_EQ(count(copy), 4);
  EXPECT_EQ(count(work), 0) << "done already";
}

} // namespace
