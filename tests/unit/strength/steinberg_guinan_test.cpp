// SPDX-License-Identifier: MIT
// Steinberg, Cochran and Guinan's law: its formula on every lane against long double, numbers worked out by hand, and what the material does with
// a modulus that changes: elastic strain kept, total energy kept, elastic energy to heat at melting.
#include "bolide/strength/steinberg_guinan.hpp"
#include "bolide/concepts/strength.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"
#include "unit/material/material_point.hpp"

#include <algorithm>
#include <cmath>

namespace bolide {
namespace {

const auto aluminium = strength::steinberg_guinan::aluminium_6061_t6();
const auto copper = strength::steinberg_guinan::copper();

template <class V> class SteinbergGuinan : public testing::Test {};
TYPED_TEST_SUITE(SteinbergGuinan, lane_types);

TYPED_TEST(SteinbergGuinan, IsItsFormula) {
  using V = TypeParam;
  using T = scalar_t<V>;
  EXPECT_TRUE((Strength<strength::steinberg_guinan, V> && VariableShearModulus<strength::steinberg_guinan, V>));
  for (const auto& m : {aluminium, copper})
    for (const double p : {-2e9, 0.0, 5e9, 80e9})
      for (const double eta : {0.9, 1.0, 1.4})
        for (const double t : {0.0, 300.0, 800.0, 1500.0})
          for (const double strain : {0.0, 0.01, 0.3, 5.0}) {
            const long double f = 1 + static_cast<long double>(m.pressure_factor) * p / std::cbrt(static_cast<long double>(eta)) -
                                  static_cast<long double>(m.temperature_factor) * (t - 300.0L);
            const long double hardened = std::min<long double>(m.yield * std::pow(1 + m.beta * static_cast<long double>(strain), static_cast<long double>(m.n)), m.largest_yield);
            const double melting = 1200, factor = t >= melting ? 0 : std::max(static_cast<double>(f), 0.0);
            const V at[] = {V(T(p)), V(T(eta * m.reference_density)), V(T(t)), V(T(melting))};
            test::expect_close(static_cast<double>(lane(m.shear_modulus_at(at[0], at[1], at[2], at[3]), 0)), m.shear_modulus * factor, test::epsilon<V>(40), m.shear_modulus, "G");
            const V y = m.yield_stress(V(T(strain)), V(T(0)), at[2], at[3], at[0], at[1]);
            test::expect_close(static_cast<double>(lane(y, 0)), static_cast<double>(hardened) * factor, test::epsilon<V>(80), m.largest_yield, "Y");
            EXPECT_LE(lane(m.yield_floor(at[2], at[3], at[0], at[1]), 0), lane(y, 0) * (1 + test::epsilon<V>(8)));
          }
}

TEST(SteinbergGuinanNumbers, WorkedOutByHand) {
  // aluminium 6061-T6 at 20 GPa, V/V0 = 0.85, 500 K: f = 1 + 6.52e-11 20e9 0.85^(1/3) - 6.16e-4 200 = 1 + 1.304 0.947268 - 0.1232 = 2.112038
  const double rho = 2703 / 0.85;
  EXPECT_NEAR(aluminium.shear_modulus_at(20e9, rho, 500.0, 2000.0), 27.6e9 * 2.112038, 1e-5 * 27.6e9);
  // eps = 0.1: (1 + 12.5)^0.1 = exp(0.1 ln 13.5) = exp(0.2602690) = 1.297279; Y = 0.29 1.297279 2.112038 = 0.794570 GPa
  EXPECT_NEAR(aluminium.yield_stress(0.1, 0.0, 500.0, 2000.0, 20e9, rho), 0.794570e9, 1e-5 * 0.29e9);
  // copper, eps = 0.5 at zero pressure, V0 and 300 K: (1 + 18)^0.45 = exp(0.45 2.944439) = exp(1.3249976) = 3.762176; Y = 0.451461 GPa
  EXPECT_NEAR(copper.yield_stress(0.5, 0.0, 300.0, 1356.0, 0.0, 8930.0), 0.451461e9, 2e-6 * 0.45e9);
  EXPECT_EQ(copper.yield_stress(5.0, 0.0, 300.0, 1356.0, 0.0, 8930.0), 0.64e9) << "never above Y_max f";
  EXPECT_EQ(copper.yield_stress(0.5, 0.0, 1356.0, 1356.0, 0.0, 8930.0), 0) << "molten";
  EXPECT_EQ(copper.shear_modulus_at(5e9, 8930.0, 1400.0, 1356.0), 0);
  EXPECT_EQ(copper.shear_modulus_at(-40e9, 8000.0, 300.0, 1356.0), 0) << "a tension beyond the linear form";
}

TEST(SteinbergGuinanParameters, AreCheckedWithASentence) {
  auto m = aluminium;
  EXPECT_NO_THROW(m.validate());
  m.largest_yield = 0.1e9;
  try {
    m.validate();
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "Steinberg-Guinan Y_max = 1e+08 Pa: must be at least Y0 (unit: Pa)");
  }
  for (double strength::steinberg_guinan::* x : {&strength::steinberg_guinan::shear_modulus, &strength::steinberg_guinan::beta, &strength::steinberg_guinan::pressure_factor,
                                                 &strength::steinberg_guinan::reference_density}) {
    auto bad = copper;
    bad.*x = std::nan("");
    EXPECT_THROW(bad.validate(), bad_parameter);
  }
}

// ---- in a material --------------------------------------------------------------------------------------------------------------------
using rz = space::axisymmetric;
using thermal = eos::isentrope_temperature<eos::mie_grueneisen>;
using metal = material<thermal, strength::steinberg_guinan, failure::none, viscosity::none>;
using solid_point = test::material_point<metal, rz>;
const double rho0 = 2785;
metal solid(double yield = 0.29e9) {
  auto s = aluminium;
  s.yield = yield;
  s.largest_yield = std::max(yield, s.largest_yield);
  return {thermal{eos::mie_grueneisen{{.constant_gamma = true}}}, s, {}, {}};
}

TEST(VariableModulus, TrialReturnAndWaveSpeedUseTheStatesOwn) {
  solid_point m(solid(), 1.1 * rho0, 0.1e6);
  const auto at = m.thermodynamics();
  const double g = aluminium.shear_modulus_at(at.pressure, 1.1 * rho0, at.temperature, at.melting_temperature);
  EXPECT_GT(g, 1.3 * 27.6e9) << "the state must differ from the reference";
  EXPECT_NEAR(m.get<field::shear_modulus>(), g, 1e-9 * g);
  const auto report = m.advance({0, 1e3, 0, 0, 0}, 1e-9, false);
  EXPECT_NEAR(m.get<field::deviator>(2), g * 1e-6, 1e-6 * g * 1e-6);
  EXPECT_NEAR(report.limit.rate, std::sqrt(at.sound_speed_squared + 4.0 / 3 * g / (1.1 * rho0)) / (0.4 * 1e-4), 1e-6 * report.limit.rate);
  for (int i = 0; i < 40; ++i) m.advance({0, 1e6, 0, 0, 0}, 1e-9, false); // far beyond yield
  const double y = aluminium.yield_stress(m.get<field::plastic_strain>(), 0.0, at.temperature, at.melting_temperature, at.pressure, 1.1 * rho0);
  const rz::deviator<double> s{m.get<field::deviator>(0), m.get<field::deviator>(1), m.get<field::deviator>(2)};
  EXPECT_NEAR(std::sqrt(1.5 * rz::contract(s, s)), y, 0.01 * y) << "the law is asked with the strain of the step before";
}

TEST(VariableModulus, KeepsTheElasticStrainAndTheEnergy) {
  // sheared below yield, then compressed: G grows, and the stress with it; what the shear energy gains the heat loses
  solid_point m(solid(20e9), rho0, 0);
  for (int i = 0; i < 100; ++i) m.advance({0, 1e5, 0, 0, 0}, 1e-9);
  const double g0 = m.get<field::shear_modulus>(), s0 = m.get<field::deviator>(2);
  double work = 0;
  const double e0 = m.get<field::energy>();
  for (int i = 0; i < 1000; ++i) work += m.advance({-1e5, 0, 0, -1e5, -1e5}, 1e-9).work_energy;
  const double g1 = m.get<field::shear_modulus>();
  EXPECT_GT(g1, 1.5 * g0);
  EXPECT_NEAR(m.get<field::deviator>(2) / s0, g1 / g0, 1e-9 * g1 / g0);
  EXPECT_NEAR(m.get<field::energy>() - e0, work / 1e-6, 1e-9 * work / 1e-6) << "e changes by work alone";
  const rz::deviator<double> s{m.get<field::deviator>(0), m.get<field::deviator>(1), m.get<field::deviator>(2)};
  EXPECT_NEAR(m.material().shear_energy(m.p, 0), rz::contract(s, s) / (4 * g1 * m.density()), 1e-9 * rz::contract(s, s) / (4 * g1 * m.density()));
}

TEST(VariableModulus, MeltingTurnsTheElasticShearEnergyToHeat) {
  solid_point m(solid(20e9), rho0, 0.3e6); // 293 + 343 K
  for (int i = 0; i < 1000; ++i) m.advance({0, 1e5, 0, 0, 0}, 1e-9);
  const double shear = m.material().shear_energy(m.p, 0);
  ASSERT_GT(shear, 2e4);
  const double before = m.thermodynamics().temperature, e = m.get<field::energy>();
  m.get<field::energy>() = e + 0.4e6; // heated beyond melting from outside
  m.advance({1e-3, 0, 0, 0, 0}, 1e-9);
  EXPECT_EQ(m.get<field::shear_modulus>(), 0);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(m.get<field::deviator>(c), 0);
  EXPECT_EQ(m.material().shear_energy(m.p, 0), 0);
  EXPECT_NEAR(m.thermodynamics().temperature - before, (0.4e6 + shear) / 875, 0.01) << "all of it is heat now";
  m.get<field::energy>() = e; // frozen again: it starts without stress and is elastic
  m.advance({1e-3, 0, 0, 0, 0}, 1e-9);
  m.advance({0, 1e5, 0, 0, 0}, 1e-9);
  EXPECT_GT(m.get<field::shear_modulus>(), 1e10);
  EXPECT_NEAR(m.get<field::deviator>(2), m.get<field::shear_modulus>() * 1e-4, 1e-3 * m.get<field::shear_modulus>() * 1e-4);
}

TEST(VariableModulus, APointAtRestKeepsItsStateAndItsStep) {
  using viscous = material<thermal, strength::steinberg_guinan, failure::none>;
  test::material_point<viscous, rz> m(viscous{thermal{eos::mie_grueneisen{{.constant_gamma = true}}}, aluminium, {}}, 1.05 * rho0, 0.1e6);
  const double moving = m.advance({1e-3, 0, 0, 0, 0}, 1e-9).limit.rate, g = m.get<field::shear_modulus>();
  EXPECT_NEAR(m.advance({0, 0, 0, 0, 0}, 1e-9).limit.rate, moving, 1e-9 * moving);
  EXPECT_EQ(m.get<field::shear_modulus>(), g);
}

} // namespace
} // namespace bolide
