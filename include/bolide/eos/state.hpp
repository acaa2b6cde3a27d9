// SPDX-License-Identifier: MIT
// Initial states of a material: cold_state(eos) and ambient_state(eos, T0). Set-up work, any equation of state.
//
//   cold_state     the scale point itself: reference density, e = 0. For eos::grover 0 K and x = 1 (p is p_c(1), a few MPa, not 0).
//   ambient_state  p = 0 at T = T0 on the model's own surface. A model with a temperature: e(rho, T0) is found for each rho, then the
//                  density of p = 0 nearest to the reference density. A model without: p(rho, e = 0) = 0.
//   scaled_to      the model wrapped in eos::scaled_density so that its ambient density is the one wanted.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/scaled_density.hpp"

#include <cmath>

namespace bolide::eos {

struct material_state {
  double density;     // kg/m3
  double energy;      // J/kg
  double temperature; // K; NaN where the model knows none
  double pressure;    // Pa
  double sound_speed; // m/s
};

/// The state at (rho, e). Throws bad_parameter where c^2 is not positive.
template <class Eos> material_state state_at(const Eos& eos, double rho, double e) {
  const auto r = eos.evaluate(rho, e);
  require(r.sound_speed_squared > 0, "sound speed squared of a material state", r.sound_speed_squared,
          "> 0 (the model is stable there)", "m2/s2");
  double temperature = std::nan("");
  if constexpr (ThermalEquationOfState<Eos>) temperature = r.temperature;
  return {rho, e, temperature, r.pressure, std::sqrt(r.sound_speed_squared)};
}

template <class Eos> material_state cold_state(const Eos& eos) { return state_at(eos, eos.reference_density(), 0.0); }

namespace detail {
/// e at (rho, T), J/kg; NaN where there is none. T must rise with e.
template <class Eos> double energy_at(const Eos& eos, double rho, double temperature) {
  const double cold = eos.evaluate(rho, 0.0).cold_energy;
  double step = 100 * (temperature + 1); // J/kg, well below what any metal takes up to T
  const auto off = [&](double e) { return eos.evaluate(rho, e).temperature - temperature; };
  for (int i = 0; i < 60; ++i, step *= 2)
    if (off(cold + step) >= 0) return bracketed_root(off, i == 0 ? cold - step : cold + step / 2, cold + step);
  return std::nan("");
}

/// The density of f = 0 nearest to rho0, looked for between 0.6 and 1.6 rho0 in steps of half a percent.
template <class F> double density_near(const F& f, double rho0) {
  double up = rho0, down = rho0, f_up = f(rho0), f_down = f_up;
  for (int i = 1; i <= 120; ++i) {
    const double next_up = rho0 * (1 + 0.005 * i), f_next_up = f(next_up);
    if (f_up * f_next_up <= 0) return bracketed_root(f, up, next_up);
    up = next_up, f_up = f_next_up;
    if (i > 80) continue;
    const double next_down = rho0 * (1 - 0.005 * i), f_next_down = f(next_down);
    if (f_down * f_next_down <= 0) return bracketed_root(f, next_down, down);
    down = next_down, f_down = f_next_down;
  }
  return std::nan("");
}
} // namespace detail

/// p = 0 at temperature T0 (K). A model without a temperature ignores T0: p = 0 at e = 0. Throws bad_parameter where there is none.
template <class Eos> material_state ambient_state(const Eos& eos, double T0 = 293) {
  require(T0 > 0 && T0 < 1e5, "ambient temperature", T0, "between 0 and 1e5", "K");
  double rho, e = 0;
  if constexpr (ThermalEquationOfState<Eos>) {
    const auto pressure = [&](double r) { return eos.evaluate(r, detail::energy_at(eos, r, T0)).pressure; };
    rho = detail::density_near(pressure, eos.reference_density());
    e = detail::energy_at(eos, rho, T0);
    require(std::isfinite(rho) && std::isfinite(e), "ambient temperature", T0,
            "one at which the equation of state has p = 0 between 0.6 and 1.6 times its reference density", "K");
  } else {
    rho = detail::density_near([&](double r) { return eos.evaluate(r, 0.0).pressure; }, eos.reference_density());
    require(std::isfinite(rho), "reference density", eos.reference_density(),
            "within a factor 0.6 to 1.6 of a density with p = 0 at e = 0", "kg/m3");
  }
  return state_at(eos, rho, e);
}

/// The model with its density scaled so that p = 0 at T0 lies at `density`.
template <class Eos> scaled_density<Eos> scaled_to(const Eos& eos, double density, double T0 = 293) {
  require(density > 0, "density at ambient", density, "> 0", "kg/m3");
  return {eos, density / ambient_state(eos, T0).density};
}

} // namespace bolide::eos
