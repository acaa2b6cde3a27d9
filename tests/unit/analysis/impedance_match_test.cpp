// SPDX-License-Identifier: MIT
// Impedance matching against closed forms and an independent solution.
#include "bolide/analysis/impedance_match.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/analysis/gamma_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;
using analysis::wave_kind;
using analysis::wave_status;

TEST(ImpedanceMatch, EqualBodiesShareTheSpeed) {
  const auto check = [](const auto& eos, const eos::material_state& at, double V) {
    const auto m = analysis::impedance_match(eos, at, eos, at, V);
    EXPECT_EQ(m.status, wave_status::ok) << m.message;
    EXPECT_NEAR(m.velocity / (0.5 * V), 1, 1e-12) << V;
    EXPECT_NEAR(m.pressure / analysis::hugoniot(eos, at, 0.5 * V).pressure, 1, 1e-10) << V;
  };
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  for (const double V : {20., 1000., 6640., 15000.}) {
    check(eos::mie_grueneisen{}, eos::ambient_state(eos::mie_grueneisen{}), V);
    check(eos::tillotson{}, eos::ambient_state(eos::tillotson{}), V);
    check(eos::stiffened_gas{}, eos::ambient_state(eos::stiffened_gas{}), V);
    check(mixed, eos::ambient_state(mixed, 300), V);
  }
}

TEST(ImpedanceMatch, TwoLinesOfShockSpeed) { // rho_a (c_a + s_a (V - u)) (V - u) = rho_b (c_b + s_b u) u: a quadratic in u
  const eos::mie_grueneisen al, copper({.rho0 = 8930, .c0 = 3940, .s = 1.489, .gamma0 = 1.99});
  for (const double V : {100., 3000., 8000.}) {
    const double a = 2785 * 1.338 - 8930 * 1.489, b = -(2785 * (5328 + 2 * 1.338 * V) + 8930 * 3940.0), c = 2785 * V * (5328 + 1.338 * V);
    const double u = 2 * c / (-b + std::sqrt(b * b - 4 * a * c));
    const auto m = analysis::impedance_match(al, eos::ambient_state(al), copper, eos::ambient_state(copper), V);
    EXPECT_EQ(m.status, wave_status::ok) << m.message;
    EXPECT_NEAR(m.velocity / u, 1, 1e-9) << V;
    EXPECT_NEAR(m.pressure / (8930 * (3940 + 1.489 * u) * u), 1, 1e-9) << V;
    EXPECT_NEAR(m.right.head / (3940 + 1.489 * u), 1, 1e-9) << V;
    EXPECT_NEAR(m.left.head / (V - 5328 - 1.338 * (V - u)), 1, 1e-8) << V;
    const auto swapped = analysis::impedance_match(copper, eos::ambient_state(copper), al, eos::ambient_state(al), V);
    EXPECT_NEAR(swapped.velocity / (V - u), 1, 1e-9) << V;
    EXPECT_NEAR(swapped.pressure / m.pressure, 1, 1e-9) << V;
  }
}

TEST(ImpedanceMatch, GammaLawPairs) {
  const eos::stiffened_gas water, stiff({.gamma = 3, .p_inf = 2e10, .rho0 = 8000});
  const eos::ideal_gas air;
  const auto state = [](const auto& eos, double rho, double e) { return eos::state_at(eos, rho, e); };
  for (const double V : {10., 800., 5000.}) {
    const test::gamma_side a{4.4, 6e8, 1000, V, 0}, b{3, 2e10, 8000, 0, 0}, c{1.4, 0, 1.2, 0, 0.4 * 1.2 * 2e5};
    const auto ab = analysis::impedance_match(water, state(water, 1000, 0), stiff, state(stiff, 8000, 0), V);
    const auto exact = test::exact_riemann(a, b);
    EXPECT_NEAR(ab.velocity / exact.u, 1, 1e-9) << V;
    EXPECT_NEAR(ab.pressure / exact.p, 1, 1e-9) << V;
    const auto ac = analysis::impedance_match(water, state(water, 1000, 0), air, state(air, 1.2, 2e5), V);
    EXPECT_NEAR(ac.velocity / test::exact_riemann(a, c).u, 1, 1e-9) << V;
  }
}

TEST(Transmitted, IntoLowerAndHigherImpedance) {
  const eos::stiffened_gas water, stiff({.gamma = 3, .p_inf = 2e10, .rho0 = 8000});
  const auto check = [](const auto& first, double rho_a, const auto& second, double rho_b, double up, wave_kind back) {
    const auto shock = analysis::hugoniot(first, rho_a, 0, 0, up);
    const auto m = analysis::transmitted(first, shock, second, eos::state_at(second, rho_b, 0));
    const auto of = [](const auto& eos, double rho, double u, double p) {
      return test::gamma_side{eos.values().gamma, eos.values().p_inf, rho, u, p};
    };
    const auto exact = test::exact_riemann(of(first, shock.density, up, shock.pressure), of(second, rho_b, 0, 0));
    EXPECT_EQ(m.status, wave_status::ok) << m.message;
    EXPECT_EQ(m.left.kind, back);
    EXPECT_EQ(m.right.kind, wave_kind::shock);
    EXPECT_NEAR(m.velocity / exact.u, 1, 1e-9);
    EXPECT_NEAR(m.pressure / exact.p, 1, 1e-8);
  };
  check(water, 1000, stiff, 8000, 1000, wave_kind::shock);
  check(stiff, 8000, water, 1000, 1000, wave_kind::rarefaction);
}

TEST(Transmitted, IntoTheSameMaterialGoesOnUnchanged) {
  const eos::mie_grueneisen al;
  const auto shock = analysis::hugoniot(al, 2785, 0, 0, 3000);
  const auto m = analysis::transmitted(al, shock, al, eos::ambient_state(al));
  EXPECT_NEAR(m.velocity / 3000, 1, 1e-12);
  EXPECT_NEAR(m.pressure / shock.pressure, 1, 1e-10);
  EXPECT_NEAR(m.right.density / shock.density, 1, 1e-10);
}

TEST(Transmitted, ThinGasIsAFreeSurface) { // the velocity comes within the gas's small push of the free-surface velocity
  const eos::mie_grueneisen al;
  const eos::ideal_gas air;
  const auto shock = analysis::hugoniot(al, 2785, 0, 0, 3320);
  const auto m = analysis::transmitted(al, shock, air, eos::state_at(air, 1e-6, 2e5));
  EXPECT_NEAR(m.velocity, 6835, 0.6); // the front speed of a 6.64 km/s impact
  EXPECT_EQ(m.left.kind, wave_kind::rarefaction);
}

TEST(ImpedanceMatch, BadInputIsRefused) {
  const eos::mie_grueneisen al;
  EXPECT_THROW(analysis::impedance_match(al, eos::ambient_state(al), al, eos::ambient_state(al), 0), bad_parameter);
  EXPECT_THROW((analysis::wave_curve<eos::mie_grueneisen>(al, -1, 0)), bad_parameter);
}
} // namespace
