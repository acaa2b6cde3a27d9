// SPDX-License-Identifier: MIT
#include "materials.hpp"

#include "bolide/analysis/oblique_shock_reference.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/material/data/library.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace impact {

using bolide::bad_parameter;
namespace data = bolide::data;

void print_materials(std::ostream& to) {
  char line[320];
  std::snprintf(line, sizeof line, "%-16s %-46s %8s %7s %6s %7s  %-8s %-10s %s\n", "name", "", "density", "c0", "s", "gamma0", "phases",
                "tillotson", "source");
  to << line;
  std::snprintf(line, sizeof line, "%-16s %-46s %8s %7s %6s %7s  %-8s %-10s\n", "", "", "kg/m3", "m/s", "", "", "", "");
  to << line;
  for (const auto& m : data::library) {
    const auto text = [](std::string_view v) { return std::string(v); };
    std::snprintf(line, sizeof line, "%-16s %-46s %8.0f %7.0f %6.3f %7.2f  %-8s %-10s %s\n", text(m.name).c_str(),
                  text(m.description).c_str(), m.density, m.mie_grueneisen.c0, m.mie_grueneisen.s, m.mie_grueneisen.gamma0,
                  m.phases ? "yes" : "-", m.tillotson ? "yes" : "-", text(m.source).c_str());
    to << line;
  }
  to << "phases: --eos paper, mixed, helm and reference. Mie-Grueneisen: all. \"From memory\" means: re-check before quoting.\n";
}

void check_material(const std::string& name, const std::string& eos, const std::string& label) {
  const auto& m = data::find(name, label);
  const bool grover = eos == "paper" || eos == "mixed" || eos == "helm" || eos == "reference";
  if ((grover && m.phases) || (eos == "tillotson" && m.tillotson) || eos == "mie-gruneisen") return;
  std::string able;
  for (const auto& other : data::library)
    if (grover ? other.phases.has_value() : other.tillotson.has_value()) able.append(able.empty() ? "" : ", ").append(other.name);
  throw bad_parameter(label + " = '" + name + "': the library has no parameters of this material for --eos " + eos + " (it has them for " +
                      able + "); take --eos mie-gruneisen");
}

double contact_line_reference(const std::string& projectile, const std::string& target, double speed) {
  double highest = std::nan("");
  for (const auto& name : {projectile, target}) {
    const bolide::eos::mie_grueneisen hugoniot{data::find(name).mie_grueneisen};
    try {
      highest =
          std::fmax(highest, bolide::analysis::oblique_shock_reference(hugoniot, bolide::eos::cold_state(hugoniot), speed).reference());
    } catch (const bad_parameter&) { // too slow for an attached oblique shock: no reference
      return std::nan("");
    }
  }
  return highest;
}

} // namespace impact
