// SPDX-License-Identifier: MIT
// A small sphere on a thin plate, normal impact, once in r-z and once in three dimensions (a quarter between two mirrors): two discretisations of
// one problem that share neither gradients nor mirrors nor the lattice. Front speed of the cloud and diameter of the hole, by the definitions of
// observe/debris_cloud.hpp, at 20 and at 40 particles per diameter: within 3 % at the finer, and closer than at the coarser.
// What it does not show: that either is converged (the hole shrinks by 9 % from the coarser to the finer, in both).
#include "bolide/core/unit.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

#include "verify/table.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bolide {
namespace {
using namespace unit;

constexpr double diameter = 2 * mm, thickness = 0.6 * mm, plate_radius = 4 * mm, speed = 5 * km / s;

/// A quarter (x, y > 0) of what `Whole` is: the rest is behind the mirrors.
template <class Whole> struct quarter : Whole {
  explicit quarter(Whole w) : Whole(std::move(w)) {}
  vec<double, 3> low() const { return {0, 0, Whole::low()[2]}; }
  double volume(bool radial) const { return Whole::volume(radial) / 4; }
};
/// A disc about the z axis, 0 < z < thickness.
struct disc {
  static constexpr int dim = 3;
  double radius, height;
  vec<double, 3> anchor() const { return {0, 0, 0}; }
  vec<double, 3> low() const { return {-radius, -radius, 0}; }
  vec<double, 3> high() const { return {radius, radius, height}; }
  bool contains(const vec<double, 3>& x, double) const { return std::hypot(x[0], x[1]) < radius && x[2] > 0 && x[2] < height; }
  double volume(bool) const { return std::numbers::pi * radius * radius * height; }
};

struct outcome {
  double front_speed, hole, seconds, drift;
  std::size_t particles;
};

/// The particles of a 3-D snapshot by their distance from the z axis, so that one code measures both.
observe::snapshot in_r_and_z(const observe::snapshot& s) {
  if (s.dimension == 2) return s;
  observe::snapshot flat = s;
  flat.columns.clear();
  flat.dimension = 2;
  flat.axisymmetric = true;
  const auto &x = s.at("position"), &v = s.at("velocity");
  std::vector<double> position, velocity;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double r = std::hypot(x(i, 0), x(i, 1));
    position.insert(position.end(), {r, x(i, 2)});
    velocity.insert(velocity.end(), {(x(i, 0) * v(i, 0) + x(i, 1) * v(i, 1)) / r, v(i, 2)});
  }
  flat.add("position", "m", 2, position);
  flat.add("velocity", "m/s", 2, velocity);
  flat.add("mass", "kg", 1, s.at("mass").data);
  return flat;
}

template <class Sim> outcome finish(Sim& sim) {
  sim.run(2 * us);
  const auto cloud =
      observe::debris_cloud(in_r_and_z(observe::take_snapshot(sim)), {.plate_front_z = 0, .plate_rear_z = thickness, .impact_speed = speed});
  return {cloud.front_speed, cloud.hole_diameter, sim.solver_seconds(), sim.energies().drift(), sim.particle_count()};
}
auto aluminium() {
  return material{eos::mie_grueneisen{{.constant_gamma = true}}, strength::elastic_perfectly_plastic{27.6e9, 0.3e9}, failure::tension{1.5e9}};
}

outcome axisymmetric(int per_diameter) {
  using rz = vec<double, 2>;
  const double dx = diameter / per_diameter;
  const body ball{"ball", sphere{rz{0, -diameter / 2}, diameter / 2}, aluminium(), dx, {2785, 0}, rz{0, speed}};
  const body plate{"plate", box{rz{0, 0}, rz{plate_radius, thickness}}, aluminium(), dx, {2785, 0}};
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, ball, plate};
  return finish(sim);
}
outcome three_dimensional(int per_diameter) {
  using xyz = vec<double, 3>;
  const double dx = diameter / per_diameter;
  const body ball{"ball", quarter{sphere{xyz{0, 0, -diameter / 2}, diameter / 2}}, aluminium(), dx, {2785, 0}, xyz{0, 0, speed}};
  const body plate{"plate", quarter{disc{plate_radius, thickness}}, aluminium(), dx, {2785, 0}};
  solver sim{space::cartesian_3d{}, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, ball, plate};
  sim.add(grid::mirror{0, 0, true}).add(grid::mirror{1, 0, true});
  return finish(sim);
}

TEST(RzAgainst3D, FrontSpeedAndHoleAgree) {
  double front[2], hole[2];
  const int per_diameter[] = {20, 40};
  for (int k = 0; k < 2; ++k) {
    const outcome flat = axisymmetric(per_diameter[k]), full = three_dimensional(per_diameter[k]);
    front[k] = full.front_speed / flat.front_speed - 1, hole[k] = full.hole / flat.hole - 1;
    std::printf("[ figures  ] %d per diameter: front %.1f (r-z) %.1f (3-D) m/s, hole %.4f %.4f mm, %zu %zu particles, %.1f %.1f s, drift %.0e %.0e\n",
                per_diameter[k], flat.front_speed, full.front_speed, flat.hole / mm, full.hole / mm, flat.particles, full.particles, flat.seconds,
                full.seconds, flat.drift, full.drift);
    const std::string problem = "sphere impact, 3-D against r-z, " + std::to_string(per_diameter[k]) + " particles per diameter";
    for (const auto& [measure, value] : {std::pair{"front speed", front[k]}, std::pair{"hole diameter", hole[k]}})
      verify::record({.section = "symmetry", .problem = problem, .composition = "quadratic B-spline, APIC, USF, double",
                      .measure = std::string(measure) + ", relative difference", .value = value, .bound = k == 1 ? 0.03 : verify::none,
                      .seconds = full.seconds});
  }
  EXPECT_LT(std::abs(front[1]), 0.03);
  EXPECT_LT(std::abs(hole[1]), 0.03);
  EXPECT_LT(std::abs(front[1]), std::abs(front[0]));
  EXPECT_LT(std::abs(hole[1]), std::abs(hole[0]));
}

} // namespace
} // namespace bolide
