// SPDX-License-Identifier: MIT
// docs/verification.md from the rows that verify::record (verify/table.hpp) collected: one JSON object per line, in any order.
//
// Rows are put in order by section, problem, composition and measure (numbers within a text by their value), so that the page does not
// depend on which test ran first. A row has one of three verdicts: "met", "missed", and "reported" where nothing was asked of it.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <istream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::table {

struct row {
  std::string section, problem, composition, measure, unit, note;
  double value, bound, order, expected_order, seconds; // NaN: not stated
  bool met;
  bool asked() const { return !std::isnan(bound) || !std::isnan(expected_order); }
  const char* verdict() const { return !met ? "**missed**" : asked() ? "met" : "reported"; }
};

/// What the page says of where it was made: "processor", "compiler", ...
using facts = std::vector<std::pair<std::string, std::string>>;

/// The sections in the order of the page, each with a line of what it holds. Others follow in alphabetical order.
struct section_head {
  const char *name, *text;
};
inline constexpr std::array<section_head, 8> sections{{
    {"smooth", "Manufactured and analytic solutions without shocks: what order the method reaches where nothing breaks it."},
    {"shocks", "Exact solutions with shocks. First order in L1 is the most that a captured shock allows."},
    {"solids", "Elastic and plastic bodies against exact or published answers."},
    {"conservation", "Mass, momentum, angular momentum and energy by the ledger."},
    {"symmetry", "Galilean shift, mirror images, r-z against 3-D."},
    {"energy drift", "Change of the total energy for every scheme and transfer."},
    {"extremes", "Runs that must end well where numbers get extreme."},
    {"stable range", "How far each composition can be pushed, and what ends it. Measured, so nothing is asked."},
}};

/// Reads rows, one JSON object per line. Throws std::runtime_error with the number of a line that is none.
inline std::vector<row> read_rows(std::istream& in) {
  const auto number = [](const nlohmann::json& j, const char* name) {
    const auto& x = j.at(name);
    return x.is_null() ? std::numeric_limits<double>::quiet_NaN() : x.get<double>();
  };
  std::vector<row> rows;
  std::string line;
  for (int n = 1; std::getline(in, line); ++n) {
    if (line.empty()) continue;
    try {
      const auto j = nlohmann::json::parse(line);
      rows.push_back({j.at("section"), j.at("problem"), j.at("composition"), j.at("measure"), j.at("unit"), j.at("note"), number(j, "value"), number(j, "bound"),
                      number(j, "order"), number(j, "expected_order"), number(j, "seconds"), j.at("met")});
    } catch (const nlohmann::json::exception& e) {
      throw std::runtime_error("line " + std::to_string(n) + " is no row of the verification table: " + e.what());
    }
  }
  return rows;
}

/// a < b with runs of digits compared by value: "50 cells" before "100 cells".
inline int compare(std::string_view a, std::string_view b) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j] ? -1 : 1;
      ++i, ++j;
      continue;
    }
    const auto run = [&](std::string_view s, std::size_t& at) {
      while (at < s.size() && s[at] == '0') ++at;
      const auto begin = at;
      while (at < s.size() && digit(s[at])) ++at;
      return s.substr(begin, at - begin);
    };
    const auto x = run(a, i), y = run(b, j);
    if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
    if (const int c = x.compare(y)) return c;
  }
  return static_cast<int>(i < a.size()) - static_cast<int>(j < b.size()); // equal up to leading zeros: whichever ends first
}
inline std::size_t rank_of(const std::string& section) {
  const auto at = std::find_if(sections.begin(), sections.end(), [&](const section_head& s) { return section == s.name; });
  return static_cast<std::size_t>(at - sections.begin());
}
inline bool before(const row& a, const row& b) {
  if (const auto x = rank_of(a.section), y = rank_of(b.section); x != y) return x < y;
  for (const auto part : {&row::section, &row::problem, &row::composition, &row::measure, &row::unit, &row::note})
    if (const int c = compare(a.*part, b.*part)) return c < 0;
  return std::isnan(b.value) ? !std::isnan(a.value) : a.value < b.value;
}

inline std::string figure(double x, int digits = 3) {
  if (std::isnan(x)) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}
inline std::string fixed(double x) {
  if (std::isnan(x)) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", x);
  return text;
}
/// Text that cannot end a cell of a table.
inline std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}
inline std::string anchor(const std::string& heading) { // as GitHub makes it
  std::string out;
  for (const char c : heading) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u)) out += static_cast<char>(std::tolower(u));
    else if (c == ' ' || c == '-') out += '-';
  }
  return out;
}
inline std::string asked_order(const row& r) {
  if (std::isnan(r.order) && std::isnan(r.expected_order)) return "";
  const std::string order = std::isnan(r.order) ? "none" : fixed(r.order);
  return std::isnan(r.expected_order) ? order : order + " (" + figure(r.expected_order) + ")";
}

/// The tables of one problem; notes are numbered below it, one number for all rows that share a note.
inline std::string problem_table(const row* begin, const row* end) {
  std::string text = "| composition | measure | result | bound | order (expected) | s | verdict |\n|---|---|---|---|---|---|---|\n";
  std::vector<std::string> notes;
  for (const row* r = begin; r != end; ++r) {
    std::string mark;
    if (!r->note.empty()) {
      auto at = std::find(notes.begin(), notes.end(), r->note);
      if (at == notes.end()) at = notes.insert(notes.end(), r->note);
      mark = " [" + std::to_string(at - notes.begin() + 1) + "]";
    }
    const std::string result = std::isnan(r->value) ? "none" : figure(r->value, 4) + (r->unit.empty() ? "" : " " + cell(r->unit));
    text += "| " + cell(r->composition) + " | " + cell(r->measure) + " | " + result + " | " + figure(r->bound) + " | " + asked_order(*r) + " | " + figure(r->seconds, 2) +
            " | " + r->verdict() + mark + " |\n";
  }
  for (std::size_t n = 0; n < notes.size(); ++n) text += (n == 0 ? "\n" : "") + std::string("[") + std::to_string(n + 1) + "] " + notes[n] + "\\\n";
  if (!notes.empty()) text.erase(text.size() - 2, 1); // no line break after the last one
  return text + "\n";
}

inline std::string counts_by_section(const std::vector<row>& rows) {
  std::string text = "| section | rows | met | missed | reported only | solver time, s |\n|---|---|---|---|---|---|\n";
  for (auto r = rows.begin(); r != rows.end();) {
    const auto end = std::find_if(r, rows.end(), [&](const row& x) { return x.section != r->section; });
    const auto missed = std::count_if(r, end, [](const row& x) { return !x.met; }), asked = std::count_if(r, end, [](const row& x) { return x.met && x.asked(); });
    double seconds = 0;
    for (auto x = r; x != end; ++x) seconds += std::isnan(x->seconds) ? 0 : x->seconds;
    text += "| [" + r->section + "](#" + anchor(r->section) + ") | " + std::to_string(end - r) + " | " + std::to_string(asked) + " | " + std::to_string(missed) + " | " +
            std::to_string(end - r - asked - missed) + " | " + figure(seconds, 2) + " |\n";
    r = end;
  }
  return text + "\n";
}

inline std::string list_of_misses(const std::vector<row>& rows) {
  std::string text;
  for (const auto& r : rows)
    if (!r.met)
      text += "- " + r.section + ", " + r.problem + ", " + r.composition + ": " + r.measure + " " + (std::isnan(r.value) ? "none" : figure(r.value, 4)) +
              (r.unit.empty() ? "" : " " + r.unit) + (std::isnan(r.bound) ? "" : ", bound " + figure(r.bound)) +
              (asked_order(r).empty() ? "" : ", order " + asked_order(r)) + ". " + (r.note.empty() ? "No reason was stated." : r.note) + "\n";
  return text.empty() ? text : "## Missed\n\n" + text + "\n";
}

inline std::string render(std::vector<row> rows, const facts& where) {
  std::stable_sort(rows.begin(), rows.end(), before);
  const auto missed = std::count_if(rows.begin(), rows.end(), [](const row& r) { return !r.met; });
  const auto asked = std::count_if(rows.begin(), rows.end(), [](const row& r) { return r.asked() || !r.met; });
  std::string text = "# Verification: every result, its bound and its cost\n\n**" + std::to_string(missed) + " of " + std::to_string(asked) +
                     " rows that something is asked of are missed**; " + std::to_string(static_cast<std::ptrdiff_t>(rows.size()) - asked) + " more are reported only.\n\n" +
                     "This page is written by a program from what the tests measure. One command runs the suites again and rewrites it:\n\n"
                     "```\ncmake --build --preset release --target verification_table\n```\n\n"
                     "A row is met when |result| is at most the bound and the observed order at least three quarters of the expected one. Errors are relative unless a unit\n"
                     "stands behind them; the order is that of the two finest resolutions; s is the solver's time in seconds at the finest one.\n\n";
  for (const auto& [name, what] : where) text += "- " + name + ": " + what + "\n";
  text += (where.empty() ? "" : "\n") + counts_by_section(rows) + list_of_misses(rows);
  for (std::size_t i = 0; i < rows.size();) {
    const auto same = [&](const row& r, bool problem) { return r.section == rows[i].section && (!problem || r.problem == rows[i].problem); };
    if (i == 0 || rows[i - 1].section != rows[i].section) {
      const auto rank = rank_of(rows[i].section);
      text += "## " + rows[i].section + "\n\n" + (rank < sections.size() ? sections[rank].text + std::string("\n\n") : "");
    }
    std::size_t end = i;
    while (end < rows.size() && same(rows[end], true)) ++end;
    text += "### " + rows[i].problem + "\n\n" + problem_table(rows.data() + i, rows.data() + end);
    i = end;
  }
  text.pop_back();
  return text;
}

} // namespace bolide::table
