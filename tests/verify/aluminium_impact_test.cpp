// SPDX-License-Identifier: MIT
// --accuracy, --budget and --preset of the example aluminium_impact: a discretisation is chosen, said, and used; what was given besides is kept; bad input is
// refused with a sentence. Runs end after 50 ns: what the choice is worth is examples/tradeoff's business.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE)

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct answer {
  int code;
  std::string err;
  nlohmann::json settings; // of summary.json, where there is one
};
answer run(const std::string& arguments) {
  const fs::path folder = fs::temp_directory_path() / ("bolide_advice_" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string command =
      "cd '" + folder.string() + "' && " BOLIDE_EXAMPLE " --until 50ns --frames 0 --pictures none --out out " + arguments + " >stdout 2>stderr </dev/null";
  const int status = std::system(command.c_str());
  answer a{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder / "stderr"), {}};
  if (fs::exists(folder / "out/summary.json")) a.settings = nlohmann::json::parse(read(folder / "out/summary.json"))["settings"];
  fs::remove_all(folder);
  return a;
}

double metres(const nlohmann::json& text) { // "0.2mm"
  const auto all = text.get<std::string>();
  std::size_t end = 0;
  const double x = std::stod(all, &end);
  return all.substr(end) == "mm" ? x * 1e-3 : all.substr(end) == "um" ? x * 1e-6 : x;
}

TEST(ImpactAdvice, AnAccuracyChoosesAndSaysSo) {
  const auto rough = run("--accuracy 10%"), fine = run("--accuracy 4%");
  ASSERT_EQ(rough.code, 0) << rough.err;
  ASSERT_EQ(fine.code, 0) << fine.err;
  for (const auto* a : {&rough, &fine}) {
    EXPECT_NE(a->err.find("--accuracy "), std::string::npos);
    EXPECT_NE(a->err.find("predicted: error "), std::string::npos);
    EXPECT_NE(a->err.find("% sure"), std::string::npos);
    // what was said is what was run
    const std::string how = a->settings["shape"].get<std::string>() + " " + a->settings["transfer"].get<std::string>() + " " + a->settings["scheme"].get<std::string>() + " " +
                            a->settings["precision"].get<std::string>();
    EXPECT_NE(a->err.find(how), std::string::npos) << how << "\n" << a->err;
    // particles divide the plate
    const double layers = 2.2e-3 / metres(a->settings["spacing"]);
    EXPECT_NEAR(layers, std::round(layers), 1e-9);
  }
  EXPECT_LE(metres(fine.settings["cell"]), metres(rough.settings["cell"]) * (1 + 1e-12));
}

TEST(ImpactAdvice, ABudgetIsSpentAndBoundsTheCell) {
  const auto little = run("--budget 1ms"), more = run("--budget 50ms");
  ASSERT_EQ(little.code, 0) << little.err;
  ASSERT_EQ(more.code, 0) << more.err;
  EXPECT_LE(metres(more.settings["cell"]), metres(little.settings["cell"]) * (1 + 1e-12));
  EXPECT_NE(more.err.find("the most accurate of"), std::string::npos) << more.err;
}

TEST(ImpactAdvice, WhatIsGivenIsKept) {
  const auto a = run("--preset draft --precision float --transfer flip");
  ASSERT_EQ(a.code, 0) << a.err;
  EXPECT_EQ(a.settings["precision"], "float");
  EXPECT_EQ(a.settings["transfer"], "flip");
}

TEST(ImpactAdvice, RefusesWithASentence) {
  const auto refused = [](const std::string& arguments, const std::string& why) {
    const auto a = run(arguments);
    EXPECT_EQ(a.code, 2) << arguments;
    EXPECT_NE(a.err.find(why), std::string::npos) << a.err;
  };
  refused("--accuracy 0", "--accuracy = '0': must be more than 0 and less than 1");
  refused("--accuracy 100%", "--accuracy = '100%': must be more than 0 and less than 1");
  refused("--accuracy good", "--accuracy");
  refused("--budget 10", "--budget");
  refused("--budget 0s", "--budget = '0s': must be more than 0s");
  refused("--preset fast", "preset = 'fast': must be draft, standard or reference");
  refused("--preset draft --budget 1s", "leave the others away");
  refused("--accuracy 1% --cell 0.1mm", "--cell: is chosen by --accuracy");
  refused("--accuracy 1% --quick", "--quick: is a discretisation too");
  refused("--preset draft --cfl 0.37", "measured methods that can be offered = 0");
}

} // namespace

#else
TEST(ImpactAdvice, NeedsTheExample) { GTEST_SKIP() << "built without the example aluminium_impact"; }
#endif
