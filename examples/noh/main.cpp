// SPDX-License-Identifier: MIT
// Noh's problem, spherical, in r-z: a cold gas falls into one point at speed 1; the exact answer has a shock of density 64 that runs out.
//
// Run:  bash examples/run.sh noh [--quick]
//
// Exact (gamma 5/3): the shock is at R = t/3, behind it rho = 64, u = 0, p = 64/3; before it rho = (1 + t/R)^2, u = -1, p = 0.
// The ball is so large that its free surface is still outside of the shock at the end. APIC's own dissipation nearly suffices for the shock; more
// viscosity heats the gas while it converges (the page says how much). Known trouble: near the centre the gas is too hot and so too thin
// ("wall heating"), with every method that spreads a shock over cells.
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/observe/chart.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/strength/none.hpp"

#include <cstdio>
#include <numbers>
#include <string_view>

using namespace bolide;
using rz = vec<double, 2>;

/// A geometry of one's own: the half z > 0 of a ball. The plane z = 0 is a mirror.
struct half_ball {
  static constexpr int dim = 2;
  double radius;
  rz anchor() const { return {0, 0}; }
  rz low() const { return {0, 0}; }
  rz high() const { return {radius, radius}; }
  bool contains(const rz& x, double) const { return x.norm() < radius; }
  double volume(bool) const { return 2.0 / 3 * std::numbers::pi * radius * radius * radius; }
};

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double h = quick ? 0.01 : 0.005, until = 0.6;

  // ---- the heart: material, body, fields at the start, solver ----
  const material gas{eos::ideal_gas{{.gamma = 5.0 / 3, .c_v = 1, .rho0 = 1}}, strength::none{}, failure::none{}, viscosity::bulk{0.1, 0.1}};
  const body ball{"gas", half_ball{0.9}, gas, h / 2, {1, 0}};
  solver sim{space::axisymmetric{}, grid::sparse{h}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{.courant = 0.2}, ball};
  sim.add(grid::mirror{1, 0, true});
  sim.initialise([](auto& point) { point.velocity = -point.position.normalized(); });
  sim.run(until);

  // ---- density against the distance from the centre: particles, their mean over shells of one cell, exact ----
  observe::chart plot{"Spherical Noh, gamma = 5/3, t = 0.6", "R", "density"};
  std::vector<double> radius, density, mass(64), volume(64);
  double plateau_mass = 0, plateau_volume = 0, centre_mass = 0, centre_volume = 0;
  sim.for_each_body([&](const auto& set) {
    const auto& p = set.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double R = std::hypot(p.template get<field::position>(0)[i], p.template get<field::position>(1)[i]);
      const double m = p.template get<field::mass>()[i], v = p.template get<field::volume>()[i];
      radius.push_back(R), density.push_back(m / v);
      if (R > 0.05 && R < 0.15) plateau_mass += m, plateau_volume += v;
      if (R < 0.02) centre_mass += m, centre_volume += v;
    }
  });
  std::vector<double> exact_radius, exact_density;
  for (double R = 0; R <= 0.3; R += 0.001) exact_radius.push_back(R), exact_density.push_back(R < until / 3 ? 64 : std::pow(1 + until / R, 2));
  plot.horizontal_range = {0, 0.3};
  plot.marks("particles", radius, density).line("exact", exact_radius, exact_density);
  png::write_png("noh.png", observe::draw_chart(plot, {.mark = 0.8}));

  const double found = plateau_mass / plateau_volume;
  std::printf("density at R 0.05 to 0.15: %.2f, exact 64 (%+.1f %%); within R < 0.02: %.1f (wall heating)\n", found, 100 * (found / 64 - 1),
              centre_mass / centre_volume);
  std::printf("energy drift %.1e; %zu particles, %ld steps, %.2f s; noh.png\n", sim.energies().drift(), sim.particle_count(), sim.steps(),
              sim.solver_seconds());
  return std::abs(found / 64 - 1) < (quick ? 0.1 : 0.05) ? 0 : 1;
}
