// SPDX-License-Identifier: MIT
// Checked at the door: a constructor that is given a bad parameter throws once, with name, value, bound and unit in a sentence.
#pragma once

#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>

namespace bolide {

/// Thrown by constructors and entry points on bad input. what() is a sentence with name, value, bound and unit.
struct bad_parameter : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The shortest text that reads back as the same number.
inline std::string to_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

/// Throws bad_parameter "name = value unit: bound" unless `holds`. NaN fails every comparison, so write the bound as what must hold.
inline void require(bool holds, std::string_view name, double value, std::string_view bound, std::string_view unit = "") {
  if (holds) return;
  std::string text(name);
  text.append(" = ").append(to_text(value));
  if (!unit.empty()) text.append(" ").append(unit);
  text.append(": must be ").append(bound);
  if (!unit.empty()) text.append(" (unit: ").append(unit).append(")");
  throw bad_parameter(text);
}

} // namespace bolide
