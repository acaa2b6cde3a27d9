// SPDX-License-Identifier: MIT
// hugoniot: the state behind a shock for each particle speed; as a plot beside the published line of aluminium.
#include "commands.hpp"
#include "shock_curve.hpp"
#include "text.hpp"

#include <algorithm>

namespace explorer {
namespace {

using bolide::analysis::shock_state;

/// us = 5350 m/s + 1.34 up: 6061 aluminium, LASL, to about 100 GPa within 1 %.
double published(double up) { return 5350 + 1.34 * up; }

/// Adds the states to the panels: us(up), p(rho) and, where there is a third, the deviation from the published line.
void add(const std::vector<shock_state>& states, const std::string& name, line_style style, int color, figure& f) {
  curve speed{name, style, color, {}, {}}, pressure = speed, deviation = speed;
  for (const shock_state& s : states) {
    speed.x.push_back(s.particle_speed / 1e3), speed.y.push_back(s.shock_speed / 1e3);
    pressure.x.push_back(s.density / 1e3), pressure.y.push_back(s.pressure / 1e9);
    deviation.x.push_back(s.particle_speed / 1e3), deviation.y.push_back(100 * (s.shock_speed / published(s.particle_speed) - 1));
  }
  f.panels[0].curves.push_back(speed);
  f.panels[1].curves.push_back(pressure);
  if (f.panels.size() == 3) f.panels[2].curves.push_back(deviation);
}

figure plot_of(const request& r, const start& s, const std::vector<shock_state>& states) {
  figure f{{{"particle speed (km/s)", "shock speed (km/s)", {}}, {"density (g/cm\u00b3)", "pressure (GPa)", {}}}};
  const auto slower = [](const shock_state& a, const shock_state& b) { return a.particle_speed < b.particle_speed; };
  double slow = std::min_element(states.begin(), states.end(), slower)->particle_speed;
  double fast = std::max_element(states.begin(), states.end(), slower)->particle_speed;
  if (slow == fast) slow *= 0.5, fast *= 1.5;
  if (find_eos(r.model.eos).aluminium) {
    const std::string label = "published, 5.35 km/s + 1.34 up";
    f.panels[0].curves.push_back(
        {label, line_style::dashed, 5, {slow / 1e3, fast / 1e3}, {published(slow) / 1e3, published(fast) / 1e3}});
    f.panels.push_back({"particle speed (km/s)", "shock speed off 5.35 km/s + 1.34 up (%)", {}});
    f.panels[2].curves.push_back({"", line_style::dashed, 5, {slow / 1e3, fast / 1e3}, {0, 0}});
  }
  add(shocks(s, slow, fast, 200), r.model.eos, line_style::solid, 0, f);
  for (std::size_t i = 0; i < r.compare.size(); ++i) {
    model_choice other;
    other.eos = r.compare[i], other.cold = r.model.cold, other.table = r.model.table;
    add(shocks(start_of(r, other), slow, fast, 200), r.compare[i], line_style::dashed, static_cast<int>(i) + 1, f);
  }
  add(states, "", line_style::marks, 0, f);
  return f;
}

} // namespace

answer hugoniot_curve(const request& r) {
  const start s = start_of(r, r.model);
  const auto speeds = numbers_of(r, "up", bolide::quantity::dimension::velocity, true);
  csv_output out({"up", "us", "rho", "pressure_Pa", "energy_J_kg", "temperature_K", "region"});
  std::vector<shock_state> states;
  std::vector<std::string> remarks;
  for (const double up : speeds) {
    const auto found = shock(s, up);
    if (!found)
      throw bolide::bad_parameter("up = " + bolide::to_text(up) + " m/s: '" + r.model.eos + "' carries no such shock (none with rho < 20 rho0)");
    const shock_state& a = *found;
    out.put({written(a.particle_speed), written(a.shock_speed), written(a.density), written(a.pressure), written(a.energy),
             written(a.temperature), s.eos->region(a.density, a.energy)});
    const std::string status = s.eos->status(a.density, a.energy);
    if (status != "ok") remarks.push_back("up = " + bolide::to_text(up) + " m/s: the state's status is " + status);
    states.push_back(a);
  }
  answer a = answer_of(out.text(), *s.eos);
  a.remarks.insert(a.remarks.end(), remarks.begin(), remarks.end());
  if (!r.plot.empty() && !states.empty()) a.plot = plot_of(r, s, states);
  return a;
}

} // namespace explorer
