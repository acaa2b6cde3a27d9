// SPDX-License-Identifier: MIT
#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace explorer {

using bolide::bad_parameter;
using bolide::quantity::detail::trimmed;

namespace {
[[noreturn]] void refuse(const std::string& where, std::string_view text, const char* why) {
  throw bad_parameter(where + ": '" + std::string(text) + "' " + why);
}
bool is_bare_number(std::string_view text) {
  text = trimmed(text);
  return text.empty() || std::isalpha(static_cast<unsigned char>(text.back())) == 0;
}
} // namespace

double read_number(std::string_view text, const std::string& where) {
  std::string_view rest = trimmed(text);
  if (rest.empty()) throw bad_parameter(where + ": a number is missing");
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1); // from_chars knows no plus sign
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error == std::errc::result_out_of_range) refuse(where, text, "is too large or too small for a double");
  if (error != std::errc{} || end != rest.data() + rest.size()) refuse(where, text, "is not a number");
  if (!std::isfinite(value)) refuse(where, text, "is not a finite number");
  return value;
}

double read_quantity(std::string_view text, bolide::quantity::dimension d, const std::string& where) {
  return d == bolide::quantity::dimension::dimensionless || is_bare_number(text) ? read_number(text, where) : bolide::quantity::parse(text, d, where);
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  for (;;) {
    const auto comma = text.find(',');
    parts.emplace_back(trimmed(text.substr(0, comma)));
    if (comma == text.npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::vector<double> read_numbers(std::string_view text, const std::string& where) {
  std::vector<double> numbers;
  for (const auto& part : split_list(text)) numbers.push_back(read_number(part, where));
  return numbers;
}

csv_input read_csv(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3); // a byte-order mark, as spreadsheets write it
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  while (!lines.empty() && trimmed(lines.back()).empty()) lines.pop_back();
  if (lines.empty()) throw bad_parameter("line 1: the header row is missing (the input is empty)");
  csv_input in{split_list(lines[0]), {}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    csv_line line{i + 1, split_list(lines[i])};
    if (line.cells.size() != in.header.size())
      throw bad_parameter("line " + std::to_string(line.number) + ": '" + std::string(lines[i]) + "' has " + std::to_string(line.cells.size()) +
                          " fields where the header has " + std::to_string(in.header.size()));
    in.lines.push_back(std::move(line));
  }
  return in;
}

std::string read_all(const std::string& name) {
  std::ostringstream text;
  if (name.empty() || name == "-") {
    text << std::cin.rdbuf();
    return text.str();
  }
  std::ifstream file(name, std::ios::binary);
  if (!file) throw bad_parameter("--in = '" + name + "': cannot be read");
  text << file.rdbuf();
  if (file.bad()) throw bad_parameter("--in = '" + name + "': cannot be read");
  return text.str();
}

void csv_output::put(const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text_ += ',';
    if (cells[i].find_first_of(",\"\n") == std::string::npos) {
      text_ += cells[i];
      continue;
    }
    text_ += '"';
    for (const char c : cells[i]) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
  }
  text_ += '\n';
}

std::string written(double x) {
  if (!std::isfinite(x)) return {};
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x + 0.0, std::chars_format::general, 17).ptr};
}

} // namespace explorer
