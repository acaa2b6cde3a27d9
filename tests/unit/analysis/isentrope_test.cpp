// SPDX-License-Identifier: MIT
// The isentrope as a curve: closed forms of gases, GSL's integrator through phase borders, the spinodal of a van der Waals fluid.
#include "bolide/analysis/isentrope.hpp"
#include "bolide/analysis/release_isentrope.hpp"
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
#include "unit/analysis/van_der_waals.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;
using analysis::isentrope_end;

TEST(Isentrope, IdealGasBothWays) {
  const eos::ideal_gas gas({.gamma = 5.0 / 3});
  const double e = 3e5, c = std::sqrt(gas.evaluate(1.0, e).sound_speed_squared);
  for (const double end : {1e-3, 50.}) {
    const auto curve = analysis::isentrope(gas, 1, e, end, 7);
    ASSERT_EQ(curve.states.size(), 7u);
    EXPECT_EQ(curve.end, isentrope_end::reached);
    EXPECT_TRUE(curve.message.empty());
    EXPECT_EQ(curve.states.front().density, 1);
    for (const auto& s : curve.states) {
      EXPECT_NEAR(s.pressure / (2.0 / 3 * e * std::pow(s.density, 5.0 / 3)), 1, 1e-9) << s.density;
      EXPECT_NEAR(s.particle_speed, 3 * (c - s.sound_speed), 1e-9 * c) << s.density; // 2/(gamma - 1) = 3
      EXPECT_NEAR(s.temperature / (s.energy / 717.5), 1, 1e-14);
      EXPECT_EQ(to_region(s.region), region::gas);
    }
    EXPECT_NEAR(curve.states.back().density / end, 1, 1e-14);
  }
}

TEST(Isentrope, StiffenedGas) {
  const eos::stiffened_gas water;
  const auto curve = analysis::isentrope(water, 1000, 1e5, 1800, 5);
  const double p0 = water.evaluate(1000., 1e5).pressure + 6e8;
  for (const auto& s : curve.states) EXPECT_NEAR((s.pressure + 6e8) / (p0 * std::pow(s.density / 1000, 4.4)), 1, 1e-9) << s.density;
}

TEST(Isentrope, ChosenDensities) {
  const eos::mie_grueneisen al;
  const std::vector<double> densities{3500, 3400, 3000, 2786};
  const auto curve = analysis::isentrope_at(al, 3600, 3e6, densities, 1234);
  ASSERT_EQ(curve.states.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(curve.states[i].density / densities[i], 1, 1e-14);
    const auto alone = analysis::isentrope_at(al, 3600, 3e6, {densities[i]}, 1234).states.front();
    EXPECT_NEAR(curve.states[i].energy / alone.energy, 1, 1e-10);
    EXPECT_NEAR(curve.states[i].particle_speed / alone.particle_speed, 1, 1e-10);
  }
  EXPECT_GT(curve.states[0].particle_speed, 1234);
  EXPECT_THROW(analysis::isentrope_at(al, 3600, 3e6, {3500, 3550}), bad_parameter);
  EXPECT_THROW(analysis::isentrope(al, 3600, 3e6, 0.0, 5), bad_parameter);
  EXPECT_THROW(analysis::isentrope(al, 3600, 3e6, 3000, 1), bad_parameter);
}

/// Energy and speed at every sample against GSL's Runge-Kutta 8(9).
template <class Eos> void expect_gsl_agrees(const Eos& eos, const analysis::isentrope_curve& curve, double relative) {
  const auto slope = [&](double y, const std::array<double, 2>& v) {
    const auto p = eos.evaluate(std::exp(-y), v[0]);
    return std::array<double, 2>{-p.pressure * std::exp(y), std::sqrt(p.sound_speed_squared)};
  };
  const auto& from = curve.states.front();
  std::array<double, 2> v{from.energy, from.particle_speed};
  for (std::size_t i = 1; i < curve.states.size(); ++i) {
    const auto& to = curve.states[i];
    v = gsl::integrate<2>(slope, v, -std::log(curve.states[i - 1].density), -std::log(to.density), 1e-11, 1e-6);
    EXPECT_NEAR(v[0], to.energy, relative * (std::abs(from.energy) + std::abs(to.energy))) << to.density;
    EXPECT_NEAR(v[1], to.particle_speed, relative * (std::abs(to.particle_speed) + 1)) << to.density;
  }
}

TEST(Isentrope, AgreesWithGslThroughPhaseBorders) {
  const eos::mie_grueneisen al;
  expect_gsl_agrees(al, analysis::isentrope(al, 3800, 4e6, 2800, 9), 1e-9);
  expect_gsl_agrees(al, analysis::isentrope(al, 2785, 0, 4500, 9), 1e-9);
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const auto shock = analysis::hugoniot(mixed, eos::ambient_state(mixed, 300), 3000); // 77 GPa: ends partly molten
  const auto curve = analysis::release(mixed, shock, 15);
  ASSERT_EQ(curve.end, isentrope_end::reached);
  EXPECT_EQ(to_region(curve.states.front().region), region::solid);
  EXPECT_EQ(to_region(curve.states.back().region), region::mixed);
  EXPECT_GT(curve.states.back().melt_fraction, 0.1);
  expect_gsl_agrees(mixed, curve, 1e-7); // c^2 jumps where melting begins
}

TEST(Isentrope, ThereAndBack) {
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const auto down = analysis::isentrope(mixed, 4200, 6e6, 2400, 2).states.back(); // through melting
  const auto up = analysis::isentrope(mixed, down.density, down.energy, 4200, 2).states.back();
  EXPECT_NEAR(up.energy / 6e6, 1, 1e-8);
  EXPECT_NEAR(up.particle_speed + down.particle_speed, 0, 1e-6 * down.particle_speed);
}

TEST(Isentrope, StopsAtTheSpinodalWithAllItHas) {
  const test::van_der_waals fluid;
  const double T = 0.8, rho = 1.9, e = fluid.energy(rho, T);
  const auto curve = analysis::isentrope(fluid, rho, e, 0.5, 15);
  EXPECT_EQ(curve.end, isentrope_end::unstable);
  EXPECT_NE(curve.message.find("c^2 <= 0"), std::string::npos);
  ASSERT_GT(curve.states.size(), 1u);
  ASSERT_LT(curve.states.size(), 15u);
  // Exact: T = T0 [(V0 - b)/(V - b)]^(R/c_v) on the isentrope; c^2 = 0 found by bisection on that.
  double stable = rho, unstable = 0.5;
  for (int i = 0; i < 100; ++i) {
    const double r = 0.5 * (stable + unstable);
    (fluid.evaluate(r, fluid.energy(r, fluid.isentrope_temperature(rho, T, r))).sound_speed_squared > 0 ? stable : unstable) = r;
  }
  EXPECT_NEAR(curve.states.back().density / stable, 1, 1e-7);
  for (const auto& s : curve.states) EXPECT_NEAR(s.temperature / fluid.isentrope_temperature(rho, T, s.density), 1, 1e-9) << s.density;
  const eos::tillotson al; // torn at 0 K: the work of tension brings e to E_iv, where c^2 jumps below 0
  const auto torn = analysis::isentrope(al, 2700, 0, 1000, 100);
  EXPECT_EQ(torn.end, isentrope_end::unstable);
  EXPECT_GT(torn.states.size(), 30u);
  EXPECT_NEAR(torn.states.back().energy / al.values().E_iv, 1, 1e-6);
  EXPECT_EQ(analysis::isentrope(al, 1000, 0, 500, 5).states.size(), 1u); // unstable from the start
}

TEST(Release, GoesFromUpToTheFreeSurface) {
  const eos::mie_grueneisen al;
  const auto shock = analysis::hugoniot(al, eos::ambient_state(al), 3320);
  const auto curve = analysis::release(al, shock, 11);
  const auto end = analysis::release_isentrope(al, shock.density, shock.energy);
  ASSERT_EQ(curve.states.size(), 11u);
  EXPECT_EQ(curve.states.front().particle_speed, 3320);
  EXPECT_NEAR(curve.states.front().pressure / shock.pressure, 1, 1e-10);
  EXPECT_NEAR(curve.states.back().particle_speed / (3320 + end.speed_gain), 1, 1e-12);
  EXPECT_NEAR(curve.states.back().particle_speed, 6835, 0.5); // the table of shock states
  EXPECT_LT(std::abs(curve.states.back().pressure), 1e3);
  EXPECT_NEAR(analysis::release(al, shock, 3, 1e10).states.back().pressure / 1e10, 1, 1e-9);
}

TEST(Release, OfAGasEndsInVacuumAtTheEscapeSpeed) {
  const eos::ideal_gas air;
  const auto shock = analysis::hugoniot(air, 1.2, 2e5, 0.4 * 1.2 * 2e5, 1000);
  const auto curve = analysis::release(air, shock, 3);
  EXPECT_EQ(curve.end, isentrope_end::density_limit);
  EXPECT_FALSE(curve.message.empty());
  EXPECT_NEAR(curve.states.back().particle_speed / (1000 + 5 * curve.states.front().sound_speed), 1, 1e-9);
  EXPECT_THROW(analysis::release_isentrope(air, shock.density, shock.energy), bad_parameter);
  EXPECT_NEAR(analysis::release_isentrope(air, shock.density, shock.energy, 1e5).pressure / 1e5, 1, 1e-9);
}
} // namespace
