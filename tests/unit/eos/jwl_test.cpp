// SPDX-License-Identifier: MIT
// JWL: the formula, its derivatives, and the Chapman-Jouguet state of TNT, which follows from the six parameters and the energy alone.
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/query.hpp"
#include "unit/eos/surface.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

/// TNT, the LLNL explosives handbook's set.
const eos::jwl_parameters tnt{.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.30};
constexpr double tnt_energy = 7.0e9 / 1630; // J/kg

TEST(Jwl, FormulaWrittenOut) {
  const eos::jwl eos{tnt};
  for (const double V : {0.6, 1.0, 2.0, 7.0, 12.0}) {
    const double e = 3e6, E = 1630 * e; // J/m3 of the unburnt
    const double p = 371.2e9 * (1 - 0.30 / (4.15 * V)) * std::exp(-4.15 * V) + 3.231e9 * (1 - 0.30 / (0.95 * V)) * std::exp(-0.95 * V) + 0.30 * E / V;
    expect_close(eos.evaluate(1630 / V, e).pressure, p, 1e-13, 0, "p at V = " + std::to_string(V));
  }
  expect_close(eos.evaluate(1e-4, 3e6).pressure, 0.30 * 1e-4 * 3e6, 1e-12, 0, "an ideal gas of ratio 1.3 at the end");
  expect_close(eos.evaluate(1e-4, 3e6).sound_speed_squared, 1.3 * 0.3 * 3e6, 1e-12, 0, "and its sound speed");
}

TEST(Jwl, SoundSpeedAndLanes) {
  const eos::jwl eos{tnt};
  test::derivatives_are_right(eos, {0.02, 0.1, 0.5, 1.0, 1.36, 1.9}, {1e5, 2e6, 1e7});
  test::lanes_agree(eos, {0.02, 0.1, 0.5, 1.0, 1.36, 1.9}, {1e5, 2e6, 1e7}, 1e7);
  test::finite_everywhere(eos);
}

TEST(Jwl, ChapmanJouguetStateOfTnt) {
  const eos::jwl eos{tnt};
  const double V0 = 1 / 1630.0;
  const auto detonated = [&](double V) { // p on the Hugoniot of the products, e = e0 + p (V0 - V)/2; p is linear in e
    const auto cold = eos.evaluate(1 / V, 0.0);
    return (cold.pressure + cold.pressure_energy * tnt_energy) / (1 - cold.pressure_energy * (V0 - V) / 2);
  };
  const auto speed = [&](double V) { return V0 * std::sqrt(detonated(V) / (V0 - V)); };
  double low = 0.6 * V0, high = 0.95 * V0; // the Chapman-Jouguet point is where the Rayleigh line is least steep
  for (int i = 0; i < 200; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (speed(a) < speed(b) ? high : low) = speed(a) < speed(b) ? b : a;
  }
  const double V = 0.5 * (low + high), p = detonated(V), D = speed(V);
  EXPECT_NEAR(D, 6930, 0.005 * 6930); // the handbook's
  EXPECT_NEAR(p, 21.0e9, 0.02 * 21.0e9);
  const double e = tnt_energy + p * (V0 - V) / 2; // sonic: D - u = D V/V0 = c, exact
  EXPECT_NEAR(std::sqrt(eos.evaluate(1 / V, e).sound_speed_squared), D * V / V0, 1e-4 * D);
}

TEST(Jwl, BoxAndQuery) {
  const eos::jwl eos{tnt};
  EXPECT_EQ(eos::query(eos, 1630, tnt_energy).what, eos::status::ok);
  EXPECT_EQ(eos::query(eos, 3300, tnt_energy).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(eos, 1630, -1).what, eos::status::outside_validity);
  EXPECT_NEAR(eos::query(eos, 1000, tnt_energy).grueneisen, 0.30, 1e-15);
}

TEST(Jwl, EveryParameterMustBeGiven) {
  const auto refused = [](eos::jwl_parameters p) { EXPECT_THROW(eos::jwl{p}, bad_parameter); };
  refused({});
  refused({.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95}); // omega left out
  refused({.rho0 = 1630, .A = 371.2e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.30}); // B left out
  auto bad = tnt;
  bad.R1 = 0.9;
  refused(bad);
  bad = tnt, bad.omega = 1.0;
  refused(bad);
}
} // namespace
