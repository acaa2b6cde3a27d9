// SPDX-License-Identifier: MIT
// Thirty lines that compose a solver: the aluminium sphere on the plate, coarse, with the paper's equation of state.
#include "bolide/bolide.hpp"
#include <cstdio>

using namespace bolide;
using unit::GPa, unit::mm, unit::us;

int main() {
  // A material: equation of state (cold curve + phases), strength, failure. Its density is scaled to that of 2024 at 293 K, p = 0.
  const auto metal = eos::scaled_to(eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}}, 2785, 293);
  const material aluminium{metal, strength::johnson_cook{}, failure::tension_or_melt{1.5 * GPa}};
  const auto start = eos::ambient_state(metal, 293);

  // Two bodies: shape, material, particle spacing, state, velocity (r, z).
  const double dx = 0.2 * mm;
  using rz = vec<double, 2>;
  const body ball{"ball", sphere{rz{0, -4.75 * mm}, 4.75 * mm}, aluminium, dx, {start.density, start.energy}, rz{0, 6640}};
  const body plate{"plate", box{rz{0, 0}, rz{30 * mm, 2.2 * mm}}, aluminium, dx, {start.density, start.energy}};

  // A solver: space, grid, shape function, transfer, scheme, controls, bodies. Change a word and you have another solver.
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, ball, plate};
  sim.run(3 * us);

  const auto cloud = observe::debris_cloud(observe::take_snapshot(sim), {.plate_front_z = 0, .plate_rear_z = 2.2 * mm, .impact_speed = 6640});
  std::printf("%zu particles, %ld steps, cloud %.2f mm x %.2f mm, energy drift %.1e, %.2f s\n", sim.particle_count(), sim.steps(),
              cloud.length_plate_to_front / mm, cloud.width / mm, sim.energies().drift(), sim.solver_seconds());
  return std::abs(sim.energies().drift()) < 1e-12 ? 0 : 1;
}
