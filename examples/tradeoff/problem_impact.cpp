// SPDX-License-Identifier: MIT
// The paper's impact: a 9.5 mm sphere hits a 2.2 mm plate of aluminium at 6.64 km/s; variant `mixed` of its equation of state, Johnson-Cook, 1.5 GPa of
// tension or melting fails; 6.6 us. Beside it a slower one on a thicker plate, and for the judge a smaller sphere on a thinner plate.
//
// No exact answer: the reference is the default composition (B-splines, APIC, USF, double) with 44 cells over the plate (0.05 mm in the paper's case), half of the finest of the matrix.
// `length` is the plate's thickness. Error: mean of the relative deviations of the debris cloud's length, width, hole diameter, front speed and downstream
// momentum (docs/debris_cloud.md). FLIP's particles keep velocity noise that makes the cloud 4 % wider: it does not converge to this reference.
#include "problems.hpp"
#include "simulation.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/material/data/aluminium.hpp"
#include "bolide/material/material.hpp"
#include "bolide/observe/debris_cloud.hpp"

#include <array>
#include <cmath>
#include <memory>

namespace tradeoff {
namespace {
using namespace bolide;

struct impact {
  double diameter, thickness, plate_radius, speed, end; // m, m/s, s
};

template <class Eos> chosen_material aluminium(const Eos& eos) {
  const auto at = eos::ambient_state(eos, 293);
  return choose(material{eos, data::aluminium.strength, failure::tension_or_melt{1.5e9}}, at.density, at.energy);
}
auto scaled_eos() {
  const eos::grover base{cold::tabulated{cold::cai_ye{}}, phase::mixed{*data::aluminium.phases}};
  return eos::scaled_density{base, data::aluminium.density / eos::ambient_state(base, 293).density};
}
const chosen_material& metal(bool table) {
  static const chosen_material exact = aluminium(scaled_eos());
  if (!table) return exact;
  static const chosen_material tabulated = aluminium(eos::tabulated{scaled_eos()});
  return tabulated;
}

struct cloud {
  std::array<double, 5> measures;
  outcome costs;
};
cloud run(const impact& of_case, const settings& s) {
  const auto [diameter, thickness, plate_radius, speed, end] = of_case;
  const double h = thickness / s.cells;
  const double radius = diameter / 2, dx = h / s.per_axis;
  const point centre{0, -radius};
  const region ball{{-radius, -diameter}, {radius, 0}, centre, [=](const point& x) { return (x - centre).norm() <= radius - dx / 2; },
                    4.0 / 3 * std::acos(-1) * radius * radius * radius};
  const auto& al = metal(s.table);
  scene of{{{ball, al}, {block({0, 0}, {plate_radius, thickness}), al}}, {}, [v = of_case.speed](const point&, int body) { return start{{0, body == 0 ? v : 0}}; }, h};
  const auto sim = compose(s, of);
  sim->advance(end);
  observe::impact_scene what;
  what.plate_rear_z = thickness;
  what.impact_speed = speed;
  const observe::debris_cloud c(sim->snapshot(), what);
  return {{c.length_plate_to_front, c.width, c.hole_diameter, c.front_speed, c.momentum_downstream}, sim->costs()};
}

problem impact_problem(std::string name, const impact& i) {
  const auto reference = std::make_shared<std::array<double, 5>>();
  const double area = (i.diameter * i.diameter * std::acos(-1) / 8 + i.plate_radius * i.thickness) / (i.thickness * i.thickness);
  return {std::move(name), "impact", "mean relative deviation of length, width, hole, front speed and momentum of the cloud, against 44 cells over the plate", i.thickness, area,
          i.end * (5400 + i.speed) / i.thickness, i.speed / 5400, false, true, {5.5, 11, 22}, [i, reference](const settings& s) {
            if ((*reference)[0] == 0) *reference = run(i, {.cells = 44}).measures;
            cloud c = run(i, s);
            for (std::size_t k = 0; k < 5; ++k) c.costs.error += std::abs(c.measures[k] / (*reference)[k] - 1) / 5;
            if (!std::isfinite(c.costs.error)) throw failed_run{"a measure of the cloud is no number"};
            return c.costs;
          }};
}
} // namespace

problem paper_impact() { return impact_problem("the paper's impact", {9.5e-3, 2.2e-3, 50e-3, 6640, 6.6e-6}); }
problem thick_impact() { return impact_problem("impact of 8 mm on 3 mm at 4.5 km/s", {8e-3, 3e-3, 40e-3, 4500, 8e-6}); }
problem slower_impact() { return impact_problem("impact of 6 mm on 1.5 mm at 5 km/s", {6e-3, 1.5e-3, 30e-3, 5000, 6e-6}); }

} // namespace tradeoff
