// SPDX-License-Identifier: MIT
// optimise: -O2
// Extreme 13: how PIC loses spin, against its exact rate, and how Jaumann's rate turns a stress, against the exact turn. 100 turns of a disc and
// the steel rod: spin_slow_test.cpp.
//
// PIC. A step maps velocities to the nodes and back, v_p <- sum N(x_I - x_p) v_I: both sums spread v with the variance i h^2 per axis,
// i = sum N (x_I - x)^2 (quadratic B-spline 1/4; linear shape with points at 1/4 and 3/4 of a cell 3/16). So a step is a diffusion of i h^2.
// Nothing flows over the free rim: dv/dr = 0 there and not the shear dv/dr - v/r, and so a rotation decays. In a disc without stress
// v = J_1(k r), J_1'(k R) = 0, k R = 1.84118: angular momentum falls by exp(-i (1.84118 h/R)^2) a step, 0.8475 (h/R)^2 for the quadratic
// B-spline. Stress that keeps the disc rigid makes it 4 i (h/R)^2: lost is the spin i m h^2 (C_yx - C_xy) that APIC carries, 2 i m h^2 w of
// m R^2 w/2. A blend of PIC and FLIP loses its part of that.
//
// Jaumann. At rigid spin w the vector (s_xx - s_yy, 2 s_xy) turns by 2 w. One explicit Euler step turns it by atan(2 w dt) and makes it longer by
// sqrt(1 + (2 w dt)^2): after n turns the amplitude is (1 + (2 w dt)^2)^(n pi/(w dt)), about exp(4 pi n w dt).
#include "extreme/extreme.hpp"

#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/transfer/pic.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/material/material_point.hpp"

#include <numbers>

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 2>;

/// No stress whatever happens; its sound speed of 100 m/s only sets the time step.
struct dust {
  template <class V> eos_point<V> evaluate(V, V) const { return {V(scalar_t<V>(0)), V(scalar_t<V>(1e4))}; }
  double reference_density() const { return 1000; }
};

template <class Solver> double angular_momentum(Solver& sim) {
  double sum = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    sum += value<field::mass>(s, i) * (value<field::position>(s, i, 0) * value<field::velocity>(s, i, 1) -
                                       value<field::position>(s, i, 1) * value<field::velocity>(s, i, 0));
  });
  return sum;
}
/// Relative loss of angular momentum per step over (h/R)^2 of a disc of dust, once its slowest mode is left. R^2 is twice its mean r^2: the
/// lattice has steps at the rim.
template <class Shape> double decay_rate(int cells, const transfer::pic& blend) {
  const double h = 1.0 / cells, spin = 0.05; // rad/s: a turn of 1/100 in all
  auto c = one_thread<double>();
  c.first_step = 1;
  c.energy_bound = 2;
  const material matter{dust{}, strength::none{}, failure::none{}, viscosity::none{}};
  const body disc{"disc", sphere{point{0, 0}, 1}, matter, h / 2, initial_state{1000, 0}};
  solver sim{space::plane_strain{}, grid::sparse{h}, Shape{}, blend, scheme::musl{}, c, disc};
  sim.initialise([&](auto& p) { p.velocity = point{-spin * p.position[1], spin * p.position[0]}; });
  double mass = 0, square_radii = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    mass += value<field::mass>(s, i);
    square_radii += value<field::mass>(s, i) * (square(value<field::position>(s, i, 0)) + square(value<field::position>(s, i, 1)));
  });
  const auto run = [&](double decays) {
    while (static_cast<double>(sim.steps()) * (1 - blend.flip) < decays * cells * cells) sim.step();
  };
  run(1.2); // the next mode, k R = 5.33, is gone
  const double before = angular_momentum(sim), first = static_cast<double>(sim.steps());
  run(1.6);
  return -std::log(angular_momentum(sim) / before) / (static_cast<double>(sim.steps()) - first) * (2 * square_radii / mass) * cells * cells;
}
template <class Shape> void check_decay(const char* shape, double inertia, double bound) {
  const double exact = inertia * square(1.84118);
  const double coarse = decay_rate<Shape>(10, {}) / exact - 1, fine = decay_rate<Shape>(20, {}) / exact - 1;
  verify::record({.section = "extremes",
                  .problem = "spin of a disc without stress, 20 cells per radius",
                  .composition = std::string("plane_strain, ") + shape + "_pic_musl",
                  .measure = "angular momentum lost per step, against the exact " + to_text(std::round(1e4 * exact) / 1e4) + " (h/R)^2",
                  .value = fine,
                  .bound = bound,
                  .note = "PIC loses half of a spin in some " + to_text(std::round(10 * std::numbers::ln2 / exact) / 10) +
                          " (R/h)^2 steps; with 10 cells per radius the rate is off by " + to_text(std::round(1e4 * coarse) / 1e4)});
  EXPECT_LT(std::abs(fine), bound);
  EXPECT_LT(std::abs(coarse), 2 * bound);
}
TEST(Spin, PicLosesAtItsExactRate) {
  check_decay<shape::quadratic_bspline>("bspline", 0.25, 0.003);
  check_decay<shape::linear>("linear", 3.0 / 16, 0.015); // i is 3/16 only where points have not moved: 0.13 cells at the rim by then
}
TEST(Spin, BlendLosesItsPartOfThat) {
  const transfer::pic blend{.flip = 0.9};
  const double exact = (1 - blend.flip) * 0.25 * square(1.84118), rate = decay_rate<shape::quadratic_bspline>(10, blend) / exact - 1;
  verify::record({.section = "extremes",
                  .problem = "spin of a disc without stress, 10 cells per radius",
                  .composition = "plane_strain, bspline_pic_musl, flip 0.9",
                  .measure = "angular momentum lost per step, against a tenth of PIC's",
                  .value = rate,
                  .bound = 0.02});
  EXPECT_LT(std::abs(rate), 0.02);
}

/// A stress through 100 turns at w dt.
template <class T> void check_jaumann(double turn, double bound) {
  using space = space::plane_strain;
  using metal = material<eos::mie_grueneisen, strength::elastic, failure::none, viscosity::none>;
  test::material_point<metal, space, T> m(metal{eos::mie_grueneisen{}, strength::elastic{27.6e9}, {}, {}}, 2785, 0);
  const double s0 = 1e6;
  m.template get<field::deviator>(0) = T(s0);
  m.template get<field::deviator>(1) = T(-s0);
  const long steps = std::lround(100 * 2 * std::numbers::pi / turn);
  const double w = 1e6, dt = turn / w;
  for (long i = 0; i < steps; ++i) m.advance({0, -w, w, 0}, dt, false);
  const double a = 0.5 * (static_cast<double>(m.template get<field::deviator>(0)) - static_cast<double>(m.template get<field::deviator>(1))),
               b = static_cast<double>(m.template get<field::deviator>(2)), n = static_cast<double>(steps);
  const double amplitude = std::hypot(a, b) / s0, exact = std::pow(1 + 4 * turn * turn, 0.5 * n);
  const double phase = std::remainder(std::atan2(b, a) - n * std::atan(2 * turn), 2 * std::numbers::pi);
  const auto row = [&](const char* measure, double got, const char* unit, const std::string& note) {
    verify::record({.section = "extremes",
                    .problem = "stress of one point through 100 turns, " + to_text(turn) + " rad a step",
                    .composition = std::string("plane_strain, Jaumann's rate, ") + (sizeof(T) == 8 ? "double" : "float"),
                    .measure = measure,
                    .value = got,
                    .bound = bound,
                    .unit = unit,
                    .note = note});
    EXPECT_LT(std::abs(got), bound) << measure;
  };
  row("amplitude over the exact one of Euler's step, less 1", amplitude / exact - 1, "",
      "the step makes it " + to_text(std::round(1e4 * amplitude) / 1e4) + " times the true one");
  row("angle less the exact one of Euler's step", phase, "rad",
      "the step turns it " + to_text(std::round(1e4 * n * (2 * turn - std::atan(2 * turn))) / 1e4) + " rad too little in 1256.6");
  EXPECT_NEAR(m.density() / 2785 / std::pow(1 + turn * turn, n), 1, bound) << "by 1/det(I - dt L), as the motion of particles does";
}
TEST(Spin, JaumannsRateTurnsAStressAsEulersStep) {
  check_jaumann<double>(1e-4, 1e-9);
  check_jaumann<double>(1e-3, 1e-9);
  check_jaumann<float>(1e-3, 0.05);
}

} // namespace
} // namespace bolide
