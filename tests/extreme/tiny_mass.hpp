// SPDX-License-Identifier: MIT
// Extreme 11 and the edges: nodes of vanishing mass, particles exactly on cell faces and cell centres, and at -1.8e-18 m.
//
// A node that sees a particle with the weight w has the mass w m and takes the force f = -V sigma dN: linear shapes have dN = 1/h whatever
// w is, so that f / (w m) grows without bound; what the particle feels of it is w f/(w m), bounded. B-splines have dN ~ sqrt(w); their
// support changes at half a cell, where the spacing of doubles (floats) lets no weight between 0 and 1e-33 (1e-15) be reached.
#pragma once

#include "extreme/extreme.hpp"

namespace bolide::extreme {

template <class Method> class TinyMass : public testing::Test {};
TYPED_TEST_SUITE_P(TinyMass);

/// One particle under pressure, `off` cells before the face (or centre, where the support of a B-spline changes) at coordinate 0, crosses
/// it. It is alone, so it must not be accelerated.
TYPED_TEST_P(TinyMass, AParticleAloneCrossesWithoutASlap) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  constexpr bool is_float = sizeof(T) == 4;
  const double h = 0.1 * mm, least = is_float ? 1e-38 : 1e-300, centre = TypeParam::shape_type::smooth ? 0.5 : 0.0, v0 = 1e-6;
  const material al{eos::mie_grueneisen{}, strength::none{}, failure::none{}};
  const double c = 5328;
  double worst = 0, acceleration = 0;
  for (const double weight : {least, 1e-30, 1e-18, 1e-14, 1e-10, 1e-6}) {
    const double off = TypeParam::shape_type::smooth ? std::sqrt(2 * weight) : weight; // N = f^2/2 there
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<T>(), body{"grain", box{point{0.}, point{h / 2}}, al, h / 2, initial_state{2785, 1e4}, point{v0}});
    sim.for_each_body([&](auto& s) { s.columns.template get<field::position>()[0] = static_cast<T>((centre - off) * h); });
    for (int i = 0; i < 50; ++i) sim.step();
    is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-3, 1, 100}); // its momentum of 1e-6 m/s is no scale
    sim.for_each_body([&](const auto& s) {
      const double change = std::abs(value<field::velocity>(s, 0) - v0);
      worst = std::max(worst, change);
      acceleration = std::max(acceleration, change / sim.time() * h / (c * c));
    });
  }
  const auto row = [&](const char* what, double got, double bound, const char* unit) {
    verify::record({.section = "extremes",
                    .problem = std::string("a particle alone crosses a face, nodal weights ") + to_text(least) + " to 1e-6",
                    .composition = composition<TypeParam, space::planar_1d>(),
                    .measure = what,
                    .value = got,
                    .bound = bound,
                    .unit = unit});
    EXPECT_LT(got, bound) << what;
  };
  row("velocity change", worst, is_float ? 1e-4 : 1e-10, "m/s");
  row("acceleration over c^2/h", acceleration, 1e-9, "");
}

/// A body whose foremost particle touches a node with such a weight, under a pressure of its own that drives it: the node may fly, no
/// particle may. Compared with the same body 0.1 cells further on.
TYPED_TEST_P(TinyMass, TheOutermostParticleIsNotShotOff) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm, centre = TypeParam::shape_type::smooth ? 0.5 : 0.0;
  const material al{eos::mie_grueneisen{}, strength::none{}, failure::none{}};
  const auto fastest = [&](double off) {
    // half-offset lattice: the foremost of 20 particles at (centre + off) h
    const double front = (centre + off + 0.25) * h;
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<T>(), body{"bar", box{point{front - 10 * h}, point{front}}, al, h / 2, initial_state{2785, 1e5}});
    double v = 0;
    for (int i = 0; i < 30; ++i) {
      sim.step();
      for_each_particle(sim, [&](const auto& s, std::size_t k) { v = std::max(v, std::abs(value<field::velocity>(s, k))); });
    }
    is_sound(sim);
    return v;
  };
  const double usual = fastest(0.1);
  double worst = 0;
  for (const double off : {0.0, -1.8e-18 / h, 1e-300, 1e-30, 1e-16, -1e-16, 1e-14, -1e-14, 1e-10, 1e-6})
    worst = std::max(worst, fastest(off) / usual);
  verify::record({.section = "extremes",
                  .problem = "free surface of a pressed bar on a face, off by 0, +-1e-16, 1e-14, 1e-10, 1e-6 cells and at -1.8e-18 m",
                  .composition = composition<TypeParam, space::planar_1d>(),
                  .measure = "fastest particle over that of a bar 0.1 cells off",
                  .value = worst,
                  .bound = 2});
  EXPECT_LT(worst, 2);
}

/// Every particle of a cube-like disc exactly on faces and centres, and 1.8e-18 m below them: no stress, no motion.
TYPED_TEST_P(TinyMass, ExactlyOnEdgesIsQuiet) {
  using point = vec<double, 2>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm;
  for (const double shift : {0.0, -1.8e-18}) {
    const body disc{"disc",
                    box{point{0.25 * h, -2.25 * h + shift}, point{4.25 * h, 1.75 * h + shift}},
                    aluminium(),
                    h / 2,
                    initial_state{2785, 0},
                    point{0, 1e-3}};
    auto sim = make<TypeParam, space::axisymmetric>(h, one_thread<T>(), disc);
    for (int i = 0; i < 100; ++i) sim.step();
    double stress = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) { stress = std::max(stress, std::abs(value<field::pressure>(s, i))); });
    verify::record({.section = "extremes",
                    .problem = "points on faces and centres, shifted by " + to_text(shift) + " m, drifting at 1 mm/s",
                    .composition = composition<TypeParam, space::axisymmetric>(),
                    .measure = "pressure over the bulk modulus",
                    .value = stress / (2785 * 5328. * 5328.),
                    .bound = sizeof(T) == 8 ? 1e-15 : 1e-7});
    EXPECT_LT(stress, (sizeof(T) == 8 ? 1e-15 : 1e-7) * 2785 * 5328. * 5328.);
    is_sound(sim);
  }
}
REGISTER_TYPED_TEST_SUITE_P(TinyMass, AParticleAloneCrossesWithoutASlap, TheOutermostParticleIsNotShotOff, ExactlyOnEdgesIsQuiet);

} // namespace bolide::extreme
