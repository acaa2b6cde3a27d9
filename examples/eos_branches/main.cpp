// SPDX-License-Identifier: MIT
// The phase branches of aluminium with no solver at all: along one isochore the thermal energy rises, and solid, mixed phase, liquid
// and hot liquid follow one another; then the same material beyond V_j, where the paper has a gas.
//
// Run:  bash examples/run.sh eos_branches            (--quick changes nothing: it takes a millisecond)
#include "bolide/core/unit.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/phase/mixed.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>

using namespace bolide;
using namespace bolide::unit;

int main() {
  const auto start = std::chrono::steady_clock::now();
  const cold::cai_ye lattice;     // e_c(x), p_c(x)
  const phase::mixed regions;     // which branch answers
  const double rho0 = lattice.reference_density();

  // Each branch can be called alone, at an isochore that the phase solver makes.
  const double x = 0.8; // V/V0
  const auto isochore = regions.at(x, rho0 / x);
  const phase::branch::solid solid;
  const phase::branch::liquid liquid;
  const phase::branch::hot_liquid hot;
  const double E_ms = solid.end(isochore), E_m = liquid.begin(isochore), E_G = hot.begin(isochore);
  std::printf("V/V0 = %g: T_m = %.1f K, solidus E_ms = %.4f, liquidus E_m = %.4f, hot liquid from E_G = %.3f MJ/kg\n", x,
              isochore.melting, E_ms / MJ, E_m / MJ, E_G / MJ);
  std::printf("superheated solid at E_m: %.1f K, liquid there: %.1f K (the paper's jump)\n\n",
              solid.temperature(isochore, E_m), liquid.temperature(isochore, E_m));

  std::printf("%8s %10s  %-10s %10s %6s %10s %10s\n", "V/V0", "e_k MJ/kg", "region", "T K", "melt", "p_th GPa", "p GPa");
  const auto row = [&](double at, double e_k) {
    const auto p = regions.evaluate(at, e_k, at / rho0);
    std::printf("%8g %10.4f  %-10s %10.1f %6.3f %10.3f %10.3f\n", at, e_k / MJ, name(to_region(p.region)), p.temperature, p.melt_fraction,
                p.thermal_pressure / GPa, (lattice.evaluate(at).pressure + p.thermal_pressure) / GPa);
    return p;
  };
  for (const double e_k : {0.0, 0.5 * E_ms, 0.5 * (E_ms + E_m), 2 * E_m, 1.5 * E_G}) row(x, e_k);
  for (const double e_k : {1 * MJ, 10 * MJ}) row(1.4, e_k);

  // One number that must stay: half molten, the mixed phase is at T_m and has the mean of both ends' pressures.
  const auto half = regions.evaluate(x, 0.5 * (E_ms + E_m), x / rho0);
  const double mean = 0.5 * (solid.evaluate(isochore, E_ms).thermal_pressure + liquid.evaluate(isochore, E_m).thermal_pressure);
  const bool good = std::abs(half.thermal_pressure / mean - 1) < 1e-12 && std::abs(half.melt_fraction - 0.5) < 1e-12;
  std::printf("\nhalf molten: p_th = %.6f GPa, mean of both ends %.6f GPa: %s; %.1f ms\n", half.thermal_pressure / GPa,
              mean / GPa, good ? "equal" : "NOT EQUAL",
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() * 1e3);
  return good ? 0 : 1;
}
