// SPDX-License-Identifier: MIT
// Taylor's bar: a cylinder hits a rigid slip wall; linear hardening, Mie-Grueneisen.
//
// There is no exact answer: the reference is B-splines, FLIP, USF, double on 32 cells per radius, twice as fine as the finest of the matrix. (FLIP's figures
// converge with second order here, APIC's with first; `length` etc. of APIC on 16 cells still move by 0.3 %.) `length` is the radius. Error: mean of the relative deviations of final length, foot diameter and diameter at 0.2 of the first
// length, as Johnson and Holmquist compare bars; particles are points, half a particle's first size is added at every end.
#include "problems.hpp"
#include "simulation.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/material.hpp"
#include "bolide/strength/linear_hardening.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace tradeoff {
namespace {
using namespace bolide;

struct bar {
  eos::mie_grueneisen_parameters eos;
  strength::linear_hardening strength;
  double radius, length, speed, end; // m, m/s, s
};
constexpr double reference_cells = 32;

struct shape_of_bar {
  std::array<double, 3> measures; // m: length, foot, waist
  outcome costs;
};
shape_of_bar run(const bar& b, const settings& s) {
  const double h = b.radius / s.cells, dx = h / s.per_axis;
  scene of{{{block({0, 0}, {b.radius, b.length}), choose(material{eos::mie_grueneisen{b.eos}, b.strength, failure::none{}}, b.eos.rho0, 0)}},
           {grid::mirror{1, 0, true}},
           [&](const point&, int) { return start{{0, -b.speed}}; },
           h};
  const auto sim = compose(s, of);
  sim->advance(b.end);
  shape_of_bar r{{0, 0, 0}, sim->costs()};
  sim->each([&](const particle& p) {
    const double edge = 2 * p.x[0] + dx;
    r.measures[0] = std::max(r.measures[0], p.x[1] + dx / 2);
    r.measures[1] = std::max(r.measures[1], edge);
    if (std::abs(p.x[1] - 0.2 * b.length) < h / 2) r.measures[2] = std::max(r.measures[2], edge);
  });
  return r;
}

problem bar_problem(std::string name, const bar& b) {
  const double sound = b.eos.c0 * 1.15; // with the shear modulus of a metal
  problem p{std::move(name), "plasticity", "mean relative error of length, foot and diameter at 0.2 of the length, against 32 cells per radius", b.radius,
            b.length / b.radius, b.end * sound / b.radius, b.eos.rho0 * square(b.speed) / b.strength.yield, false, false, {2, 4, 8, 16}, {}};
  const auto reference = std::make_shared<std::array<double, 3>>();
  p.measure = [b, reference](const settings& s) {
    if ((*reference)[0] == 0) *reference = run(b, {.composition = 3, .cells = reference_cells}).measures;
    shape_of_bar r = run(b, s);
    for (std::size_t k = 0; k < 3; ++k) r.costs.error += std::abs(r.measures[k] / (*reference)[k] - 1) / 3;
    return r.costs;
  };
  return p;
}
} // namespace

problem taylor_copper() {
  return bar_problem("Taylor bar, copper at 190 m/s", {{.rho0 = 8930, .c0 = 3940, .s = 1.49, .gamma0 = 1.96}, {43.3e9, 157e6, 425e6}, 3.8e-3, 25.4e-3, 190, 80e-6});
}
problem taylor_steel() {
  return bar_problem("Taylor bar, steel at 300 m/s", {{.rho0 = 7830, .c0 = 3574, .s = 1.92, .gamma0 = 1.69}, {81.8e9, 792e6, 510e6}, 3.8e-3, 25.4e-3, 300, 60e-6});
}
problem taylor_steel_slow() {
  return bar_problem("Taylor bar, steel at 200 m/s", {{.rho0 = 7830, .c0 = 3574, .s = 1.92, .gamma0 = 1.69}, {81.8e9, 792e6, 510e6}, 3.8e-3, 25.4e-3, 200, 50e-6});
}
problem taylor_iron() {
  return bar_problem("Taylor bar, iron at 220 m/s", {{.rho0 = 7850, .c0 = 3574, .s = 1.92, .gamma0 = 1.69}, {80e9, 350e6, 400e6}, 4e-3, 30e-3, 220, 70e-6});
}
problem taylor_aluminium() {
  return bar_problem("Taylor bar, aluminium at 250 m/s", {{.rho0 = 2785, .c0 = 5328, .s = 1.338, .gamma0 = 2}, {27.6e9, 265e6, 300e6}, 3e-3, 24e-3, 250, 50e-6});
}
problem taylor_nickel() {
  return bar_problem("Taylor bar, nickel at 250 m/s", {{.rho0 = 8874, .c0 = 4602, .s = 1.437, .gamma0 = 1.93}, {76e9, 200e6, 600e6}, 5e-3, 30e-3, 250, 80e-6});
}

} // namespace tradeoff
