// SPDX-License-Identifier: MIT
// The table of options: how each setting is read from text (with units), written back as text, and explained.
// Command line, config file, the echo of the settings in summary.json and --help all go through it.
#pragma once

#include "settings.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace impact {

struct option {
  std::string name;  // without dashes
  std::string value; // what --help shows as the value
  std::string help;
  std::string group;                                                                  // heading in --help
  bool echoed;                                                                        // part of the settings that reproduce a run
  std::function<void(settings&, std::string_view text, std::string_view label)> read; // throws bolide::bad_parameter
  std::function<std::string(const settings&)> write;
};

const std::vector<option>& options();

/// The option of that name; throws bad_parameter that lists the names.
const option& find_option(std::string_view name);

/// Name and text of all settings that reproduce the run.
std::vector<std::pair<std::string, std::string>> echo(const settings& s);

/// Checks what options cannot check alone: each setting against the others. Throws bad_parameter.
void check(const settings& s);

/// The command line: settings, or an exit code where the program is done (help, version, list, a mistake, explained on stderr).
struct request {
  settings chosen;
  int exit_code = -1; // -1: go on
};
request read_command_line(int argc, char** argv);

/// Applies a JSON file, a flat object of option names and values or a summary.json with such an object under "settings".
void read_config(settings& s, const std::string& path);

} // namespace impact
