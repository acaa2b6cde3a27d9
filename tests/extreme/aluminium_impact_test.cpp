// SPDX-License-Identifier: MIT
// Checkpoints of the example aluminium_impact as its users meet them: an interrupted run goes on, another run is refused with a sentence.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE) && __has_include(<hdf5.h>)

#include "extreme/checkpoint_runs.hpp"
#include "verify/table.hpp"

using namespace checkpoint_test;

TEST_F(Checkpoint, AnInterruptedRunKeepsItsStateAndGoesOn) {
  ASSERT_EQ(run({"--out", "whole"}), 0);
  const pid_t child = start({"--out", "parts", "--checkpoint-every", "3"});
  while (!fs::exists(folder / "parts/checkpoint.h5") && ::kill(child, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(child, SIGTERM);
  ASSERT_EQ(wait(child), 128 + SIGTERM) << read(folder / "err");
  ASSERT_EQ(run({"--out", "parts", "--restart", "parts/checkpoint.h5"}), 0) << read(folder / "err");
  const auto files = differing(results("whole"), results("parts"));
  bolide::verify::record({.section = "extremes", .problem = "19 restart in the middle",
                          .composition = "the example, 825 particles, B-spline APIC USF",
                          .measure = "interrupted once: results that differ in a bit", .value = files.empty() ? 0.0 : 1.0, .bound = 0, .unit = "runs"});
  EXPECT_EQ(files, "") << "the last row and frame of the interrupted run are taken off again";
}

TEST_F(Checkpoint, AnotherRunAndBadValuesAreRefusedWithASentence) {
  ASSERT_EQ(run({"--out", "a", "--checkpoint-every", "0.4us"}), 0);
  const struct {
    std::vector<std::string> arguments;
    std::vector<std::string> names;
  } cases[] = {
      {{"--restart", "a/checkpoint.h5", "--eos", "paper"},
       {"--restart", "a/checkpoint.h5", "another composition", "eos is 'mixed' in the file and 'paper' here"}},
      {{"--restart", "a/checkpoint.h5", "--tension", "1.6GPa"}, {"tension is '1.5GPa' in the file and '1.6GPa' here"}},
      {{"--restart", "a/checkpoint.h5", "--transfer", "flip"}, {"transfer is 'apic' in the file and 'flip' here"}},
      {{"--restart", "a/checkpoint.h5", "--precision", "float"}, {"precision is 'double' in the file and 'float' here"}},
      {{"--restart", "a/checkpoint.h5", "--cell", "0.6mm"}, {"cell is '0.8mm' in the file and '600um' here"}},
      {{"--restart", "a/checkpoint.h5", "--box", "60mm,-40mm,80mm"}, {"box is 'none' in the file and '60mm,-40mm,80mm' here"}},
      {{"--restart", "a/history.csv"}, {"a/history.csv", "is no HDF5 file"}},
      {{"--restart", "b.h5"}, {"b.h5", "cannot be read"}},
      {{"--restart", "a/checkpoint.h5", "--ensemble", "2"}, {"--restart", "one run", "--ensemble"}},
      {{"--restart", "a/checkpoint.h5", "--compare"}, {"--restart", "one run", "--compare"}},
      {{"--checkpoint-every", "0us"}, {"--checkpoint-every", "0us", "more than 0"}},
      {{"--checkpoint-every", "0"}, {"--checkpoint-every", "whole number from 1"}},
      {{"--checkpoint-every", "3mm"}, {"--checkpoint-every", "3mm", "time"}},
  };
  for (const auto& c : cases) {
    auto arguments = c.arguments;
    arguments.insert(arguments.end(), {"--out", "b"});
    EXPECT_EQ(run(arguments), 2) << arguments[0] << " " << arguments[1];
    const std::string sentence = read(folder / "err");
    for (const auto& part : c.names) EXPECT_NE(sentence.find(part), std::string::npos) << "'" << part << "' is not in: " << sentence;
    EXPECT_FALSE(fs::exists(folder / "b")) << "nothing is written";
  }
}

TEST_F(Checkpoint, ARunMayGoOnForLonger) {
  ASSERT_EQ(run({"--out", "longer", "--until", "1.4us"}), 0);
  ASSERT_EQ(run({"--out", "a", "--until", "1.4us", "--checkpoint-every", "0.3us", "--step-cap", "40"}), 3) << "stopped by the cap";
  ASSERT_EQ(run({"--out", "a", "--until", "1.4us", "--restart", "a/checkpoint.h5"}), 0) << read(folder / "err");
  json a = json::parse(read(folder / "a/summary.json")), b = json::parse(read(folder / "longer/summary.json"));
  EXPECT_EQ(a["steps"], b["steps"]);
  EXPECT_EQ(a["energy"], b["energy"]);
  EXPECT_EQ(a["steps_by_cause"], b["steps_by_cause"]);
  EXPECT_EQ(read(folder / "a/particles_0010.vtu"), read(folder / "longer/particles_0010.vtu"));
}

#endif
