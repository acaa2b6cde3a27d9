// SPDX-License-Identifier: MIT
// Noh's implosion (exact/noh.hpp) in every geometry that the spaces offer: e = 0, gamma 5/3, t = 0.6, shock at 0.2.
//   planar       1-D, against a mirror
//   cylindrical  r-z: a slab of three cells between mirrors;   plane strain: a quarter of a disc between two mirrors
//   spherical    r-z: half a sphere on a mirror;               3-D: an octant between three mirrors
// Viscosity: the default (1.5, 0.06) heats the converging gas ahead of the shock, and APIC's own dissipation adds to it: the sphere's density is then
// low by half. 0.1 and 0.1 suffice for APIC (tests/extreme/noh.hpp derives the heat and holds the cold starts).
// Asked (verification.md): density within 5 % over r 0.05 to 0.15, shock within 2 cells. L1 errors over r 0.05 to 0.35, as others publish them.
#pragma once

#include "verify/exact/noh.hpp"
#include "verify/gas_flow.hpp"

#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/plane_strain.hpp"

namespace bolide::verify {

inline constexpr const char* ripple = "first order is not reached: a ripple behind the shock and what went wrong at the wall at first stay in the gas that they are in";
inline constexpr const char* few_cells = "the shock is three cells thick and stands at 0.2: within 5 % from 200 cells on (extremes)";

struct noh_result {
  l1 errors;
  double plateau, shock_off, wall; // relative error of the density over r 0.05 to 0.15; cells; relative error of the density over r < 0.03
  double scatter;                  // of the pressure over r 0.05 to 0.15
};

/// Where the mean radial velocity, by shells of a cell, goes through -1/2.
template <class Solver> double noh_shock(const Solver& sim, int axes) {
  const double h = sim.cell();
  std::vector<double> mass(static_cast<std::size_t>(0.5 / h), 0), momentum(mass.size(), 0);
  each_sample(sim, axes, [&](const sample& s) {
    const auto i = static_cast<std::size_t>(s.r / h);
    if (i < mass.size()) mass[i] += s.mass, momentum[i] += s.mass * s.u;
  });
  for (std::size_t i = mass.size() - 1; i-- > 0;) {
    const double here = momentum[i] / mass[i], ahead = momentum[i + 1] / mass[i + 1];
    if (here >= -0.5) return h * (static_cast<double>(i) + 0.5 + (here + 0.5) / (here - ahead));
  }
  return std::nan("");
}

/// Runs a scene that holds gas at rest, between its mirrors, to t = 0.6.
template <class Solver> noh_result run_noh(Solver& sim, int k, int axes) {
  constexpr double t = 0.6;
  set_in_motion(sim, [&](const auto& x) {
    auto v = x;
    double r2 = 0;
    for (int d = 0; d < Solver::dim; ++d) v[d] = d < axes ? -x[d] : 0, r2 += d < axes ? x[d] * x[d] : 0;
    return decltype(v)(v / std::sqrt(r2));
  });
  sim.run(t);
  const bool in_float = sizeof(typename Solver::scalar) == 4;
  EXPECT_LT(std::abs(sim.energies().residual()), in_float ? 1e-4 : 1e-9);
  EXPECT_LT(std::abs(sim.energies().drift()), in_float ? 1e-4 : 1e-9);
  const noh exact{k};
  noh_result result;
  result.errors = l1_errors_of_shells(sim, axes, 0.05, 0.35, [&](double r) { return exact.at(r, t); });
  result.scatter = scatter_of_pressure(sim, axes, 0.05, 0.15);
  double mass = 0, volume = 0, wall_mass = 0, wall_volume = 0;
  each_sample(sim, axes, [&](const sample& s) {
    if (s.r > 0.05 && s.r < 0.15) mass += s.mass, volume += s.volume;
    if (s.r < 0.03) wall_mass += s.mass, wall_volume += s.volume;
  });
  result.plateau = mass / volume / exact.plateau() - 1;
  result.wall = wall_mass / wall_volume / exact.plateau() - 1;
  result.shock_off = (noh_shock(sim, axes) - exact.shock(t)) / sim.cell();
  return result;
}

enum class noh_geometry { planar, cylinder_rz, cylinder_plane_strain, sphere_rz, sphere_3d };

template <noh_geometry G, class Method, class Viscosity = viscosity::bulk> noh_result run_noh(int cells, int per_cell, Viscosity q = Viscosity()) {
  const double h = 1.0 / cells, spacing = h / per_cell;
  const material gas{verify::ideal_gas{5.0 / 3}, strength::none{}, failure::none{}, q};
  auto c = one_thread<typename Method::scalar>();
  c.dt_floor = 1e-9; // cold gas asks for long first steps
  const initial_state cold{1, 0};
  if constexpr (G == noh_geometry::planar) {
    auto sim = solve<Method>(space::planar_1d{}, h, c, body{"slab", box{vec<double, 1>{0}, vec<double, 1>{1}}, gas, spacing, cold});
    sim.add(grid::mirror{0, 0, true});
    return run_noh(sim, 1, 1);
  } else if constexpr (G == noh_geometry::cylinder_rz) {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"cylinder", box{vec<double, 2>{0, 0}, vec<double, 2>{1, 3 * h}}, gas, spacing, cold});
    sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 3 * h, false});
    return run_noh(sim, 2, 1);
  } else if constexpr (G == noh_geometry::cylinder_plane_strain) {
    auto sim = solve<Method>(space::plane_strain{}, h, c, body{"cylinder", positive_part<2>{0, 1}, gas, spacing, cold});
    sim.add(grid::mirror{0, 0, true}).add(grid::mirror{1, 0, true});
    return run_noh(sim, 2, 2);
  } else if constexpr (G == noh_geometry::sphere_rz) {
    auto sim = solve<Method>(space::axisymmetric{}, h, c, body{"sphere", positive_part<2>{0, 1}, gas, spacing, cold});
    sim.add(grid::mirror{1, 0, true});
    return run_noh(sim, 3, 2);
  } else {
    auto sim = solve<Method>(space::cartesian_3d{}, h, c, body{"sphere", positive_part<3>{0, 1}, gas, spacing, cold});
    sim.add(grid::mirror{0, 0, true}).add(grid::mirror{1, 0, true}).add(grid::mirror{2, 0, true});
    return run_noh(sim, 3, 3);
  }
}

constexpr const char* name_of(noh_geometry g) {
  switch (g) {
  case noh_geometry::planar: return "Noh, planar";
  case noh_geometry::cylinder_rz:
  case noh_geometry::cylinder_plane_strain: return "Noh, cylindrical";
  default: return "Noh, spherical";
  }
}
constexpr const char* space_of(noh_geometry g) {
  switch (g) {
  case noh_geometry::planar: return "planar_1d";
  case noh_geometry::cylinder_plane_strain: return "plane_strain";
  case noh_geometry::sphere_3d: return "cartesian_3d";
  default: return "axisymmetric";
  }
}

/// Rows of a geometry at resolutions that double. `gated`: the density within 5 % and the shock within 2 cells; the order where one is given.
template <noh_geometry G, class Method> void verify_noh(const std::vector<int>& cells, viscosity::bulk q, bool gated, const asked& bounds) {
  std::vector<l1> errors;
  noh_result last{};
  for (const int n : cells) {
    last = run_noh<G, Method>(n, 2, q);
    errors.push_back(last.errors);
  }
  char text[40];
  std::snprintf(text, sizeof text, ", viscosity %g, %g", q.quadratic, q.linear);
  const std::string composition = composed<Method>(space_of(G)) + text, resolution = std::to_string(cells.back()) + " cells";
  record_errors(name_of(G), composition, "shells of r 0.05-0.35, " + resolution, errors, bounds);
  const auto one = [&](const char* what, double value, double bound, const char* unit = "", const char* note = "") {
    record_and_check({.section = "shocks", .problem = name_of(G), .composition = composition, .measure = what + (", " + resolution), .value = value, .bound = gated ? bound : none,
                      .unit = unit, .note = *note ? note : bounds.note});
  };
  one("density in r 0.05-0.15", last.plateau, 0.05);
  one("shock radius less 0.2", last.shock_off, 2, "cells");
  one("wall heating: density in r < 0.03", last.wall, none, "", "too hot where the shock formed, as in all codes of this kind: the density is low there");
  one("scatter of the particles' pressure in r 0.05-0.15", last.scatter, none, "",
      "what one particle has more its neighbour in the cell has less: the grid does not see it, and it stays as the shock left it");
}

} // namespace bolide::verify
