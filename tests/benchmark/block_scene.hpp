// SPDX-License-Identifier: MIT
// The scene that solvers are timed on: a block of aluminium in smooth motion, for the textbook solver and for the composed one.
//
// A square ring section (r-z) or a cube of `cells` cells a side, two particles per cell and axis, starts without stress off the axis and moves with
//   v_d = V sin(2 pi u_d) prod over the other axes of cos(pi u_e),   u = (x - corner) / edge,   V = rate edge / (2 pi)
// so that strain rates do not depend on the size: 5e4 /s, compression beside stretching and shear. Within 50 steps a good part of it yields; in
// 300 steps it strains by some 5 % and particles cross up to two cells. Free boundaries.
// Material: Mie-Grueneisen, J2 with linear hardening, bulk viscosity (textbook.hpp, parameters).
#pragma once

#include "textbook.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/strength/linear_hardening.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

namespace bolide::scenes {

template <int Dim> struct block {
  int cells;                         // a side
  textbook::parameters metal{};
  double strain_rate = 5e4;          // 1/s
  double h = 1e-4;                   // m
  int from_axis = 20;                // cells between the axes and the block
  static constexpr int margin = 8;   // cells of the dense grid around it

  static constexpr int dim = Dim;
  double edge() const { return cells * h; }
  double corner() const { return from_axis * h; }
  double spacing() const { return h / 2; }
  double dt() const { // 0.3 of h over the speed of longitudinal waves and that of the material
    return 0.3 * h / (std::sqrt(metal.c0 * metal.c0 + 4.0 / 3 * metal.shear_modulus / metal.rho0) + speed());
  }
  double speed() const { return strain_rate * edge() / (2 * std::numbers::pi); }
  vec<double, Dim> velocity(const vec<double, Dim>& x) const {
    vec<double, Dim> v;
    for (int d = 0; d < Dim; ++d) {
      v[d] = speed();
      for (int e = 0; e < Dim; ++e) {
        const double u = (x[e] - corner()) / edge();
        v[d] *= e == d ? std::sin(2 * std::numbers::pi * u) : std::cos(std::numbers::pi * u);
      }
    }
    return v;
  }
  auto geometry() const {
    return box{vec<double, Dim>(vec<double, Dim>::Constant(corner())), vec<double, Dim>(vec<double, Dim>::Constant(corner() + edge()))};
  }
};

template <int Dim> using space_of = std::conditional_t<Dim == 2, space::axisymmetric, space::cartesian_3d>;

/// The block in the composed solver: FLIP, update stress first.
template <class T, class Shape, int Dim, class Viscosity = viscosity::bulk>
auto composed(const block<Dim>& scene, const Viscosity& viscosity, int threads = 1) {
  const auto& a = scene.metal;
  const eos::mie_grueneisen_parameters hugoniot{.rho0 = a.rho0, .c0 = a.c0, .s = a.slope, .gamma0 = a.gamma0};
  const material metal{eos::mie_grueneisen{hugoniot},
                       strength::linear_hardening{a.shear_modulus, a.yield, a.hardening}, failure::none{}, viscosity};
  const body block_body{"block", scene.geometry(), metal, scene.spacing(), initial_state{a.rho0, 0}};
  controls<T> c;
  c.threads = threads;
  c.first_step = 1;
  solver sim{space_of<Dim>{}, grid::sparse{scene.h}, Shape{}, transfer::flip{}, scheme::usf{}, c, block_body};
  sim.initialise([&](auto& point) { point.velocity = scene.velocity(point.position); });
  return sim;
}
template <class T, class Shape, int Dim> auto composed(const block<Dim>& scene, int threads = 1) {
  return composed<T, Shape>(scene, viscosity::bulk{scene.metal.quadratic, scene.metal.linear}, threads);
}

/// The block in the textbook solver, T its number type.
template <class T, class Shape, int Dim> auto by_the_book(const block<Dim>& scene) {
  using solver_type = std::conditional_t<Dim == 2, textbook::rz<T, Shape>, textbook::xyz<T, Shape>>;
  textbook::box<Dim> domain{{}, {}, scene.h};
  for (std::size_t d = 0; d < Dim; ++d) {
    domain.origin[d] = scene.corner() - scene.margin * scene.h;
    domain.nodes[d] = scene.cells + 2 * scene.margin + 1;
  }
  solver_type sim(scene.metal, domain);
  const double spacing = scene.spacing();
  sim.particles.reserve(static_cast<std::size_t>(std::pow(2 * scene.cells, Dim)));
  for_each_lattice_point(scene.geometry(), scene.geometry().anchor(), spacing, Dim == 2, [&](const vec<double, Dim>& x) {
    typename solver_type::particle p{};
    const auto v = scene.velocity(x);
    p.m = T(scene.metal.rho0 * space_of<Dim>::volume(x.data(), std::pow(spacing, Dim)));
    p.J = T(1);
    if constexpr (Dim == 2) {
      p.r = T(x[0]), p.z = T(x[1]), p.vr = T(v[0]), p.vz = T(v[1]);
    } else {
      for (int d = 0; d < Dim; ++d) p.x[d] = T(x[d]), p.v[d] = T(v[d]);
    }
    sim.particles.push_back(p);
  });
  return sim;
}

} // namespace bolide::scenes
