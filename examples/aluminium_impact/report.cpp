// SPDX-License-Identifier: MIT
// The measures, their statistics, and the table on standard output.
#include "outcome.hpp"

#include "bolide/core/floors.hpp"
#include "bolide/core/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace impact {

using bolide::quantity::dimension;
using bolide::quantity::format;

std::vector<bolide::observe::measure> outcome::measures() const {
  auto rows = cloud.rows();
  const auto& l = energies;
  rows.push_back({"energy_drift_relative", "1", l.drift()});
  rows.push_back({"ledger_residual_relative", "1", l.residual()});
  rows.push_back({"momentum_error_relative", "1", l.momentum_error(1)});
  return rows;
}

printed_cloud printed_for(const std::string& eos) {
  if (eos == "mie-gruneisen") return {36.8, 32.4};
  if (eos == "tillotson") return {38.7, 34.1};
  return {36.8, 33.3}; // the paper's new equation of state, which paper, mixed and helm are variants of
}

bool is_the_papers_case(const settings& s) {
  const settings d;
  const auto aluminium = [](const std::string& name) { return name.rfind("aluminium", 0) == 0; };
  return s.diameter == d.diameter && s.velocity == d.velocity && s.thickness == d.thickness && s.until == d.until &&
         aluminium(s.projectile) && aluminium(s.target);
}

std::string readable(double si, dimension d) {
  const std::string text = format(si, d);
  const auto unit = std::min(text.find_first_not_of("0123456789.+-e"), text.size());
  return text.substr(0, unit).append(" ").append(text.substr(unit));
}

std::string title(const settings& s) {
  return readable(s.diameter, dimension::length) + " " + s.projectile + " sphere at " + readable(s.velocity, dimension::velocity) + " on " +
         readable(s.thickness, dimension::length) + " " + s.target;
}

std::vector<statistic> statistics(const std::vector<outcome>& members) {
  std::vector<statistic> all;
  const double n = static_cast<double>(members.size());
  for (const auto& m : members.front().measures()) all.push_back({m.name, m.unit, 0, 0});
  for (const auto& o : members) {
    const auto rows = o.measures();
    for (std::size_t k = 0; k < all.size(); ++k) all[k].mean += rows[k].value / n;
  }
  for (const auto& o : members) {
    const auto rows = o.measures();
    for (std::size_t k = 0; k < all.size(); ++k) all[k].deviation += (rows[k].value - all[k].mean) * (rows[k].value - all[k].mean);
  }
  for (auto& s : all) s.deviation = members.size() > 1 ? std::sqrt(s.deviation / (n - 1)) : std::nan("");
  return all;
}

namespace {
void line(const char* what, const char* unit, double value, int digits, double printed = std::nan(""), double measured = std::nan("")) {
  if (std::isnan(value)) std::printf("%-46s %-5s %10s", what, unit, "-"); // such as a front where nothing is downstream
  else std::printf("%-46s %-5s %10.*f", what, unit, digits, value);
  if (!std::isnan(printed)) std::printf(" %10.1f %12.1f", printed, measured);
  std::printf("\n");
}
} // namespace

void print_table(const outcome& o) {
  const settings& s = o.used;
  const auto& c = o.cloud;
  const bool papers = is_the_papers_case(s) && o.status == run_status::done;
  const auto printed = papers ? printed_for(s.eos) : printed_cloud{std::nan(""), std::nan("")};
  std::printf("%s, t = %s\n", title(s).c_str(), readable(o.simulated, dimension::time).c_str());
  std::printf("EOS %s, %s %s %s %s, spacing %s, cell %s, tension %s: %zu particles, %ld steps\n\n", s.eos.c_str(), s.shape.c_str(),
              s.transfer.c_str(), s.scheme.c_str(), s.precision.c_str(), readable(s.spacing, dimension::length).c_str(),
              readable(s.cell, dimension::length).c_str(), s.tension ? readable(*s.tension, dimension::pressure).c_str() : "none",
              o.particles, o.steps);
  std::printf("%-46s %-5s %10s%s\n", "", "", "here", papers ? "      paper   experiment" : "");
  line("length, plate's rear face to front", "mm", c.length_plate_to_front * 1e3, 2, printed.length, experiment.length);
  line("length, plate's front face to front", "mm", c.length_impact_face_to_front * 1e3, 2, printed.length, experiment.length);
  line("width (99.9 % of the mass)", "mm", c.width * 1e3, 2, printed.width, experiment.width);
  line("width (99 %)", "mm", c.width_p99 * 1e3, 2);
  line("length, veil to front", "mm", c.length_veil_to_front * 1e3, 2);
  line("bubble length", "mm", c.bubble_length * 1e3, 2);
  line("hole diameter", "mm", c.hole_diameter * 1e3, 2);
  line("front speed", "m/s", c.front_speed, 0);
  line("rear speed of the projectile", "m/s", c.rear_speed, 0);
  line("expansion speed", "m/s", c.expansion_speed, 0);
  line("mass downstream", "g", c.mass_downstream * 1e3, 3);
  line("momentum downstream", "N s", c.momentum_downstream, 3);
  line("molten fraction of the projectile", "", c.molten_fraction_projectile, 4);
  line("median temperature downstream", "K", c.median_temperature, 0);
  line("peak pressure, 99.9 % of the projectile", "GPa", c.peak_pressure_p999 / 1e9, 1);
  line("peak pressure, single particle (a spike)", "GPa", c.peak_pressure / 1e9, 1);
  std::printf("%-46s %-5s %10.2e\n", "projectile's mass that saw over 150 GPa", "", c.mass_fraction_over_150_GPa);
  if (!std::isnan(c.mass_fraction_over_1p5_reference)) {
    char what[80];
    std::snprintf(what, sizeof what, "  over 1.5 x contact-line reference %.0f GPa", o.reference_pressure / 1e9);
    std::printf("%-46s %-5s %10.2e\n", what, "", c.mass_fraction_over_1p5_reference);
  }
  std::printf("%-46s %-5s %10.2e\n", "total energy drift", "", o.energies.drift());
  std::printf("%-46s %-5s %10.2e\n", "ledger residual", "", o.energies.residual());
  std::printf("%-46s %-5s %10.2e\n", "axial momentum error", "", o.energies.momentum_error(1));
  if (o.energies.particles_left > 0)
    std::printf("%-46s %-5s %10llu (%.3g g)\n", "particles that left through the box", "",
                static_cast<unsigned long long>(o.energies.particles_left), o.energies.mass_left * 1e3);
  std::printf("floors, in particle-steps:");
  for (std::size_t k = 0; k < bolide::floor_names.size(); ++k)
    std::printf(" %s %llu", bolide::floor_names[k], static_cast<unsigned long long>(o.energies.floors.count[k]));
  std::printf("\n\n");
  for (const auto& p : o.pictures) std::printf("%s\n", p.string().c_str());
  std::printf("%s\n", (std::filesystem::path(s.out) / "summary.json").string().c_str());
  std::printf("\nsolver %.2f s, %.1f ns per particle and step on %d thread%s; %.2f s in all\n", o.solver, o.ns_per_particle_step(),
              o.threads, o.threads == 1 ? "" : "s", o.wall);
  for (const auto& held : o.checks) std::printf("checked: %s\n", held.c_str());
  for (const auto& failed : o.failed_checks) std::printf("FAILED: %s\n", failed.c_str());
}

} // namespace impact
