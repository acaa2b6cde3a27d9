// SPDX-License-Identifier: MIT
// Mie-Grueneisen beyond the linear us-up line: the quadratic Hugoniot, its guard, and the three expansions.
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/query.hpp"
#include "unit/eos/surface.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

/// The shock state that belongs to a particle velocity, from the us-up line and the jump conditions, put back into the model.
void hugoniot_is_on_the_surface(const eos::mie_grueneisen& eos, double highest_up) {
  const auto& q = eos.values();
  for (double up = 50; up < highest_up; up += 150) {
    const double us = q.c0 + q.s * up + q.s2 * up * up, rho = q.rho0 * us / (us - up);
    if (rho > eos.guard_density()) break;
    expect_close(eos.evaluate(rho, 0.5 * up * up).pressure, q.rho0 * us * up, 1e-10, 0, "p at up = " + std::to_string(up));
  }
}

const eos::mie_grueneisen curved_up{{.rho0 = 2785, .c0 = 5328, .s = 1.25, .s2 = 1.2e-5}};
const eos::mie_grueneisen curved_down{{.rho0 = 2785, .c0 = 5328, .s = 1.5, .s2 = -2.5e-5}};

TEST(QuadraticHugoniot, ShockStatesLieOnTheSurface) {
  hugoniot_is_on_the_surface(eos::mie_grueneisen{}, 20000);
  hugoniot_is_on_the_surface(curved_up, 20000);
  hugoniot_is_on_the_surface(curved_down, 20000);
}

TEST(QuadraticHugoniot, GoesOverIntoTheLinearOne) {
  const eos::mie_grueneisen linear{}, nearly{{.s2 = 1e-28}};
  for (const double eta : {0.3, 0.999, 1.0, 1.2, 2.0, 3.3, 3.5, 5.0})
    for (const double e : {-1e5, 0., 1e7}) {
      const auto a = linear.evaluate(eta * 2785, e), b = nearly.evaluate(eta * 2785, e);
      expect_close(b.pressure, a.pressure, 1e-9, 1e9, "p at eta = " + std::to_string(eta));
      expect_close(b.sound_speed_squared, a.sound_speed_squared, 1e-8, 1e6, "c^2 at eta = " + std::to_string(eta));
    }
  expect_close(nearly.guard_density(), linear.guard_density(), 1e-8, 0, "guard");
}

TEST(QuadraticHugoniot, GuardIsContinuousAndWithoutPole) {
  for (const auto* eos : {&curved_up, &curved_down}) {
    const double guard = eos->guard_density();
    EXPECT_GT(guard, 1.5 * 2785);
    for (const double e : {0., 1e8}) {
      const auto a = eos->evaluate(guard * (1 - 1e-13), e), b = eos->evaluate(guard * (1 + 1e-13), e);
      expect_close(a.pressure, b.pressure, 1e-9, 1e9, "p");
      expect_close(a.sound_speed_squared, b.sound_speed_squared, 1e-9, 1e6, "c^2");
    }
    double last = 0;
    for (double rho = 2785; rho < 60000; rho *= 1.01) {
      EXPECT_GE(eos->evaluate(rho, 0.0).pressure, last);
      last = eos->evaluate(rho, 0.0).pressure;
    }
    EXPECT_TRUE(eos->outside_validity(guard * 1.01, 0.0));
  }
}

TEST(QuadraticHugoniot, SoundSpeedAndLanes) {
  for (const auto* eos : {&curved_up, &curved_down}) {
    test::derivatives_are_right(*eos, {0.6, 0.95, 1.1, 1.5, 1.9}, {-1e5, 1e6, 3e7});
    test::lanes_agree(*eos, {0.6, 0.9, 1.02, 1.5, 1.9}, {-1e5, 1e6, 3e7}, 3e7);
    test::finite_everywhere(*eos);
  }
}

const eos::mie_grueneisen fading{{.fading_expansion = true}};

TEST(FadingExpansion, IsTheSameInCompressionAndSmoothAtReferenceDensity) {
  const eos::mie_grueneisen plain;
  for (const double eta : {1.0, 1.001, 1.5, 3.0, 4.5}) {
    EXPECT_DOUBLE_EQ(fading.evaluate(eta * 2785, 3e6).pressure, plain.evaluate(eta * 2785, 3e6).pressure);
    EXPECT_DOUBLE_EQ(fading.evaluate(eta * 2785, 3e6).sound_speed_squared, plain.evaluate(eta * 2785, 3e6).sound_speed_squared);
  }
  for (const double e : {0., 1e6, 1e8}) {
    const auto a = fading.evaluate(2785 * (1 - 1e-12), e), b = fading.evaluate(2785 * (1 + 1e-12), e);
    expect_close(a.pressure, b.pressure, 1e-9, 1e9, "p");
    expect_close(a.sound_speed_squared, b.sound_speed_squared, 1e-9, 1e6, "c^2 (with constant_gamma it jumps by gamma0 e)");
    expect_close(a.pressure_energy, b.pressure_energy, 1e-9, 0, "dp/de");
  }
}

TEST(FadingExpansion, IsSaneInStrongExpansion) {
  const eos::mie_grueneisen plain;
  const double e = 30e6; // a vaporised metal
  EXPECT_GT(plain.evaluate(2.785, e).sound_speed_squared, 1e12); // the convention of the literature: c grows without bound
  for (double eta = 1; eta > 1e-6; eta *= 0.8) {
    const auto r = fading.evaluate(eta * 2785, e);
    EXPECT_LT(r.sound_speed_squared, 4e8) << eta;
    EXPECT_GT(r.sound_speed_squared, 0) << eta;
    EXPECT_GT(r.pressure, 0) << eta;
  }
  const auto gas = fading.evaluate(2785e-6, e);
  expect_close(gas.pressure, 2. / 3 * 2785e-6 * e, 1e-4, 0, "the ideal gas at the end");
  expect_close(gas.sound_speed_squared, 10. / 9 * e, 1e-4, 0, "and its sound speed");
  EXPECT_NEAR(fading.evaluate(2785 * 2. / 3, 0.0).pressure, -4. / 27 * 2785 * 5328. * 5328., 1); // the greatest cold pull
  double bound = 0; // the binding energy: integral of -p_ref/rho^2 from rho0 to 0
  for (int i = 0; i < 100000; ++i) {
    const double y = (i + 0.5) * 1e-5;
    bound -= fading.evaluate(y * 2785, 0.0).pressure / (2785 * y * y) * 1e-5;
  }
  EXPECT_NEAR(bound, 0.5 * 5328. * 5328., 1e-4 * bound);
}

TEST(FadingExpansion, SoundSpeedAndLanes) {
  test::derivatives_are_right(fading, {1e-3, 0.1, 0.4, 0.8, 0.99, 1.2, 3.0}, {-1e5, 1e6, 3e7});
  test::lanes_agree(fading, {1e-3, 0.1, 0.4, 0.8, 1.2, 3.0}, {-1e5, 1e6, 3e7}, 3e7);
  test::finite_everywhere(fading);
}

TEST(MieGrueneisenBox, StandsForTheKindOfExpansion) {
  EXPECT_EQ(eos::query(eos::mie_grueneisen{}, 0.3 * 2785, 1e6).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(eos::mie_grueneisen{{.constant_gamma = true}}, 0.3 * 2785, 6e7).what, eos::status::ok);
  EXPECT_EQ(eos::query(fading, 1e-3 * 2785, 3e7).what, eos::status::ok);
  EXPECT_EQ(eos::query(fading, 0.6 * 2785, 0).what, eos::status::unstable); // the spinodal of the cold pull
}

TEST(MieGrueneisenParameters, BadOnesAreRefused) {
  const auto refused = [](eos::mie_grueneisen_parameters p) { EXPECT_THROW(eos::mie_grueneisen{p}, bad_parameter); };
  refused({.s2 = std::nan("")});
  refused({.s = 0.9, .s2 = -1e-6});
  refused({.constant_gamma = true, .fading_expansion = true});
  refused({.fading_expansion = true, .gamma_far = 3});
  refused({.gamma0 = 6, .s2 = 1e-5}); // p_ref would fall before the guard
  refused({.gamma0 = 0.5, .fading_expansion = true}); // gamma_far is 2/3
}
TEST(MieGrueneisenParameters, GammaFarCountsOnlyWhereExpansionFades) {
  const eos::mie_grueneisen soft{{.gamma0 = 0.5}}, set{{.gamma0 = 0.5, .gamma_far = 0.1}};
  for (const double rho : {1500., 2785., 4000.}) {
    EXPECT_EQ(soft.evaluate(rho, 1e6).pressure, set.evaluate(rho, 1e6).pressure);
    EXPECT_NEAR(soft.evaluate(rho, 1e6).pressure - soft.evaluate(rho, 0.).pressure, 0.5 * 2785 * 1e6, 1e-3);
  }
  const eos::mie_grueneisen fades{{.gamma0 = 0.5, .fading_expansion = true, .gamma_far = 0.4}};
  EXPECT_NEAR(fades.evaluate(1e-6 * 2785, 1e6).pressure, 0.4 * 1e-6 * 2785 * 1e6, 0.1); // less the cold pull, 0.08 Pa
}
} // namespace
