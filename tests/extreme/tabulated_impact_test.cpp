// SPDX-License-Identifier: MIT
// optimise: -O1
// Extreme 10, with a tabulated equation of state: in the paper's impact on 5.5 cells over the plate B-splines with APIC drive some particles
// of hot vapour far below the table's lowest density, 0.2 rho0. The run ends, its books close, and its debris cloud is the exact model's.
#include "extreme/extreme.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/material/any_material.hpp"
#include "bolide/material/data/aluminium.hpp"
#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/take_snapshot.hpp"

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 2>;

constexpr double speed = 6640, thickness = 2.2 * mm; // m/s, m

struct outcome {
  double length, width, hole, front; // m, m, m, m/s
  std::uint64_t outside;             // particle-steps outside the equation of state's range
  double seconds;
  std::string floors;
};
template <class Method, class Eos> outcome impact(const Eos& eos) {
  using metal = any_material<double, space::axisymmetric>; // one solver is compiled for both
  const auto ambient = eos::ambient_state(eos, 293);
  const initial_state at{ambient.density, ambient.energy};
  const metal al{material{eos, data::aluminium.strength, failure::tension_or_melt{1.5e9}}};
  const double radius = 4.75 * mm, h = thickness / 5.5, dx = h / 2;
  const body ball{"ball", sphere{point{0, -radius}, radius}, al, dx, at, point{0, speed}};
  const body plate{"plate", box{point{0, 0}, point{50 * mm, thickness}}, al, dx, at};
  auto sim = make<Method, space::axisymmetric>(h, one_thread<double>(), ball, plate);
  sim.run(6.6 * us);
  is_sound(sim);
  observe::impact_scene what;
  what.plate_rear_z = thickness;
  what.impact_speed = speed;
  const observe::debris_cloud cloud(observe::take_snapshot(sim), what);
  const auto outside = sim.energies().floors[floor_kind::validity];
  return {cloud.length_plate_to_front, cloud.width, cloud.hole_diameter, cloud.front_speed, outside, sim.solver_seconds(), floors(sim)};
}

TEST(TabulatedImpact, ApicDrivesVapourOutOfTheTableAndTheCloudIsTheExactModels) {
  const eos::grover base{cold::tabulated{cold::cai_ye{}}, phase::mixed{*data::aluminium.phases}};
  const eos::scaled_density exact{base, data::aluminium.density / eos::ambient_state(base, 293).density};
  const auto a = impact<bspline_apic_usf>(eos::tabulated{exact}), b = impact<bspline_apic_usf>(exact);
  EXPECT_GT(a.outside, 100u) << "particles do leave the table";
  const struct {
    const char* name;
    double table, model;
  } measures[] = {{"length", a.length, b.length}, {"width", a.width, b.width}, {"hole", a.hole, b.hole}, {"front speed", a.front, b.front}};
  for (const auto& m : measures) {
    const double off = m.table / m.model - 1;
    verify::record({.section = "extremes",
                    .problem = "the paper's impact, mixed as a table, 5.5 cells over the plate",
                    .composition = composition<bspline_apic_usf, space::axisymmetric>(),
                    .measure = std::string(m.name) + " of the debris cloud, against the exact model",
                    .value = off,
                    .bound = 1e-6,
                    .seconds = a.seconds,
                    .note = a.floors});
    EXPECT_LT(std::abs(off), 1e-6) << m.name;
  }
}

} // namespace
} // namespace bolide
