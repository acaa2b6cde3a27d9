// SPDX-License-Identifier: MIT
// Everything JSON (nlohmann): the config file that is read, summary.json that is written. A number that is none (NaN) is null.
#include "options.hpp"
#include "outcome.hpp"

#include "bolide/core/contract.hpp"
#include "bolide/core/floors.hpp"
#include "bolide/observe/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace impact {
namespace {

using json = nlohmann::ordered_json;

/// A setting in a config file: text as on the command line, or a bare number or bool where the option takes one.
std::string text_of(const json& value, const std::string& label) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return bolide::to_text(value.get<double>());
  if (value.is_number_integer()) return value.dump();
  throw bolide::bad_parameter(label + " = " + value.dump() + ": must be a text such as \"9.5mm\" or a number");
}

json energies_of(const bolide::energy_state& e, const census& c) {
  return {{"kinetic_J", e.kinetic}, {"internal_J", e.internal}, {"cold_J", c.cold}, {"thermal_J", c.thermal}, {"elastic_shear_J", c.shear}};
}

json settings_of(const settings& s) {
  json all = json::object();
  for (const auto& [name, text] : echo(s)) all[name] = text;
  return all;
}

} // namespace

void read_config(settings& s, const std::string& path) {
  std::ifstream file(path);
  if (!file) throw bolide::bad_parameter("--config = '" + path + "': cannot be read");
  json root;
  try {
    root = json::parse(file);
  } catch (const json::parse_error& e) { throw bolide::bad_parameter("--config = '" + path + "': is no JSON: " + e.what()); }
  if (!root.is_object()) throw bolide::bad_parameter("--config = '" + path + "': must hold an object of settings");
  const json& chosen = root.contains("settings") ? root["settings"] : root;
  if (!chosen.is_object()) throw bolide::bad_parameter("--config = '" + path + "': \"settings\" must be an object");
  for (const auto& [name, value] : chosen.items()) {
    const option& o = find_option(name);
    const std::string label = name + " (in " + path + ")";
    o.read(s, text_of(value, label), label);
  }
}

void write_summary(const std::filesystem::path& path, const outcome& o) {
  const settings& s = o.used;
  const bolide::ledger& l = o.energies;
  json j;
  j["status"] = name(o.status);
  if (!o.message.empty()) j["message"] = o.message;
  j["title"] = title(s);
  j["eos"] = s.eos;
  j["shape"] = s.shape;
  j["scheme"] = s.scheme;
  j["transfer"] = s.transfer;
  j["precision"] = s.precision;
  j["initial"] = s.initial;
  const json echoed = settings_of(s);
  j["tension"] = echoed["tension"];
  j["viscosity"] = echoed["viscosity"];
  j["particles"] = o.particles;
  j["steps"] = o.steps;
  j["simulated_s"] = o.simulated;
  j["wall_s"] = o.wall;
  j["solver_s"] = o.solver;
  j["ns_per_particle_step"] = o.ns_per_particle_step();
  j["threads"] = o.threads;
  j["mass_discrete_kg"] = o.first.mass;
  j["mass_geometric_kg"] = o.geometric_mass;
  for (const auto& m : o.measures()) j[m.name] = m.value;
  j["reference_pressure_GPa"] = o.reference_pressure / 1e9;
  j["left_grid_particles"] = l.particles_left;
  j["mass_left_kg"] = l.mass_left;
  j["momentum_left_kg_m_s"] = {l.momentum_left[0], l.momentum_left[1]};
  j["energy_left_J"] = l.left;
  for (std::size_t k = 0; k < bolide::floor_names.size(); ++k) j["floors"][bolide::floor_names[k]] = l.floors.count[k];
  for (std::size_t k = 0; k < o.steps_by_cause.size(); ++k)
    j["steps_by_cause"][bolide::name(static_cast<bolide::step_cause>(k))] = o.steps_by_cause[k];
  j["energy"] = {
      {"initial", energies_of(l.initial, o.first)},
      {"final", energies_of(l.now, o.final)},
      {"channels",
       {{"transfer_J", l.transfer}, {"returned_heat_J", l.returned_heat}, {"work_mismatch_J", l.work_mismatch}, {"left_J", l.left}}},
      {"of_which",
       {{"plastic_work_J", l.plastic_work}, {"viscous_heating_J", l.viscous_heating}, {"failure_release_J", l.failure_release}}}};
  j["checks"] = o.checks;
  j["failed_checks"] = o.failed_checks;
  for (const auto& p : o.pictures) j["pictures"].push_back(p.filename().string());
  j["settings"] = echoed;
  bolide::observe::write_whole_file(path, j.dump(2) + "\n");
}

void write_statistics(const std::filesystem::path& path, const std::vector<std::vector<outcome>>& groups) {
  json j;
  for (const auto& group : groups) {
    json g;
    g["eos"] = group.front().used.eos;
    g["title"] = title(group.front().used);
    g["members"] = group.size();
    const auto printed = printed_for(group.front().used.eos);
    if (is_the_papers_case(group.front().used)) g["paper"] = {{"length_mm", printed.length}, {"width_mm", printed.width}};
    for (const statistic& row : statistics(group))
      g["measures"][row.name] = {{"unit", row.unit}, {"mean", row.mean}, {"standard_deviation", row.deviation}};
    g["settings"] = settings_of(group.front().used);
    j["runs"].push_back(g);
  }
  if (is_the_papers_case(groups.front().front().used)) j["experiment"] = {{"length_mm", experiment.length}, {"width_mm", experiment.width}};
  bolide::observe::write_whole_file(path, j.dump(2) + "\n");
}

} // namespace impact
