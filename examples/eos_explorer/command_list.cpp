// SPDX-License-Identifier: MIT
// list: every name, its validity box, its parameters and where they come from.
#include "cold_curves.hpp"
#include "commands.hpp"
#include "text.hpp"

#include <cmath>

namespace explorer {
namespace {

/// The finite ones of a box's borders; an open side is an empty field.
std::vector<std::string> borders(const bolide::eos::validity_box& box) {
  return {written(box.density_low), written(box.density_high), written(box.energy_low), written(box.energy_high)};
}

} // namespace

answer list_models(const request&) {
  csv_output out({"kind", "name", "reference_density_kg_m3", "rho_min_kg_m3", "rho_max_kg_m3", "e_min_J_kg", "e_max_J_kg", "parameters", "source"});
  for (const auto& entry : all_equations_of_state()) {
    model_choice choice;
    choice.eos = entry.name;
    std::vector<std::string> row = {"eos", entry.name};
    eos_pointer eos;
    try {
      eos = make_eos(choice);
    } catch (const bolide::bad_parameter&) { // one that has no default
    }
    row.push_back(eos ? written(eos->reference_density()) : "");
    const auto box = eos ? borders(eos->validity()) : std::vector<std::string>(4);
    row.insert(row.end(), box.begin(), box.end());
    row.insert(row.end(), {choice.set.description(), entry.source + (eos ? "" : " required")});
    out.put(row);
  }
  for (const auto& entry : all_cold_curves()) {
    std::vector<std::string> row = {"cold", entry.name, "", "", "", "", "", "", entry.source};
    assignments set;
    if (entry.name.find(':') == std::string::npos) {
      row[2] = written(make_cold(entry.name, set, false).reference_density());
      row[7] = set.description();
    }
    out.put(row);
  }
  return {out.text(), {}, {}};
}

} // namespace explorer
