// SPDX-License-Identifier: MIT
// Cold curves from files: an embedded-atom potential in setfl form, and a user's two columns.
#include "cold_curves.hpp"
#include "text.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/user_table.hpp"
#include "bolide/potential/setfl.hpp"

#include <cmath>
#include <filesystem>

namespace explorer {

any_cold make_setfl(const std::string& where) {
  std::string file = where, element;
  if (const auto colon = where.rfind(':'); colon != std::string::npos && !std::filesystem::exists(where))
    file = where.substr(0, colon), element = where.substr(colon + 1);
  return any_cold(bolide::cold::lattice(bolide::potential::setfl::read(file, element)));
}

namespace {

/// What the header names; throws with the line where it names nothing known.
bolide::cold::table_columns columns_of(const std::string& file, const std::string& text) {
  using namespace bolide::cold;
  const auto header = split_list(text.substr(0, text.find_first_of("\r\n")));
  const struct {
    const char* name;
    value_column what;
    double unit;
  } values[] = {{"pressure_Pa", value_column::pressure, 1},
                {"pressure_GPa", value_column::pressure, 1e9},
                {"energy_J_kg", value_column::specific_energy, 1},
                {"energy_MJ_kg", value_column::specific_energy, 1e6}};
  table_columns columns;
  for (const auto& v : values) {
    if (header.size() != 2 || header[1] != v.name || (header[0] != "x" && header[0] != "rho_kg_m3")) continue;
    columns.volume = header[0] == "x" ? volume_column::ratio : volume_column::density;
    columns.value = v.what, columns.value_unit = v.unit;
    return columns;
  }
  throw bolide::bad_parameter("file '" + file + "' line 1: the header must be x or rho_kg_m3, a comma, and one of pressure_Pa, pressure_GPa, "
                              "energy_J_kg, energy_MJ_kg");
}

} // namespace

any_cold make_user_table(const std::string& file, assignments& set) {
  const std::string text = bolide::text::read_file(file);
  bolide::cold::table_columns columns = columns_of(file, text);
  double density = std::nan("");
  set.apply({{"density", "kg/m3", &density}});
  if (!std::isnan(density)) columns.reference_density = density;
  else if (columns.volume == bolide::cold::volume_column::ratio)
    throw bolide::bad_parameter("file '" + file + "': the density at x = 1 is missing: --set density=2700kg/m3, say");
  return any_cold(bolide::cold::user_table::from_text(text, columns, file));
}

} // namespace explorer
