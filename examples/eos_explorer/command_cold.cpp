// SPDX-License-Identifier: MIT
// cold: energy and pressure of the lattice at 0 K against V/V0; as a plot the paper's figures 1 and 2.
#include "cold_curves.hpp"
#include "commands.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>

namespace explorer {
namespace {

constexpr double tension_begins = 0.95; // the third panel shows what the second is too coarse for

/// The named curve between two volumes, evenly in x.
void draw(const any_cold& model, const std::string& name, double low, double high, int color, figure& f) {
  curve energy{name, color == 0 ? line_style::solid : line_style::dashed, color, {}, {}}, pressure = energy;
  for (int i = 0; i <= 400; ++i) {
    const double x = low + (high - low) * i / 400;
    const auto c = model.evaluate(x);
    energy.x.push_back(x), energy.y.push_back(c.energy / 1e6);
    pressure.x.push_back(x), pressure.y.push_back(c.pressure / 1e9);
  }
  f.panels[0].curves.push_back(energy);
  f.panels[1].curves.push_back(pressure);
  if (f.panels.size() < 3) return;
  curve pull{name, energy.style, color, {}, {}};
  for (int i = 0; i <= 400; ++i) {
    const double x = tension_begins + (high - tension_begins) * i / 400;
    pull.x.push_back(x), pull.y.push_back(model.evaluate(x).pressure / 1e9);
  }
  f.panels[2].curves.push_back(pull);
}

} // namespace

answer cold(const request& r) {
  model_choice choice = r.model;
  const any_cold model = make_cold(choice.cold, choice.set, choice.table);
  choice.set.check(choice.cold);
  const auto xs = numbers_of(r, "x", bolide::quantity::dimension::dimensionless, true);
  csv_output out({"x", "energy_J_kg", "pressure_Pa", "dp_dx_Pa"});
  for (const double x : xs) {
    const auto c = model.evaluate(x);
    out.put({written(x), written(c.energy), written(c.pressure), written(c.slope)});
  }
  answer a{out.text(), {}, {}};
  if (!model.remark().empty()) a.remarks.push_back(model.remark());
  if (r.plot.empty() || xs.empty()) return a;
  double low = *std::min_element(xs.begin(), xs.end()), high = *std::max_element(xs.begin(), xs.end());
  if (low == high) low *= 0.8, high *= 1.2;
  figure f{{{"volume ratio V/V0", "cold energy (MJ/kg)", {}}, {"volume ratio V/V0", "cold pressure (GPa)", {}}}};
  if (low < 0.8 && high > 1.2) f.panels.push_back(f.panels[1]);
  draw(model, choice.cold, low, high, 0, f);
  for (std::size_t i = 0; i < r.compare.size(); ++i) {
    assignments none;
    draw(make_cold(r.compare[i], none, choice.table), r.compare[i], low, high, static_cast<int>(i) + 1, f);
  }
  a.plot = f;
  return a;
}

} // namespace explorer
