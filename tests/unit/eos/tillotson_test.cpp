// SPDX-License-Identifier: MIT
// Tillotson: one test for each trap that implementations have fallen into, and every branch against its formula differentiated by hand.
#include "bolide/eos/cold_expansion_cut.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/pressure_cutoff.hpp"
#include "bolide/eos/query.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/surface.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

const eos::tillotson aluminium;
/// alpha and beta apart, so that one taken for the other shows.
const eos::tillotson uneven{{.alpha = 3, .beta = 7}};

struct branch {
  long double p, p_rho, p_e;
  long double c2(long double rho) const { return p_rho + p * p_e / (rho * rho); }
};
/// The two formulas and their derivatives in long double, written from the definitions.
branch condensed(const eos::tillotson_parameters& q, long double rho, long double e) {
  const long double eta = rho / q.rho0, mu = eta - 1, w = e / (q.E0 * eta * eta) + 1;
  const long double w_rho = -2 * e / (q.E0 * eta * eta * eta * q.rho0), w_e = 1 / (q.E0 * eta * eta);
  return {(q.a + q.b / w) * rho * e + q.A * mu + q.B * mu * mu,
          (q.a + q.b / w) * e - q.b / (w * w) * w_rho * rho * e + (q.A + 2 * q.B * mu) / q.rho0,
          (q.a + q.b / w) * rho - q.b / (w * w) * w_e * rho * e};
}
branch vapour(const eos::tillotson_parameters& q, long double rho, long double e) {
  const long double eta = rho / q.rho0, mu = eta - 1, z = 1 / eta - 1, w = e / (q.E0 * eta * eta) + 1, z_rho = -q.rho0 / (rho * rho);
  const long double w_rho = -2 * e / (q.E0 * eta * eta * eta * q.rho0), w_e = 1 / (q.E0 * eta * eta);
  const long double fall = expl(-q.alpha * z * z), cold = q.A * mu * expl(-q.beta * z), hot = q.b * rho * e / w, inner = hot + cold;
  const long double inner_rho = q.b * e / w - hot / w * w_rho + q.A / q.rho0 * expl(-q.beta * z) - q.beta * z_rho * cold;
  return {q.a * rho * e + inner * fall,
          q.a * e + (inner_rho - 2 * q.alpha * z * z_rho * inner) * fall,
          q.a * rho + (q.b * rho / w - hot / w * w_e) * fall};
}
branch exact(const eos::tillotson_parameters& q, long double rho, long double e) {
  if (rho >= q.rho0 || e <= q.E_iv) return condensed(q, rho, e);
  const branch hot = vapour(q, rho, e), cold = condensed(q, rho, e);
  if (e >= q.E_cv) return hot;
  const long double k = (e - q.E_iv) / (q.E_cv - q.E_iv), k_e = 1 / (q.E_cv - q.E_iv);
  return {k * hot.p + (1 - k) * cold.p, k * hot.p_rho + (1 - k) * cold.p_rho, k * hot.p_e + (1 - k) * cold.p_e + k_e * (hot.p - cold.p)};
}

TEST(Tillotson, EveryBranchToNineDigits) { // traps b and f: c^2 has p p_e/rho^2, and in the transition the derivative of the weight
  int seen[4] = {0, 0, 0, 0};
  for (const auto* eos : {&aluminium, &uneven})
    for (double eta = 0.15; eta < 4; eta += 0.0931)
      for (double e = -2e5; e < 1e9; e += 1.3e5 + 0.2 * std::abs(e)) {
        const double rho = eta * 2700;
        if (eos->outside_validity(rho, e)) continue;
        const auto r = eos->evaluate(rho, e);
        const branch b = exact(eos->values(), rho, e);
        const double sum = static_cast<double>(fabsl(b.p_rho) + fabsl(b.p * b.p_e) / (rho * rho));
        const std::string at = " at eta = " + std::to_string(eta) + ", e = " + std::to_string(e);
        expect_close(r.pressure, static_cast<double>(b.p), 1e-12, 75e9, "p" + at);
        expect_close(r.sound_speed_squared, static_cast<double>(b.c2(rho)), 1e-11, sum, "c^2" + at);
        expect_close(r.pressure_energy, static_cast<double>(b.p_e), 1e-12, rho, "dp/de" + at);
        ++seen[rho >= 2700 ? 0 : e <= 3.0e6 ? 1 : e < 13.9e6 ? 2 : 3];
      }
  for (const int n : seen) EXPECT_GT(n, 50);
}

TEST(Tillotson, WeightsAreTheRightWayRound) { // trap a: swapped weights make p jump at E_iv and E_cv
  for (const double eta : {0.3, 0.5, 0.7, 0.9, 0.99}) {
    const double rho = 2700 * eta;
    const auto at = [&](double e) { return uneven.evaluate(rho, e).pressure; };
    expect_close(at(3.0e6 * (1 + 1e-12)), at(3.0e6 * (1 - 1e-12)), 1e-9, 1e9, "p at E_iv");
    expect_close(at(13.9e6 * (1 + 1e-12)), at(13.9e6 * (1 - 1e-12)), 1e-9, 1e9, "p at E_cv");
    const branch cold = condensed(uneven.values(), rho, 3.0e6), hot = vapour(uneven.values(), rho, 3.0e6);
    EXPECT_GT(std::abs(static_cast<double>(cold.p - hot.p)), 1e7) << "the jump it would be";
  }
}

TEST(Tillotson, AlphaBelongsToTheSquare) { // trap c: exp(-beta z) on the cold term, exp(-alpha z^2) on all
  const double rho = 1800, e = 20e6, z = 0.5, eta = rho / 2700, hot = 1.63 * rho * e / (e / (5e6 * eta * eta) + 1);
  const double right = 0.5 * rho * e + (hot + 75.2e9 * (eta - 1) * std::exp(-7 * z)) * std::exp(-3 * z * z);
  const double swapped = 0.5 * rho * e + (hot + 75.2e9 * (eta - 1) * std::exp(-3 * z)) * std::exp(-7 * z * z);
  expect_close(uneven.evaluate(rho, e).pressure, right, 1e-13, 0, "p");
  EXPECT_GT(std::abs(right - swapped), 1e9);
}

TEST(Tillotson, ColdPullIsRawAndHasItsCures) { // trap d
  EXPECT_NEAR(aluminium.evaluate(0.8 * 2700, 0.0).pressure, -12.44e9, 0.01e9);
  EXPECT_LT(aluminium.evaluate(0.7 * 2700, 0.0).sound_speed_squared, 0);
  const eos::cold_expansion_cut ramp{aluminium}, step{aluminium, 0.8, 0.8};
  EXPECT_EQ(ramp.evaluate(0.87 * 2700, 0.0).pressure, 0);
  EXPECT_EQ(step.evaluate(0.799 * 2700, 0.0).pressure, 0);
  EXPECT_EQ(step.evaluate(0.801 * 2700, 0.0).pressure, aluminium.evaluate(0.801 * 2700, 0.0).pressure);
  const double pull = aluminium.evaluate(0.9 * 2700, 0.0).pressure;
  expect_close(ramp.evaluate(0.9 * 2700, 0.0).pressure, 0.5 * pull, 1e-12, 0, "half way up the ramp");
  for (const double rho : {0.875 * 2700, 0.925 * 2700}) {
    const auto a = ramp.evaluate(rho * (1 - 1e-13), 0.0), b = ramp.evaluate(rho * (1 + 1e-13), 0.0);
    expect_close(a.pressure, b.pressure, 1e-9, 1e9, "p at the ramp's ends");
  }
  EXPECT_EQ(ramp.evaluate(1350., 2e7).pressure, aluminium.evaluate(1350., 2e7).pressure); // hot vapour is not touched
  EXPECT_EQ(ramp.evaluate(2000., 2e7).sound_speed_squared, aluminium.evaluate(2000., 2e7).sound_speed_squared);
  test::derivatives_are_right(ramp, {0.89, 0.9, 0.91, 0.95, 1.2}, {0, 1e5, 2e7}, 1e-5);
  test::lanes_agree(ramp, {0.5, 0.8783, 0.9, 0.95, 1.2}, {0, 1e5, 2e7}, 1e8);
  EXPECT_THROW((eos::cold_expansion_cut{aluminium, 0.9, 0.8}), bad_parameter);
  EXPECT_THROW((eos::cold_expansion_cut{aluminium, 0.9, 1.1}), bad_parameter);
  EXPECT_EQ((eos::pressure_cutoff{aluminium, -1.5e9}).evaluate(0.8 * 2700, 0.0).pressure, -1.5e9);
}

TEST(Tillotson, NoCureLeavesATimeStepInfinite) { // trap e: c = 0 after a cut; the floor is a modifier, and never sqrt of a negative
  const eos::sound_speed_floor eos{eos::cold_expansion_cut{aluminium}, 0.1};
  const double c0 = std::sqrt(75.2e9 / 2700);
  for (double eta = 0.01; eta < 1.5; eta += 0.013)
    for (const double e : {0., 1e6, 1e7}) EXPECT_GE(std::sqrt(eos.evaluate(2700 * eta, e).sound_speed_squared), 0.1 * c0 * (1 - 1e-12)) << eta;
}

TEST(Tillotson, BordersBelongToWhatTheFormulaSays) { // trap g: eta = 1 with e >= E_iv, and both energies, strict or not
  EXPECT_EQ(aluminium.evaluate(2700., 8e6).sound_speed_squared, static_cast<double>(condensed(aluminium.values(), 2700, 8e6).c2(2700)));
  const auto c2_I = static_cast<double>(condensed(aluminium.values(), 2000, 3.0e6).c2(2000));
  const auto c2_III = static_cast<double>(vapour(aluminium.values(), 2000, 13.9e6).c2(2000));
  expect_close(aluminium.evaluate(2000., 3.0e6).sound_speed_squared, c2_I, 1e-12, 0, "E_iv belongs to I");
  expect_close(aluminium.evaluate(2000., 13.9e6).sound_speed_squared, c2_III, 1e-12, 0, "E_cv belongs to III");
}

TEST(Tillotson, E0IsNotTheVaporisationEnergyAndEnergiesArePerMass) { // traps h and i
  const eos::tillotson other{{.E0 = 6.0e6}};
  EXPECT_NE(other.evaluate(2800., 2e6).pressure, aluminium.evaluate(2800., 2e6).pressure);
  EXPECT_EQ(other.evaluate(2800., 0.0).pressure, aluminium.evaluate(2800., 0.0).pressure);
  EXPECT_STREQ(other.branch_name(2000, 3.0e6), "expanded_cold"); // E0 moves no border
  // 0.135 Mbar and 0.081 Mbar, the per-volume form of the same set in a vendor's manual, over 2700 kg/m3
  EXPECT_NEAR(0.135e11 / 2700, aluminium.values().E0, 1);
  EXPECT_NEAR(0.081e11 / 2700, aluminium.values().E_iv, 1);
}

TEST(Tillotson, TemperatureIsNotEnergyOverHeatCapacity) { // trap j
  const eos::isentrope_temperature warm{aluminium};
  const double rho = 1.5 * 2700; // on the Hugoniot: p = (e + ...) with e = p (V0 - V)/2
  double e = 1e6;
  for (int i = 0; i < 100; ++i) e = 0.5 * aluminium.evaluate(rho, e).pressure * (1 / 2700.0 - 1 / rho);
  EXPECT_GT(e / 875, 6000);
  EXPECT_LT(warm.evaluate(rho, e).temperature, 0.75 * e / 875);
}

TEST(Tillotson, AThinHotGasKeepsItsDigitsInFloat) { // the 10 GPa pull of I must not leave its round-off where its weight is 0
  for (const double eta : {1e-6, 1e-4, 1e-2})
    for (const double e : {13.9e6, 16.5e6, 1e9}) {
      const auto one = aluminium.evaluate(static_cast<float>(2700 * eta), static_cast<float>(e));
      const auto exact = aluminium.evaluate(static_cast<double>(static_cast<float>(2700 * eta)), static_cast<double>(static_cast<float>(e)));
      expect_close(static_cast<double>(one.pressure), exact.pressure, 1e-6, 0, "p");
      if (e > 13.9e6) expect_close(static_cast<double>(one.sound_speed_squared), exact.sound_speed_squared, 1e-5, 0, "c^2");
    }
}

TEST(Tillotson, IsFiniteEverywhere) { test::finite_everywhere(aluminium); }
} // namespace
