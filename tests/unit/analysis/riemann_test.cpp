// SPDX-License-Identifier: MIT
// Riemann's problem for any equation of state against the exact solution of gases, and its waves against their own equations.
#include "bolide/analysis/release_isentrope.hpp"
#include "bolide/analysis/riemann.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/gsl/ode.hpp"
#include "unit/analysis/gamma_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;
using analysis::flow_state;
using analysis::riemann;
using analysis::wave_kind;
using analysis::wave_status;
using test::gamma_side;

const eos::ideal_gas air;
const eos::ideal_gas monatomic({.gamma = 5.0 / 3});

gamma_side side(const eos::ideal_gas& gas, const flow_state& s) { return {gas.values().gamma, 0, s.density, s.velocity, s.pressure}; }
gamma_side side(const eos::stiffened_gas& gas, const flow_state& s) {
  return {gas.values().gamma, gas.values().p_inf, s.density, s.velocity, s.pressure};
}

/// Star state and densities of riemann() against the exact ones, to `relative` (u: of the larger sound speed).
template <class L, class R> void expect_exact(const L& le, const flow_state& l, const R& re, const flow_state& r, double relative) {
  const auto found = riemann(le, l, re, r);
  const gamma_side a = side(le, l), b = side(re, r);
  const auto exact = test::exact_riemann(a, b);
  EXPECT_EQ(found.status(), wave_status::ok) << found.message();
  EXPECT_NEAR((found.star_pressure() + a.p_inf) / (exact.p + a.p_inf), 1, relative);
  EXPECT_NEAR(found.star_velocity(), exact.u, relative * std::fmax(a.c(), b.c()));
  EXPECT_NEAR(found.left().density / a.density(exact.p), 1, relative);
  EXPECT_NEAR(found.right().density / b.density(exact.p), 1, relative);
  EXPECT_EQ(found.left().kind, exact.p > l.pressure ? wave_kind::shock : wave_kind::rarefaction);
  EXPECT_EQ(found.right().kind, exact.p > r.pressure ? wave_kind::shock : wave_kind::rarefaction);
}

// ---- gases: the problems of the literature ---------------------------------------------------------------------------------------------
TEST(Riemann, SodHasThePublishedStarState) {
  const auto s = riemann(air, {1, 0, 1}, air, {0.125, 0, 0.1});
  EXPECT_NEAR(s.star_pressure(), 0.303130, 5e-7);
  EXPECT_NEAR(s.star_velocity(), 0.927453, 5e-7);
  EXPECT_NEAR(s.left().density, 0.426319, 5e-7);
  EXPECT_NEAR(s.right().density, 0.265574, 5e-7);
  EXPECT_NEAR(s.right().head, 1.752156, 5e-7);
}

TEST(Riemann, NearVacuumHasThePublishedStarState) {
  const auto s = riemann(air, {1, -2, 0.4}, air, {1, 2, 0.4});
  EXPECT_NEAR(s.star_pressure(), 0.00189387, 5e-9);
  EXPECT_NEAR(s.star_velocity(), 0, 1e-14);
  EXPECT_NEAR(s.left().density, 0.0218521, 5e-8);
}

TEST(Riemann, LeBlancHasThePublishedStarState) {
  const auto s = riemann(monatomic, {1, 0, 0.1 * 2 / 3}, monatomic, {1e-3, 0, 1e-10 * 2 / 3});
  EXPECT_NEAR(s.star_pressure(), 5.15578e-4, 5e-10);
  EXPECT_NEAR(s.star_velocity(), 0.621839, 5e-7);
  EXPECT_NEAR(s.left().density, 0.0540793, 5e-8);
  EXPECT_NEAR(s.right().density, 0.0040000, 5e-8);
  EXPECT_NEAR(3 + 6 * s.right().head, 7.9747, 5e-5);
  EXPECT_NEAR(3 + 6 * s.star_velocity(), 6.7310, 5e-5);
}

TEST(Riemann, EqualsTheExactSolutionOfGases) {
  expect_exact(air, {1, 0, 1}, air, {0.125, 0, 0.1}, 1e-9);
  expect_exact(air, {1, -2, 0.4}, air, {1, 2, 0.4}, 1e-9);
  expect_exact(monatomic, {1, 0, 0.1 * 2 / 3}, monatomic, {1e-3, 0, 1e-10 * 2 / 3}, 1e-9);
  expect_exact(air, {1, 0, 1000}, air, {1, 0, 0.01}, 1e-9);                          // blast
  expect_exact(air, {5.99924, 19.5975, 460.894}, air, {5.99242, -6.19633, 46.095}, 1e-9); // two shocks
  expect_exact(air, {1.2, 0, 1e5}, air, {1.2, 300, 1e5}, 1e-9);                      // SI, two rarefactions
  expect_exact(air, {1.2, 0, 1e5}, air, {1.2, -1e-3, 1e5}, 1e-9);                    // almost acoustic
}

TEST(Riemann, TwoDifferentGases) {
  expect_exact(air, {1, 0, 1}, monatomic, {0.125, 0, 0.1}, 1e-9);
  expect_exact(monatomic, {0.2, 0, 1e5}, air, {1.2, 0, 1e6}, 1e-9);
  expect_exact(monatomic, {1e-3, 50, 10}, air, {1, 0, 1}, 1e-9);
}

TEST(Riemann, StiffenedGases) {
  const eos::stiffened_gas water, heavy({.gamma = 3, .p_inf = 2e10, .rho0 = 8000});
  expect_exact(water, {1000, 500, 1e5}, water, {1000, -500, 1e5}, 1e-9);
  expect_exact(water, {1000, 0, 1e9}, water, {1000, 0, 1e5}, 1e-9);
  expect_exact(water, {1000, 2000, 0}, heavy, {8000, 0, 0}, 1e-9);
  expect_exact(heavy, {8000, 1000, 0}, water, {1000, 0, 0}, 1e-9);
  expect_exact(water, {1000, -50, 1e5}, water, {1000, 50, 1e5}, 1e-8); // holds in tension: p* = -76 MPa
  const auto tension = riemann(water, {1000, -50, 1e5}, water, {1000, 50, 1e5});
  EXPECT_LT(tension.star_pressure(), -7e7);
  const auto found = riemann(water, {1000, 0, 1e9}, air, {1.2, 0, 1e5}); // a liquid and a gas
  const auto exact = test::exact_riemann(side(water, {1000, 0, 1e9}), side(air, {1.2, 0, 1e5}));
  EXPECT_NEAR(found.star_pressure() / exact.p, 1, 1e-6); // p* is 1/300 of what p_inf loses to round-off
  EXPECT_NEAR(found.star_velocity() / exact.u, 1, 1e-9);
}

// ---- the state between the waves ------------------------------------------------------------------------------------------------------
TEST(RiemannSample, SodAlongEveryRay) {
  const auto s = riemann(air, {1, 0, 1}, air, {0.125, 0, 0.1});
  const double g = 1.4, c = std::sqrt(g);
  const auto check = [&](double ray, double rho, double u, double p) {
    const auto a = s.sample(ray);
    EXPECT_NEAR(a.density / rho, 1, 1e-9) << ray;
    EXPECT_NEAR(a.velocity, u, 1e-9) << ray;
    EXPECT_NEAR(a.pressure / p, 1, 1e-9) << ray;
    EXPECT_NEAR(a.energy / (p / (g - 1) / rho), 1, 1e-9) << ray;
  };
  for (double ray = -1.18; ray < -0.071; ray += 0.01) { // the fan: u = 2/(g + 1) (c + x/t), c - (g - 1)/2 u
    const double u = 2 / (g + 1) * (c + ray), ratio = (c - 0.5 * (g - 1) * u) / c;
    check(ray, std::pow(ratio, 2 / (g - 1)), u, std::pow(ratio, 2 * g / (g - 1)));
  }
  check(-1.2, 1, 0, 1);
  check(s.left().tail + 1e-9, s.left().density, s.star_velocity(), s.star_pressure());
  check(0.92, s.left().density, s.star_velocity(), s.star_pressure());
  check(0.93, s.right().density, s.star_velocity(), s.star_pressure());
  check(1.75215, s.right().density, s.star_velocity(), s.star_pressure());
  check(1.75216, 0.125, 0, 0.1);
}

TEST(RiemannSample, MirrorAndMovingFrame) {
  const eos::mie_grueneisen al;
  const eos::tillotson other;
  const flow_state a{2785, 3000, 2e10}, b{2700, -500, 1e9};
  const auto s = riemann(al, a, other, b);
  const auto mirrored = riemann(other, {b.density, -b.velocity, b.pressure}, al, {a.density, -a.velocity, a.pressure});
  const auto moving = riemann(al, {a.density, a.velocity + 700, a.pressure}, other, {b.density, b.velocity + 700, b.pressure});
  EXPECT_NEAR(mirrored.star_pressure() / s.star_pressure(), 1, 1e-10);
  for (double ray = -8000; ray < 12000; ray += 613) {
    const auto here = s.sample(ray), there = mirrored.sample(-ray), carried = moving.sample(ray + 700);
    EXPECT_NEAR(here.density / there.density, 1, 1e-9) << ray;
    EXPECT_NEAR(here.velocity, -there.velocity, 1e-6) << ray;
    EXPECT_NEAR(here.density / carried.density, 1, 1e-9) << ray;
    EXPECT_NEAR(here.energy, carried.energy, 1e-2) << ray;
  }
}

/// Mass, momentum and energy in [-X, X] at t = 1 from sampling, against what flowed in through the ends: exact for any weak solution.
template <class L, class R> void expect_conservation(const L& le, const flow_state& l, const R& re, const flow_state& r, double X) {
  const auto s = riemann(le, l, re, r);
  ASSERT_EQ(s.status(), wave_status::ok) << s.message();
  const auto a = s.sample(-X), b = s.sample(X);
  // Edges where the solution jumps or kinks; between them a smooth integrand (Gauss, 5 points on 200 panels).
  const double edges[] = {-X, s.left().head, s.left().tail, s.star_velocity(), s.right().tail, s.right().head, X};
  static constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
  static constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double mass = 0, momentum = 0, energy = 0;
  const auto add = [&](double x, double w) {
    const auto q = s.sample(x);
    mass += w * q.density;
    momentum += w * q.density * q.velocity;
    energy += w * q.density * (q.energy + 0.5 * q.velocity * q.velocity);
  };
  for (int k = 0; k < 6; ++k) {
    if (!(edges[k + 1] > edges[k])) continue;
    const double half = 0.5 * (edges[k + 1] - edges[k]) / 200;
    for (int i = 0; i < 200; ++i) {
      const double middle = edges[k] + (2 * i + 1) * half;
      add(middle, half * weight[0]);
      for (const int j : {1, 2}) add(middle - half * node[j], half * weight[j]), add(middle + half * node[j], half * weight[j]);
    }
  }
  const auto total = [](const analysis::flow_sample& q) { return q.density * (q.energy + 0.5 * q.velocity * q.velocity); };
  const auto of = [&](double left, double right, double flux_in, double flux_out) { return X * (left + right) + flux_in - flux_out; };
  const double m = of(a.density, b.density, a.density * a.velocity, b.density * b.velocity);
  const double i = of(a.density * a.velocity, b.density * b.velocity, a.pressure + a.density * a.velocity * a.velocity,
                      b.pressure + b.density * b.velocity * b.velocity);
  const double e = of(total(a), total(b), (total(a) + a.pressure) * a.velocity, (total(b) + b.pressure) * b.velocity);
  EXPECT_NEAR(mass / m, 1, 1e-8);
  EXPECT_NEAR(momentum, i, 1e-8 * m * X);
  EXPECT_NEAR(energy, e, 1e-8 * m * X * X);
}

TEST(RiemannSample, ConservesMassMomentumAndEnergy) {
  const eos::mie_grueneisen al;
  const eos::tillotson tillotson;
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  expect_conservation(air, {1, 0, 1}, air, {0.125, 0, 0.1}, 2);
  expect_conservation(al, {2785, 0, 5e10}, tillotson, {2700, 0, 0}, 10000);
  expect_conservation(al, {3500, 100, 8e10}, air, {1.2, 0, 1e5}, 15000);
  expect_conservation(mixed, {3300, 0, 4e10}, al, {2785, 0, 0}, 12000);
}

// ---- real materials ----------------------------------------------------------------------------------------------------------------------
TEST(Riemann, WavesOfMetalsObeyTheirEquations) { // the shock: three jumps; the rarefaction: the isentrope by GSL, to the star density
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const eos::mie_grueneisen al;
  const flow_state l{3600, 0, 6e10}, r{2785, 0, 0};
  const auto s = riemann(mixed, l, al, r);
  ASSERT_EQ(s.status(), wave_status::ok) << s.message();
  ASSERT_EQ(s.left().kind, wave_kind::rarefaction);
  ASSERT_EQ(s.right().kind, wave_kind::shock);
  const double us = 5328 + 1.338 * s.star_velocity();
  EXPECT_NEAR(s.right().head / us, 1, 1e-9);
  EXPECT_NEAR(s.star_pressure() / (2785 * us * s.star_velocity()), 1, 1e-9);
  const auto slope = [&](double y, const std::array<double, 2>& v) {
    const auto p = mixed.evaluate(std::exp(-y), v[0]);
    return std::array<double, 2>{-p.pressure * std::exp(y), std::sqrt(p.sound_speed_squared)};
  };
  const double e0 = s.sample(-1e5).energy;
  const auto end = gsl::integrate<2>(slope, {e0, 0}, -std::log(l.density), -std::log(s.left().density), 1e-11, 1e-6);
  EXPECT_NEAR(end[0] / s.left().energy, 1, 1e-8);
  EXPECT_NEAR(end[1] / s.star_velocity(), 1, 1e-8);
  EXPECT_NEAR(mixed.evaluate(s.left().density, s.left().energy).pressure / s.star_pressure(), 1, 1e-8);
}

// ---- what has no simple answer says so ----------------------------------------------------------------------------------------------------
TEST(Riemann, GasesPartAndLeaveAVacuum) {
  const auto s = riemann(air, {1, -10, 0.4}, monatomic, {2, 10, 0.4});
  EXPECT_EQ(s.status(), wave_status::vacuum);
  EXPECT_FALSE(s.message().empty());
  EXPECT_EQ(s.star_pressure(), 0);
  EXPECT_TRUE(std::isnan(s.star_velocity()));
  const double left = -10 + 2 * std::sqrt(1.4 * 0.4) / 0.4, right = 10 - 2 * std::sqrt(5.0 / 3 * 0.2) / (2.0 / 3);
  EXPECT_NEAR(s.left().velocity, left, 1e-9); // the escape speed 2c/(gamma - 1)
  EXPECT_NEAR(s.right().velocity, right, 1e-9);
  const auto gap = s.sample(0);
  EXPECT_EQ(gap.density, 0);
  EXPECT_EQ(gap.pressure, 0);
  EXPECT_TRUE(std::isnan(gap.velocity));
  const double u = 2 / 2.4 * (std::sqrt(0.56) - 7 + 0.2 * -10), c = u + 7; // the fan at x/t = -7
  EXPECT_NEAR(s.sample(-7).velocity, u, 1e-9);
  EXPECT_NEAR(s.sample(-7).density / std::pow(c / std::sqrt(0.56), 5), 1, 1e-8);
  EXPECT_NEAR(s.sample(-20).velocity, -10, 1e-15);
}

TEST(Riemann, MetalTornApartEndsInFreeSurfaces) {
  const eos::tillotson al;
  const auto shocked = analysis::hugoniot(al, eos::ambient_state(al), 1000);
  const flow_state l{shocked.density, -8000, shocked.pressure}, r{2700, 8000, 0};
  const auto s = riemann(al, l, al, r);
  EXPECT_EQ(s.status(), wave_status::vacuum);
  EXPECT_NEAR(al.evaluate(s.left().density, s.left().energy).pressure, 0, 1e3);
  const auto free = analysis::release_isentrope(al, shocked.density, shocked.energy);
  EXPECT_NEAR(s.left().velocity, -8000 + free.speed_gain, 1e-4);
  EXPECT_NEAR(s.right().velocity, 8000, 1e-4);
  EXPECT_EQ(s.sample(0).density, 0);
  EXPECT_NEAR(s.sample(s.left().velocity - 1).density / free.density, 1, 1e-9);
}

/// p(rho) alone; softer by `factor` in c^2 above rho1, and `jump` (Pa) higher.
struct two_slopes {
  double rho0 = 1000, rho1 = 1100, c2 = 4e6, factor = 1, jump = 0;
  template <class V> eos_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const auto dense = rho > V(T(rho1));
    const V p = select(dense, V(T(c2 * (rho1 - rho0) + jump)) + T(factor * c2) * (rho - T(rho1)), T(c2) * (rho - T(rho0)));
    return {p + T(0) * e, select(dense, V(T(factor * c2)), V(T(c2)))};
  }
  double reference_density() const { return rho0; }
};

/// The contact of two equal bodies of a model at closing speed V.
template <class Eos> analysis::meeting collide(const Eos& eos, double rho, double e, double V) {
  const analysis::wave_curve<Eos> body(eos, rho, e);
  return analysis::meet(body, V, body, 0);
}

TEST(Riemann, LossOfConvexityIsSaid) {
  // A soft second slope: just above the kink the first wave outruns the shock.
  const two_slopes soft{.factor = 0.25};
  EXPECT_EQ(collide(soft, 1000, 0, 300).status, wave_status::ok);
  const auto split = collide(soft, 1000, 0, 500);
  EXPECT_EQ(split.status, wave_status::not_convex);
  EXPECT_NE(split.message.find("splits in two"), std::string::npos) << split.message;
  EXPECT_EQ(collide(soft, 1000, 0, 6000).status, wave_status::ok); // overdriven: one shock again
  // The same kink in the other direction: c rises on expansion.
  const auto fan = analysis::meet(analysis::wave_curve(soft, 1150, 0.0), 0, analysis::wave_curve(air, 1, 1e5), 0);
  EXPECT_EQ(fan.status, wave_status::not_convex);
  EXPECT_NE(fan.message.find("left wave: the sound speed rises"), std::string::npos) << fan.message;
  const two_slopes stiff{.factor = 4};
  EXPECT_EQ(analysis::meet(analysis::wave_curve(stiff, 1150, 0.0), 0, analysis::wave_curve(air, 1, 1e5), 0).status, wave_status::ok);
  // The paper's melting jump: two shocks of one strength.
  const eos::grover paper{cold::tabulated{cold::cai_ye{}}, phase::paper{}};
  const auto warm = eos::ambient_state(paper, 300);
  EXPECT_EQ(collide(paper, warm.density, warm.energy, 9000).status, wave_status::ok);
  const auto several = collide(paper, warm.density, warm.energy, 9400);
  EXPECT_EQ(several.status, wave_status::not_convex);
  EXPECT_NE(several.message.find("the Hugoniot has 2 shocks"), std::string::npos) << several.message;
  EXPECT_EQ(collide(paper, warm.density, warm.energy, 9900).status, wave_status::ok);
}

TEST(Riemann, APressureJumpHasNoCommonPressure) {
  const two_slopes jump{.factor = 1, .jump = 1e9};
  const auto m = collide(jump, 1000, 0, 500);
  EXPECT_EQ(m.status, wave_status::no_solution);
  EXPECT_FALSE(m.message.empty());
}

TEST(Riemann, BadStatesAreRefused) {
  const eos::tillotson al;
  EXPECT_THROW(riemann(air, {0, 0, 1}, air, {1, 0, 1}), bad_parameter);
  EXPECT_THROW(riemann(air, {1, std::nan(""), 1}, air, {1, 0, 1}), bad_parameter);
  EXPECT_THROW(riemann(air, {1, 0, -1}, air, {1, 0, 1}), bad_parameter);
  EXPECT_THROW(riemann(al, {1500, 0, -2e10}, al, {2700, 0, 0}), bad_parameter); // beyond the spinodal
}
} // namespace
