// SPDX-License-Identifier: MIT
// match and riemann: two materials in contact.
#include "commands.hpp"
#include "shock_curve.hpp"
#include "text.hpp"

#include "bolide/analysis/impedance_match.hpp"
#include "bolide/analysis/riemann.hpp"

#include <algorithm>
#include <cmath>

namespace explorer {
namespace {

using bolide::bad_parameter;
using bolide::analysis::wave_status;
using bolide::quantity::dimension;

double needed(const request& r, const std::string& name, dimension d) {
  if (!r.has(name)) throw bad_parameter(r.command + " needs --" + name + "; --help explains it");
  return read_quantity(r.given.at(name), d, "--" + name);
}

void check(wave_status status, const std::string& message, answer& a) {
  if (status == wave_status::no_solution) throw bad_parameter(message);
  if (!message.empty()) a.remarks.push_back(message);
}

bolide::eos::material_state ahead(const start& s) { return {s.density, s.energy, std::nan(""), s.pressure, 0}; }

/// Pressure (GPa) against the velocity of the interface (km/s): what each side can have by a shock.
figure plot_of_match(const request& r, const start& flyer, const start& target, double V, double velocity, double pressure) {
  panel p{"velocity of the interface (km/s)", "pressure (GPa)", {}};
  curve from_flyer{"flyer, " + r.model.eos, line_style::solid, 0, {V / 1e3}, {flyer.pressure / 1e9}};
  curve from_target{"target, " + r.other.eos, line_style::solid, 1, {0}, {target.pressure / 1e9}};
  const double top = 1.8 * pressure;
  for (const auto& s : shocks(flyer, 0.005 * V, V, 199))
    if (s.pressure < top) from_flyer.x.push_back((V - s.particle_speed) / 1e3), from_flyer.y.push_back(s.pressure / 1e9);
  for (const auto& s : shocks(target, 0.005 * V, V, 199))
    if (s.pressure < top) from_target.x.push_back(s.particle_speed / 1e3), from_target.y.push_back(s.pressure / 1e9);
  p.curves = {from_flyer, from_target, {"interface", line_style::marks, 3, {velocity / 1e3}, {pressure / 1e9}}};
  return {{p}};
}

bolide::analysis::flow_state flow(const request& r, const std::string& name) {
  if (!r.has(name)) throw bad_parameter("riemann needs --" + name + "; --help explains it");
  const auto n = read_numbers(r.given.at(name), "--" + name);
  if (n.size() != 3) throw bad_parameter("--" + name + " = '" + r.given.at(name) + "': must be RHO,U,P in kg/m3, m/s, Pa");
  if (!(n[0] > 0)) throw bad_parameter("--" + name + ": density = " + bolide::to_text(n[0]) + " kg/m3 must be > 0");
  return {n[0], n[1], n[2]};
}

struct place_sample {
  double x;
  bolide::analysis::flow_sample flow;
};

figure plot_of_profile(const std::vector<place_sample>& all, double time) {
  figure f;
  const double reach = std::max(std::abs(all.front().x), std::abs(all.back().x)), metre = reach < 1e-4 ? 1e-6 : reach < 0.1 ? 1e-3 : 1;
  const auto add = [&](const char* label, double unit, const auto& get) {
    curve c{"t = " + bolide::quantity::format(time, dimension::time), line_style::solid, 0, {}, {}};
    for (const auto& s : all)
      if (std::isfinite(get(s.flow))) c.x.push_back(s.x / metre), c.y.push_back(get(s.flow) / unit);
    f.panels.push_back({metre == 1 ? "x (m)" : metre == 1e-3 ? "x (mm)" : "x (\u00b5m)", label, {c}});
  };
  double largest = 0; // of the pressure: gases are drawn in Pa, metals in GPa
  for (const auto& s : all) largest = std::max(largest, std::abs(s.flow.pressure));
  add("density (kg/m\u00b3)", 1, [](const auto& s) { return s.density; });
  add("velocity (m/s)", 1, [](const auto& s) { return s.velocity; });
  if (largest > 1e8) add("pressure (GPa)", 1e9, [](const auto& s) { return s.pressure; });
  else if (largest > 1e5) add("pressure (MPa)", 1e6, [](const auto& s) { return s.pressure; });
  else add("pressure (Pa)", 1, [](const auto& s) { return s.pressure; });
  return f;
}

} // namespace

answer match(const request& r) {
  if (r.other.eos.empty()) throw bad_parameter("match needs --eos2; --help explains it");
  const double V = needed(r, "velocity", dimension::velocity);
  if (!(V > 0)) throw bad_parameter("--velocity = " + bolide::to_text(V) + " m/s: must be > 0");
  const start flyer = start_of(r, r.model), target = start_of(r, r.other, "density2");
  const auto met = with_model(*flyer.eos, [&](const auto& a) {
    return with_model(*target.eos, [&](const auto& b) { return bolide::analysis::impedance_match(a, ahead(flyer), b, ahead(target), V); });
  });
  csv_output out({"interface_velocity_m_s", "pressure_Pa"});
  out.put({written(met.velocity), written(met.pressure)});
  answer a = answer_of(out.text(), *flyer.eos);
  check(met.status, met.message, a);
  if (!r.plot.empty()) a.plot = plot_of_match(r, flyer, target, V, met.velocity, met.pressure);
  return a;
}

answer riemann(const request& r) {
  const double time = needed(r, "time", dimension::time);
  if (!(time > 0)) throw bad_parameter("--time = " + bolide::to_text(time) + " s: must be > 0");
  const auto left = flow(r, "left"), right = flow(r, "right");
  model_choice on_left = r.model, on_right = r.other.eos.empty() ? r.model : r.other;
  const eos_pointer a_eos = make_eos(on_left), b_eos = make_eos(on_right);
  const auto xs = numbers_of(r, "x", dimension::length, false);
  answer a = answer_of({}, *a_eos);
  csv_output out({"x", "rho", "velocity_m_s", "pressure_Pa", "energy_J_kg", "temperature_K", "region"});
  std::vector<place_sample> profile;
  with_model(*a_eos, [&](const auto& l) {
    with_model(*b_eos, [&](const auto& m) {
      const auto solution = bolide::analysis::riemann(l, left, m, right);
      check(solution.status(), solution.message(), a);
      const auto row = [&](double x) {
        const auto s = solution.sample(x / time);
        const any_eos& eos = x / time <= solution.star_velocity() ? *a_eos : *b_eos;
        const bool matter = s.density > 0;
        out.put({written(x), written(s.density), written(s.velocity), written(s.pressure), written(s.energy),
                 matter ? written(eos.evaluate(s.density, s.energy).temperature) : "", matter ? eos.region(s.density, s.energy) : ""});
      };
      for (const double x : xs) row(x);
      if (r.plot.empty() || xs.empty()) return;
      const double low = *std::min_element(xs.begin(), xs.end()), high = *std::max_element(xs.begin(), xs.end());
      for (int i = 0; i <= 1000; ++i) {
        const double x = low + (high - low) * i / 1000;
        profile.push_back({x, solution.sample(x / time)});
      }
    });
  });
  a.csv = out.text();
  if (!profile.empty()) a.plot = plot_of_profile(profile, time);
  return a;
}

} // namespace explorer
