// SPDX-License-Identifier: MIT
// Numbers and tables as text: what is read (lists, quantities, CSV with line numbers) and the CSV that is written.
// Every refusal is a bolide::bad_parameter: one sentence that says where.
#pragma once

#include "bolide/core/quantity.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace explorer {

/// A finite number without a unit; `where` starts the sentence of a refusal ("line 3", "--x").
double read_number(std::string_view text, const std::string& where);

/// A number in SI, or a quantity with its unit.
double read_quantity(std::string_view text, bolide::quantity::dimension d, const std::string& where);

/// "1,2,3": the pieces between the commas, blanks removed.
std::vector<std::string> split_list(std::string_view text);
std::vector<double> read_numbers(std::string_view text, const std::string& where);

struct csv_line {
  std::size_t number; // of the line in the file, from 1
  std::vector<std::string> cells;
};
struct csv_input {
  std::vector<std::string> header;
  std::vector<csv_line> lines;
};
/// All of a CSV text, with as many cells on every line as in its header. Empty lines at its end are passed over.
csv_input read_csv(std::string_view text);
/// The file, or standard input for an empty name.
std::string read_all(const std::string& file);

/// A table as text, built in memory so that it is written whole or not at all.
class csv_output {
public:
  explicit csv_output(const std::vector<std::string>& header) { put(header); }
  void put(const std::vector<std::string>& cells);
  const std::string& text() const { return text_; }

private:
  std::string text_;
};
/// 17 significant digits, no minus sign before 0; an empty field for what is no number.
std::string written(double x);

} // namespace explorer
