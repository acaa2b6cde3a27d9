// SPDX-License-Identifier: MIT
// budget COMPILE_COMMANDS FOLDER TOTAL_S UNIT_S UNIT_MB: compiles every translation unit below FOLDER once, exactly as the build does, and
// prints user CPU seconds and the largest resident set of each. Exits 1 when a unit or the total is over its budget.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct unit {
  std::string directory, command, file;
};

/// The text of `"key": "..."` on this line, JSON escapes undone; empty if the line has another key.
std::string value_of(const std::string& line, const std::string& key) {
  const auto at = line.find("\"" + key + "\": \"");
  if (at == std::string::npos) return {};
  std::string text;
  for (auto i = at + key.size() + 5; i < line.size() && line[i] != '"'; ++i) {
    if (line[i] == '\\') ++i;
    text += line[i];
  }
  return text;
}

/// CMake writes one key per line.
std::vector<unit> read_units(const std::string& path, const std::string& folder) {
  std::vector<unit> units;
  unit next;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (const auto text = value_of(line, "directory"); !text.empty()) next.directory = text;
    if (const auto text = value_of(line, "command"); !text.empty()) next.command = text;
    if (const auto text = value_of(line, "file"); !text.empty()) {
      next.file = text;
      if (text.rfind(folder, 0) == 0) units.push_back(next);
    }
  }
  return units;
}

/// The same command without its outputs: object and dependency file.
std::string without_outputs(const std::string& command) {
  std::istringstream words(command);
  std::string kept, word;
  while (words >> word) {
    if (word == "-o" || word == "-MT" || word == "-MF") words >> word;
    else if (word != "-MD") kept += word + ' ';
  }
  return kept + "-o /dev/null";
}

struct cost {
  double seconds, megabytes;
  bool compiled;
};

cost compile(const unit& u) {
  const std::string command = "cd '" + u.directory + "' && exec " + without_outputs(u.command);
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used); // the compiler proper and the assembler are the driver's children: counted with it
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {seconds(used.ru_utime) + seconds(used.ru_stime), double(used.ru_maxrss) / 1024, WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: budget COMPILE_COMMANDS FOLDER TOTAL_S UNIT_S UNIT_MB\n");
    return 2;
  }
  const double total_budget = std::atof(argv[3]), unit_seconds = std::atof(argv[4]), unit_megabytes = std::atof(argv[5]);
  const auto units = read_units(argv[1], argv[2]);
  double total = 0;
  bool good = !units.empty();
  for (const auto& u : units) {
    const auto c = compile(u);
    const bool within = c.compiled && c.seconds <= unit_seconds && c.megabytes <= unit_megabytes;
    std::printf("%8.2f s %7.0f MB  %s%s\n", c.seconds, c.megabytes, u.file.c_str(), within ? "" : c.compiled ? "  OVER BUDGET" : "  DOES NOT COMPILE");
    std::fflush(stdout);
    total += c.seconds;
    good = good && within;
  }
  std::printf("%8.2f s CPU in %zu units; budget %g s, %g s and %g MB per unit\n", total, units.size(), total_budget, unit_seconds, unit_megabytes);
  return good && total <= total_budget ? 0 : 1;
}
