// SPDX-License-Identifier: MIT
// A table as comma-separated values that is valid at any moment.
//
// The header row names the columns with their units, "time (s)". Numbers have 17 significant digits, so a double reads back as the
// same double. Each row is handed to the system in one piece, so a run that is stopped leaves whole rows. Text with a comma, a
// quote or a line break is quoted as in RFC 4180. A row with another number of cells than the header is refused.
#pragma once

#include "bolide/observe/whole_file.hpp"

#include <cerrno>
#include <charconv>
#include <concepts>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::observe {

/// What stands in one place of the table: a number or a text. Made from either without a word, so that a row reads
/// table.row({sim.time(), sim.steps(), "sound"}).
class csv_cell {
 public:
  template <std::floating_point T> csv_cell(T x) {
    char buffer[64];
    text_.assign(buffer, std::to_chars(buffer, buffer + sizeof buffer, static_cast<double>(x), std::chars_format::general, 17).ptr);
  }
  template <std::integral T> csv_cell(T x) : text_(std::to_string(x)) {}
  csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) {
      text_ = text;
      return;
    }
    text_ = '"';
    for (const char c : text) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
  }
  csv_cell(const char* text) : csv_cell(std::string_view(text)) {}
  csv_cell(const std::string& text) : csv_cell(std::string_view(text)) {}

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class csv_table {
 public:
  /// Opens `path` anew and writes the header.
  csv_table(const std::filesystem::path& path, const std::vector<std::string>& header) : path_(path), columns_(header.size()) {
    require(!header.empty(), "columns of the table " + path.string(), 0, "at least 1");
    make_folder_of(path);
    errno = 0;
    file_.open(path, std::ios::binary | std::ios::trunc);
    if (!file_) throw output_error("cannot open the table " + path.string() + ": " + std::strerror(errno));
    write(std::vector<csv_cell>(header.begin(), header.end()));
  }

  void row(const std::vector<csv_cell>& cells) {
    require(cells.size() == columns_, "cells in row " + std::to_string(rows_ + 1) + " of the table " + path_.string(),
            static_cast<double>(cells.size()), "the " + std::to_string(columns_) + " of its header");
    write(cells);
    ++rows_;
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

 private:
  /// One line in one write, then out of the buffer: whoever stops the program finds whole rows.
  void write(const std::vector<csv_cell>& cells) {
    std::string line;
    for (const csv_cell& cell : cells) line += cell.text() + ',';
    line.back() = '\n';
    errno = 0;
    file_.write(line.data(), static_cast<std::streamsize>(line.size()));
    file_.flush();
    if (!file_) throw output_error("cannot write a row of the table " + path_.string() + ": " + std::strerror(errno));
  }
  std::filesystem::path path_;
  std::size_t columns_, rows_ = 0;
  std::ofstream file_;
};

} // namespace bolide::observe
