// SPDX-License-Identifier: MIT
// Extreme 15: the axis of r-z. A uniform pressure patch on the seeding lattice feels no radial force above round-off, in any composition
// and in float; a ring at r = 1e-12 m and less is harmless; jittered points are reported. (tests/verify/axis_test.cpp: converging flow at
// the axis.)
#pragma once

#include "extreme/extreme.hpp"

#include "bolide/viscosity/none.hpp"

namespace bolide::extreme {

template <class Method> class Axis : public testing::Test {};
TYPED_TEST_SUITE_P(Axis);

/// Largest |radial acceleration| over p/(rho h) after one step of a patch of uniform pressure between walls.
template <class Method> double patch(double per_cell, double jittered) {
  using point = vec<double, 2>;
  using T = typename Method::scalar;
  const double h = 1e-3, width = 12 * h, e = 2.5e5;
  const body b{"gas",
               box{point{0, 0}, point{width, width}},
               gas(1.4, 1000, viscosity::none{}),
               h / per_cell,
               initial_state{1000, e},
               point{0, 0},
               jitter{jittered, 3}};
  auto sim = make<Method, space::axisymmetric>(h, one_thread<T>(), b);
  sim.add(grid::mirror{0, width, false}).add(grid::mirror{1, 0, true}).add(grid::mirror{1, width, false});
  sim.step();
  double worst = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) { worst = std::max(worst, std::abs(value<field::velocity>(s, i))); });
  return worst / sim.dt() * h / (0.4 * e);
}
TYPED_TEST_P(Axis, AUniformPatchFeelsNoRadialForce) {
  const double bar = sizeof(typename TypeParam::scalar) == 8 ? 1e-11 : 1e-5;
  const auto row = [&](const std::string& what, double got, double bound, const char* note) {
    verify::record({.section = "extremes",
                    .problem = "uniform pressure patch at the axis, " + what,
                    .composition = composition<TypeParam, space::axisymmetric>(),
                    .measure = "radial acceleration over p/(rho h)",
                    .value = got,
                    .bound = bound,
                    .note = note});
  };
  for (const double per_cell : {2.0, 4.0}) {
    const double worst = patch<TypeParam>(per_cell, 0);
    const bool exact = TypeParam::shape_type::support < 4; // N'' is constant in a quadratic, and zero in a linear shape function
    row(to_text(per_cell) + " points per cell side", worst, exact ? bar : 0.02,
        exact ? "" : "the mended quadrature is exact for piecewise quadratic N, not for cubic");
    EXPECT_LT(worst, exact ? bar : 0.02);
  }
  row("points jittered by 10 %", patch<TypeParam>(2, 0.1), verify::none, "quadrature of a jittered lattice");
}

/// A ring next to r = 0 with the mass and volume of a ring of that radius: no division by r may be seen. Its slab expands with the same
/// speeds as without.
TYPED_TEST_P(Axis, ARingAtTinyRadiusIsHarmless) {
  using point = vec<double, 2>;
  using T = typename TypeParam::scalar;
  const body b{"slab", box{point{0, 0}, point{0.4 * mm, 0.4 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 1e5}};
  const auto fastest = [&](double r) {
    auto sim = make<TypeParam, space::axisymmetric>(0.1 * mm, one_thread<T>(), b);
    sim.for_each_body([&](auto& s) {
      auto& p = s.columns;
      for (std::size_t i = 0; i < p.size() && r > 0; ++i) {
        if (p.id()[i] != 3) continue;
        const T ratio = static_cast<T>(r / value<field::position>(s, i));
        p.template get<field::position>(0)[i] = static_cast<T>(r);
        for (T* x : {p.template get<field::mass>(), p.template get<field::volume>(), p.template get<field::material_volume>()})
          x[i] *= ratio;
      }
    });
    double v = 0;
    for (int i = 0; i < 50; ++i) sim.step();
    is_sound(sim);
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      EXPECT_GE(value<field::position>(s, i), 0);
      for (int d = 0; d < 2; ++d) v = std::max(v, std::abs(value<field::velocity>(s, i, d)));
    });
    return v;
  };
  const double usual = fastest(0);
  double worst = 0;
  for (const double r : {1e-7, 1e-12, 1e-18}) worst = std::max(worst, fastest(r) / usual);
  verify::record({.section = "extremes",
                  .problem = "a ring at r = 1e-7, 1e-12, 1e-18 m",
                  .composition = composition<TypeParam, space::axisymmetric>(),
                  .measure = "fastest particle over that of the undisturbed slab",
                  .value = worst,
                  .bound = 1.5});
  EXPECT_LT(worst, 1.5);
}

/// The outermost ring of a body on the centre of a cell, where the far node's weight vanishes and the hoop force must vanish with it.
TYPED_TEST_P(Axis, TheOutermostRingOnACellCentre) {
  using point = vec<double, 2>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm;
  auto c = one_thread<T>();
  c.accept_one_particle_per_cell = true;
  for (const double off : {0.0, 1e-14, -1e-14, 1e-9, 1e-5}) {
    const body disc{"disc", box{point{off * h, 0}, point{(6 + off) * h, 6 * h}}, aluminium(), h, initial_state{2785, 0}, point{0, 1000.}};
    const body wall{"wall", box{point{off * h, 6 * h}, point{(10 + off) * h, 10 * h}}, aluminium(), h, initial_state{2785, 0}};
    auto sim = make<TypeParam, space::axisymmetric>(h, c, disc, wall);
    for (int i = 0; i < 100; ++i) sim.step();
    is_sound(sim);
    EXPECT_GT(sim.time(), 0.1 * us) << "the time step must not collapse";
  }
}
REGISTER_TYPED_TEST_SUITE_P(Axis, AUniformPatchFeelsNoRadialForce, ARingAtTinyRadiusIsHarmless, TheOutermostRingOnACellCentre);

} // namespace bolide::extreme
