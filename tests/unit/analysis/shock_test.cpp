// SPDX-License-Identifier: MIT
// Hugoniot, release and melting thresholds against the tables of docs/eos.md, and the contact-line reference against an own calculation.
#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/melt_thresholds.hpp"
#include "bolide/analysis/oblique_shock_reference.hpp"
#include "bolide/analysis/release_isentrope.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/tillotson.hpp"

#include <gtest/gtest.h>

namespace {
using namespace bolide;

const cold::tabulated& lattice(cold::cutoff cut) {
  static const cold::tabulated none{cold::cai_ye{}}, sharp{cold::cai_ye{cold::cutoff::sharp}};
  return cut == cold::cutoff::none ? none : sharp;
}
const cold::cutoff none = cold::cutoff::none, sharp = cold::cutoff::sharp;

TEST(Hugoniot, OfMieGrueneisenIsItsOwnLine) {
  const eos::mie_grueneisen model;
  for (const double up : {0.1, 10., 500., 3320., 10000., 30000.}) {
    const auto s = analysis::hugoniot(model, eos::ambient_state(model), up);
    EXPECT_NEAR(s.shock_speed / (5328 + 1.338 * up), 1, up < 1 ? 1e-7 : 1e-9) << up;
    EXPECT_NEAR(s.energy, 0.5 * up * up, 1e-9 * up * up + 1e-6);
  }
}

TEST(Hugoniot, TableOfShockStatesAndFrontSpeeds) { // impact speed, us, p, rho/rho0, front, residual e
  const double rows[][6] = {
      {2, 6.666, 18.56, 1.1765, 2.006, 0.056}, {5, 8.673, 60.39, 1.4050, 5.090, 0.545},
      {6.64, 9.770, 90.34, 1.5147, 6.835, 1.022}, {7, 10.011, 97.58, 1.5376, 7.225, 1.142},
      {10, 12.018, 167.35, 1.7125, 10.57, 2.29}, {15, 15.363, 320.89, 1.9538, 16.49, 4.34}, {20, 18.708, 521.0, 2.1484, 0, 0},
      {70, 52.158, 5084, 3.0399, 0, 0}};
  const eos::mie_grueneisen model;
  const auto ahead = eos::ambient_state(model);
  for (const auto& r : rows) {
    const auto s = analysis::hugoniot(model, ahead, 500 * r[0]);
    EXPECT_NEAR(s.shock_speed / 1e3, r[1], 0.00051) << r[0];
    EXPECT_NEAR(s.pressure / 1e9, r[2], 0.0051 + (r[2] > 500 ? 0.5 : 0)) << r[0];
    EXPECT_NEAR(s.density / 2785, r[3], 0.000051) << r[0];
    if (r[4] == 0) continue;
    const auto released = analysis::release_isentrope(model, s.density, s.energy);
    EXPECT_NEAR((500 * r[0] + released.speed_gain) / 1e3, r[4], r[4] > 10 ? 0.0051 : 0.00056) << r[0];
    EXPECT_NEAR(released.energy / 1e6, r[5], r[5] > 2 ? 0.0051 : 0.00051) << r[0];
  }
}

TEST(Hugoniot, TableOfTheNewEquationOfState) { // us against up; computed with the sharp cut-off (the default is 2 to 6 m/s lower)
  const double rows[][4] = {
      {1000, 6777, 6698, 6753}, {2000, 8233, 8151, 8183}, {3000, 9680, 9597, 9543}, {3320, 10134, 10052, 9967},
      {4000, 11102, 11019, 10852}, {5000, 12504, 12639, 12126}, {6000, 14081, 13989, 13379}};
  const eos::grover paper{lattice(sharp), phase::paper{}};
  const eos::grover mixed{lattice(sharp), phase::mixed{}};
  const eos::grover standard{lattice(none), phase::mixed{}};
  const eos::tillotson tillotson;
  const auto cold = eos::cold_state(paper), warm = eos::ambient_state(mixed, 300), start = eos::ambient_state(tillotson);
  for (const auto& r : rows) {
    EXPECT_NEAR(analysis::hugoniot(paper, cold, r[0]).shock_speed, r[1], 0.6) << r[0];
    EXPECT_NEAR(analysis::hugoniot(mixed, warm, r[0]).shock_speed, r[2], 0.6) << r[0];
    EXPECT_NEAR(analysis::hugoniot(tillotson, start, r[0]).shock_speed, r[3], 0.6) << r[0];
    EXPECT_NEAR(analysis::hugoniot(standard, eos::ambient_state(standard, 300), r[0]).shock_speed, r[2], 4) << r[0];
  }
  const auto at = [](const auto& model, const auto& ahead) { return analysis::hugoniot(model, ahead, 3320); };
  EXPECT_NEAR(at(paper, cold).pressure / 1e9, 90.8, 0.051);
  EXPECT_NEAR(at(mixed, warm).pressure / 1e9, 88.0, 0.051);
  EXPECT_NEAR(at(tillotson, start).pressure / 1e9, 89.3, 0.051);
  EXPECT_NEAR(at(paper, cold).temperature, 2409, 1.1); // 2409.9 on the table of the sharp curve
  EXPECT_NEAR(at(mixed, warm).temperature, 3024, 0.6);
}

TEST(Hugoniot, WithinFourPercentOfTheMeasuredLine) { // LASL 6061: us = 5350 + 1.34 up, to 4 km/s
  const eos::grover mixed{lattice(none), phase::mixed{}};
  const auto ahead = eos::ambient_state(mixed);
  for (double up = 500; up <= 4000; up += 500) EXPECT_NEAR(analysis::hugoniot(mixed, ahead, up).shock_speed / (5350 + 1.34 * up), 1,
      0.04) << up;
}

TEST(Hugoniot, TakesTheLargestOfSeveralRootsAndNoJump) { // the paper's melting jump gives three sign changes, one of them no root
  const eos::grover paper{lattice(none), phase::paper{}};
  const auto ahead = eos::ambient_state(paper, 300);
  for (const double up : {4500., 4650., 4700., 4750., 4900.}) {
    int changes = 0;
    double largest = 0, last = -1;
    for (double compression = 0.2; compression < 0.6; compression += 1e-5) {
      const double us = up / compression, e = ahead.energy + ahead.pressure * up / (ahead.density * us) + 0.5 * up * up;
      const double f = paper.evaluate(ahead.density / (1 - compression), e).pressure - ahead.pressure - ahead.density * us * up;
      if (f * last < 0) {
        ++changes;
        if (largest == 0) largest = us;
      }
      last = f;
    }
    EXPECT_EQ(changes, up > 4550 && up < 4850 ? 3 : 1) << up;
    const auto s = analysis::hugoniot(paper, ahead, up);
    EXPECT_NEAR(s.shock_speed / largest, 1, 1e-4) << up;
    EXPECT_NEAR(paper.evaluate(s.density, s.energy).pressure / s.pressure, 1, 1e-9) << up;
    EXPECT_EQ(s.melt_fraction, up > 4550 ? 1 : 0) << up;
  }
}

TEST(Hugoniot, SaysSoWhenThereIsNone) {
  const eos::mie_grueneisen model;
  EXPECT_THROW(analysis::hugoniot(model, eos::ambient_state(model), -1), bad_parameter);
  const eos::tillotson soft({.a = 0.01, .b = 0, .A = 1e6, .B = 0});
  EXPECT_THROW(analysis::hugoniot(soft, eos::ambient_state(soft), 1e6), bad_parameter);
}

TEST(MeltThresholds, TableOfTheNewEquationOfState) {
  const auto of = [](const auto& model, const auto& ahead) { return analysis::find_melt_thresholds(model, ahead); };
  const eos::grover mixed{lattice(none), phase::mixed{}};
  const eos::grover helm{lattice(none), phase::helm{}};
  const auto m = of(mixed, eos::ambient_state(mixed, 300)), h = of(helm, eos::ambient_state(helm, 300));
  EXPECT_NEAR(m.hugoniot_begin.pressure / 1e9, 118, 0.51);
  EXPECT_NEAR(m.hugoniot_begin.temperature, 4560, 5);
  EXPECT_NEAR(m.hugoniot_end.pressure / 1e9, 146, 0.51);
  EXPECT_NEAR(m.hugoniot_end.temperature, 4836, 5);
  EXPECT_NEAR(m.release_begin.pressure / 1e9, 65.0, 0.06);
  EXPECT_NEAR(m.release_end.pressure / 1e9, 81.4, 0.06);
  EXPECT_NEAR(m.release_begin.particle_speed, 2692, 1);
  EXPECT_NEAR(m.release_end.particle_speed, 3145, 1);
  EXPECT_NEAR(h.hugoniot_begin.pressure / 1e9, 116, 0.51);
  EXPECT_NEAR(h.hugoniot_end.pressure / 1e9, 143, 0.51);
  EXPECT_NEAR(h.release_begin.pressure / 1e9, 65.3, 0.06);
  EXPECT_NEAR(h.release_end.pressure / 1e9, 82.3, 0.06);
  // The paper's variant has no mixed phase: its release jumps from superheated solid to liquid.
  const eos::grover paper{lattice(sharp), phase::paper{}};
  EXPECT_NEAR(of(paper, eos::ambient_state(paper, 300)).release_begin.pressure / 1e9, 80.1, 0.06);
  EXPECT_NEAR(of(paper, eos::cold_state(paper)).release_begin.pressure / 1e9, 100.7, 0.06);
  const eos::grover old{lattice(sharp), phase::mixed{}};
  const auto c = of(old, eos::cold_state(old));
  EXPECT_NEAR(c.hugoniot_begin.pressure / 1e9, 145, 0.51);
  EXPECT_NEAR(c.hugoniot_begin.temperature, 5157, 1);
  EXPECT_NEAR(c.hugoniot_end.pressure / 1e9, 174, 0.51);
  EXPECT_NEAR(c.release_begin.pressure / 1e9, 85.6, 0.06);
  EXPECT_NEAR(c.release_end.pressure / 1e9, 101.8, 0.06);
}

TEST(ReleaseIsentrope, ResidualEnergyOfTillotson) {
  const eos::tillotson model;
  const auto s = analysis::hugoniot(model, eos::ambient_state(model), 3320);
  EXPECT_NEAR(analysis::release_isentrope(model, s.density, s.energy).energy / 1e6, 1.07, 0.0051);
}

TEST(ReleaseIsentrope, KeepsTheEntropyOfTheClosedForm) { // Mie-Grueneisen with Gamma rho constant: T = T_H exp[gamma0 rho0 (V_H - V)]
  const eos::isentrope_temperature model{eos::mie_grueneisen{}};
  const auto s = analysis::hugoniot(model, eos::ambient_state(model), 3320);
  const auto end = analysis::release_isentrope(model, s.density, s.energy);
  EXPECT_LT(std::abs(end.pressure), 1e3);
  // c_v is constant, so along an isentrope T - T_s scales as T_s does.
  const double factor = std::exp(2.0 * 2785 * (1 / s.density - 1 / end.density));
  EXPECT_NEAR(end.temperature / (s.temperature * factor), 1, 1e-6);
}

TEST(ReleaseIsentrope, StopsAtTheWantedPressureAndRefusesTension) {
  const eos::mie_grueneisen model;
  const auto s = analysis::hugoniot(model, eos::ambient_state(model), 2000);
  EXPECT_NEAR(analysis::release_isentrope(model, s.density, s.energy, 10e9).pressure / 10e9, 1, 1e-9);
  EXPECT_THROW(analysis::release_isentrope(model, 2000, 0), bad_parameter);
}

TEST(ContactLine, ReferenceForThePapersImpact) {
  const eos::mie_grueneisen model;
  const auto ahead = eos::ambient_state(model);
  const auto r = analysis::oblique_shock_reference(model, ahead, 6640);
  EXPECT_NEAR(r.plane / 1e9, 90.34, 0.01);
  // Own calculation on the line us = c0 + s up: scan the turn over up for a given inflow, the angle by bisection.
  const double c0 = 5328, slope = 1.338, rho = 2785;
  const auto turn = [&](double q, double& p) {
    double best = 0;
    for (double up = 1; c0 + slope * up < q; up += 0.5) {
      const double us = c0 + slope * up, t = std::sqrt(q * q - us * us), d = std::atan(us / t) - std::atan((us - up) / t);
      if (d > best) best = d, p = rho * us * up;
    }
    return best;
  };
  double low = 0.1, high = 0.5, p = 0;
  for (int i = 0; i < 40; ++i) {
    const double beta = 0.5 * (low + high);
    (turn(3320 / std::sin(beta), p) > beta ? low : high) = beta;
  }
  EXPECT_NEAR(r.angle, low, 1e-5);
  EXPECT_NEAR(r.detachment / p, 1, 1e-3);
  EXPECT_NEAR(r.detachment / 1e9, 156.7, 0.2);
  EXPECT_NEAR(r.inflow, 3320 / std::sin(low), 1);
  EXPECT_GT(r.detachment, r.plane);
  // Stagnation: above the normal shock of speed q, and Bernoulli holds with the density between both ends.
  const double up = (r.inflow - c0) / slope, p1 = rho * r.inflow * up, v = r.inflow - up, rho1 = rho * r.inflow / v;
  EXPECT_GT(r.stagnation, p1 + 0.5 * rho1 * v * v);
  EXPECT_LT(r.stagnation, p1 + 0.5 * 1.3 * rho1 * v * v);
  EXPECT_EQ(r.reference(), r.stagnation);
}

TEST(ContactLine, GrowsWithSpeed) {
  const eos::mie_grueneisen model;
  double last = 0;
  for (const double U : {2000., 4000., 6000., 10000.}) {
    const auto r = analysis::oblique_shock_reference(model, eos::ambient_state(model), U);
    EXPECT_GT(r.detachment, last);
    EXPECT_GT(r.detachment, 1.3 * r.plane);
    last = r.detachment;
  }
}
} // namespace
