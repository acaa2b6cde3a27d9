// SPDX-License-Identifier: MIT
// Sedov's blast wave (exact/sedov.hpp), gamma 1.4, cold gas of density 1, t = 1: planar (1-D on a mirror, shock at 0.5), cylindrical (r-z slab, 0.75)
// and spherical (r-z half sphere, 1). The energy starts evenly in the gas within two cells of the origin.
// Measured: shock radius (steepest fall of the shells' density, by its half height), density behind it against the jump of 6, L1 errors over shells
// from half of the shock radius to 1.2 of it (further in there is next to no mass, and no particle).
// Particles per cell: the hot gas must fill the inside of the blast wave. In one dimension its few particles come apart by then and stop pushing (two
// per cell: shock radius low by 10 to 12 %, more on finer cells), so there are 64 of them; around a centre the gas of the first two cells fills a third
// of the radius (two per cell side: no pressure is left inside, radius low by 3 to 12 %), so there are 12 per side there, 6 around it, 2 beyond.
#pragma once

#include "verify/exact/sedov.hpp"
#include "verify/gas_flow.hpp"

#include <algorithm>
#include <numbers>

namespace bolide::verify {

inline constexpr const char* thin_peak =
    "half of the mass lies in the outer 4 % (sphere), 6 % (cylinder) or 12 % (plane) of the radius, a few thicknesses of the shock: less than first order until that is resolved";

inline constexpr const char* thinned =
    "the shock is where it should be; behind it the gas that came from a few cells is stretched to less than one particle per cell and does not keep its pressure";

struct sedov_result {
  l1 errors;
  double shock = 0, peak = 0; // radius; largest density of a shell
};

/// Runs a scene of cold gas to t = 1. `fraction`: of the whole space that the scene holds.
template <class Solver> sedov_result run_sedov(Solver& sim, int j, int axes, double energy, double fraction) {
  const double hot = 2 * sim.cell();
  const auto distance = [axes](const auto& x) {
    double r2 = 0;
    for (int d = 0; d < axes; ++d) r2 += x[d] * x[d];
    return std::sqrt(r2);
  };
  double mass = 0; // of the hot gas
  each_sample(sim, axes, [&](const sample& s) {
    if (s.r < hot) mass += s.mass;
  });
  sim.initialise([&](auto& point) { point.energy = distance(point.position) < hot ? energy * fraction / mass : 0; });
  sim.run(1);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-9);
  const sedov exact(j, energy);
  const double rs = exact.shock(1), h = sim.cell();
  sedov_result result;
  result.errors = l1_errors_of_shells(sim, axes, 0.5 * rs, 1.2 * rs, [&](double r) { return exact.at(r, 1); });
  std::vector<double> m(static_cast<std::size_t>(1.2 * rs / h)), v = m;
  each_sample(sim, axes, [&](const sample& s) {
    const auto i = static_cast<std::size_t>(s.r / h);
    if (i < m.size()) m[i] += s.mass, v[i] += s.volume;
  });
  std::vector<double> rho(m.size());
  for (std::size_t i = 0; i < m.size(); ++i) rho[i] = v[i] > 0 ? m[i] / v[i] : 0;
  result.peak = *std::max_element(rho.begin(), rho.end());
  const double level = 0.5 * (1 + result.peak);
  for (std::size_t i = rho.size() - 1; i-- > 0;)
    if (rho[i] >= level) {
      result.shock = h * (static_cast<double>(i) + 0.5 + (rho[i] - level) / (rho[i] - rho[i + 1]));
      break;
    }
  return result;
}

template <int J, class Method> sedov_result run_sedov(int cells, int per_cell) {
  const double h = 1.0 / cells, spacing = h / per_cell, energies[] = {2 * 0.0673428, 0.3113668, 0.851072};
  const material gas{verify::ideal_gas{1.4}, strength::none{}, failure::none{}};
  auto c = one_thread<typename Method::scalar>();
  const initial_state cold{1, 0};
  if constexpr (J == 1) {
    auto sim = solve<Method>(space::planar_1d{}, h, c, body{"gas", box{vec<double, 1>{0}, vec<double, 1>{0.7}}, gas, spacing, cold});
    sim.add(grid::mirror{0, 0, true});
    return run_sedov(sim, 1, 1, energies[0], 0.5);
  } else if constexpr (J == 2) {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"gas", box{vec<double, 2>{0, 0}, vec<double, 2>{1, 3 * h}}, gas, spacing, cold});
    sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 3 * h, false});
    return run_sedov(sim, 2, 1, energies[1], 3 * h);
  } else {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"core", positive_part<2>{0, 3 * h}, gas, spacing / 6, cold}, body{"mantle", positive_part<2>{3 * h, 8 * h}, gas, spacing / 3, cold},
                             body{"gas", positive_part<2>{8 * h, 1.25}, gas, spacing, cold});
    sim.add(grid::mirror{1, 0, true});
    return run_sedov(sim, 3, 2, energies[2], 0.5);
  }
}

/// Rows: shock radius within 2 % (verification.md section 4), errors and their order.
template <int J, class Method> void verify_sedov(const std::vector<int>& cells, int per_cell, const asked& bounds) {
  const double radii[] = {0.5, 0.75, 1};
  const char* const names[] = {"Sedov, planar", "Sedov, cylindrical", "Sedov, spherical"};
  std::vector<l1> errors;
  sedov_result last;
  for (const int n : cells) {
    last = run_sedov<J, Method>(n, per_cell);
    errors.push_back(last.errors);
  }
  const std::string composition = composed<Method>(J == 1 ? "planar_1d" : "axisymmetric"), resolution = std::to_string(cells.back()) + " cells per unit of " + std::to_string(per_cell);
  record_errors(names[J - 1], composition, resolution, errors, bounds);
  record_and_check({.section = "shocks", .problem = names[J - 1], .composition = composition, .measure = "shock radius, " + resolution, .value = last.shock / radii[J - 1] - 1, .bound = 0.02});
  record({.section = "shocks", .problem = names[J - 1], .composition = composition, .measure = "largest density of a shell against 6, " + resolution, .value = last.peak / 6 - 1,
          .note = "the exact peak is a point; a shock of three cells cuts it off"});
}

} // namespace bolide::verify
