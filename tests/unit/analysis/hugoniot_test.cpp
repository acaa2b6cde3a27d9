// SPDX-License-Identifier: MIT
// Principal and secondary Hugoniots against closed forms; all roots where there are several.
#include "bolide/analysis/hugoniot.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/stiffened_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;

/// us of a stiffened gas in state (rho, p): a + sqrt(a^2 + c^2), a = (gamma + 1) up/4.
double stiffened_speed(const eos::stiffened_gas& gas, double rho, double p, double up) {
  const double a = 0.25 * (gas.values().gamma + 1) * up;
  return a + std::sqrt(a * a + gas.values().gamma * (p + gas.values().p_inf) / rho);
}

TEST(Hugoniot, MieGrueneisenToTenDigits) {
  const eos::mie_grueneisen model;
  for (const double up : {100., 1000., 3320., 8000., 20000.})
    EXPECT_NEAR(analysis::hugoniot(model, 2785, 0, 0, up).shock_speed / (5328 + 1.338 * up), 1, 1e-10) << up;
}

TEST(Hugoniot, StiffenedAndIdealGasToTenDigits) {
  const eos::stiffened_gas water;
  const eos::ideal_gas air;
  for (const double up : {10., 300., 2000., 10000.}) {
    EXPECT_NEAR(analysis::hugoniot(water, 1000, 0, 0, up).shock_speed / stiffened_speed(water, 1000, 0, up), 1, 1e-10) << up;
    const double e = 2e5, p = 0.4 * 1.2 * e, a = 0.6 * up, us = a + std::sqrt(a * a + 1.4 * p / 1.2);
    const auto s = analysis::hugoniot(air, 1.2, e, p, up);
    EXPECT_NEAR(s.shock_speed / us, 1, 1e-10) << up;
    EXPECT_NEAR(s.pressure / (p + 1.2 * us * up), 1, 1e-10) << up;
    EXPECT_NEAR(s.temperature / (s.energy / 717.5), 1, 1e-14) << up;
    EXPECT_EQ(to_region(s.region), region::gas);
  }
  EXPECT_TRUE(std::isnan(analysis::hugoniot(water, 1000, 0, 0, 100).region)); // it knows none
}

TEST(Hugoniot, IsTheSameInAnyUnits) { // pressures of order 1e-9 Pa
  const eos::ideal_gas gas({.gamma = 5.0 / 3});
  const double e = 1e-16, p = 2.0 / 3 * 1e-3 * e, up = 1e-3, a = up * 2 / 3;
  EXPECT_NEAR(analysis::hugoniot(gas, 1e-3, e, p, up).shock_speed / (a + std::sqrt(a * a + 5.0 / 3 * p / 1e-3)), 1, 1e-10);
}

TEST(SecondaryHugoniot, StiffenedGasFromAShockedState) {
  const eos::stiffened_gas water;
  const auto first = analysis::hugoniot(water, 1000, 0, 0, 1500);
  for (const double jump : {1., 200., 1500., 6000.}) {
    const auto second = analysis::reshock(water, first, jump);
    const double us = stiffened_speed(water, first.density, first.pressure, jump);
    EXPECT_NEAR(second.shock_speed / us, 1, 1e-9) << jump;
    EXPECT_NEAR(second.pressure / (first.pressure + first.density * us * jump), 1, 1e-9) << jump;
    EXPECT_NEAR(second.density / (first.density * us / (us - jump)), 1, 1e-9) << jump;
    EXPECT_NEAR(water.evaluate(second.density, second.energy).pressure / second.pressure, 1, 1e-9) << jump;
  }
}

TEST(SecondaryHugoniot, ReflectionAtAWallOfAnIdealGas) {
  // Strong shock: p2/p1 -> (3 gamma - 1)/(gamma - 1) = 8 for air, rho2/rho1 -> gamma/(gamma - 1).
  const eos::ideal_gas air;
  const auto first = analysis::hugoniot(air, 1.2, 1e-3, 0.4 * 1.2 * 1e-3, 5000);
  const auto second = analysis::reflected_shock(air, first);
  EXPECT_NEAR(second.pressure / first.pressure, 8, 1e-6);
  EXPECT_NEAR(second.density / first.density, 3.5, 1e-6);
  // Mass between the wall and the reflected front: what came in at up through the moving front.
  EXPECT_NEAR(second.density * (second.shock_speed - first.particle_speed) / (first.density * second.shock_speed), 1, 1e-12);
}

TEST(SecondaryHugoniot, TwoShocksHeatLessThanOne) { // aluminium to about 90 GPa at once and by reflection
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const auto ahead = eos::ambient_state(mixed, 300);
  const auto twice = analysis::reflected_shock(mixed, analysis::hugoniot(mixed, ahead, 1500));
  double low = 1500, high = 5000;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (analysis::hugoniot(mixed, ahead, middle).pressure < twice.pressure ? low : high) = middle;
  }
  const auto once = analysis::hugoniot(mixed, ahead, low);
  EXPECT_NEAR(once.pressure / twice.pressure, 1, 1e-9);
  EXPECT_LT(twice.energy, 0.9 * once.energy);
  EXPECT_LT(twice.temperature, 0.8 * once.temperature);
  EXPECT_GT(twice.density, once.density);
}

TEST(HugoniotAll, EveryRootAndNoJump) {
  const eos::grover paper{cold::tabulated{cold::cai_ye{}}, phase::paper{}};
  const auto ahead = eos::ambient_state(paper, 300);
  for (const double up : {4400., 4650., 4700., 4900.}) {
    const auto all = analysis::hugoniot_all(paper, ahead, up);
    ASSERT_EQ(all.size(), up > 4550 && up < 4850 ? 2u : 1u) << up;
    EXPECT_EQ(all.front().shock_speed, analysis::hugoniot(paper, ahead, up).shock_speed);
    for (const auto& s : all) {
      EXPECT_NEAR(paper.evaluate(s.density, s.energy).pressure / s.pressure, 1, 1e-9) << up;
      EXPECT_NEAR(s.density * (s.shock_speed - up) / (ahead.density * s.shock_speed), 1, 1e-12) << up;
    }
    if (all.size() < 2) continue;
    EXPECT_GT(all[0].shock_speed, all[1].shock_speed);
    EXPECT_EQ(to_region(all[0].region), region::liquid); // the jump in p makes the liquid's shock the faster one
    EXPECT_EQ(to_region(all[1].region), region::solid);
    EXPECT_GT(all[1].temperature, all[0].temperature);   // superheated
  }
  EXPECT_TRUE(analysis::hugoniot_all(eos::stiffened_gas{{.gamma = 1.01}}, 1000, 0, 0, 1e9).empty());
}
} // namespace
