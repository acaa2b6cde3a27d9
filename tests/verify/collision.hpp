// SPDX-License-Identifier: MIT
// Elastic bodies that collide in plane strain: what each transfer and scheme keeps of mass, momentum, angular momentum and energy.
//
// Discs (Sulsky, Chen, Schreyer 1994): E 1000, nu 0.3, rho 1000, R 0.2 at (0.25, 0.25) and (0.75, 0.75), +-0.1 m/s on both axes, cells 0.05, to 3.5
// s.
//   Kinetic energy pi R^2 rho v^2 = 2.513 J per metre at the start.
// Rings (the ladder of a public suite): E 100 MPa, nu 0.2, rho 1000, 3 m < r < 4 m, +-30 m/s, cells 0.2 m, to 0.2 s. The centres start at
//   (-+4.2, -+offset): head-on with offset 0, with angular momentum otherwise.
// No heat is asked of the material, no viscosity: kinetic and strain energy are all there is.
#pragma once

#include "verify/elastic.hpp"

#include "bolide/scheme/usl.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/transfer/pic.hpp"
#include "bolide/transfer/xpic.hpp"

#include <cmath>
#include <numbers>

namespace bolide::verify {

using plane = vec<double, 2>;

template <class Method> controls<typename Method::scalar> collision_controls() {
  auto c = one_thread<typename Method::scalar>();
  c.energy_bound = 2; // what a transfer loses is measured, not forbidden
  return c;
}
template <class Method> auto colliding_discs(const typename Method::transfer_type& transfer, double h = 0.05) {
  const auto solid = elastic({1000, 0.3, 1000});
  const initial_state at{1000, 0};
  const body a{"lower", shell{plane{0.25, 0.25}, 0, 0.2}, solid, h / 2, at, plane{0.1, 0.1}},
      b{"upper", shell{plane{0.75, 0.75}, 0, 0.2}, solid, h / 2, at, plane{-0.1, -0.1}};
  return solver{space::plane_strain{},
                grid::sparse{h},
                typename Method::shape_type{},
                transfer,
                typename Method::scheme_type{},
                collision_controls<Method>(),
                a,
                b};
}

/// `mirrored`: x to -x; `boost`: the frame moves.
template <class Method>
auto colliding_rings(const typename Method::transfer_type& transfer, double offset = 0, bool mirrored = false, const plane& boost = plane{0, 0}) {
  const double h = 0.2, side = mirrored ? -1 : 1;
  const auto solid = elastic({100e6, 0.2, 1000});
  const initial_state at{1000, 0};
  const body a{"first", shell{plane{-4.2 * side, -offset}, 3, 4}, solid, h / 2, at, plane(boost + plane{30 * side, 0})},
      b{"second", shell{plane{4.2 * side, offset}, 3, 4}, solid, h / 2, at, plane(boost + plane{-30 * side, 0})};
  return solver{space::plane_strain{},
                grid::sparse{h},
                typename Method::shape_type{},
                transfer,
                typename Method::scheme_type{},
                collision_controls<Method>(),
                a,
                b};
}

struct sums {
  double mass = 0, angular = 0; // kg, kg m2/s (APIC: with the spin of its affine field)
  plane momentum{0, 0};
};
template <class Solver, class Method> sums sums_of(const Solver& sim, Method) {
  sums r;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double m = p.template get<field::mass>()[i];
      const plane x{p.template get<field::position>(0)[i], p.template get<field::position>(1)[i]},
          v{p.template get<field::velocity>(0)[i], p.template get<field::velocity>(1)[i]};
      r.mass += m;
      r.momentum += m * v;
      r.angular += m * (x[0] * v[1] - x[1] * v[0]);
      if constexpr (std::remove_cvref_t<decltype(p)>::template has<field::affine_velocity>)
        r.angular += m * Method::shape_type::inertia * square(sim.cell()) *
                     (p.template get<field::affine_velocity>(2)[i] - p.template get<field::affine_velocity>(1)[i]);
    }
  });
  return r;
}

struct collision {
  double kinetic = 0, total = 0;                // kinetic energy and kinetic + internal energy at the end over the kinetic energy at the start
  double drift = 0, residual = 0, transfer = 0; // of the ledger, over the same
  double mass = 0, momentum = 0, angular = 0;   // changes: over the mass, over sum m |v|, over the angular momentum at the start
  double seconds = 0;
};
template <class Method, class Solver> collision collide(Solver& sim, double until) {
  const auto before = sums_of(sim, Method());
  sim.run(until);
  const auto after = sums_of(sim, Method());
  const auto& l = sim.energies();
  collision r;
  r.kinetic = l.now.kinetic / l.initial.kinetic;
  r.total = l.now.total() / l.initial.kinetic;
  r.drift = l.drift();
  r.residual = l.residual();
  r.transfer = l.transfer / l.initial.kinetic;
  r.mass = after.mass / before.mass - 1;
  r.momentum = (after.momentum - before.momentum).norm() / l.momentum_scale;
  r.angular = before.angular != 0 ? after.angular / before.angular - 1 : 0;
  r.seconds = sim.solver_seconds();
  return r;
}

/// A transfer with its loss dropped (0) or returned as heat (1); FLIP loses nothing and has no choice.
template <class Transfer> Transfer with_heat(Transfer t, double heat) {
  if constexpr (requires { t.heat; }) t.heat = heat;
  return t;
}
template <class Transfer> std::string transfer_name(const Transfer& t) {
  if constexpr (requires { t.flip; })
    if (t.flip > 0) return "pic, flip " + std::to_string(t.flip).substr(0, 4);
  return Transfer::name;
}
template <class Method> std::string composition_of(const typename Method::transfer_type& t) {
  return std::string("plane_strain, ") + Method::shape_type::name + ", " + transfer_name(t) + ", " + Method::scheme_type::name;
}

/// What every composition promises on the oblique rings: mass to the bit, momentum, the ledger; total energy where the loss is returned as heat, and
/// no gain where it is dropped; angular momentum with APIC.
template <class Method> collision check_conservation(const typename Method::transfer_type& transfer, double heat, double until = 0.2) {
  const auto t = with_heat(transfer, heat);
  auto sim = colliding_rings<Method>(t, 1);
  const auto r = collide<Method>(sim, until);
  const std::string who = composition_of<Method>(t) + (heat > 0 ? ", loss as heat" : ", loss dropped");
  record({.section = "energy drift",
          .problem = "elastic rings, oblique",
          .composition = who,
          .measure = "total energy gained over the initial energy",
          .value = r.drift,
          .bound = heat > 0 || std::string(Method::transfer_type::name) == "flip" ? 1e-12 : none,
          .seconds = r.seconds});
  record({.section = "conservation",
          .problem = "elastic rings, oblique",
          .composition = who,
          .measure = "angular momentum, relative change",
          .value = r.angular,
          .bound = Method::transfer_type::affine ? 1e-11 : none,
          .seconds = r.seconds});
  record({.section = "conservation",
          .problem = "elastic rings, oblique",
          .composition = who,
          .measure = "momentum over sum m |v|",
          .value = r.momentum,
          .bound = 1e-12});
  record({.section = "conservation",
          .problem = "elastic rings, oblique",
          .composition = who,
          .measure = "residual of the ledger over the initial energy",
          .value = r.residual,
          .bound = 1e-12});
  EXPECT_EQ(r.mass, 0) << who;
  EXPECT_LT(r.momentum, 1e-12) << who;
  EXPECT_LT(std::abs(r.residual), 1e-12) << who;
  if (heat > 0) { EXPECT_LT(std::abs(r.drift), 1e-12) << who; }
  EXPECT_LT(r.drift, 1e-12) << who << ": dropping the loss must not gain energy";
  if (Method::transfer_type::affine) { EXPECT_LT(std::abs(r.angular), 1e-11) << who; }
  return r;
}

/// Kinetic and strain energy that are left where the loss is dropped: head-on rings after 0.2 s, discs after 3.5 s.
template <class Method> double left_by(const typename Method::transfer_type& transfer) {
  const auto t = with_heat(transfer, 0);
  auto rings = colliding_rings<Method>(t);
  auto discs = colliding_discs<Method>(t);
  const auto r = collide<Method>(rings, 0.2), d = collide<Method>(discs, 3.5);
  const std::string who = composition_of<Method>(t);
  record({.section = "solids",
          .problem = "colliding rings, head-on, loss dropped",
          .composition = who,
          .measure = "kinetic and strain energy at 0.2 s over the start",
          .value = r.total,
          .seconds = r.seconds});
  record({.section = "solids",
          .problem = "colliding discs, loss dropped",
          .composition = who,
          .measure = "kinetic energy at 3.5 s over the start (2.513 J/m)",
          .value = d.kinetic,
          .seconds = d.seconds});
  record({.section = "solids",
          .problem = "colliding discs, loss dropped",
          .composition = who,
          .measure = "momentum over sum m |v|",
          .value = d.momentum,
          .bound = 1e-12});
  EXPECT_LT(d.momentum, 1e-12) << who;
  EXPECT_LT(r.momentum, 1e-12) << who;
  EXPECT_LT(std::abs(r.residual), 1e-12) << who;
  EXPECT_GT(d.kinetic, 0.3 * d.total) << who << ": the discs must rebound";
  return r.total;
}

/// All transfers of a shape and a scheme: conservation with the loss returned and dropped, then the ladder of what they lose.
template <class Shape, class Scheme> void check_transfers() {
  const auto both = [](const auto& t) {
    using tested = method<Shape, std::remove_cvref_t<decltype(t)>, Scheme>;
    check_conservation<tested>(t, 0);
    if constexpr (requires { t.heat; }) check_conservation<tested>(t, 1);
    return left_by<tested>(t);
  };
  const double flip = both(transfer::flip{}), blend = both(transfer::pic{.flip = 0.99}), xpic = both(transfer::xpic<5>{});
  EXPECT_NEAR(flip, 1, 1e-12);
  EXPECT_LT(blend, flip);
  EXPECT_LT(xpic, flip);
  double pic = 0;
  if constexpr (Shape::smooth || !Scheme::stress_first) { // linear shapes, PIC and USF: collision_linear_slow_test.cpp
    pic = both(transfer::pic{});
    EXPECT_LT(pic, std::min(blend, xpic)); // the most dissipative of all
  }
  if constexpr (requires { Shape::inertia; }) {
    const double apic = both(transfer::apic{});
    EXPECT_LT(apic, flip);
    EXPECT_GT(apic, pic);
  }
}

} // namespace bolide::verify
