// SPDX-License-Identifier: MIT
// A table as comma-separated values that is valid at any moment.
//
// The header row names the columns with their units, "time (s)". Numbers have 17 significant digits, so a double reads back as the
// same double. Each row is handed to the system in one piece, so a run that is stopped leaves whole rows. Text with a comma, a
// quote or a line break is quoted as in RFC 4180. A row with another number of cells than the header is refused.
#pragma once

#include "bolide/observe/durable_file.hpp"
#include "bolide/observe/whole_file.hpp"

#include <cerrno>
#include <charconv>
#include <concepts>
#include <cstdint>
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

/// How far a table had come when a checkpoint was taken; 0 bytes: it was not open yet.
struct csv_mark {
  std::uint64_t bytes = 0, rows = 0;
  template <class A> void archive(A& a) {
    a.value("bytes", bytes);
    a.value("rows", rows);
  }
};

class csv_table {
 public:
  /// Opens `path` anew and writes the header. With a mark the table goes on from there: rows that were written after it are taken off. A
  /// file that is not there is begun anew; one that is shorter than the mark or has another header is refused.
  csv_table(const std::filesystem::path& path, const std::vector<std::string>& header, const csv_mark& from = {})
      : path_(path), columns_(header.size()) {
    require(!header.empty(), "columns of the table " + path.string(), 0, "at least 1");
    make_folder_of(path);
    const std::string first = line(std::vector<csv_cell>(header.begin(), header.end()));
    const bool goes_on = from.bytes > 0 && std::filesystem::exists(path);
    if (goes_on) cut(first, from);
    errno = 0;
    file_.open(path, std::ios::binary | (goes_on ? std::ios::app : std::ios::trunc));
    if (!file_) throw output_error("cannot open the table " + path.string() + ": " + std::strerror(errno));
    if (!goes_on) write(first);
  }
  /// The place to go on from: all rows so far, on the disk.
  csv_mark mark() const {
    flush_to_disk(path_);
    return {bytes_, rows_};
  }

  void row(const std::vector<csv_cell>& cells) {
    require(cells.size() == columns_, "cells in row " + std::to_string(rows_ + 1) + " of the table " + path_.string(),
            static_cast<double>(cells.size()), "the " + std::to_string(columns_) + " of its header");
    write(line(cells));
    ++rows_;
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

 private:
  static std::string line(const std::vector<csv_cell>& cells) {
    std::string text;
    for (const csv_cell& cell : cells) text += cell.text() + ',';
    text.back() = '\n';
    return text;
  }
  /// One line in one write, then out of the buffer: whoever stops the program finds whole rows.
  void write(const std::string& text) {
    errno = 0;
    file_.write(text.data(), static_cast<std::streamsize>(text.size()));
    file_.flush();
    if (!file_) throw output_error("cannot write a row of the table " + path_.string() + ": " + std::strerror(errno));
    bytes_ += text.size();
  }
  /// Cuts an existing table at the mark, if it is the one that the mark is of.
  void cut(const std::string& header, const csv_mark& from) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path_, error);
    std::string there(header.size(), '\0');
    std::ifstream(path_, std::ios::binary).read(there.data(), static_cast<std::streamsize>(there.size()));
    if (error || size < from.bytes || there != header)
      throw output_error("the table " + path_.string() +
                         (there != header ? " has another header than the one"
                                          : " has " + std::to_string(size) + " bytes, fewer than the " + std::to_string(from.bytes)) +
                         " that the checkpoint goes on from");
    std::filesystem::resize_file(path_, from.bytes, error);
    if (error) throw output_error("cannot shorten the table " + path_.string() + ": " + error.message());
    bytes_ = from.bytes;
    rows_ = from.rows;
  }
  std::filesystem::path path_;
  std::size_t columns_;
  std::uint64_t bytes_ = 0, rows_ = 0;
  std::ofstream file_;
};

} // namespace bolide::observe
