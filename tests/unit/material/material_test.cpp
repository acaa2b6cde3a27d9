// SPDX-License-Identifier: MIT
// The constitutive update on a single material point: strength, viscosity, failure and the void, the work, floors and step causes.
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/johnson_cook.hpp"
#include "bolide/strength/none.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/material/material_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bolide {
namespace {

using test::material_point;
using rz = space::axisymmetric;
const eos::mie_grueneisen fluid{{.constant_gamma = true}};
const double rho0 = 2785;

/// p = K (rho/rho0 - 1), no heat in it: every number of a test can be worked out by hand.
struct spring {
  double rho0 = 1000, c = 2000;
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(c * c) * (rho - T(rho0)), V(T(c * c))};
  }
  double reference_density() const { return rho0; }
};

// ---- strength -----------------------------------------------------------------------------------------------------------------------
TEST(RadialReturn, ElasticBelowYield) {
  material_point<material<spring, strength::elastic_perfectly_plastic, failure::none, viscosity::none>, rz> m({spring{}, {30e9, 0.3e9}, {}, {}}, 1000, 0);
  const double rate = 1e4, dt = 1e-9;
  m.advance({0, rate, 0, 0, 0}, dt); // simple shear v_r = rate z: s_rz = G rate dt
  EXPECT_NEAR(m.get<field::deviator>(2), 30e9 * rate * dt, 1e-6 * 30e9 * rate * dt);
  EXPECT_NEAR(m.get<field::deviator>(0), 0, 1);
  EXPECT_EQ(m.get<field::plastic_strain>(), 0);
}

TEST(RadialReturn, KeepsTheDirectionAndEndsOnTheYieldSurface) {
  const double g = 30e9, y = 0.3e9;
  material_point<material<spring, strength::elastic_perfectly_plastic, failure::none, viscosity::none>, rz> m({spring{}, {g, y}, {}, {}}, 1000, 0);
  // isochoric extension along r, the same compression shared by z and theta, and some shear: no spin-free direction preferred
  const rz::gradient<double> l{2e6, 1e6, 1e6, -1e6, -1e6};
  const double dt = 1e-8;
  const auto trial_rate = rz::deviatoric_rate(l);
  const auto report = m.advance(l, dt);
  rz::deviator<double> s, trial;
  for (std::size_t c = 0; c < 3; ++c) {
    s[c] = m.get<field::deviator>(static_cast<int>(c));
    trial[c] = 2 * g * dt * trial_rate[c];
  }
  const double trial_equivalent = std::sqrt(1.5 * rz::contract(trial, trial));
  ASSERT_GT(trial_equivalent, 2 * y) << "the test must yield";
  EXPECT_NEAR(std::sqrt(1.5 * rz::contract(s, s)), y, 1e-6 * y);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(s[c], trial[c] * y / trial_equivalent, 1e-6 * y);
  const double strain = (trial_equivalent - y) / (3 * g);
  EXPECT_NEAR(m.get<field::plastic_strain>(), strain, 1e-9);
  EXPECT_NEAR(report.plastic_work, m.get<field::volume>() * y * strain, 1e-9 * report.plastic_work);
}

TEST(RadialReturn, UniaxialStrainReachesTheHugoniotElasticLimit) {
  const double g = 27.6e9, y = 0.3e9;
  material_point<material<eos::mie_grueneisen, strength::elastic_perfectly_plastic, failure::none, viscosity::none>> m({fluid, {g, y}, {}, {}}, rho0, 0);
  for (int i = 0; i < 200; ++i) m.advance({-1e5}, 1e-9);
  EXPECT_NEAR(m.get<field::deviator>(), -2.0 / 3 * y, 1e-6 * y) << "|s_xx| = 2 Y/3 behind the precursor";
}

TEST(ElasticShear, EnergyInTheDeviatorIsNoHeat) {
  // slow isochoric shear far below yield: all work is elastic, the temperature must not rise by it
  material al{eos::isentrope_temperature{fluid}, strength::elastic_perfectly_plastic{27.6e9, 5e9}, failure::none{}, viscosity::none{}};
  material_point<decltype(al), rz> m(al, rho0, 0);
  for (int i = 0; i < 1000; ++i) m.advance({0, 1e4, 0, 0, 0}, 1e-9);
  const double shear = al.shear_energy(m.p, 0);
  EXPECT_GT(shear, 400) << "J/kg: the test must store some";
  EXPECT_NEAR(m.get<field::energy>(), shear, 0.002 * shear);
  EXPECT_NEAR(m.thermodynamics().temperature, 293, 0.05);
}

TEST(JaumannRotation, TurnsTheStressWithTheMaterial) {
  material_point<material<spring, strength::elastic_perfectly_plastic, failure::none, viscosity::none>, rz> m({spring{}, {30e9, 1e12}, {}, {}}, 1000, 0);
  m.get<field::deviator>(0) = 1e8;
  m.get<field::deviator>(1) = -1e8;
  const double w = 1e6, turn = std::acos(-1.0) / 4; // v_r = w z, v_z = -w r; 2 w t = pi/2
  const int n = 20000;
  for (int i = 0; i < n; ++i) m.advance({0, w, -w, 0, 0}, turn / w / n, false);
  // rotated by 45 degrees the stress is all in rz
  EXPECT_NEAR(m.get<field::deviator>(0), 0, 1e-3 * 1e8);
  EXPECT_NEAR(std::abs(m.get<field::deviator>(2)), 1e8, 1e-3 * 1e8);
}

// ---- work and energy ----------------------------------------------------------------------------------------------------------------
TEST(Work, CompressionFollowsTheIsentrope) {
  material al{eos::isentrope_temperature{fluid}, strength::none{}, failure::none{}, viscosity::none{}};
  material_point<decltype(al)> m(al, rho0, 0);
  for (int i = 0; i < 20000; ++i) m.advance({-1e6}, 1e-11);
  // the modifier's own isentrope through (rho0, 0, 293 K): e - e_s = 0 there, so T is T_s = 293 exp(Gamma0 (1 - V/V0))
  const double ratio = rho0 / m.density();
  EXPECT_NEAR(ratio, std::exp(-0.2), 1e-4);
  // (the stored energy is half a step ahead: material.hpp)
  const double half_step = 0.5 * m.get<field::pressure>() / m.density() * 1e6 * 1e-11;
  EXPECT_NEAR(m.thermodynamics().temperature - half_step / 875, 293 * std::exp(2 * (1 - ratio)), 0.01);
}

TEST(Work, ViscousHeatingIsItsOwnEntry) {
  material al{fluid, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, rho0, 0);
  const auto r = m.advance({-1e7}, 1e-10);
  const double q = al.viscosity.pressure(m.density(), 5328.0, -1e7, 1e-4);
  EXPECT_NEAR(m.get<field::viscous_pressure>(), q, 1e-6 * q);
  EXPECT_NEAR(r.viscous_heating, q * 1e7 * 1e-10 * m.get<field::volume>(), 1e-6 * r.viscous_heating);
  EXPECT_NEAR(r.work_energy, (q + m.get<field::pressure>()) * 1e7 * 1e-10 * m.get<field::volume>(), 1e-9 * r.work_energy);
  EXPECT_NEAR(m.get<field::energy>(), r.work_energy / 1e-6, 1e-9 * m.get<field::energy>());
}

// ---- failure and the void ------------------------------------------------------------------------------------------------------------
template <class Material> void pull(material_point<Material>& m, int steps, double rate = 1e6, double dt = 1e-9) {
  for (int i = 0; i < steps; ++i) m.advance({rate}, dt);
}

template <class Eos> class VoidOpening : public testing::Test {
public:
  static Eos make();
};
using thermal_mg = eos::isentrope_temperature<eos::mie_grueneisen>;
using thermal_tillotson = eos::isentrope_temperature<eos::tillotson>;
template <> thermal_mg VoidOpening<thermal_mg>::make() { return thermal_mg{fluid}; }
template <> thermal_tillotson VoidOpening<thermal_tillotson>::make() { return thermal_tillotson{eos::tillotson{}}; }
using void_cases = testing::Types<thermal_mg, thermal_tillotson>;
TYPED_TEST_SUITE(VoidOpening, void_cases);

TYPED_TEST(VoidOpening, KeepsTheMaterialAtZeroPressureAndConstantEnergy) {
  const auto eos = VoidOpening<TypeParam>::make();
  material al{eos, strength::none{}, failure::tension{1.5e9}};
  for (double e0 : {0.0, 0.3e6, 0.8e6}) { // cold and hot debris
    // start compressed so that p > 0 although hot
    material_point<decltype(al)> m(al, 1.05 * eos.reference_density(), e0);
    while (m.template get<field::failed>() == 0 && m.density() > 500) pull(m, 1);
    ASSERT_GT(m.template get<field::failed>(), 0) << "it must fail in tension";
    EXPECT_EQ(m.template get<field::pressure>(), 0) << "no tension left";
    const double e = m.template get<field::energy>();
    pull(m, 8);
    const auto state = al.eos.evaluate(m.own_density(), e);
    EXPECT_NEAR(state.pressure, 0, 1e-6 * m.own_density() * state.sound_speed_squared) << "p(V_m, e) = 0 after a few steps";
    pull(m, 1000); // the void opens wide
    EXPECT_EQ(m.template get<field::energy>(), e) << "a void does no work";
    EXPECT_EQ(m.template get<field::pressure>(), 0);
    EXPECT_EQ(m.template get<field::viscous_pressure>(), 0);
    EXPECT_GT(m.template get<field::volume>(), 2 * m.template get<field::material_volume>());
    EXPECT_NEAR(al.eos.evaluate(m.own_density(), e).pressure, 0, 1e-9 * m.own_density() * state.sound_speed_squared);
    // temperature of the material, not of the bulk: near 293 K + e/c_v less the work of heating, and far from the raw value
    const double t = m.thermodynamics().temperature, raw = al.eos.evaluate(m.density(), e).temperature;
    EXPECT_GT(t, 200);
    EXPECT_LT(t, 2000);
    EXPECT_GT(std::abs(t - raw), 100) << "the raw volume would say something else: the test can tell the two apart";
    // and closes again
    const double gap = std::log(m.template get<field::volume>() / m.template get<field::material_volume>());
    pull(m, static_cast<int>(gap / 1e-3) - 2, -1e6);
    EXPECT_EQ(m.template get<field::pressure>(), 0) << "still open";
    EXPECT_EQ(m.template get<field::energy>(), e);
    pull(m, 60, -1e6);
    EXPECT_GT(m.template get<field::pressure>(), 1e9) << "closed: it carries compression again";
    EXPECT_NEAR(m.own_density(), m.density(), 1e-12 * m.density());
    EXPECT_GT(m.template get<field::failed>(), 0) << "failure is for good";
  }
}

TEST(VoidOpeningFloat, WorksInSinglePrecision) {
  material al{thermal_mg{fluid}, strength::none{}, failure::tension{1.5e9}};
  material_point<decltype(al), space::planar_1d, float> m(al, rho0, 0.2e6);
  for (int i = 0; i < 500; ++i) m.advance({1e6}, 1e-9);
  ASSERT_GT(m.get<field::failed>(), 0);
  const auto state = al.eos.evaluate(m.own_density(), static_cast<double>(m.get<field::energy>()));
  EXPECT_NEAR(state.pressure, 0, 1e-5 * rho0 * state.sound_speed_squared);
}

TEST(SettledPoint, KeepsItsMaterialVolumeUntilItsEnergyChangesOrTheVoidCloses) {
  material al{thermal_mg{fluid}, strength::none{}, failure::tension{1.5e9}};
  material_point<decltype(al)> m(al, rho0, 0.2e6);
  while (m.get<field::failed>() < 2) m.advance({1e6}, 1e-9);
  const double settled = m.own_density();
  EXPECT_NEAR(al.eos.evaluate(settled, m.get<field::energy>()).pressure, 0, 1e-14 * rho0 * square(5328.0));
  pull(m, 100);
  EXPECT_EQ(m.own_density(), settled);
  EXPECT_GT(settled / m.density(), 1.1) << "the void went on opening";
  m.get<field::energy>() = 0.4e6;
  m.get<field::failed>() = 1;
  pull(m, 100);
  EXPECT_EQ(m.get<field::failed>(), 2);
  EXPECT_LT(m.own_density(), 0.99 * settled) << "hotter material takes more room";
  EXPECT_NEAR(al.eos.evaluate(m.own_density(), m.get<field::energy>()).pressure, 0, 1e-14 * rho0 * square(5328.0));
  while (m.get<field::pressure>() == 0) m.advance({-1e6}, 1e-9);
  EXPECT_EQ(m.get<field::failed>(), 1) << "closed";
}

TEST(FailedPoint, CarriesItsPressureWhileItExpandsFromCompression) {
  // molten at high pressure, then released: no void may open before the pressure is gone
  material al{thermal_mg{fluid}, strength::johnson_cook{}, failure::tension_or_melt{1.5e9}};
  material_point<decltype(al)> m(al, 1.5 * rho0, 10e6);
  m.advance({-1e5}, 1e-9);
  ASSERT_GT(m.get<field::failed>(), 0) << "it must have melted";
  double before = m.get<field::pressure>();
  ASSERT_GT(before, 1e11);
  for (int steps = 0; m.density() > 1.1 * rho0; ++steps) {
    m.advance({2e6}, 1e-9);
    ASSERT_EQ(m.own_density(), m.density()) << "step " << steps;
    ASSERT_NEAR(m.get<field::pressure>(), m.thermodynamics().pressure, 0.01 * before) << "step " << steps; // half a step of energy between them
    ASSERT_LT(m.get<field::pressure>(), before);
    before = m.get<field::pressure>();
  }
  while (m.get<field::pressure>() > 0) m.advance({2e6}, 1e-9);
  for (int i = 0; i < 50; ++i) m.advance({2e6}, 1e-9);
  EXPECT_GT(m.own_density(), 1.02 * m.density()) << "now there is a void";
  EXPECT_NEAR(al.eos.evaluate(m.own_density(), m.get<field::energy>()).pressure, 0, 1e-9 * rho0 * square(5328.0));
}

TEST(FailedPoint, CarriesNoShear) {
  material al{thermal_mg{fluid}, strength::johnson_cook{}, failure::tension_or_melt{1.5e9}};
  material_point<decltype(al)> m(al, rho0, 0);
  pull(m, 40);
  ASSERT_GT(m.get<field::failed>(), 0);
  EXPECT_EQ(m.get<field::deviator>(), 0);
  for (int i = 0; i < 500; ++i) m.advance({-1e6}, 1e-9); // recompression
  EXPECT_GT(m.get<field::pressure>(), 0);
  EXPECT_EQ(m.get<field::deviator>(), 0);
}

TEST(FailedPoint, MeltingFailsWithoutTension) {
  material al{thermal_mg{fluid}, strength::johnson_cook{}, failure::tension_or_melt::melt_only()};
  material_point<decltype(al)> m(al, rho0, 1.0e6); // 293 + 1143 K at V0
  m.advance({1e-3}, 1e-9);
  EXPECT_GT(m.get<field::failed>(), 0);
  EXPECT_GT(m.get<field::pressure>(), 0) << "it still carries compression";
}

TEST(FailedPoint, ReleasesTheElasticEnergyOfTensionIntoTheLedger) {
  material al{spring{}, strength::none{}, failure::tension{1e8}, viscosity::none{}};
  material_point<decltype(al)> m(al, 1000, 0);
  double released = 0;
  while (m.get<field::failed>() == 0) released += m.advance({1e5}, 1e-9).failure_release;
  const double p = 1e8; // p^2/(2 rho c^2) per volume at failure
  EXPECT_NEAR(released, p * p / (2 * m.density() * 4e6) * m.get<field::volume>(), 0.01 * released);
}

// A particle at rest (|L| dt below round-off) keeps its state and is passed over: these tests move it by a hair.
// ---- each floor, once ----------------------------------------------------------------------------------------------------------------
TEST(Floors, SoundSpeed) {
  material al{eos::tillotson{}, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 2700, 0);
  for (int i = 0; i < 400; ++i) m.advance({1e6}, 1e-9, false); // cold expansion below eta = 0.75: c^2 < 0
  const auto r = m.advance({1e-3}, 1e-9, false);
  EXPECT_EQ(r.floors[floor_kind::sound_speed], 1u);
  EXPECT_NEAR(m.get<field::sound_speed>(), 0.05 * std::sqrt(al.eos.evaluate(2700.0, 0.0).sound_speed_squared), 1) << "5 % of the reference value";
}
TEST(Floors, ColdEnergy) {
  material al{thermal_mg{fluid}, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, rho0, 0);
  m.get<field::energy>() = -0.5e6; // far below 0 K
  EXPECT_EQ(m.advance({1e-3}, 1e-9).floors[floor_kind::cold_energy], 1u);
}
TEST(Floors, Validity) {
  material al{fluid, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 1.02 * fluid.guard_density(), 0);
  EXPECT_EQ(m.advance({1e-3}, 1e-9).floors[floor_kind::validity], 1u);
}
TEST(Floors, VoidIteration) {
  // a failed point far from zero pressure may change its volume by a quarter per step, no more
  material al{eos::mie_grueneisen{{.constant_gamma = true}}, strength::none{}, failure::tension{1.5e9}};
  material_point<decltype(al)> m(al, rho0, 0);
  pull(m, 40);
  ASSERT_GT(m.get<field::failed>(), 0);
  m.get<field::energy>() = 20e6; // an energy that belongs to a much larger volume
  m.get<field::failed>() = 1;
  pull(m, 200);
  m.get<field::material_volume>() = m.get<field::volume>() * 0.4;
  EXPECT_EQ(m.advance({1e6}, 1e-9).floors[floor_kind::void_iteration], 1u);
}
TEST(Floors, Expansion) {
  material al{fluid, strength::none{}, failure::tension{1.5e9}};
  al.expansion_limit = 10;
  material_point<decltype(al)> m(al, rho0, 0);
  for (int i = 0; i < 100; ++i) m.advance({1e8}, 1e-9);
  EXPECT_GT(m.advance({1e8}, 1e-9).floors[floor_kind::expansion], 0u);
  EXPECT_NEAR(m.get<field::volume>(), 10 * 1e-6 / rho0, 1e-6 * 10 * 1e-6 / rho0);
}
TEST(Floors, CountOnlyTheLanesThatExist) {
  material al{fluid, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 1.02 * fluid.guard_density(), 0); // one particle in a register of eight
  EXPECT_EQ(m.advance({1e-3}, 1e-9).floors[floor_kind::validity], 1u);
}

// ---- each cause of the time step, once ------------------------------------------------------------------------------------------------
TEST(StepCause, Sound) {
  material al{spring{}, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 1000, 0);
  const auto r = m.advance({1e-3}, 1e-9);
  EXPECT_EQ(r.limit.cause, step_cause::sound);
  EXPECT_EQ(r.limit.particle, 3u);
  EXPECT_NEAR(r.limit.rate, 2000 / (0.4 * 1e-4), 1);
}
TEST(StepCause, SoundFollowsTheStateNotTheStart) {
  material al{fluid, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, rho0, 0);
  const double before = m.advance({1e-3}, 1e-9).limit.rate;
  for (int i = 0; i < 300; ++i) m.advance({-1e6}, 1e-9);
  const double after = m.advance({1e-3}, 1e-9).limit.rate;
  EXPECT_GT(after / before, 1.5) << "a stiffer state asks for a shorter step";
}
TEST(StepCause, ShearStiffens) {
  const double g = 30e9;
  material al{spring{}, strength::elastic_perfectly_plastic{g, 1e9}, failure::none{}};
  material_point<decltype(al)> m(al, 1000, 0);
  EXPECT_NEAR(m.advance({1e-3}, 1e-9).limit.rate, std::sqrt(4e6 + 4.0 / 3 * g / 1000) / (0.4 * 1e-4), 1);
}
TEST(StepCause, Velocity) {
  material al{spring{}, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 1000, 0);
  m.get<field::velocity>() = 3000;
  const auto r = m.advance({1e-3}, 1e-9);
  EXPECT_EQ(r.limit.cause, step_cause::velocity);
  EXPECT_NEAR(r.limit.rate, 5000 / (0.4 * 1e-4), 1);
}
TEST(StepCause, Viscosity) {
  material al{spring{}, strength::none{}, failure::none{}, viscosity::bulk{1.5, 0.06}};
  material_point<decltype(al)> m(al, 1000, 0);
  const double d = 4e7;
  const auto r = m.advance({-d}, 1e-11, true, 0.1);
  EXPECT_EQ(r.limit.cause, step_cause::viscosity);
  const double q = 1.5 * 1e-4 * d + 0.06 * 2000;
  EXPECT_NEAR(r.limit.rate, (q + std::sqrt(q * q + 4e6)) / (0.1 * 1e-4), 1e-3 * r.limit.rate);
}
TEST(StepCause, Strain) {
  material al{spring{}, strength::none{}, failure::none{}};
  material_point<decltype(al)> m(al, 1000, 0);
  const auto r = m.advance({1e8}, 1e-11); // expansion: no viscosity
  EXPECT_EQ(r.limit.cause, step_cause::strain);
  EXPECT_NEAR(r.limit.rate, 4e8, 1);
}
TEST(StepCause, AVoidCarriesNoWave) {
  material al{fluid, strength::none{}, failure::tension{1.5e9}};
  material_point<decltype(al)> m(al, rho0, 0);
  pull(m, 60);
  EXPECT_EQ(m.advance({1.0}, 1e-9).limit.cause, step_cause::strain) << "nothing else is left";
}
TEST(StepCause, NotANumberIsTheShortestStepOfAll) {
  material al{thermal_mg{fluid}, strength::johnson_cook{}, failure::tension_or_melt{1.5e9}};
  material_point<decltype(al)> m(al, rho0, 0);
  m.get<field::energy>() = std::nan("");
  const auto r = m.advance({1e-3}, 1e-9);
  EXPECT_FALSE(r.limit.rate == r.limit.rate) << "NaN must not be hidden: rate " << r.limit.rate;
}
TEST(StepCause, NotANumberIsNotOverwrittenByALaterParticle) {
  material al{spring{}, strength::none{}, failure::none{}, viscosity::none{}};
  using columns = particles::columns<double, space::planar_1d, decltype(al)::particle_fields>;
  columns p;
  const int n = 40;
  for (std::uint32_t i = 0; i < n; ++i) p.append(i);
  for (std::size_t i = 0; i < n; ++i) p.get<field::mass>()[i] = 1e-6;
  al.initialise(p, 0, n, 1000, 0);
  p.get<field::velocity>()[2] = std::nan("");
  double l[1][chunk_size];
  for (auto& x : l[0]) x = 1e-3;
  update_report report;
  al.update<space::planar_1d>(p, 0, n, l, step_context<double>{1e-9, 1e-4, 0.4, 0, true}, report);
  EXPECT_FALSE(report.limit.rate == report.limit.rate);
  EXPECT_EQ(report.limit.particle, 2u);
}

TEST(AtRest, KeepsItsStateAndStillLimitsTheStep) {
  material al{thermal_mg{fluid}, strength::johnson_cook{}, failure::tension_or_melt{1.5e9}};
  material_point<decltype(al)> m(al, 1.01 * rho0, 1e4);
  m.advance({0}, 0); // the initial stress
  const double p = m.get<field::pressure>(), v = m.get<field::volume>();
  const double rate = m.advance({1e-3}, 1e-9).limit.rate;
  const auto r = m.advance({0}, 1e-9);
  EXPECT_NEAR(m.get<field::pressure>(), p, 1e-9 * p);
  EXPECT_NEAR(m.get<field::volume>(), v, 1e-11 * v);
  EXPECT_NEAR(r.limit.rate, rate, 1e-6 * rate);
  EXPECT_EQ(r.limit.cause, step_cause::sound);
}

// ---- parameters, fields ---------------------------------------------------------------------------------------------------------------
TEST(MaterialFields, AreThoseOfItsModels) {
  using fluid_material = material<eos::mie_grueneisen, strength::none, failure::none, viscosity::none>;
  using solid = material<thermal_mg, strength::johnson_cook, failure::tension_or_melt, viscosity::bulk, record::peak_pressure>;
  EXPECT_FALSE(fluid_material::particle_fields::contains<field::deviator>);
  EXPECT_FALSE(fluid_material::particle_fields::contains<field::sound_speed>);
  EXPECT_FALSE(fluid_material::particle_fields::contains<field::failed>);
  EXPECT_TRUE(solid::particle_fields::contains<field::deviator>);
  EXPECT_TRUE(solid::particle_fields::contains<field::material_volume>);
  EXPECT_TRUE(solid::particle_fields::contains<field::peak_pressure>);
}
TEST(MaterialRecord, KeepsThePeakPressure) {
  material al{fluid, strength::none{}, failure::none{}, viscosity::none{}, record::peak_pressure{}};
  material_point<decltype(al)> m(al, rho0, 0);
  for (int i = 0; i < 100; ++i) m.advance({-1e6}, 1e-9);
  const double peak = m.get<field::pressure>();
  for (int i = 0; i < 100; ++i) m.advance({1e6}, 1e-9);
  EXPECT_LT(m.get<field::pressure>(), 0.2 * peak);
  EXPECT_EQ(m.get<field::peak_pressure>(), peak);
}
TEST(MaterialParameters, BadStatesAreRefusedWithASentence) {
  material al{eos::tillotson{}, strength::none{}, failure::none{}};
  using point = material_point<decltype(al)>;
  EXPECT_THROW(point(al, -1, 0), bad_parameter);
  try {
    point(al, 1000, 0); // cold, far expanded: the surface is unstable there
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("sound speed squared of the initial state"), std::string::npos) << e.what();
  }
  strength::johnson_cook bad;
  bad.n = -1;
  EXPECT_THROW((material{thermal_mg{fluid}, bad, failure::none{}}), bad_parameter);
}

} // namespace
} // namespace bolide
