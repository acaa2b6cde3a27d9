// SPDX-License-Identifier: MIT
#include "advice.hpp"

#include "bolide/advise/advisor.hpp"
#include "bolide/advise/measured.hpp"
#include "bolide/core/quantity.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace impact {
namespace {

namespace advise = bolide::advise;
using bolide::bad_parameter;
using bolide::quantity::dimension;

/// The scene in the units of the table (examples/tradeoff/problem_impact.cpp): cells count the plate's thickness.
advise::scene scene_of(const settings& s) {
  constexpr double sound = 5400; // m/s, as there
  const double area = std::numbers::pi / 8 * s.diameter * s.diameter + s.plate_radius * s.thickness;
  return {"impact", area / (s.thickness * s.thickness), s.until * (sound + s.velocity) / s.thickness, s.velocity / sound};
}

double read_share(const std::string& text) {
  const bool percent = !text.empty() && text.back() == '%';
  const double x = bolide::quantity::parse(percent ? text.substr(0, text.size() - 1) : text, dimension::dimensionless, "--accuracy") / (percent ? 100 : 1);
  if (!(x > 0 && x < 1)) throw bad_parameter("--accuracy = '" + text + "': must be more than 0 and less than 1 (for example 1% or 0.01)");
  return x;
}

advise::advice ask(const advise::advisor& of, const settings& s, const wish& w) {
  const auto scene = scene_of(s);
  if (!w.accuracy.empty()) return of.for_accuracy(scene, read_share(w.accuracy));
  if (w.budget.empty()) return of.preset(scene, w.preset);
  const double seconds = bolide::quantity::parse(w.budget, dimension::time, "--budget");
  if (!(seconds > 0)) throw bad_parameter("--budget = '" + w.budget + "': must be more than 0s");
  return of.for_budget(scene, seconds);
}

} // namespace

std::string take_advice(settings& s, const wish& w, const std::function<bool(std::string_view)>& given) {
  const std::string name = !w.accuracy.empty() ? "--accuracy" : !w.budget.empty() ? "--budget" : "--preset";
  if (int(!w.accuracy.empty()) + int(!w.budget.empty()) + int(!w.preset.empty()) > 1)
    throw bad_parameter(name + ": one of --accuracy, --budget and --preset chooses; leave the others away");
  for (const char* chosen : {"cell", "spacing"})
    if (given(chosen)) throw bad_parameter("--" + std::string(chosen) + ": is chosen by " + name + "; leave one of them away");
  advise::advisor of(advise::measured_table());
  of.offer([&](const advise::method& m) { // what this program composes, within what was given
    const bool composed = (m.shape == "linear" && m.transfer == "flip") || (m.shape == "bspline" && (m.transfer == "flip" || m.transfer == "apic"));
    const bool stable = !(m.shape == "linear" && m.transfer == "flip" && m.scheme == "usf" && m.courant > 0.5); // breaks up flowing metal above 0.7 (docs/verification.md)
    const auto kept = [&](const char* option, bool same) { return !given(option) || same; };
    return composed && stable && (m.scheme == "usf" || m.scheme == "musl") && !m.table && kept("shape", m.shape == s.shape) && kept("transfer", m.transfer == s.transfer) &&
           kept("scheme", m.scheme == s.scheme) && kept("precision", m.precision == s.precision) && kept("cfl", m.courant == s.cfl);
  });
  const auto a = ask(of, s, w);

  s.shape = a.how.shape;
  s.transfer = a.how.transfer;
  s.scheme = a.how.scheme;
  s.precision = a.how.precision;
  s.cfl = a.how.courant;
  const double layers = std::round(a.cells * a.how.per_axis); // of particles: a whole number, they divide the plate
  s.spacing = s.thickness / layers;
  s.cell = a.how.per_axis * s.spacing;

  char text[300];
  std::snprintf(text, sizeof text, "%s %s: %s, cells of %.4g mm; predicted: error %.2g %%, %.2g s on one thread of the machine measured on; %.0f %% sure%s; ", name.c_str(),
                (!w.accuracy.empty() ? w.accuracy : !w.budget.empty() ? w.budget : w.preset).c_str(), advise::name(a.how).c_str(),
                1e3 * s.cell, 100 * a.error, a.cost, 100 * a.sure, a.reaches ? "" : " (it falls short)");
  return text + a.why;
}

} // namespace impact
