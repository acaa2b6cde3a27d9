// SPDX-License-Identifier: MIT
// Liquid and vapour in equilibrium, for an equation of state with a temperature whose isotherms have a van der Waals loop.
//
//   saturation              at temperature T: Maxwell's equal areas, integral of (p - p_s) dV from V_l to V_v = 0
//   saturation_at_pressure  the T at which p_s is the pressure asked for (the boiling point)
// p must be continuous along the isotherm (phase::helm, not the variants with a gas branch), and the condensed branch is what the model has
// there (below the triple point a solid). Method: p(ln V) at T with Gauss's 5 points on panels of 0.05 in ln V from 2 rho_ref to 1e-9
// rho_ref or the end of the validity box; roots to round-off. A loop narrower than a panel (some 0.1 % below the critical T) is not seen.
// Status no_solution (all else NaN): no loop at this T (above the critical one, or a model without vapour), or the vapour would lie
// outside the validity box. Cost: 1e5 to 1e6 calls of the equation of state at one T, ten times that at one p.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/inverse.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace bolide::analysis {

struct saturation_state {
  double temperature;                     // K
  double pressure;                        // Pa
  double liquid_density, liquid_energy;   // kg/m3, J/kg: the boiling liquid
  double vapour_density, vapour_energy;   // kg/m3, J/kg: the saturated vapour
  double latent_heat;                     // J/kg, enthalpy of the vapour less that of the liquid
  eos::status what;
};

namespace detail {
/// An isotherm from thin to dense, with its integral of p dV.
template <class Eos> class isotherm_loop {
public:
  isotherm_loop(const Eos& eos, double T) : eos_(eos), temperature_(T) {
    const double reference = eos.reference_density(), thin = std::fmax(1e-9 * reference, eos::validity_of(eos).density_low * (1 + 1e-12));
    first_ = -std::log(thin);
    const auto panels = static_cast<std::size_t>(std::fmax(0, std::log(2 * reference / thin) / width));
    integral_.push_back(0);
    double last = pressure(edge(0));
    for (std::size_t i = 1; i <= panels; ++i) {
      const double p = pressure(edge(i));
      // Three branches: rising to the vapour's spinodal, falling to the liquid's, rising while the model goes on.
      if (std::isnan(last)) thin_ = i; // the model has no such T at smaller densities
      const bool rises = p > last || std::isnan(last);
      if (vapour_ == 0 && !rises) vapour_ = i - 1;
      else if (vapour_ != 0 && liquid_ == 0 && rises) liquid_ = i - 1;
      else if (liquid_ != 0 && !rises) break;
      integral_.push_back(i > thin_ ? integral_.back() + area(edge(i - 1), edge(i)) : 0);
      if (liquid_ != 0) dense_ = i;
      last = p;
    }
  }

  bool has_loop() const { return vapour_ > thin_ && dense_ > liquid_; }
  /// Bounds of p_s: both branches have every pressure between them.
  double highest() const { return std::fmin(pressure(edge(vapour_)), pressure(edge(dense_))); }
  double lowest() const { return std::fmax(pressure(edge(liquid_)), pressure(edge(thin_))); }
  double liquid(double p) const { return branch(p, liquid_, dense_); } // ln V
  double vapour(double p) const { return branch(p, thin_, vapour_); }
  double energy(double y) const { return eos::energy_at_temperature(eos_, std::exp(-y), temperature_).value; }
  /// Integral of (p - p_s) dV from the liquid to the vapour of pressure p_s; NaN where p_s is not on both branches.
  double excess(double p_s) const {
    const double a = liquid(p_s), b = vapour(p_s);
    if (!std::isfinite(a) || !std::isfinite(b)) return std::nan("");
    return to(b) - to(a) - p_s * (std::exp(b) - std::exp(a));
  }

private:
  static constexpr double width = 0.05;
  double edge(std::size_t i) const { return first_ - width * static_cast<double>(i); }
  double pressure(double y) const { return eos_.evaluate(std::exp(-y), energy(y)).pressure; } // NaN where the model has no such T
  double branch(double p, std::size_t from, std::size_t end) const {
    return eos::bracketed_root([&](double y) { return pressure(y) - p; }, edge(from), edge(end));
  }
  double area(double a, double b) const {
    static constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
    static constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    const auto f = [&](double y) { return pressure(y) * std::exp(y); };
    return half * (weight[0] * f(middle) + weight[1] * (f(middle - half * node[1]) + f(middle + half * node[1])) +
                   weight[2] * (f(middle - half * node[2]) + f(middle + half * node[2])));
  }
  double to(double y) const {
    const auto i = static_cast<std::size_t>((first_ - y) / width);
    return integral_[i] + area(edge(i), y);
  }

  const Eos& eos_;
  double temperature_, first_ = 0;
  std::vector<double> integral_;
  // Edges: first inside the model, at the two spinodals, at the end of the condensed branch.
  std::size_t thin_ = 0, vapour_ = 0, liquid_ = 0, dense_ = 0;
};
} // namespace detail

namespace detail {
inline saturation_state no_saturation(double T) {
  const double none = std::nan("");
  return {T, none, none, none, none, none, none, eos::status::no_solution};
}
} // namespace detail

/// Liquid and vapour that coexist at T (K).
template <class Eos> saturation_state saturation(const Eos& eos, double T) {
  static_assert(ThermalEquationOfState<Eos>, "bolide: analysis::saturation needs a ThermalEquationOfState.");
  require(T > 0 && std::isfinite(T), "temperature of saturation", T, "> 0 and finite", "K");
  const detail::isotherm_loop loop(eos, T);
  if (!loop.has_loop()) return detail::no_saturation(T);
  const auto excess = [&](double log_p) { return loop.excess(std::exp(log_p)); };
  constexpr double inside = 1e-9; // a bound itself may lie beyond its branch by round-off
  const double p = std::exp(eos::bracketed_root(excess, std::log(loop.lowest()) + inside, std::log(loop.highest()) - inside));
  if (!std::isfinite(p)) return detail::no_saturation(T);
  const double l = loop.liquid(p), v = loop.vapour(p), e_l = loop.energy(l), e_v = loop.energy(v);
  return {T, p, std::exp(-l), e_l, std::exp(-v), e_v, e_v - e_l + p * (std::exp(v) - std::exp(l)), eos::status::ok};
}

/// Liquid and vapour that coexist at p (Pa): the boiling point, looked for between two temperatures (K).
template <class Eos> saturation_state saturation_at_pressure(const Eos& eos, double p, double T_low, double T_high) {
  require(p > 0, "pressure of saturation", p, "> 0", "Pa");
  require(T_low > 0 && T_high > T_low, "lower temperature of the search for saturation", T_low, "> 0 and below the upper one", "K");
  // ln p_s is almost a straight line in 1/T. No loop counts as too hot.
  const auto off = [&](double inverse_T) {
    const saturation_state at = saturation(eos, 1 / inverse_T);
    return at.what == eos::status::ok ? std::log(at.pressure / p) : 1;
  };
  const double found = eos::bracketed_root(off, 1 / T_high, 1 / T_low);
  if (!std::isfinite(found)) return detail::no_saturation(std::nan(""));
  const saturation_state s = saturation(eos, 1 / found);
  return std::abs(s.pressure / p - 1) < 1e-6 ? s : detail::no_saturation(std::nan("")); // a sign change where the loop ends is no root
}

} // namespace bolide::analysis
