// SPDX-License-Identifier: MIT
// Isotherms, liquid-vapour equilibrium and vaporisation thresholds: van der Waals' fluid in closed form, aluminium as regression.
#include "bolide/analysis/isotherm.hpp"
#include "bolide/analysis/saturation.hpp"
#include "bolide/analysis/vaporisation_thresholds.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/gsl/ode.hpp"
#include "bolide/gsl/root.hpp"
#include "unit/analysis/van_der_waals.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;

double pressure(double rho, double T) { return 8.0 / 3 * rho * T / (1 - rho / 3) - 3 * rho * rho; } // van der Waals

// ---- isotherms --------------------------------------------------------------------------------------------------------------------------
TEST(Isotherm, IdealGasAndVanDerWaals) {
  const eos::ideal_gas air;
  for (const auto& s : analysis::isotherm(air, 300, {0.1, 1.2, 40})) {
    EXPECT_EQ(s.what, eos::status::ok);
    EXPECT_NEAR(s.pressure / (0.4 * 717.5 * 300 * s.density), 1, 1e-12);
    EXPECT_NEAR(s.energy / (717.5 * 300), 1, 1e-12);
  }
  const test::van_der_waals fluid;
  for (const auto& s : analysis::isotherm(fluid, 0.9, {0.01, 0.5, 1.0, 2.0, 2.9}))
    EXPECT_NEAR(s.pressure, pressure(s.density, 0.9), 1e-8 * (1 + std::abs(s.pressure))) << s.density;
}

TEST(Isotherm, ColdOneIsTheColdCurve) { // the table of cold curves, sharp cut-off
  const eos::grover mixed{cold::cai_ye{cold::cutoff::sharp}, phase::mixed{}};
  const double rho0 = mixed.reference_density(), table[][2] = {{0.5, 256.7}, {0.7, 62.48}, {0.9, 10.357}, {1.1, -5.837}};
  for (const auto& row : table) {
    const auto s = analysis::cold_isotherm(mixed, {rho0 / row[0]}).front();
    EXPECT_NEAR(s.pressure / 1e9, row[1], 0.0006 * std::abs(row[1])) << row[0];
    EXPECT_EQ(to_region(s.region), region::solid);
  }
}

TEST(Isotherm, RoomTemperatureOfAluminium) { // measured 220 GPa at V/V0 = 0.5 (Greene 1994); Cai-Ye is stiffer
  const eos::grover mixed{cold::cai_ye{}, phase::mixed{}};
  const auto ambient = eos::ambient_state(mixed, 300);
  const auto at = analysis::isotherm(mixed, 300, {ambient.density, ambient.density / 0.5});
  EXPECT_NEAR(at[0].pressure, 0, 1e5);
  EXPECT_NEAR(at[0].energy / ambient.energy, 1, 1e-9);
  EXPECT_NEAR(at[1].pressure / 1e9, 238.6, 0.1); // 8.5 % high
  EXPECT_THROW(analysis::isotherm(mixed, 0, {2700}), bad_parameter);
  EXPECT_THROW(analysis::isotherm(mixed, 300, {-1}), bad_parameter);
}

// ---- equilibrium ------------------------------------------------------------------------------------------------------------------------
TEST(Saturation, EqualAreasOfVanDerWaals) {
  const test::van_der_waals fluid;
  for (const double T : {0.5, 0.7, 0.9, 0.99, 0.999}) {
    const auto s = analysis::saturation(fluid, T);
    ASSERT_EQ(s.what, eos::status::ok) << T;
    EXPECT_NEAR(pressure(s.liquid_density, T) / s.pressure, 1, 1e-8) << T;
    EXPECT_NEAR(pressure(s.vapour_density, T) / s.pressure, 1, 1e-8) << T;
    const double l = 1 / s.liquid_density, v = 1 / s.vapour_density;
    EXPECT_NEAR(8.0 / 3 * T * std::log((v - 1.0 / 3) / (l - 1.0 / 3)) + 3 * (1 / v - 1 / l), s.pressure * (v - l), 1e-9) << T;
    const double entropy = 8.0 / 3 * std::log((v - 1.0 / 3) / (l - 1.0 / 3)); // c_v is the same in both
    EXPECT_NEAR(s.latent_heat / (T * entropy), 1, 1e-8) << T;
    EXPECT_GT(s.liquid_density, 1);
    EXPECT_LT(s.vapour_density, 1);
  }
  EXPECT_NEAR(analysis::saturation(fluid, 0.9).pressure, 0.6469983518, 1e-9); // of the literature
}

TEST(Saturation, CriticalPointOfHelm) { // published: 20 750 K, 0.89 g/cc, 8.8 GPa
  const eos::grover helm{cold::tabulated{cold::cai_ye{}}, phase::helm{}};
  const auto below = analysis::saturation(helm, 20700);
  ASSERT_EQ(below.what, eos::status::ok);
  EXPECT_NEAR(below.pressure / 1e9, 8.8, 0.05);
  EXPECT_NEAR(0.5 * (below.liquid_density + below.vapour_density), 890, 5);
  EXPECT_EQ(analysis::saturation(helm, 20800).what, eos::status::no_solution);
  EXPECT_EQ(analysis::saturation(helm, 10000).what, eos::status::no_solution); // its vapour lies beyond x = 5
}

TEST(Saturation, BoilingPointAndNoLoop) {
  const test::van_der_waals fluid;
  const double p = analysis::saturation(fluid, 0.73).pressure;
  const auto s = analysis::saturation_at_pressure(fluid, p, 0.5, 1.2);
  EXPECT_EQ(s.what, eos::status::ok);
  EXPECT_NEAR(s.temperature, 0.73, 1e-9);
  EXPECT_EQ(analysis::saturation(fluid, 1.01).what, eos::status::no_solution);
  EXPECT_EQ(analysis::saturation(eos::ideal_gas{}, 300).what, eos::status::no_solution);
  EXPECT_EQ(analysis::saturation_at_pressure(fluid, 1.5, 0.5, 1.2).what, eos::status::no_solution); // above the critical pressure
  EXPECT_TRUE(std::isnan(analysis::saturation_at_pressure(fluid, 1.5, 0.5, 1.2).pressure));
  EXPECT_EQ(analysis::saturation_at_pressure(fluid, p, 0.8, 1.2).what, eos::status::no_solution);   // boils below the range
}

// ---- thresholds -------------------------------------------------------------------------------------------------------------------------
TEST(VaporisationThresholds, EntropyOfVanDerWaals) { // S = c_v ln T + (8/3) ln(V - 1/3) behind the shock is that of the marked states
  const test::van_der_waals fluid;
  const double rho = 2.3, T = 0.5;
  const auto ahead = eos::state_at(fluid, rho, fluid.energy(rho, T));
  const auto marked = analysis::boiling_states(fluid, 0.3, 0.5, 1);
  const auto found = analysis::find_vaporisation_thresholds(fluid, ahead, marked, 0.1, 50);
  const auto entropy = [&](double density, double e) {
    return fluid.c_v * std::log((e + 3 * density) / fluid.c_v) + 8.0 / 3 * std::log(1 / density - 1.0 / 3);
  };
  EXPECT_NEAR(entropy(found.begin.density, found.begin.energy), entropy(marked.begin_density, marked.begin_energy), 1e-8);
  EXPECT_NEAR(entropy(found.end.density, found.end.energy), entropy(marked.end_density, marked.end_energy), 1e-8);
  EXPECT_GT(found.end.pressure, found.begin.pressure);
  EXPECT_THROW(analysis::find_vaporisation_thresholds(fluid, ahead, marked, 0.1, 0.2), bad_parameter);
}

/// The other way round, by GSL: the isentrope through (rho, e) is compressed until the Hugoniot of `ahead` is met. Pressure there.
template <class Eos> double meets_hugoniot(const Eos& eos, const eos::material_state& ahead, double rho, double e, double highest) {
  const auto energy = [&](double to) {
    const auto slope = [&](double y, const std::array<double, 1>& v) {
      return std::array<double, 1>{-eos.evaluate(std::exp(-y), v[0]).pressure * std::exp(y)};
    };
    return gsl::integrate<1>(slope, {e}, -std::log(rho), -std::log(to), 1e-11, 1e-6)[0];
  };
  const auto off = [&](double to) { // e - e0 = (p + p0)(V0 - V)/2
    const double at = energy(to), p = eos.evaluate(to, at).pressure;
    return at - ahead.energy - 0.5 * (p + ahead.pressure) * (1 / ahead.density - 1 / to);
  };
  const double met = gsl::root(off, 1.2 * ahead.density, highest, 1e-12);
  return eos.evaluate(met, energy(met)).pressure;
}

TEST(VaporisationThresholds, TillotsonAluminium) {
  const eos::tillotson al;
  const auto ahead = eos::ambient_state(al);
  const auto found = analysis::find_vaporisation_thresholds(al, ahead, analysis::tillotson_states(al));
  EXPECT_NEAR(found.begin.pressure / meets_hugoniot(al, ahead, 2700, 3.0e6, 8000), 1, 1e-7);
  EXPECT_NEAR(found.end.pressure / meets_hugoniot(al, ahead, 2700, 13.9e6, 8000), 1, 1e-7);
  EXPECT_NEAR(found.begin.pressure / 1e9, 162.5, 0.1);
  EXPECT_NEAR(found.end.pressure / 1e9, 437.7, 0.1);
  EXPECT_NEAR(2 * found.begin.particle_speed, 10000, 500); // aluminium on aluminium: vapour is reported above 10 km/s
}

TEST(VaporisationThresholds, AluminiumByItsBoilingPoint) { // 2743 K and 10.9 MJ/kg (handbook); 300 K start
  const eos::grover helm{cold::tabulated{cold::cai_ye{}}, phase::helm{}};
  const auto ahead = eos::ambient_state(helm, 300);
  const auto marked = analysis::heating_states(helm, 2743, 10.9e6);
  const auto found = analysis::find_vaporisation_thresholds(helm, ahead, marked);
  EXPECT_NEAR(found.begin.pressure / meets_hugoniot(helm, ahead, marked.begin_density, marked.begin_energy, 8000), 1, 1e-6);
  EXPECT_NEAR(found.end.pressure / meets_hugoniot(helm, ahead, marked.end_density, marked.end_energy, 8000), 1, 1e-6);
  EXPECT_NEAR(found.begin.pressure / 1e9, 208.2, 0.2);
  EXPECT_NEAR(found.end.pressure / 1e9, 583.8, 0.5);
}
} // namespace
