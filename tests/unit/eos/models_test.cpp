// SPDX-License-Identifier: MIT
// What is particular to each equation of state: Mie-Grueneisen's guard, Tillotson's borders, the modifiers, the initial states.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/lanes.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

TEST(MieGrueneisen, FormulaWrittenOut) {
  const eos::mie_grueneisen eos;
  const double rho = 3600, e = 2e6, eta = 1 - 2785 / rho, p_h = 2785 * 5328. * 5328. * eta / std::pow(1 - 1.338 * eta, 2);
  expect_close(eos.evaluate(rho, e).pressure, p_h * (1 - eta) + 2.0 * 2785 * e, 1e-14, 0, "compression");
  expect_close(eos.evaluate(2000., e).pressure, 2785 * 5328. * 5328. * (2000 / 2785. - 1) + 2.0 * 2785 * e, 1e-14, 0, "expansion");
}

TEST(MieGrueneisen, PressureAndSoundSpeedAreContinuousAtReferenceDensityAndGuard) {
  const eos::mie_grueneisen eos;
  EXPECT_NEAR(eos.guard_density() / 2785, 1 / (1 - 0.95 / 1.338), 1e-12);
  for (const double rho : {2785.0, eos.guard_density()})
    for (const double e : {0., 5e6, 5e8}) {
      const auto a = eos.evaluate(rho * (1 - 1e-13), e), b = eos.evaluate(rho * (1 + 1e-13), e);
      expect_close(a.pressure, b.pressure, 1e-10, 1e9, "p");
      expect_close(a.sound_speed_squared, b.sound_speed_squared, 1e-10, 1e6, "c^2");
    }
  double last = 0;
  for (double rho = 2785; rho < 60000; rho *= 1.01) { // through the pole at 3.96 rho0 and far beyond
    const auto p = eos.evaluate(rho, 0.0);
    EXPECT_GE(p.pressure, last);
    EXPECT_GT(p.sound_speed_squared, 0);
    last = p.pressure;
  }
}

TEST(MieGrueneisen, TheGuardIsReported) {
  const eos::mie_grueneisen eos;
  EXPECT_FALSE(eos.outside_validity(eos.guard_density() * 0.999, 0.0));
  EXPECT_TRUE(eos.outside_validity(eos.guard_density() * 1.001, 0.0));
  using V = pack<double, 4>;
  const auto mask = eos.outside_validity(test::ramp<V>(9000, 400), V(0));
  EXPECT_EQ(count(mask), 2); // 9000 9400 | 9800 10200, the guard is at 9602 kg/m3
}

TEST(Tillotson, FormulaWrittenOut) {
  const eos::tillotson eos;
  const auto I = [](double rho, double e) {
    const double eta = rho / 2700, mu = eta - 1;
    return (0.5 + 1.63 / (e / (5e6 * eta * eta) + 1)) * rho * e + 75.2e9 * mu + 65e9 * mu * mu;
  };
  const auto III = [](double rho, double e) {
    const double eta = rho / 2700, mu = eta - 1, z = 1 / eta - 1;
    return 0.5 * rho * e + (1.63 * rho * e / (e / (5e6 * eta * eta) + 1) + 75.2e9 * mu * std::exp(-5 * z)) * std::exp(-5 * z * z);
  };
  expect_close(eos.evaluate(3500., 20e6).pressure, I(3500, 20e6), 1e-13, 0, "I, compressed and hot");
  expect_close(eos.evaluate(2000., 2e6).pressure, I(2000, 2e6), 1e-13, 1e9, "I, expanded and cold");
  expect_close(eos.evaluate(2000., 15e6).pressure, III(2000, 15e6), 1e-13, 0, "III");
  const double e = 8e6, w = (e - 3e6) / (13.9e6 - 3e6);
  expect_close(eos.evaluate(2000., e).pressure, w * III(2000, e) + (1 - w) * I(2000, e), 1e-13, 0, "II");
}

TEST(Tillotson, PressureIsContinuousAtEveryBorderAndSoundSpeedJumpsWhereItMust) {
  const eos::tillotson eos;
  const double d = 1e-12;
  for (const double eta : {0.4, 0.7, 0.9})
    for (const double border : {3.0e6, 13.9e6}) {
      const auto a = eos.evaluate(2700 * eta, border * (1 - d)), b = eos.evaluate(2700 * eta, border * (1 + d));
      expect_close(a.pressure, b.pressure, 1e-10, 1e8, "p over energy");
    }
  for (const double e : {0., 2e6, 5e6, 20e6}) {
    const auto a = eos.evaluate(2700 * (1 - d), e), b = eos.evaluate(2700 * (1 + d), e);
    expect_close(a.pressure, b.pressure, 1e-9, 1e9, "p at rho0");
    expect_close(eos.evaluate(2700., e).pressure, b.pressure, 1e-9, 1e9, "rho0 itself belongs to I");
  }
  const eos::tillotson late({.E_cv = 15e6}); // the set that the printed jumps belong to
  const auto c2 = [&](double e) { return late.evaluate(0.7 * 2700, e).sound_speed_squared / 1e6; };
  EXPECT_NEAR(c2(3.0e6 * (1 - d)), 15.3, 0.05);
  EXPECT_NEAR(c2(3.0e6 * (1 + d)), 12.3, 0.05);
  EXPECT_NEAR(c2(15e6 * (1 - d)), 22.1, 0.05);
  EXPECT_NEAR(c2(15e6 * (1 + d)), 17.8, 0.05);
  EXPECT_NEAR(eos.evaluate(0.8 * 2700, 0.0).pressure / 1e9, -12.4, 0.05); // the cold pull, raw
  EXPECT_LT(eos.evaluate(0.74 * 2700 * 0.95, 0.0).sound_speed_squared, 0);
}

TEST(Tillotson, TheGuardIsReported) {
  const eos::tillotson eos;
  EXPECT_FALSE(eos.outside_validity(1350., -1.1e6)); // 0.9 E0 eta^2 = 1.125 MJ/kg at eta = 0.5
  EXPECT_TRUE(eos.outside_validity(1350., -1.2e6));
}

TEST(IsentropeTemperature, OfMieGrueneisenHasTheClosedForm) { // Gamma rho constant: T_s = T0 exp[gamma0 (1 - V/V0)]
  const eos::mie_grueneisen base;
  const eos::isentrope_temperature eos{base};
  EXPECT_NEAR(eos.evaluate(2785., 0.0).temperature, 293, 1e-9);
  for (const double eta : {0.15, 0.5, 0.9, 1.1, 1.5, 2.5, 3.3, 3.9}) {
    // e_s: integrate de = -p dV finely in V with the midpoint rule on the exact linear ODE's integrating factor.
    const double x1 = 1 / eta, n = 200000, h = (x1 - 1) / n, g = 2.0;
    double weighted = 0; // e_s exp(g x) = -integral p_ref V0 exp(g x) dx
    for (int i = 0; i < int(n); ++i) {
      const double x = 1 + h * (i + 0.5);
      weighted -= h * base.evaluate(2785 / x, 0.0).pressure / 2785 * std::exp(g * x);
    }
    const double e_s = weighted * std::exp(-g * x1), t_s = 293 * std::exp(g * (1 - x1));
    for (const double e : {e_s, e_s + 1e6, e_s - 3e5})
      expect_close(eos.evaluate(2785 * eta, e).temperature, t_s + (e - e_s) / 875, 2e-9, 300 + std::abs(e_s) / 875,
          "T at eta = " + std::to_string(eta));
  }
}

TEST(IsentropeTemperature, MeltsByLindemann) {
  const eos::isentrope_temperature eos{eos::mie_grueneisen{}};
  const auto solid = eos.evaluate(2785., 500e3), liquid = eos.evaluate(2785., 600e3);
  EXPECT_NEAR(solid.melting_temperature, 933, 1e-9);
  EXPECT_EQ(solid.melt_fraction, 0);
  EXPECT_EQ(to_region(solid.region), region::solid);
  EXPECT_EQ(liquid.melt_fraction, 1);
  EXPECT_EQ(to_region(liquid.region), region::liquid);
  const double x = 0.7, L = std::exp(2 * 1.7 * (1 - x)) * std::pow(x, -2 * (2.18 - 1.7 - 1. / 3));
  EXPECT_NEAR(eos.evaluate(2785 / x, 0.0).melting_temperature, 933 * L, 1e-9);
  const auto p = eos.evaluate(3500., 2e6);
  EXPECT_NEAR(p.cold_energy, 2e6 - 875 * p.temperature, 1e-3); // the energy at which T = 0
  EXPECT_LT(eos.evaluate(2785., -3e5).temperature, 0);         // reported, not floored
}

TEST(ScaledDensity, IsTheSameMetalWithAnotherAtomicMass) {
  const eos::mie_grueneisen base;
  const eos::scaled_density eos{base, 1.25};
  EXPECT_DOUBLE_EQ(eos.reference_density(), 1.25 * 2785);
  const auto a = base.evaluate(3000., 1e6), b = eos.evaluate(3750., 1e6);
  expect_close(b.pressure, 1.25 * a.pressure, 1e-13, 0, "p");
  expect_close(b.sound_speed_squared, a.sound_speed_squared, 1e-13, 0, "c^2");
  const eos::grover grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const auto alloy = eos::scaled_to(grover, 2785);
  const auto state = eos::ambient_state(alloy);
  EXPECT_NEAR(state.density, 2785, 1e-9);
  EXPECT_NEAR(state.sound_speed, eos::ambient_state(grover).sound_speed, 1e-6);
}

TEST(SoundSpeedFloor, ActsOnlyBelowAndTellsWhere) {
  const eos::grover raw{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  const eos::sound_speed_floor eos{raw, 0.1};
  const double least = 0.01 * raw.evaluate(raw.reference_density(), 0.0).sound_speed_squared, spinodal = raw.reference_density() / 1.6;
  EXPECT_NEAR(eos.least_sound_speed_squared(), least, 1e-6);
  EXPECT_LT(raw.evaluate(spinodal, 2.5e6).sound_speed_squared, 0);
  EXPECT_EQ(eos.evaluate(spinodal, 2.5e6).sound_speed_squared, eos.least_sound_speed_squared());
  EXPECT_EQ(eos.evaluate(3000., 1e6).sound_speed_squared, raw.evaluate(3000., 1e6).sound_speed_squared);
  EXPECT_TRUE(eos.floored(raw.evaluate(spinodal, 2.5e6)));
  EXPECT_FALSE(eos.floored(raw.evaluate(3000., 1e6)));
}

TEST(MaterialState, AmbientOfTheNewEquationOfState) {
  const eos::grover sharp{cold::cai_ye{cold::cutoff::sharp}, phase::mixed{}};
  EXPECT_NEAR(sharp.reference_density() / eos::ambient_state(sharp, 300).density, 1.0226, 5e-5);
  const eos::grover grover{cold::tabulated{cold::cai_ye{}}, phase::helm{}};
  const auto a = eos::ambient_state(grover, 300);
  const auto b = eos::ambient_state(grover, 301);
  // Against the table of docs/eos.md (helm, sharp cut-off): alpha_V 7.8e-5 /K; c_p from the enthalpy at p = 0.
  EXPECT_NEAR((a.density / b.density - 1) * 1e5, 7.8, 0.1);
  EXPECT_NEAR(b.energy - a.energy, 934 + 0.5 * 934 * 0.1, 60); // c_p = c_v (1 + alpha gamma T)
}

TEST(MaterialState, SaysSoWhenThereIsNone) {
  const eos::grover grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  EXPECT_THROW(eos::ambient_state(grover, -5), bad_parameter);
  try {
    eos::ambient_state(grover, 60000);
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("ambient temperature = 60000 K: must be one at which"), std::string::npos) << e.what();
  }
}

TEST(Models, BadParametersAreRefused) {
  const auto refused = [](auto build) { EXPECT_THROW(build(), bad_parameter); };
  refused([] { return eos::mie_grueneisen({.rho0 = -1}); });
  refused([] { return eos::mie_grueneisen({.s = 0.9}); });
  refused([] { return eos::mie_grueneisen({.gamma0 = 3.0}); });
  refused([] { return eos::mie_grueneisen({.guard = 1.0}); });
  refused([] { return eos::tillotson({.E_cv = 1e6}); });
  refused([] { return eos::tillotson({.A = 0}); });
  refused([] { return eos::tillotson({.rho0 = std::nan("")}); });
  refused([] { return eos::isentrope_temperature{eos::tillotson{}, 0.0}; });
  refused([] { return eos::isentrope_temperature{eos::tillotson{}, 875, -3}; });
  refused([] { return eos::scaled_density{eos::tillotson{}, 0.0}; });
  refused([] { return eos::sound_speed_floor{eos::tillotson{}, 2.0}; });
  try {
    eos::tillotson bad({.E0 = -2});
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "eos::tillotson E0 = -2 J/kg: must be > 0 (unit: J/kg)");
  }
}
} // namespace
