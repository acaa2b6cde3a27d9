// SPDX-License-Identifier: MIT
// Runs of the example aluminium_impact for tests of its checkpoints: 825 particles, some 70 steps, in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace checkpoint_test {

namespace fs = std::filesystem;
using nlohmann::json;
using seconds = std::chrono::duration<double>;

inline std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Checkpoint : public ::testing::Test {
protected:
  fs::path folder;
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("bolide_checkpoint_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// Starts the example in the folder; its standard error goes to the file `err`.
  pid_t start(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{BOLIDE_EXAMPLE, "--spacing", "0.4mm", "--cell", "0.8mm", "--until", "1us", "--frames", "10", "--pictures", "none"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (auto& w : words) argv.push_back(w.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder.c_str()) != 0 || !std::freopen("out", "w", stdout) || !std::freopen("err", "w", stderr)) ::_exit(126);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  static int wait(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  int run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }

  /// All results but the checkpoints, without what the clock measured: name -> bytes.
  std::map<std::string, std::string> results(const std::string& of) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder / of)) {
      const auto name = entry.path().filename();
      if (name.extension() == ".h5" || name.extension() == ".part") continue;
      if (name != "summary.json") files[name] = read(entry.path());
      else {
        json j = json::parse(read(entry.path()));
        for (const char* clock : {"wall_s", "solver_s", "ns_per_particle_step"}) j.erase(clock);
        files[name] = j.dump();
      }
    }
    return files;
  }
  static std::string differing(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
    std::string names = a.size() == b.size() ? "" : "another number of files; ";
    for (const auto& [name, bytes] : a)
      if (!b.count(name) || b.at(name) != bytes) names += name + "; ";
    return names;
  }
};

} // namespace checkpoint_test
