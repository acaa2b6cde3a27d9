// SPDX-License-Identifier: MIT
// eos::reference against measurements of aluminium, in one table beside the paper's set, Tillotson and Mie-Grueneisen; every figure comes from
// evaluate(rho, e) and the analysis tools alone. The promises of the workbench are asserted at their tolerances, what is off at its measured
// value. What was fitted is in tests/validate/reference_calibration_test.cpp; what was not is in the test Predicted.
#include "bolide/analysis/isotherm.hpp"
#include "bolide/analysis/melt_thresholds.hpp"
#include "bolide/analysis/saturation.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/tillotson.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {
using namespace bolide;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
using figures = std::map<std::string, double>;

/// The state on the isobar p = 0 where the melt fraction passes from 0 (complete: to 1), looked for between two densities.
template <class Eos> eos::material_state melting_at_zero_pressure(const Eos& eos, double dense, double thin, bool complete) {
  const auto energy = [&](double rho) { return eos::energy_at_pressure(eos, rho, 0).value; };
  for (int i = 0; i < 60; ++i) {
    const double rho = 0.5 * (dense + thin), fraction = eos.evaluate(rho, energy(rho)).melt_fraction;
    (complete ? fraction < 1 : fraction == 0) ? dense = rho : thin = rho;
  }
  const double rho = complete ? thin : dense;
  return eos::state_at(eos, rho, energy(rho));
}

template <class Eos> void shock_figures(figures& f, const Eos& eos, const eos::material_state& ambient) {
  for (const double up : {1e3, 2e3, 3e3, 4e3, 5e3, 6e3})
    f["us at up = " + std::to_string(static_cast<int>(up)) + " m/s, m/s"] = analysis::hugoniot(eos, ambient, up).shock_speed;
}

/// What can be asked of any equation of state with melting, from its surface alone.
template <class Eos> figures measure(const Eos& eos) {
  figures f;
  const double T = 300, step = 1;
  const auto a = eos::ambient_state(eos, T), cold = eos::ambient_state(eos, T - step), warm = eos::ambient_state(eos, T + step);
  const auto at = eos.evaluate(a.density, a.energy);
  const double c_p = (warm.energy - cold.energy) / (2 * step), K_S = a.density * at.sound_speed_squared;
  f["density at 300 K, kg/m3"] = a.density;
  f["volume expansion, 1e-6/K"] = 1e6 * std::log(cold.density / warm.density) / (2 * step);
  f["c_p, J/(kg K)"] = c_p;
  f["K_S, GPa"] = K_S / 1e9;
  f["K_T, GPa"] = K_S / (c_p * at.temperature_energy) / 1e9;
  f["p at V/V0 = 0.5, 300 K, GPa"] = analysis::isotherm(eos, T, {2 * a.density}).front().pressure / 1e9;
  f["cohesive energy, MJ/kg"] =
      (eos.evaluate(1e-6 * eos.reference_density(), 0.0).cold_energy - eos.evaluate(eos.reference_density(), 0.0).cold_energy) / 1e6;

  const auto solid = melting_at_zero_pressure(eos, a.density, 0.8 * a.density, false);
  const auto liquid = melting_at_zero_pressure(eos, a.density, 0.8 * a.density, true);
  f["melting point at p = 0, solidus, K"] = solid.temperature;
  f["melting point at p = 0, liquidus, K"] = liquid.temperature;
  f["latent heat at p = 0, kJ/kg"] = (liquid.energy - solid.energy) / 1e3;
  f["volume of melting, %"] = 100 * (solid.density / liquid.density - 1);
  f["liquid at p = 0, kg/m3"] = liquid.density;
  f["liquid sound speed, m/s"] = liquid.sound_speed;
  const auto hot = eos::density_at_pressure_temperature(eos, 0, 2000, 2100);
  f["liquid at 2000 K, kg/m3"] = hot.what == eos::status::ok ? hot.value : none;

  shock_figures(f, eos, a);
  const auto melt = analysis::find_melt_thresholds(eos, a);
  f["shock melting begins, GPa"] = melt.hugoniot_begin.pressure / 1e9;
  f["shock melting begins, K"] = melt.hugoniot_begin.temperature;
  f["shock melting complete, GPa"] = melt.hugoniot_end.pressure / 1e9;
  f["melt on release begins, GPa"] = melt.release_begin.pressure / 1e9;
  f["melt on release complete, GPa"] = melt.release_end.pressure / 1e9;
  double slow = 3000, fast = 6000;
  for (int i = 0; i < 40; ++i) (analysis::hugoniot(eos, a, 0.5 * (slow + fast)).pressure < 155.8e9 ? slow : fast) = 0.5 * (slow + fast);
  f["T on the Hugoniot at 155.8 GPa, K"] = analysis::hugoniot(eos, a, fast).temperature;
  return f;
}

/// Tillotson and Mie-Grueneisen have neither temperature nor melting.
template <class Eos> figures measure_mechanical(const Eos& eos) {
  figures f;
  const auto a = eos::ambient_state(eos);
  f["density at 300 K, kg/m3"] = a.density;
  f["K_S, GPa"] = a.density * a.sound_speed * a.sound_speed / 1e9;
  shock_figures(f, eos, a);
  return f;
}

struct datum {
  std::string name;
  double published;
};
const std::vector<datum> published = {
    {"density at 300 K, kg/m3", 2699},
    {"volume expansion, 1e-6/K", 69},
    {"c_p, J/(kg K)", 897},
    {"K_T, GPa", 72.5},
    {"K_S, GPa", 76},
    {"p at V/V0 = 0.5, 300 K, GPa", 220},
    {"cohesive energy, MJ/kg", 12.05},
    {"melting point at p = 0, solidus, K", 933.45},
    {"melting point at p = 0, liquidus, K", 933.45},
    {"latent heat at p = 0, kJ/kg", 397},
    {"volume of melting, %", 6.5},
    {"liquid at p = 0, kg/m3", 2380},
    {"liquid sound speed, m/s", 4700},
    {"liquid at 2000 K, kg/m3", 2080},
    {"us at up = 1000 m/s, m/s", 6690},
    {"us at up = 2000 m/s, m/s", 8030},
    {"us at up = 3000 m/s, m/s", 9370},
    {"us at up = 4000 m/s, m/s", 10710},
    {"us at up = 5000 m/s, m/s", 12050},
    {"us at up = 6000 m/s, m/s", 13390},
    {"shock melting begins, GPa", 125},
    {"shock melting begins, K", 4600},
    {"shock melting complete, GPa", none},
    {"T on the Hugoniot at 155.8 GPa, K", 5394},
    {"melt on release begins, GPa", 67.5},
    {"melt on release complete, GPa", 95},
    {"boiling point at 1 atm, K", 2792},
    {"heat of vaporisation, MJ/kg", 10.9},
    {"critical temperature, K", 6600},
    {"critical density, kg/m3", 637},
    {"critical pressure, GPa", 0.2},
};

const eos::reference& model() {
  static const eos::reference r;
  return r;
}
const figures& of_reference() {
  static const figures f = [] {
    figures g = measure(model());
    const auto boiling = analysis::saturation_at_pressure(model(), 101325, 2200, 3500);
    g["boiling point at 1 atm, K"] = boiling.temperature;
    g["heat of vaporisation, MJ/kg"] = boiling.latent_heat / 1e6;
    g["critical temperature, K"] = model().critical().temperature;
    g["critical density, kg/m3"] = model().critical().density;
    g["critical pressure, GPa"] = model().critical().pressure / 1e9;
    return g;
  }();
  return f;
}
double found(const std::string& name) { return of_reference().at(name); }
void within(const std::string& name, double expected, double tolerance) { EXPECT_NEAR(found(name), expected, tolerance) << name; }

TEST(ReferenceEos, TheTable) {
  const std::array<std::pair<const char*, figures>, 4> sets{
      {{"reference", of_reference()},
       {"paper, mixed", measure(eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}})},
       {"Tillotson", measure_mechanical(eos::tillotson{})},
       {"Mie-Grueneisen", measure_mechanical(eos::mie_grueneisen{})}}};
  std::printf("%-38s %9s", "aluminium", "published");
  for (const auto& s : sets) std::printf(" %18s", s.first);
  std::printf("\n");
  for (const auto& d : published) {
    if (std::isnan(d.published)) std::printf("%-38s %9s", d.name.c_str(), "-");
    else std::printf("%-38s %9.5g", d.name.c_str(), d.published);
    for (const auto& s : sets) {
      const auto at = s.second.find(d.name);
      if (at == s.second.end()) std::printf(" %18s", "-");
      else if (std::isnan(d.published)) std::printf(" %9.5g         ", at->second);
      else std::printf(" %9.5g %+6.1f %%", at->second, 100 * (at->second / d.published - 1));
    }
    std::printf("\n");
  }
  for (const auto& d : published) EXPECT_TRUE(std::isfinite(found(d.name))) << d.name;
}

// ---- the promises ----------------------------------------------------------------------------------------------------------------------
TEST(ReferenceEos, PrincipalHugoniot) { // us = 5350 + 1.34 up: 0.5 % to 4 km/s, 1 % to 6 km/s
  for (const double up : {1e3, 2e3, 3e3, 4e3, 5e3, 6e3}) {
    const double line = 5350 + 1.34 * up;
    within("us at up = " + std::to_string(static_cast<int>(up)) + " m/s, m/s", line, (up <= 4000 ? 0.005 : 0.01) * line);
  }
}

TEST(ReferenceEos, AmbientAndCold) { // 5 %
  for (const std::size_t i : {0u, 1u, 2u, 3u, 4u, 5u, 6u}) within(published[i].name, published[i].published, 0.05 * published[i].published);
  within("density at 300 K, kg/m3", 2699, 1);
}

TEST(ReferenceEos, Melting) {
  within("shock melting begins, GPa", 125, 5);
  within("shock melting begins, K", 4600, 300);
  within("melting point at p = 0, solidus, K", 933.45, 0.03 * 933.45);
  EXPECT_NEAR(found("melting point at p = 0, liquidus, K"), found("melting point at p = 0, solidus, K"), 1e-3); // an isobar melts at one T
  within("latent heat at p = 0, kJ/kg", 397, 0.05 * 397);
  within("melt on release begins, GPa", 67.5, 2.5);
  within("melt on release complete, GPa", 95, 10);
}

TEST(ReferenceEos, CriticalPoint) {
  within("critical temperature, K", 6600, 0.25 * 6600);
  within("critical density, kg/m3", 650, 250);
  within("critical pressure, GPa", 0.3, 0.2);
}

// ---- what nobody fitted, and what is off ---------------------------------------------------------------------------------------------------
TEST(ReferenceEos, Predicted) {
  within("T on the Hugoniot at 155.8 GPa, K", 5394, 543); // Jin et al., their uncertainty; on the melting line, which is fitted to 100 GPa
  within("heat of vaporisation, MJ/kg", 10.27, 0.02);     // -5.8 %
}

// Each pulls at the others; what a refit with one of them forced gave is said beside it. (Those refits were made with slightly other weights of
// the rest: 150 K, 3 GPa and 0.1 GPa for onset temperature, isotherm and critical pressure; they show directions, not this set's figures.)
TEST(ReferenceEos, MissesAtTheirMeasuredValues) {
  within("volume of melting, %", 7.23, 0.02);        // +11 %; 6.5 costs a latent heat of -4.6 %, 300 K isotherm -5 %, critical pressure 0.52 GPa,
                                                     // and the melting line no longer reaches 0 K under tension
  within("latent heat at p = 0, kJ/kg", 384.2, 0.5); // -3.2 %; 397 costs a volume of melting of +11 %, critical temperature +9 %
  within("liquid sound speed, m/s", 4875, 5);        // +3.7 %; 4779 costs a volume of melting of +16 %
  within("p at V/V0 = 0.5, 300 K, GPa", 214.8, 0.3); // -2.4 %; 219.6 costs us at 2 and 3 km/s another 0.1 %, critical pressure 0.48 GPa
  within("shock melting begins, K", 4739, 5);        // +3.0 %; 4615 costs an onset at 120.3 GPa
  within("boiling point at 1 atm, K", 2646, 3);      // -5.2 %, hardly weighed in the fit
  within("critical density, kg/m3", 561.6, 1);       // -12 %
}
} // namespace
