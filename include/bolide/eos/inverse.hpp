// SPDX-License-Identifier: MIT
// An equation of state asked the other way round, with a status; set-up and analysis work, any model.
//
//   energy_at_temperature(eos, rho, T)                  e of T(rho, e) = T         a model with a temperature
//   energy_at_pressure(eos, rho, p)                     e of p(rho, e) = p
//   density_at_pressure_energy(eos, p, e, guess)        rho of p(rho, e) = p
//   density_at_pressure_temperature(eos, p, T, guess)   rho of p(rho, e(rho, T)) = p
//
// value is NaN unless the status is ok: no number that did not converge, none from outside the model's validity box.
//   below_cold_energy   the answer would lie below the cold curve (p below that of the cold curve at this density)
//   outside_validity    the answer would lie outside the box
//   unstable            the only densities found have a falling isotherm (p, T) or c^2 <= 0 (p, e)
//   no_solution         no point of the surface has these values: p or T jumps over them, or never reaches them
//   not_converged       the search ran out of steps
// Several roots. In energy: the lowest (the solid, where the paper's variant has a solid and a liquid at one T). In density: the stable one
// whose ln(rho) is nearest to the guess's, the denser of two as near. Where solid and liquid coexist T does not move with e: the answer
// is the energy at which melting begins, and its region says mixed.
// Method: a sign change is looked for between nodes (energies: from the cold curve or the box's lower end in steps that grow by a quarter,
// and the model's energy_borders; densities: outwards from the guess in steps of 0.5 % that grow to 5 % of the way), then
// eos/bracketed_root.hpp to round-off, and the value there is looked at, so that a jump is not taken for a root. Two roots between two
// nodes are not seen. Cost: 50 to 300 calls of evaluate() in energy and at (p, e), 1e4 to 3e4 at (p, T).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bolide::eos {

struct inverse {
  double value;
  status what;
};

namespace detail {
inline inverse unanswered(status what) { return {std::numeric_limits<double>::quiet_NaN(), what}; }

/// A root of f in [a, b], where f changes its sign. `small(x, f(x))` says whether the value there is zero but for round-off.
template <class F, class Small> inverse settle(const F& f, const Small& small, double a, double b) {
  const double x = bracketed_root(f, a, b);
  if (small(x, f(x))) return {x, status::ok};
  const double width = 1e-15 * std::abs(x); // of the narrowest bracket, and a little more
  return unanswered(f(x - width) * f(x + width) <= 0 ? status::no_solution : status::not_converged);
}

/// Energies between which a sign change is looked for, rising: both sides of every border, and steps that grow by a quarter.
template <class Eos> std::vector<double> energy_nodes(const Eos& eos, double rho) {
  const validity_box box = validity_of(eos);
  const double largest = 1e13, high = std::min(box.energy_high, largest); // J/kg
  double low = std::max(box.energy_low, -largest), zero = std::clamp(0.0, low, high);
  if constexpr (requires { eos.evaluate(rho, 0.0).cold_energy; }) low = zero = std::max(low, eos.evaluate(rho, 0.0).cold_energy);
  std::vector<double> nodes{zero};
  for (double step = 1; zero + step < high; step *= 1.25) nodes.push_back(zero + step);
  for (double step = 1; zero - step > low; step *= 1.25) nodes.push_back(zero - step);
  nodes.push_back(low);
  nodes.push_back(high);
  for (const double border : energy_borders_of(eos, rho))
    for (const double e : {border - 1e-12 * std::abs(border), border, border + 1e-12 * std::abs(border)})
      if (e > low && e < high) nodes.push_back(e);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The lowest root of f(e), which as a rule rises, over the nodes.
template <class Eos, class F, class Small> inverse lowest_energy(const Eos& eos, double rho, const F& f, const Small& small) {
  const std::vector<double> nodes = energy_nodes(eos, rho);
  double last = f(nodes.front());
  const double first = last;
  if (first == 0) return {nodes.front(), status::ok};
  bool jumped = false;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double next = f(nodes[i]);
    if (last * next <= 0) {
      const inverse r = settle(f, small, nodes[i - 1], nodes[i]);
      if (r.what != status::no_solution) return r;
      jumped = true;
    }
    last = next;
  }
  if (small(nodes.front(), first)) return {nodes.front(), status::ok};
  if (jumped || std::isnan(first) || std::isnan(last)) return unanswered(status::no_solution);
  if (first > 0) {
    if constexpr (requires { eos.evaluate(rho, 0.0).cold_energy; }) return unanswered(status::below_cold_energy);
    else return unanswered(std::isfinite(validity_of(eos).energy_low) ? status::outside_validity : status::no_solution);
  }
  return unanswered(std::isfinite(validity_of(eos).energy_high) ? status::outside_validity : status::no_solution);
}

/// The root of f(rho) that is stable and nearest to the guess. `stable(rho)` judges a root.
template <class Eos, class F, class Small, class Stable>
inverse nearest_density(const Eos& eos, double guess, const F& f, const Small& small, const Stable& stable) {
  const validity_box box = validity_of(eos);
  const double low = std::max(box.density_low, 1e-9 * guess), high = std::min(box.density_high, 1e6 * guess);
  if (!(guess >= low && guess <= high)) return unanswered(status::outside_validity);
  status worst = status::no_solution;
  inverse best = unanswered(worst);
  double way_best = std::numeric_limits<double>::infinity();
  for (const int direction : {1, -1}) { // the denser one first: a root as near on the other side does not replace it
    double a = guess, f_a = f(a), way = 0;
    const double end = direction > 0 ? high : low;
    while (a != end && way < way_best) {
      way += std::max(0.005, 0.05 * way);
      double b = guess * std::exp(direction * way);
      if (direction > 0 ? b > end : b < end) b = end;
      const double f_b = f(b);
      if (f_a * f_b <= 0) {
        const inverse r = settle(f, small, a, b);
        const double r_way = std::abs(std::log(r.value / guess));
        if (r.what == status::ok && stable(r.value)) {
          if (r_way < way_best) best = r, way_best = r_way;
          break;
        }
        if (r.what != status::no_solution) worst = r.what == status::ok ? status::unstable : r.what;
      }
      a = b, f_a = f_b;
    }
  }
  return best.what == status::ok ? best : unanswered(worst);
}

inline constexpr double round_off = 1e-14;
} // namespace detail

/// e (J/kg) at rho (kg/m3) and T (K).
template <class Eos> inverse energy_at_temperature(const Eos& eos, double rho, double temperature) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: eos::energy_at_temperature needs a model with a temperature (wrap one that has none in "
                                             "eos::isentrope_temperature).");
  require(rho > 0 && std::isfinite(rho), "eos::energy_at_temperature density", rho, "> 0 and finite", "kg/m3");
  require(temperature > 0 && std::isfinite(temperature), "eos::energy_at_temperature temperature", temperature, "> 0 and finite", "K");
  const validity_box box = validity_of(eos);
  if (!(rho >= box.density_low && rho <= box.density_high)) return detail::unanswered(status::outside_validity);
  const auto off = [&](double e) { return eos.evaluate(rho, e).temperature - temperature; };
  const auto small = [&](double e, double value) {
    const double cold = eos.evaluate(rho, e).cold_energy;
    return std::abs(value) <= 1e-10 * temperature + detail::round_off * (std::abs(e) + std::abs(cold)) * eos.evaluate(rho, e).temperature_energy;
  };
  const inverse r = detail::lowest_energy(eos, rho, off, small);
  if (r.what != status::ok || eos.evaluate(rho, r.value).temperature_energy != 0) return r;
  double below = eos.evaluate(rho, 0.0).cold_energy, at = r.value; // on the plateau: go back to where it begins
  for (int i = 0; i < 200 && below < at; ++i) {
    const double middle = 0.5 * (below + at);
    if (middle <= below || middle >= at) break;
    (off(middle) >= 0 ? at : below) = middle;
  }
  return {at, status::ok};
}

/// e (J/kg) at rho (kg/m3) and p (Pa).
template <class Eos> inverse energy_at_pressure(const Eos& eos, double rho, double pressure) {
  require(rho > 0 && std::isfinite(rho), "eos::energy_at_pressure density", rho, "> 0 and finite", "kg/m3");
  require(std::isfinite(pressure), "eos::energy_at_pressure pressure", pressure, "finite", "Pa");
  const validity_box box = validity_of(eos);
  if (!(rho >= box.density_low && rho <= box.density_high)) return detail::unanswered(status::outside_validity);
  const auto off = [&](double e) { return eos.evaluate(rho, e).pressure - pressure; };
  const auto small = [&](double e, double value) {
    const double terms = std::abs(pressure) + rho * (std::abs(eos.evaluate(rho, e).sound_speed_squared) + std::abs(e)); // that p is a difference of
    return std::abs(value) <= 10 * detail::round_off * terms;
  };
  return detail::lowest_energy(eos, rho, off, small);
}

/// rho (kg/m3) at p (Pa) and e (J/kg).
template <class Eos> inverse density_at_pressure_energy(const Eos& eos, double pressure, double e, double guess) {
  require(std::isfinite(pressure), "eos::density_at_pressure_energy pressure", pressure, "finite", "Pa");
  require(std::isfinite(e), "eos::density_at_pressure_energy energy", e, "finite", "J/kg");
  require(guess > 0 && std::isfinite(guess), "eos::density_at_pressure_energy guess", guess, "> 0 and finite", "kg/m3");
  const validity_box box = validity_of(eos);
  if (!(e >= box.energy_low && e <= box.energy_high)) return detail::unanswered(status::outside_validity);
  const auto off = [&](double rho) { return eos.evaluate(rho, e).pressure - pressure; };
  const auto small = [&](double rho, double value) {
    const double terms = std::abs(pressure) + rho * (std::abs(eos.evaluate(rho, e).sound_speed_squared) + std::abs(e));
    return std::abs(value) <= 10 * detail::round_off * terms;
  };
  const inverse r = detail::nearest_density(eos, guess, off, small, [&](double rho) { return eos.evaluate(rho, e).sound_speed_squared > 0; });
  if (r.what != status::ok) return r;
  const status what = status_at(eos, r.value, e, eos.evaluate(r.value, e));
  return what == status::ok ? r : detail::unanswered(what);
}

/// rho (kg/m3) at p (Pa) and T (K). The energy there is energy_at_temperature's.
template <class Eos> inverse density_at_pressure_temperature(const Eos& eos, double pressure, double temperature, double guess) {
  require(std::isfinite(pressure), "eos::density_at_pressure_temperature pressure", pressure, "finite", "Pa");
  require(temperature > 0 && std::isfinite(temperature), "eos::density_at_pressure_temperature temperature", temperature, "> 0 and finite", "K");
  require(guess > 0 && std::isfinite(guess), "eos::density_at_pressure_temperature guess", guess, "> 0 and finite", "kg/m3");
  const auto off = [&](double rho) {
    const inverse e = energy_at_temperature(eos, rho, temperature); // NaN where there is none
    return eos.evaluate(rho, e.value).pressure - pressure;
  };
  const auto small = [&](double rho, double value) {
    const double e = energy_at_temperature(eos, rho, temperature).value;
    const double terms = std::abs(pressure) + rho * (std::abs(eos.evaluate(rho, e).sound_speed_squared) + std::abs(e));
    return std::abs(value) <= 100 * detail::round_off * terms;
  };
  const auto stable = [&](double rho) {
    const double h = 1e-5 * rho, e = energy_at_temperature(eos, rho, temperature).value;
    return off(rho + h) > off(rho - h) && eos.evaluate(rho, e).sound_speed_squared > 0;
  };
  return detail::nearest_density(eos, guess, off, small, stable);
}

} // namespace bolide::eos
