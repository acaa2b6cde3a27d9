// SPDX-License-Identifier: MIT
// The cells of a table without quoted text, row by row.
#pragma once

#include "unit/observe/test_folder.hpp"

#include <sstream>
#include <vector>

namespace bolide::observe::test {

inline std::vector<std::vector<std::string>> read_rows(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(bytes_of(path));
  for (std::string line; std::getline(text, line);) {
    rows.emplace_back();
    for (std::size_t at = 0; at != std::string::npos;) {
      const std::size_t comma = line.find(',', at);
      rows.back().push_back(line.substr(at, comma == std::string::npos ? comma : comma - at));
      at = comma == std::string::npos ? comma : comma + 1;
    }
  }
  return rows;
}

} // namespace bolide::observe::test
