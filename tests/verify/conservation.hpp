// SPDX-License-Identifier: MIT
// Two elastic balls that graze each other, in any space, on any grid, in double and float: mass to the bit, momentum, angular momentum where the
// transfer promises it, total energy and the ledger. Rows: section "conservation". (Rings in plane strain, with every transfer: collision.hpp.)
//
// Balls of radius 4 cells, 2 points per cell side, E 100 MPa, nu 0.2, rho 1000 kg/m3, cells 0.2 m, +-15 m/s along the last axis, centres
// 9 cells apart along it and 2 across every other; until they have parted (0.08 s, the wave needs 0.005 s through a ball). In r-z they hit head-on,
// in 1-D they are bars. In r-z the axis takes radial momentum: the axial one is asked for.
#pragma once

#include "verify/elastic.hpp"

#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/plane_strain.hpp"

#include <array>

namespace bolide::verify {

/// A method in a space on a grid.
template <class Method, class Space, class Grid = grid::sparse> struct composed_of {
  using method_type = Method;
  using space_type = Space;
  using grid_type = Grid;
  static std::string name() { return std::string(Space::name) + ", " + Grid::name + " grid, " + Method::name(); }
};
struct composed_names {
  template <class C> static std::string GetName(int) {
    return std::string(C::space_type::name) + "_" + C::grid_type::name + "_" + C::method_type::name();
  }
};

struct kept {
  double mass = 0;
  std::array<double, 3> momentum{}, angular{}; // angular: z alone in two dimensions
};
/// Sums in the order of particle ids, so that sorting changes no bit of them.
template <class C, class Solver> kept sums_over(const Solver& sim) {
  using method_type = typename C::method_type;
  constexpr int dim = Solver::dim;
  struct part {
    double mass = 0;
    std::array<double, 3> momentum{}, angular{};
  };
  std::vector<part> parts(sim.particle_count());
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      part& one = parts[p.id()[i]];
      one.mass = static_cast<double>(p.template get<field::mass>()[i]);
      std::array<double, 3> x{}, v{};
      for (int d = 0; d < dim; ++d) {
        x[static_cast<std::size_t>(d)] = static_cast<double>(p.template get<field::position>(d)[i]);
        v[static_cast<std::size_t>(d)] = static_cast<double>(p.template get<field::velocity>(d)[i]);
      }
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t a = (d + 1) % 3, b = (d + 2) % 3;
        one.momentum[d] = one.mass * v[d];
        one.angular[d] = one.mass * (x[a] * v[b] - x[b] * v[a]);
        if constexpr (method_type::transfer_type::affine)
          if (a < dim && b < dim) {
            const auto slope = [&](std::size_t of, std::size_t along) { // dv_of / dx_along
              return static_cast<double>(p.template get<field::affine_velocity>(static_cast<int>(of) * dim + static_cast<int>(along))[i]);
            };
            one.angular[d] += one.mass * method_type::shape_type::inertia * square(sim.cell()) * (slope(b, a) - slope(a, b));
          }
      }
    }
  });
  kept sum;
  for (const auto& one : parts) {
    sum.mass += one.mass;
    for (std::size_t d = 0; d < 3; ++d) sum.momentum[d] += one.momentum[d], sum.angular[d] += one.angular[d];
  }
  return sum;
}

template <class C> void check_kept() {
  using method_type = typename C::method_type;
  using space = typename C::space_type;
  using T = typename method_type::scalar;
  constexpr int dim = space::dim;
  using point = vec<double, dim>;
  const double h = 0.2;
  point at = point::Constant(space::hoop ? 0.0 : h), velocity = point::Zero();
  at[dim - 1] = 4.5 * h;
  velocity[dim - 1] = 15;
  const auto solid = elastic({100e6, 0.2, 1000});
  const body first{"first", sphere{point(-at), 4 * h}, solid, h / 2, initial_state{1000, 0}, velocity},
      second{"second", sphere{at, 4 * h}, solid, h / 2, initial_state{1000, 0}, point(-velocity)};
  solver sim{space{},
             typename C::grid_type{h},
             typename method_type::shape_type{},
             typename method_type::transfer_type{},
             typename method_type::scheme_type{},
             one_thread<T>(),
             first,
             second};
  const auto before = sums_over<C>(sim);
  sim.run(0.04);
  const double squeezed = sim.energies().now.internal / sim.energies().initial.total(); // they have met
  sim.run(0.08);
  const auto after = sums_over<C>(sim);
  const auto& l = sim.energies();
  double momentum = 0, angular = 0, spin = 0;
  for (std::size_t d = space::hoop ? 1 : 0; d < dim; ++d)
    momentum = std::max(momentum, std::abs(after.momentum[d] - before.momentum[d]) / l.momentum_scale);
  for (std::size_t d = 0; d < 3; ++d) angular += square(after.angular[d] - before.angular[d]), spin += square(before.angular[d]);
  constexpr bool affine = method_type::transfer_type::affine, fine = sizeof(T) == 8;
  const auto row = [&](const char* measure, double got, double bound) {
    record({.section = "conservation",
            .problem = "elastic balls, grazing (r-z and 1-D: head-on)",
            .composition = C::name(),
            .measure = measure,
            .value = got,
            .bound = bound,
            .seconds = sim.solver_seconds(),
            .note = std::to_string(sim.particle_count()) + " particles, " + std::to_string(sim.steps()) + " steps"});
    if (!std::isnan(bound)) { EXPECT_LE(std::abs(got), bound) << C::name() << ": " << measure; }
  };
  row("mass, change", after.mass - before.mass, 0);
  row("momentum over sum m |v|", momentum, fine ? 1e-12 : 3e-6);
  if (dim > 1 && !space::hoop) row("angular momentum, relative change", std::sqrt(angular / spin), affine ? (fine ? 1e-12 : 1e-5) : none);
  row("total energy, change over the initial energy", l.drift(), fine ? 1e-12 : 3e-6);
  row("residual of the ledger over the initial energy", l.residual(), fine ? 1e-12 : 3e-6);
  EXPECT_GT(squeezed, 0.01);
}

} // namespace bolide::verify
