// SPDX-License-Identifier: MIT
// The two gases: formulas, sound speed against differences, every lane type, parameters, and a shock of each against the exact one.
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>

namespace {
using namespace bolide;
using bolide::test::expect_close;

template <class Eos> struct Gases : ::testing::Test {};
using gases = ::testing::Types<eos::ideal_gas, eos::stiffened_gas>;
TYPED_TEST_SUITE(Gases, gases);

TYPED_TEST(Gases, SoundSpeedIsThePressureDerivative) {
  const TypeParam eos{};
  for (double eta = 0.2; eta < 5; eta += 0.231)
    for (double e = 1e3; e < 1e7; e *= 3.1) {
      const double rho = eta * eos.reference_density(), dr = 1e-5 * rho, de = 1e-5 * e;
      const auto p = [&](double r, double energy) { return eos.evaluate(r, energy).pressure; };
      const double p_rho = (p(rho + dr, e) - p(rho - dr, e)) / (2 * dr), p_e = (p(rho, e + de) - p(rho, e - de)) / (2 * de);
      expect_close(eos.evaluate(rho, e).sound_speed_squared, p_rho + p(rho, e) * p_e / (rho * rho), 1e-6, 0,
                   "c^2 at eta " + std::to_string(eta));
    }
}

/// The exact strong-shock state satisfies p = rho0 us up with the model's own p(rho, e): both closed forms, from a state at rest.
TYPED_TEST(Gases, ShockStatesLieOnTheSurface) {
  const TypeParam eos{};
  const double g = eos.values().gamma, rho0 = eos.reference_density();
  const double e0 = std::is_same_v<TypeParam, eos::ideal_gas> ? 2e5 : 0; // a gas at rest needs some energy to have a sound speed
  const auto rest = eos.evaluate(rho0, e0);
  for (const double up : {1.0, 100.0, 2000.0}) {
    const double a = (g + 1) / 4 * up, us = a + std::sqrt(a * a + rest.sound_speed_squared);
    const double p = rest.pressure + rho0 * us * up, rho = rho0 * us / (us - up), e = e0 + (p + rest.pressure) / 2 * (1 / rho0 - 1 / rho);
    expect_close(eos.evaluate(rho, e).pressure, p, 1e-9, 0, "p at up " + std::to_string(up));
  }
}

template <class V> class GasLanes : public ::testing::Test {};
TYPED_TEST_SUITE(GasLanes, lane_types);

TYPED_TEST(GasLanes, GiveTheScalarAnswer) {
  using V = TypeParam;
  const auto check = [](const auto& eos) {
    const V rho = test::ramp<V>(0.7, 0.11) * V(static_cast<scalar_t<V>>(eos.reference_density())), e = test::ramp<V>(1e5, 3e4);
    const auto many = eos.evaluate(rho, e);
    for (int i = 0; i < lane_width<V>; ++i) {
      const auto one = eos.evaluate(static_cast<double>(lane(rho, i)), static_cast<double>(lane(e, i)));
      expect_close(lane(many.pressure, i), one.pressure, test::epsilon<V>(40), 1e8, "p");
      expect_close(lane(many.sound_speed_squared, i), one.sound_speed_squared, test::epsilon<V>(40), 1e6, "c^2");
    }
    EXPECT_FALSE(any(eos.outside_validity(rho, e)));
    EXPECT_TRUE(all(eos.outside_validity(rho, V(static_cast<scalar_t<V>>(-1e8)))));
  };
  check(eos::ideal_gas{});
  check(eos::stiffened_gas{});
}

TEST(IdealGas, KnowsItsTemperatureAndThatItIsAGas) {
  const eos::ideal_gas air;
  const auto p = air.evaluate(1.2, air.energy(293));
  EXPECT_NEAR(p.temperature, 293, 1e-10);
  EXPECT_NEAR(p.pressure, 0.4 * 1.2 * 717.5 * 293, 1e-6); // 100.9 kPa
  EXPECT_NEAR(std::sqrt(p.sound_speed_squared), 343.1, 0.1);
  EXPECT_EQ(to_region(p.region), region::gas);
  EXPECT_EQ(p.melt_fraction, 1);
  EXPECT_EQ(p.cold_energy, 0);
  EXPECT_THROW(eos::ambient_state(air, 293), bad_parameter) << "p = 0 at 293 K does not exist";
}

TEST(StiffenedGas, IsTheUsualFormWithTheEnergyCountedFromRest) {
  const eos::stiffened_gas water;
  const double shift = 4.4 * 6e8 / (3.4 * 1000);
  expect_close(water.evaluate(1100., 2e5).pressure, 3.4 * 1100 * (2e5 + shift) - 4.4 * 6e8, 1e-12, 0, "p");
  const auto rest = eos::ambient_state(water);
  EXPECT_DOUBLE_EQ(rest.density, 1000);
  EXPECT_NEAR(rest.sound_speed, std::sqrt(4.4 * 6e5), 1e-9);
  const eos::isentrope_temperature warm{water, 4180, 293}; // a modifier takes any equation of state
  EXPECT_NEAR(warm.evaluate(1000., 41800.).temperature, 303, 1e-6);
}

TEST(Gas, BadParametersAreRefused) {
  EXPECT_THROW(eos::ideal_gas({.gamma = 1.0}), bad_parameter);
  EXPECT_THROW(eos::ideal_gas({.c_v = 0}), bad_parameter);
  EXPECT_THROW(eos::ideal_gas({.rho0 = std::nan("")}), bad_parameter);
  EXPECT_THROW(eos::stiffened_gas({.gamma = 0.9}), bad_parameter);
  EXPECT_THROW(eos::stiffened_gas({.rho0 = -1}), bad_parameter);
  try {
    eos::stiffened_gas bad({.p_inf = -1});
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "eos::stiffened_gas p_inf = -1 Pa: must be > 0 (0 is eos::ideal_gas) (unit: Pa)");
  }
}
} // namespace
