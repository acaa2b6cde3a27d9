// SPDX-License-Identifier: MIT
// Quantities as people write them: "9.5mm", "6.64 km/s", "1.5GPa", "293K". Read once at the edge of a program; inside all is SI.
//
//   parse("9.5mm", dimension::length)     9.5 * unit::mm, the same double that C++ code with unit constants gets
//   format(9.5e-3, dimension::length)     "9.5mm"; what format writes, parse reads back as exactly the same number
//
// A number without a unit is refused, since 9.5 may be millimetres or metres and the difference is a crater. Only the
// dimensionless take bare numbers. A refusal is a bad_parameter whose sentence names the text and lists the units of the dimension.
#pragma once

#include "bolide/core/contract.hpp"

#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace bolide::quantity {

/// What a number measures.
enum class dimension { length, velocity, pressure, time, temperature, density, dimensionless };

/// A unit's spelling and its size in SI.
struct spelled_unit {
  std::string_view name;
  double factor;
};

namespace detail {
// The SI unit comes first.
inline constexpr spelled_unit length_units[] = {{"m", 1}, {"km", 1e3}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}};
inline constexpr spelled_unit velocity_units[] = {{"m/s", 1}, {"km/s", 1e3}, {"mm/us", 1e3}, {"cm/us", 1e4}};
inline constexpr spelled_unit pressure_units[] = {{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9},
                                                  {"TPa", 1e12}, {"bar", 1e5}, {"kbar", 1e8}, {"Mbar", 1e11}};
inline constexpr spelled_unit time_units[] = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"ps", 1e-12}};
inline constexpr spelled_unit temperature_units[] = {{"K", 1}, {"kK", 1e3}};
inline constexpr spelled_unit density_units[] = {{"kg/m3", 1}, {"g/cm3", 1e3}, {"g/cc", 1e3}};

struct dimension_entry {
  dimension what;
  std::string_view name; // with its article, for the sentences
  std::span<const spelled_unit> units;
  std::string_view written; // the units that format() chooses from, besides SI
  std::string_view example;
};
inline constexpr dimension_entry dimensions[] = {
    {dimension::length, "a length", length_units, "km mm um nm", "9.5mm"},
    {dimension::velocity, "a velocity", velocity_units, "km/s", "6640m/s"},
    {dimension::pressure, "a pressure", pressure_units, "kPa MPa GPa TPa", "1.5GPa"},
    {dimension::time, "a time", time_units, "ms us ns ps", "6.6us"},
    {dimension::temperature, "a temperature", temperature_units, "", "293K"},
    {dimension::density, "a density", density_units, "", "2785kg/m3"},
    {dimension::dimensionless, "a plain number", {}, "", "0.3"},
};
constexpr const dimension_entry& entry(dimension d) { return dimensions[static_cast<std::size_t>(d)]; }

constexpr const spelled_unit* find_unit(dimension d, std::string_view name) {
  for (const auto& unit : entry(d).units)
    if (unit.name == name) return &unit;
  return nullptr;
}

/// Is `word` one of the blank-separated words of `list`?
constexpr bool lists(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const auto end = list.find(' ');
    if (list.substr(0, end) == word) return true;
    list = end == std::string_view::npos ? std::string_view{} : list.substr(end + 1);
  }
  return false;
}

constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}
} // namespace detail

/// The spellings of a dimension's units, SI first: "m km cm mm um nm". Empty for the dimensionless.
inline std::string units_of(dimension d) {
  std::string list;
  for (const auto& unit : detail::entry(d).units) list.append(list.empty() ? "" : " ").append(unit.name);
  return list;
}

namespace detail {
[[noreturn]] inline void refuse(std::string_view name, std::string_view text, dimension d, std::string_view why) {
  std::string sentence;
  if (!name.empty()) sentence.append(name).append(" = ");
  sentence.append("'").append(text).append("': ").append(why).append("; ").append(entry(d).name);
  if (entry(d).units.empty()) sentence.append(" has no unit");
  else sentence.append(" needs one of the units ").append(units_of(d));
  throw bad_parameter(sentence.append(" (for example ").append(entry(d).example).append(")"));
}

/// Why `unit` is no unit of d.
inline std::string unknown_unit(std::string_view unit, dimension d) {
  for (const auto& other : dimensions)
    if (other.what != d && find_unit(other.what, unit)) return std::string("'").append(unit).append("' is a unit of ").append(other.name);
  return std::string("unknown unit '").append(unit).append("'");
}
} // namespace detail

/// The SI value of a quantity written as number and unit, blanks allowed between them. `name` is what the sentence of a refusal calls it.
inline double parse(std::string_view text, dimension d, std::string_view name = {}) {
  std::string_view rest = detail::trimmed(text);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1); // from_chars knows no plus sign
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error == std::errc::invalid_argument || !(std::isfinite(value))) detail::refuse(name, text, d, "not a number");
  if (error == std::errc::result_out_of_range) detail::refuse(name, text, d, "too large or too small for a double");
  const auto unit_name = detail::trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
  if (unit_name.empty()) {
    if (d != dimension::dimensionless) detail::refuse(name, text, d, "has no unit");
    return value;
  }
  const auto* unit = detail::find_unit(d, unit_name);
  if (!unit) detail::refuse(name, text, d, detail::unknown_unit(unit_name, d));
  const double si = value * unit->factor;
  if (!std::isfinite(si)) detail::refuse(name, text, d, "too large or too small for a double");
  return si;
}

namespace detail {
/// `si` in this unit with the fewest digits that survive the product with the unit's factor; empty where none do.
inline std::string written_in(const spelled_unit& unit, double si, dimension d) {
  for (const int digits : {15, 16, 17}) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, si / unit.factor, std::chars_format::general, digits).ptr;
    auto text = std::string(buffer, end).append(unit.name);
    if (parse(text, d) == si) return text;
  }
  return {};
}
} // namespace detail

/// Number and unit such that parse() gives exactly `si` back: the shortest such text, with a liking for numbers between 1 and
/// 1000 (0.05mm rather than 5e-05m). A quantity that is not finite is written as a bare inf or nan, which parse() refuses.
inline std::string format(double si, dimension d) {
  if (d == dimension::dimensionless || !std::isfinite(si)) return to_text(si);
  const auto& entry = detail::entry(d);
  std::string best = to_text(si).append(entry.units.front().name); // times one: exact for every double
  if (si == 0) return best;
  std::size_t best_cost = 2 * best.size() + 7;
  for (const auto& unit : entry.units) {
    if (unit.factor != 1 && !detail::lists(entry.written, unit.name)) continue;
    const auto text = detail::written_in(unit, si, d);
    const double size = std::fabs(si / unit.factor);
    const std::size_t cost = 2 * text.size() + (size >= 0.01 && size < 1000 ? (size < 1 ? 1 : 0) : 6);
    if (text.empty() || cost >= best_cost) continue;
    best = text;
    best_cost = cost;
  }
  return best;
}

} // namespace bolide::quantity
