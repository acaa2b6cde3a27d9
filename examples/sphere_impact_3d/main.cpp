// SPDX-License-Identifier: MIT
// An aluminium sphere on an aluminium plate in three dimensions, a quarter between two mirrors, beside the same impact in r-z.
//
// Run:  bash examples/run.sh sphere_impact_3d [--quick]
//
// There is no exact solution; but r-z and 3-D share neither gradients nor lattice, so that where they agree the discretisation is not what is seen.
#include "bolide/core/unit.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/material/data/aluminium.hpp"
#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/picture.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/png/write_png.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

#include <cstdio>
#include <numbers>
#include <string_view>

using namespace bolide;
using unit::GPa, unit::mm, unit::us;
using rz = vec<double, 2>;
using xyz = vec<double, 3>;

constexpr double diameter = 2 * mm, thickness = 0.6 * mm, plate_radius = 4 * mm, speed = 5000, until = 2 * us;

/// The quarter x, y > 0 of a ball or of a disc about the z axis; a geometry is any struct with these six members.
template <class Inside> struct quarter {
  static constexpr int dim = 3;
  double radius, z_low, z_high, whole_volume;
  Inside inside; // (distance from the axis, z, spacing)
  xyz anchor() const { return {0, 0, z_low}; }
  xyz low() const { return {0, 0, z_low}; }
  xyz high() const { return {radius, radius, z_high}; }
  bool contains(const xyz& x, double spacing) const { return inside(std::hypot(x[0], x[1]), x[2], spacing); }
  double volume(bool) const { return whole_volume / 4; }
};
template <class Inside> quarter(double, double, double, double, Inside) -> quarter<Inside>;

/// Particles of a 3-D snapshot by their distance from the axis, so that pictures and measures of r-z apply.
observe::snapshot in_r_and_z(const observe::snapshot& s) {
  observe::snapshot flat = s;
  flat.columns.clear();
  flat.dimension = 2, flat.axisymmetric = true;
  const auto &x = s.at("position"), &v = s.at("velocity");
  std::vector<double> position, velocity;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double r = std::hypot(x(i, 0), x(i, 1));
    position.insert(position.end(), {r, x(i, 2)});
    velocity.insert(velocity.end(), {(x(i, 0) * v(i, 0) + x(i, 1) * v(i, 1)) / r, v(i, 2)});
  }
  flat.add("position", "m", 2, position), flat.add("velocity", "m/s", 2, velocity), flat.add("mass", "kg", 1, s.at("mass").data);
  return flat;
}

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  const double dx = diameter / (quick ? 20 : 40), R = diameter / 2;

  // ---- the heart: one material, two spaces, two solvers ----
  const material metal{eos::mie_grueneisen{data::aluminium.mie_grueneisen}, strength::elastic_perfectly_plastic{27.6 * GPa, 0.3 * GPa},
                       failure::tension{1.5 * GPa}};
  const initial_state rest{data::aluminium.density, 0};
  const auto solve = [&](auto space, const auto& ball, const auto& plate) {
    return solver{space, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, controls<>{}, ball, plate};
  };
  auto flat = solve(space::axisymmetric{}, body{"sphere", sphere{rz{0, -R}, R}, metal, dx, rest, rz{0, speed}},
                    body{"plate", box{rz{0, 0}, rz{plate_radius, thickness}}, metal, dx, rest});
  flat.run(until);

  const auto in_ball = [=](double r, double z, double spacing) { return std::hypot(r, z + R) <= R - spacing / 2; };
  const auto in_disc = [=](double r, double z, double) { return r < plate_radius && z > 0 && z < thickness; };
  const quarter ball{R, -2 * R, 0., 4.0 / 3 * std::numbers::pi * R * R * R, in_ball};
  const quarter disc{plate_radius, 0., thickness, std::numbers::pi * plate_radius * plate_radius * thickness, in_disc};
  auto full = solve(space::cartesian_3d{}, body{"sphere", ball, metal, dx, rest, xyz{0, 0, speed}}, body{"plate", disc, metal, dx, rest});
  full.add(grid::mirror{0, 0, true}).add(grid::mirror{1, 0, true});
  full.run(until);

  // ---- measures by the same definitions, one picture of both ----
  const observe::impact_scene scene{.plate_front_z = 0, .plate_rear_z = thickness, .impact_speed = speed};
  const auto flat_shot = observe::take_snapshot(flat), full_shot = in_r_and_z(observe::take_snapshot(full));
  const observe::debris_cloud a(flat_shot, scene), b(full_shot, scene);
  const auto how = observe::paint::speed().between(0, 5);
  png::write_png("sphere_impact_3d.png",
                 observe::draw_panels({{&flat_shot, how, "r-z", {}}, {&full_shot, how, "3-D, all particles by distance from the axis", {}}},
                                      {-6 * mm, 10 * mm, -5 * mm, 5 * mm}, 1, "Al sphere 2 mm on Al plate 0.6 mm, 5 km/s", {.width = 800}));
  const double front = b.front_speed / a.front_speed - 1, hole = b.hole_diameter / a.hole_diameter - 1,
               worse = std::max(std::abs(front), std::abs(hole));
  std::printf("r-z: front %.0f m/s, hole %.3f mm; %zu particles, %.2f s\n3-D: front %.0f m/s, hole %.3f mm; %zu particles, %.2f s\n", a.front_speed,
              a.hole_diameter / mm, flat.particle_count(), flat.solver_seconds(), b.front_speed, b.hole_diameter / mm, full.particle_count(),
              full.solver_seconds());
  std::printf("differences: front %+.2f %%, hole %+.2f %%; sphere_impact_3d.png\n", 100 * front, 100 * hole);
  return worse < 0.03 ? 0 : 1;
}
