// SPDX-License-Identifier: MIT
// A run of the example aluminium_impact that is killed at any moment goes on from its newest checkpoint to the same files as one that was
// never stopped: 20 kills at random moments, while a checkpoint is written after every step.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE) && __has_include(<hdf5.h>)

#include "extreme/checkpoint_runs.hpp"
#include "verify/table.hpp"

#include <sys/stat.h>

#include <random>

using namespace checkpoint_test;

/// Until the file was replaced so many times, at most 20 s.
void wait_for_changes(const fs::path& path, int changes) {
  const auto which = [&] {
    struct stat s {};
    return ::stat(path.c_str(), &s) == 0 ? s.st_ino : 0;
  };
  auto last = which();
  for (int waited = 0; changes > 0 && waited < 40000; ++waited) {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    if (const auto now = which(); now != last) last = now, --changes;
  }
}

TEST_F(Checkpoint, ARunThatIsKilledAtAnyMomentGoesOnToTheSameFiles) {
  ASSERT_EQ(run({"--out", "whole"}), 0);
  const auto whole = results("whole");
  ASSERT_EQ(whole.size(), 1u + 11 + 1 + 1) << "history, frames, their list, summary";
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run({"--out", "timed", "--checkpoint-every", "1"}), 0);
  const seconds takes = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(differing(whole, results("timed")), "") << "checkpoints change nothing";

  const double steps = json::parse(read(folder / "whole/summary.json"))["steps"];
  ASSERT_GT(steps, 60) << "four times up to 14 steps must not end a run";
  std::mt19937_64 random(11);
  int killed = 0, went_on = 0, differ = 0;
  for (int k = 0; k < 20; ++k) {
    const fs::path checkpoint = folder / "killed/checkpoint.h5";
    std::vector<std::string> arguments{"--out", "killed", "--checkpoint-every", "1"};
    if (k % 4 == 0) fs::remove_all(folder / "killed"); // four kills one after another, each later in the run, then anew
    if (fs::exists(checkpoint)) arguments.insert(arguments.end(), {"--restart", checkpoint.string()});
    const pid_t child = start(arguments);
    wait_for_changes(checkpoint, std::uniform_int_distribution<int>(0, 12)(random));
    std::this_thread::sleep_for(takes / steps * std::uniform_real_distribution<double>(0, 2)(random)); // anywhere within a step and its checkpoint
    ::kill(child, SIGKILL);
    killed += wait(child) == -SIGKILL;
    if (!fs::exists(checkpoint)) continue; // killed before the first one
    ++went_on;
    fs::remove_all(folder / "rest");
    fs::copy(folder / "killed", folder / "rest");
    ASSERT_EQ(run({"--out", "rest", "--restart", "rest/checkpoint.h5"}), 0) << "kill " << k << ": " << read(folder / "err");
    const auto files = differing(whole, results("rest"));
    EXPECT_EQ(files, "") << "kill " << k;
    differ += !files.empty();
    if (fs::exists(folder / "rest/checkpoint_previous.h5")) {
      ASSERT_EQ(run({"--out", "rest", "--restart", "rest/checkpoint_previous.h5"}), 0) << "kill " << k << ": " << read(folder / "err");
      EXPECT_EQ(differing(whole, results("rest")), "") << "the one before, kill " << k;
    }
  }
  EXPECT_GE(killed, 16) << "on a machine that is very busy a run may end before it is killed";
  EXPECT_GE(went_on, 15);
  bolide::verify::record({.section = "extremes", .problem = "19 restart in the middle",
                          .composition = "the example, 825 particles, B-spline APIC USF",
                          .measure = "restarts that end in other bits, of " + std::to_string(went_on) + " after " + std::to_string(killed) + " kills",
                          .value = double(differ), .bound = 0, .unit = "restarts"});
}

#endif
