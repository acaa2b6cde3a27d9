// SPDX-License-Identifier: MIT
// All named materials. A new one: its own file beside these, and its line here.
#pragma once

#include "bolide/material/data/aluminium.hpp"
#include "bolide/material/data/aluminium_1100.hpp"
#include "bolide/material/data/aluminium_2024.hpp"
#include "bolide/material/data/aluminium_6061.hpp"
#include "bolide/material/data/copper.hpp"
#include "bolide/material/data/iron.hpp"
#include "bolide/material/data/lead.hpp"
#include "bolide/material/data/steel_4340.hpp"
#include "bolide/material/data/tungsten.hpp"

#include <array>
#include <string>
#include <string_view>

namespace bolide::data {

inline constexpr std::array library{aluminium, aluminium_2024, aluminium_6061, aluminium_1100, copper, iron, steel_4340, lead, tungsten};

/// "aluminium, aluminium_2024, ...", for messages.
inline std::string names() {
  std::string list;
  for (const parameter_set& set : library) list.append(list.empty() ? "" : ", ").append(set.name);
  return list;
}

/// The material of that name; throws bad_parameter with the names that there are. `what` is what the sentence calls it.
inline const parameter_set& find(std::string_view name, std::string_view what = "material") {
  for (const parameter_set& set : library)
    if (set.name == name) return set;
  throw bad_parameter(std::string(what) + " = '" + std::string(name) + "': no such material; the library has " + names());
}

} // namespace bolide::data
