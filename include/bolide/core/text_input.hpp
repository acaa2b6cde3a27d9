// SPDX-License-Identifier: MIT
// Reading numbers from a text file with refusals that say where: "al.eam line 7: expected ..., found 'abc'".
#pragma once

#include "bolide/core/contract.hpp"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

namespace bolide::text {

/// The whole file; a refusal names the path and the system's reason.
inline std::string read_file(const std::string& path) {
  const auto refuse = [&](const char* what) { throw bad_parameter("file '" + path + "': " + what + " (" + std::strerror(errno) + ")"); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) refuse("cannot be opened");
  std::string all;
  char block[65536];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file.get())) all.append(block, n);
  if (std::ferror(file.get())) refuse("cannot be read");
  return all;
}

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// A word for a message: at most 40 characters, what cannot be printed as '?'.
inline std::string shown(std::string_view word) {
  std::string r = "'";
  for (const char c : word.substr(0, 40)) r += c >= 32 && c < 127 ? c : '?';
  return r.append(word.size() > 40 ? "...'" : "'");
}

/// Is the word, all of it, a finite number? A Fortran exponent (1.5D-03) and a leading plus are read too.
inline bool parse_number(std::string_view word, double& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1); // from_chars knows no plus sign
  char buffer[64];
  if (word.empty() || word.size() > sizeof buffer) return false;
  for (std::size_t i = 0; i < word.size(); ++i) buffer[i] = word[i] == 'D' || word[i] == 'd' ? 'e' : word[i];
  const auto [end, error] = std::from_chars(buffer, buffer + word.size(), value);
  if (error == std::errc::result_out_of_range && end == buffer + word.size()) { // 1e-400 is 0, 1e400 is no number
    value = std::strtod(std::string(buffer, word.size()).c_str(), nullptr);
    return std::isfinite(value);
  }
  return error == std::errc() && end == buffer + word.size() && std::isfinite(value);
}

/// Walks through a text word by word and line by line.
class cursor {
public:
  cursor(std::string_view all, std::string_view source) : rest_(all), source_(source) {}

  std::size_t line() const { return line_; }
  /// Refuses with source and line.
  [[noreturn]] void refuse(std::string_view what) const { refuse_at(line_, what); }
  [[noreturn]] void refuse_at(std::size_t line, std::string_view what) const {
    throw bad_parameter(std::string(source_).append(" line ").append(std::to_string(line)).append(": ").append(what));
  }

  /// What is left of this line, which is then behind; false at the end of the text.
  bool next_line(std::string_view& found) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    found = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (end != std::string_view::npos) ++line_;
    return true;
  }
  /// The next word on this line or below; empty at the end of the text. The cursor then stands on the word's line.
  std::string_view next_word() {
    while (!rest_.empty() && (is_blank(rest_[0]) || rest_[0] == '\n')) {
      if (rest_[0] == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    return take_word();
  }
  /// The next word of this line; empty at its end.
  std::string_view next_word_of_line() {
    while (!rest_.empty() && is_blank(rest_[0])) rest_.remove_prefix(1);
    return take_word();
  }

private:
  std::string_view take_word() {
    std::size_t n = 0;
    while (n < rest_.size() && !is_blank(rest_[n]) && rest_[n] != '\n') ++n;
    const std::string_view word = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return word;
  }

  std::string_view rest_;
  std::string source_;
  std::size_t line_ = 1;
};

} // namespace bolide::text
