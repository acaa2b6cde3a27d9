// SPDX-License-Identifier: MIT
// Kidder's isentropic shell (exact/kidder.hpp) as an initial-value problem, without a pressure boundary: the body goes from the radius where density and
// pressure vanish (a free surface of the exact solution) out to where the release of its outer surface has not yet come to the shell by the end
// (undisturbed_from). Compared are the shells of one cell between the shell's own rims, r0 0.9 to 1, at t = 0.8 tau, where the radius has fallen to
// 0.6 and the density risen 2.8 times (cylinder) or 4.6 times (sphere).
// The flow is smooth, and still of first order: the stress is updated with velocities half a step away from where it acts, the step goes with the cell,
// and an artificial viscosity heats what is compressed without a shock. At a quarter of the step APIC gains a third and reaches order 1.3.
#pragma once

#include "verify/exact/kidder.hpp"
#include "verify/gas_flow.hpp"

#include "bolide/viscosity/none.hpp"

namespace bolide::verify {

inline constexpr const char* first_order = "smooth flow, but first order in time with a step that goes with the cell (order 1.3 at Courant 0.1)";

template <int K, class Method, class Viscosity> l1 run_kidder(int cells, int per_cell, Viscosity q, double part, double courant) {
  const double h = 1.0 / cells, spacing = h / per_cell;
  const kidder exact{K, K == 2 ? 0.001 : 6.3096e-4};
  const double until = part * exact.tau(), outer = exact.undisturbed_from(1, until) + 3 * h, from = exact.vacuum();
  const material gas{verify::ideal_gas{exact.gamma()}, strength::none{}, failure::none{}, q};
  const auto run = [&](auto& sim) {
    constexpr int axes = K - 1;
    const auto distance = [](const auto& x) {
      double r2 = 0;
      for (int d = 0; d < axes; ++d) r2 += x[d] * x[d];
      return std::sqrt(r2);
    };
    sim.initialise([&](auto& point) {
      const double r = distance(point.position), p = exact.initial_pressure(r);
      point.density = exact.initial_density(r);
      point.energy = p / ((exact.gamma() - 1) * point.density);
    });
    sim.run(until);
    const double scale = exact.scale(until);
    return l1_errors_of_shells(sim, axes, 0.9 * scale, 1.0 * scale, [&](double r) { return exact.at(r, until); });
  };
  const initial_state any{exact.rho_e, 1};
  auto c = one_thread<typename Method::scalar>();
  c.courant = courant;
  if constexpr (K == 2) {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"gas", box{vec<double, 2>{from, 0}, vec<double, 2>{outer, 3 * h}}, gas, spacing, any});
    sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 3 * h, false});
    return run(sim);
  } else {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"gas", positive_part<2>{from, outer}, gas, spacing, any});
    sim.add(grid::mirror{1, 0, true});
    return run(sim);
  }
}

template <int K, class Method, class Viscosity> void verify_kidder(const std::vector<int>& cells, Viscosity q, const asked& bounds, double courant = 0.4) {
  std::vector<l1> errors;
  for (const int n : cells) errors.push_back(run_kidder<K, Method>(n, 2, q, 0.8, courant));
  const std::string composition = composed<Method>("axisymmetric") + (Viscosity::present ? ", viscosity" : ", no viscosity") + (courant == 0.4 ? "" : ", Courant " + to_text(courant));
  record_errors(K == 2 ? "Kidder, cylindrical" : "Kidder, spherical", composition, "shell at 0.8 tau, " + std::to_string(cells.back()) + " cells per unit", errors, bounds);
}

} // namespace bolide::verify
