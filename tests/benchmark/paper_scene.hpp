// SPDX-License-Identifier: MIT
// The paper's scene for benchmarks: a sphere of 9.5 mm hits a plate of 2.2 x 50 mm at 6.64 km/s in r-z, 58,010 particles, cells of 0.1 mm; linear shapes,
// FLIP, update stress first. The material is cheap (Mie-Grueneisen, linear hardening, a tension limit), so that what the grid costs is not hidden.
//
// `specks`: four single particles at rest in the corners of a box of 560 x 900 cells around it all. A grid that is a rectangle around the material is then
// that box, whatever the plate does.
#pragma once

#include "textbook.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/strength/linear_hardening.hpp"


namespace bolide::scenes {

struct paper {
  textbook::parameters metal{};
  double h = 1e-4; // m
  int cells_r = 560, cells_z = 900, first_z = -300; // the wide box, in cells
  bool specks = false;

  vec<double, 2> low() const { return {0, first_z * h}; }
  vec<double, 2> high() const { return {cells_r * h, (first_z + cells_z) * h}; }
  /// The cells in the corners of the wide box, one lattice point each; of none: no particle.
  struct corners {
    static constexpr int dim = 2;
    vec<double, 2> from, to;
    double h;
    bool present;
    vec<double, 2> anchor() const { return from; }
    vec<double, 2> low() const { return from; }
    vec<double, 2> high() const { return to; }
    bool contains(const vec<double, 2>& x, double spacing) const {
      const auto at_an_end = [&](int d) { return x[d] < from[d] + spacing || x[d] > to[d] - spacing; };
      return present && at_an_end(0) && at_an_end(1);
    }
    double volume(bool) const { return 0; }
  };
};

/// The scene on a grid; with a box, material that leaves it is taken out.
template <class Grid> auto composed(const paper& scene, const Grid& grid) {
  const auto& a = scene.metal;
  const eos::mie_grueneisen_parameters hugoniot{.rho0 = a.rho0, .c0 = a.c0, .s = a.slope, .gamma0 = a.gamma0};
  const material metal{eos::mie_grueneisen{hugoniot}, strength::linear_hardening{a.shear_modulus, a.yield, a.hardening}, failure::tension{1.5e9},
                       viscosity::bulk{a.quadratic, a.linear}};
  using point = vec<double, 2>;
  const initial_state at{a.rho0, 0};
  const body ball{"ball", sphere{point{0, -4.75e-3}, 4.75e-3}, metal, scene.h / 2, at, point{0, 6640}};
  const body plate{"plate", box{point{0, 0}, point{50e-3, 2.2e-3}}, metal, scene.h / 2, at};
  const body specks{"specks", paper::corners{scene.low(), scene.high(), scene.h, scene.specks}, metal, scene.h / 2, at};
  controls<double> c;
  c.threads = 1;
  return solver{space::axisymmetric{}, grid, shape::linear{}, transfer::flip{}, scheme::usf{}, c, ball, plate, specks};
}

} // namespace bolide::scenes
