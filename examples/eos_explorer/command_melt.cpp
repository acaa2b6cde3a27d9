// SPDX-License-Identifier: MIT
// melt: where melting begins and ends, on the Hugoniot and on release to p = 0; as a plot the phase diagram with the shock's path.
#include "commands.hpp"
#include "shock_curve.hpp"
#include "text.hpp"

#include "bolide/analysis/melt_thresholds.hpp"

#include <algorithm>
#include <cmath>

namespace explorer {
namespace {

using bolide::analysis::melt_thresholds;
using bolide::analysis::shock_state;

/// The energy at this density where melting begins (or ends): the melt fraction leaves 0 (or comes to 1).
double melting_energy(const any_eos& eos, double rho, bool complete) {
  const auto molten = [&](double e) {
    const double nu = eos.evaluate(rho, e).melt_fraction;
    return complete ? nu >= 1 : nu > 0;
  };
  double low = eos.evaluate(rho, 0).cold_energy, high = low + 1e5;
  for (int i = 0; i < 60 && !molten(high); ++i) low = high, high += (high - eos.evaluate(rho, 0).cold_energy);
  for (int i = 0; i < 60; ++i) (molten(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}

/// Pressure (GPa) and temperature (K) along the solidus or the liquidus, from p = 0 to `end` (Pa).
curve melting_curve(const any_eos& eos, bool complete, double end) {
  curve c{complete ? "liquidus" : "solidus", complete ? line_style::dashed : line_style::solid, complete ? 1 : 4, {}, {}};
  for (int i = 0; i <= 240; ++i) {
    const double rho = eos.reference_density() * (0.8 + 0.006 * i);
    const auto s = eos.evaluate(rho, melting_energy(eos, rho, complete));
    if (!(s.pressure >= 0)) continue;
    if (s.pressure > end) break;
    c.x.push_back(s.pressure / 1e9), c.y.push_back(s.melting_temperature);
  }
  return c;
}

/// Do two curves of rising pressure agree within half a percent? Then melting is at one temperature for each pressure.
bool is_one_line(const curve& a, const curve& b) {
  for (std::size_t i = 0, j = 1; i < a.x.size(); ++i) {
    while (j + 1 < b.x.size() && b.x[j] < a.x[i]) ++j;
    if (j >= b.x.size() || b.x[j] < a.x[i]) break;
    const double between = b.y[j - 1] + (b.y[j] - b.y[j - 1]) * (a.x[i] - b.x[j - 1]) / (b.x[j] - b.x[j - 1]);
    if (std::abs(between - a.y[i]) > 0.005 * a.y[i]) return false;
  }
  return true;
}

figure plot_of(const request& r, const start& s, const melt_thresholds& t) {
  const double end = 1.35 * t.hugoniot_end.pressure;
  panel p{"pressure (GPa)", "temperature (K)", {}};
  p.curves.push_back(melting_curve(*s.eos, false, end));
  if (const curve liquidus = melting_curve(*s.eos, true, end); is_one_line(p.curves.back(), liquidus)) p.curves.back().label = "melting";
  else p.curves.push_back(liquidus);
  curve path{"shock, " + r.model.eos, line_style::solid, 0, {s.pressure / 1e9}, {s.eos->evaluate(s.density, s.energy).temperature}};
  for (const shock_state& a : shocks(s, 50, 1.3 * t.hugoniot_end.particle_speed, 160)) {
    if (a.pressure > end) break;
    path.x.push_back(a.pressure / 1e9), path.y.push_back(a.temperature);
  }
  p.curves.push_back(path);
  p.curves.push_back({"melting on the shock", line_style::marks, 0, {t.hugoniot_begin.pressure / 1e9, t.hugoniot_end.pressure / 1e9},
                      {t.hugoniot_begin.temperature, t.hugoniot_end.temperature}});
  p.curves.push_back({"shocks that melt on release", line_style::marks, 2, {t.release_begin.pressure / 1e9, t.release_end.pressure / 1e9},
                      {t.release_begin.temperature, t.release_end.temperature}});
  if (find_eos(r.model.eos).aluminium) // Jin et al., Phys. Rev. B 2025: melting begins on the Hugoniot; liquid
    p.curves.push_back({"aluminium, Jin et al. 2025", line_style::marks, 5, {125, 155.8}, {4576, 5394}, {235, 543}});
  return {{p}};
}

} // namespace

answer melt(const request& r) {
  const start s = start_of(r, r.model);
  if (!s.eos->knows_melting()) throw bolide::bad_parameter("'" + r.model.eos + "': knows no melting");
  const bolide::eos::material_state ahead{s.density, s.energy, std::nan(""), s.pressure, 0};
  const melt_thresholds t = bolide::analysis::find_melt_thresholds(thermal_handle{s.eos.get()}, ahead);
  csv_output out({"event", "up", "us", "rho", "pressure_Pa", "energy_J_kg", "temperature_K"});
  const auto row = [&](const char* event, const shock_state& a) {
    out.put({event, written(a.particle_speed), written(a.shock_speed), written(a.density), written(a.pressure), written(a.energy),
             written(a.temperature)});
  };
  row("hugoniot_onset", t.hugoniot_begin);
  row("hugoniot_completion", t.hugoniot_end);
  row("release_onset", t.release_begin);
  row("release_completion", t.release_end);
  answer a = answer_of(out.text(), *s.eos);
  if (!r.plot.empty()) a.plot = plot_of(r, s, t);
  return a;
}

} // namespace explorer
