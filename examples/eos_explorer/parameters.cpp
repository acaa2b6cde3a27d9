// SPDX-License-Identifier: MIT
#include "parameters.hpp"

#include "text.hpp"

#include "bolide/core/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace explorer {
namespace {

using bolide::bad_parameter;
using bolide::quantity::dimension;
using bolide::quantity::detail::trimmed;

struct spelling {
  std::string_view unit, name; // kept in `unit`, may be written as `name`
  double factor;
};
/// Units that core/quantity.hpp does not have.
constexpr spelling spellings[] = {
    {"J/kg", "J/kg", 1},         {"J/kg", "kJ/kg", 1e3},           {"J/kg", "MJ/kg", 1e6},       {"J/(kg K)", "J/(kg K)", 1},
    {"J/(kg K)", "J/kg/K", 1},   {"J/(kg K)", "kJ/(kg K)", 1e3},   {"J/(kg K)", "kJ/kg/K", 1e3}, {"J/(kg K2)", "J/(kg K2)", 1},
    {"J/(kg K2)", "J/kg/K2", 1}, {"eV", "eV", 1},                  {"eV", "meV", 1e-3},          {"angstrom", "angstrom", 1},
    {"angstrom", "A", 1},        {"angstrom", "nm", 10},           {"angstrom", "pm", 1e-2},     {"1/angstrom", "1/angstrom", 1},
    {"1/angstrom", "1/A", 1},    {"1/angstrom", "1/nm", 0.1},      {"u", "u", 1},                {"u", "g/mol", 1},
    {"s/m", "s/m", 1},           {"s/m", "s/km", 1e-3}};

double parse_spelled(std::string_view text, std::string_view unit, const std::string& where) {
  const std::string_view all = trimmed(text);
  double value = 0;
  std::string names;
  const std::string_view rest = !all.empty() && all[0] == '+' ? all.substr(1) : all;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) throw bad_parameter(where + " = '" + std::string(text) + "': not a number");
  const std::string_view name = trimmed(all.substr(static_cast<std::size_t>(end - all.data())));
  for (const auto& s : spellings) {
    if (s.unit != unit) continue;
    if (s.name == name) return value * s.factor;
    names.append(names.empty() ? "" : " ").append(s.name);
  }
  throw bad_parameter(where + " = '" + std::string(text) + "': " + (name.empty() ? "has no unit" : "unknown unit") + "; needs one of " + names);
}

double parse_value(std::string_view text, const std::string& unit, const std::string& where) {
  if (unit.empty()) return bolide::quantity::parse(text, dimension::dimensionless, where);
  for (const auto d : {dimension::length, dimension::velocity, dimension::pressure, dimension::time, dimension::temperature, dimension::density})
    if (bolide::quantity::detail::entry(d).units.front().name == unit) return bolide::quantity::parse(text, d, where);
  return parse_spelled(text, unit, where);
}

} // namespace

void assignments::add(const std::string& text) {
  const auto equals = text.find('=');
  const std::string name(trimmed(std::string_view(text).substr(0, equals)));
  if (equals == std::string::npos || name.empty())
    throw bad_parameter("--set '" + text + "': must be name=value (for example rho0=2785kg/m3)");
  given_[name] = std::string(trimmed(std::string_view(text).substr(equals + 1)));
}

void assignments::apply(const std::vector<parameter>& parameters) {
  for (const auto& p : parameters) {
    if (const auto at = given_.find(p.name); at != given_.end()) *p.value = parse_value(at->second, p.unit, "--set " + p.name);
    known_.push_back(p.name);
    if (!description_.empty()) description_ += "; ";
    description_ += p.name + "=" + (std::isnan(*p.value) ? "?" : bolide::to_text(*p.value)) + (p.unit.empty() ? "" : " ") + p.unit;
  }
}

void assignments::check(const std::string& model) const {
  for (const auto& [name, value] : given_) {
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    std::string list;
    for (const auto& k : known_) list += (list.empty() ? "" : ", ") + k;
    throw bad_parameter("--set " + name + ": '" + model + "' has no such parameter; it has " + (list.empty() ? "none" : list));
  }
}

} // namespace explorer
