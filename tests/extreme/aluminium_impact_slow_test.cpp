// SPDX-License-Identifier: MIT
// A run of the example aluminium_impact that is killed at any moment goes on from its newest checkpoint to the same files as one that was
// never stopped: 20 kills at random moments, while a checkpoint is written after every step.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE) && __has_include(<hdf5.h>)

#include "extreme/checkpoint_runs.hpp"

#include <random>

using namespace checkpoint_test;

TEST_F(Checkpoint, ARunThatIsKilledAtAnyMomentGoesOnToTheSameFiles) {
  ASSERT_EQ(run({"--out", "whole"}), 0);
  const auto whole = results("whole");
  ASSERT_EQ(whole.size(), 1u + 11 + 1 + 1) << "history, frames, their list, summary";
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run({"--out", "timed", "--checkpoint-every", "1"}), 0);
  const seconds takes = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(differing(whole, results("timed")), "") << "checkpoints change nothing";

  std::mt19937_64 random(11);
  int killed = 0, went_on = 0;
  for (int k = 0; killed < 20 && k < 60; ++k) { // on a machine whose load changes a run may end before it is killed
    const fs::path checkpoint = folder / "killed/checkpoint.h5";
    std::vector<std::string> arguments{"--out", "killed", "--checkpoint-every", "1"};
    if (k % 4 == 0) fs::remove_all(folder / "killed"); // four kills one after another, each later in the run, then anew
    if (fs::exists(checkpoint)) arguments.insert(arguments.end(), {"--restart", checkpoint.string()});
    const pid_t child = start(arguments);
    std::this_thread::sleep_for(takes * std::uniform_real_distribution<double>(0.05, k % 4 == 0 ? 0.9 : 0.5)(random));
    ::kill(child, SIGKILL);
    killed += wait(child) == -SIGKILL;
    if (!fs::exists(checkpoint)) continue; // killed before the first one
    ++went_on;
    fs::remove_all(folder / "rest");
    fs::copy(folder / "killed", folder / "rest");
    ASSERT_EQ(run({"--out", "rest", "--restart", "rest/checkpoint.h5"}), 0) << "kill " << k << ": " << read(folder / "err");
    EXPECT_EQ(differing(whole, results("rest")), "") << "kill " << k;
    if (fs::exists(folder / "rest/checkpoint_previous.h5")) {
      ASSERT_EQ(run({"--out", "rest", "--restart", "rest/checkpoint_previous.h5"}), 0) << "kill " << k << ": " << read(folder / "err");
      EXPECT_EQ(differing(whole, results("rest")), "") << "the one before, kill " << k;
    }
  }
  EXPECT_EQ(killed, 20);
  EXPECT_GE(went_on, 12);
}

#endif
