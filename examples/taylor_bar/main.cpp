// SPDX-License-Identifier: MIT
// Taylor's bar: a copper cylinder hits a rigid wall at 190 m/s and mushrooms; its final shape against Johnson and Cook's measured one.
//
// Run:  bash examples/run.sh taylor_bar [--quick]
//
// The wall is a mirror plane (frictionless, and the bar cannot leave it). The strength is the linear hardening that is fitted to such tests,
// 157 + 425 eps MPa. Compared as Johnson and Holmquist (1988) do: the mean of the relative
// errors of final length, foot diameter, and diameter at 0.2 of the first length above the wall.
#include "bolide/core/unit.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/data/copper.hpp"
#include "bolide/observe/picture.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/strength/linear_hardening.hpp"

#include <cstdio>
#include <string_view>

using namespace bolide;
using unit::GPa, unit::MPa, unit::mm, unit::us;
using rz = vec<double, 2>;

struct outline { double length, foot, waist; }; // m; two diameters

/// Of the particles' centres and half a spacing.
outline measure(const observe::snapshot& bar, double first_length) {
  outline o{};
  const auto& x = bar.at("position");
  for (std::size_t i = 0; i < bar.size(); ++i) {
    const double edge = x(i, 0) + bar.spacing / 2, height = x(i, 1);
    o.length = std::max(o.length, height + bar.spacing / 2);
    if (height < 0.02 * first_length) o.foot = std::max(o.foot, 2 * edge);
    if (std::abs(height - 0.2 * first_length) < bar.spacing) o.waist = std::max(o.waist, 2 * edge);
  }
  return o;
}

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double length = 25.4 * mm, radius = 3.81 * mm, dx = radius / (quick ? 16 : 32);

  // ---- the heart: material, body, wall, solver ----
  const strength::linear_hardening hardening{43.3 * GPa, 157 * MPa, 425 * MPa}; // shear modulus, yield stress, and its rise with plastic strain
  const material copper{eos::mie_grueneisen{data::copper.mie_grueneisen}, hardening, failure::none{}};
  const body bar{"bar", box{rz{0, 0}, rz{radius, length}}, copper, dx, {data::copper.density, 0}, rz{0, -190}};
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, bar};
  sim.add(grid::mirror{1, 0, true});
  sim.run(80 * us);

  auto last = observe::take_snapshot(sim);
  const outline found = measure(last, length), shot{16.2 * mm, 13.5 * mm, 10.1 * mm};
  last.spacing *= 1.3; // to draw: the foot is stretched, and its particles should not show gaps
  const auto how = observe::paint::of("plastic_strain", "equivalent plastic strain", 1).between(0, 2);
  png::write_png("taylor_bar.png", observe::draw_panel({&last, how, "OFHC copper, 190 m/s", {}}, {0, 18 * mm, -8 * mm, 8 * mm}));

  const double errors[] = {found.length / shot.length - 1, found.foot / shot.foot - 1, found.waist / shot.waist - 1};
  const double mean = (std::abs(errors[0]) + std::abs(errors[1]) + std::abs(errors[2])) / 3;
  std::printf("length %.2f mm (%+.1f %%), foot %.2f mm (%+.1f %%), diameter at 0.2 L %.2f mm (%+.1f %%): mean error %.1f %%\n", found.length / mm,
              100 * errors[0], found.foot / mm, 100 * errors[1], found.waist / mm, 100 * errors[2], 100 * mean);
  std::printf("energy drift %.1e, plastic work %.1f of %.1f J; %zu particles, %ld steps, %.2f s; taylor_bar.png\n", sim.energies().drift(),
              sim.energies().plastic_work, sim.energies().initial.kinetic, sim.particle_count(), sim.steps(), sim.solver_seconds());
  return mean < 0.03 ? 0 : 1;
}
