// SPDX-License-Identifier: MIT
// isentrope and release: the states of a path of constant entropy, one row each.
#include "commands.hpp"
#include "shock_curve.hpp"
#include "text.hpp"

#include "bolide/analysis/isentrope.hpp"

#include <cmath>

namespace explorer {
namespace {

using bolide::bad_parameter;
using bolide::analysis::isentrope_curve;
using bolide::quantity::dimension;

int rows_of(const request& r) {
  if (!r.has("rows")) return 101;
  const double n = read_number(r.given.at("rows"), "--rows");
  if (!(n >= 2 && n <= 1e6) || n != std::floor(n))
    throw bad_parameter("--rows = '" + r.given.at("rows") + "': must be a whole number from 2 to 1000000");
  return static_cast<int>(n);
}

figure plot_of(const isentrope_curve& path, const std::string& name) {
  figure f{{{"density (g/cm\u00b3)", "pressure (GPa)", {}}, {"particle speed (km/s)", "pressure (GPa)", {}}}};
  curve by_density{name, line_style::solid, 0, {}, {}}, by_speed = by_density;
  for (const auto& s : path.states) {
    by_density.x.push_back(s.density / 1e3), by_density.y.push_back(s.pressure / 1e9);
    by_speed.x.push_back(s.particle_speed / 1e3), by_speed.y.push_back(s.pressure / 1e9);
  }
  f.panels[0].curves.push_back(by_density);
  f.panels[1].curves.push_back(by_speed);
  return f;
}

/// follow(rows) gives the path.
template <class Follow> answer table_of(const request& r, const start& s, const Follow& follow) {
  const isentrope_curve path = follow(rows_of(r));
  csv_output out({"rho", "energy_J_kg", "pressure_Pa", "temperature_K", "particle_velocity_m_s", "region"});
  for (const auto& p : path.states)
    out.put({written(p.density), written(p.energy), written(p.pressure), written(p.temperature), written(p.particle_speed),
             s.eos->region(p.density, p.energy)});
  answer a = answer_of(out.text(), *s.eos);
  if (!path.message.empty()) a.remarks.push_back(path.message);
  if (!r.plot.empty()) a.plot = plot_of(follow(401), r.command + ", " + r.model.eos);
  return a;
}

const std::string& needed(const request& r, const std::string& name) {
  if (!r.has(name)) throw bad_parameter(r.command + " needs --" + name + "; --help explains it");
  return r.given.at(name);
}

} // namespace

answer isentrope(const request& r) {
  needed(r, "from");
  const start s = start_of(r, r.model);
  const double to = read_quantity(needed(r, "to"), dimension::density, "--to");
  if (!(to > 0)) throw bad_parameter("--to = " + bolide::to_text(to) + " kg/m3: must be > 0");
  return table_of(r, s, [&](int rows) {
    return with_model(*s.eos, [&](const auto& model) { return bolide::analysis::isentrope(model, s.density, s.energy, to, rows); });
  });
}

answer release(const request& r) {
  const start s = start_of(r, r.model);
  const double up = read_quantity(needed(r, "up"), dimension::velocity, "--up");
  if (!(up > 0)) throw bad_parameter("--up = " + bolide::to_text(up) + " m/s: must be > 0");
  const double end = r.has("pressure") ? read_quantity(r.given.at("pressure"), dimension::pressure, "--pressure") : 0;
  return table_of(r, s, [&](int rows) {
    return with_model(*s.eos, [&](const auto& model) {
      const auto shocked = bolide::analysis::hugoniot(model, s.density, s.energy, s.pressure, up);
      return bolide::analysis::release(model, shocked, rows, end);
    });
  });
}

} // namespace explorer
