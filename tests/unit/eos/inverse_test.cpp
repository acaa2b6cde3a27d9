// SPDX-License-Identifier: MIT
// Inversions: there and back on every model and branch, which of several roots is given, and every status that is not ok.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/inverse.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/shifted_reference.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/lanes.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

template <class Phase> const auto& metal() {
  static const eos::grover<cold::tabulated, Phase> g{cold::tabulated{cold::cai_ye{}}};
  return g;
}

/// e -> T, p -> e, and (p, e), (p, T) -> rho for states of a model; the guess is 3 % off.
template <class Eos> int there_and_back(const Eos& eos, double eta_low, double eta_high, double e_low, double e_high) {
  int tried = 0;
  for (double eta = eta_low; eta < eta_high; eta += 0.137)
    for (double above = e_low; above < e_high; above *= 2.3) {
      const double rho = eta * eos.reference_density();
      double e = above;
      if constexpr (ThermalEquationOfState<Eos>) e += eos.evaluate(rho, 0.0).cold_energy;
      const eos::full_state s = eos::query(eos, rho, e);
      if (s.what != eos::status::ok) continue;
      const std::string at = " at eta = " + std::to_string(eta) + ", e = " + std::to_string(e);
      const auto by_p = eos::energy_at_pressure(eos, rho, s.pressure);
      EXPECT_EQ(by_p.what, eos::status::ok) << at;
      expect_close(by_p.value, e, 1e-11, s.sound_speed_squared, "e(rho, p)" + at);
      const auto rho_e = eos::density_at_pressure_energy(eos, s.pressure, e, 1.03 * rho);
      EXPECT_EQ(rho_e.what, eos::status::ok) << at;
      if (rho_e.what == eos::status::ok)
        expect_close(eos.evaluate(rho_e.value, e).pressure, s.pressure, 1e-10, rho * s.sound_speed_squared, "p(rho(p, e))" + at);
      if constexpr (ThermalEquationOfState<Eos>) {
        const auto by_t = eos::energy_at_temperature(eos, rho, s.temperature);
        EXPECT_EQ(by_t.what, eos::status::ok) << at;
        if (std::isinf(s.specific_heat)) { // the plateau: where it begins
          EXPECT_LE(by_t.value, e) << at;
        } else expect_close(by_t.value, e, 1e-11, std::abs(s.cold_energy) + s.sound_speed_squared, "e(rho, T)" + at);
      }
      ++tried;
    }
  return tried;
}

TEST(Inverse, ThereAndBackOnEveryBranch) {
  EXPECT_GT(there_and_back(metal<phase::mixed>(), 0.75, 3.0, 1e4, 1e8), 150);
  EXPECT_GT(there_and_back(metal<phase::helm>(), 0.75, 3.0, 1e4, 1e8), 150);
  EXPECT_GT(there_and_back(eos::mie_grueneisen{}, 0.8, 3.3, 1e4, 1e8), 150);
  EXPECT_GT(there_and_back(eos::tillotson{}, 0.8, 3.3, 1e4, 1e8), 150);
  EXPECT_GT(there_and_back(eos::ideal_gas{}, 0.1, 5.0, 1e4, 1e8), 300);
  EXPECT_GT(there_and_back(eos::stiffened_gas{}, 0.8, 1.6, 1e4, 5e6), 30);
  EXPECT_GT(there_and_back(eos::isentrope_temperature{eos::mie_grueneisen{}}, 0.8, 3.3, 1e4, 1e8), 150);
  EXPECT_GT(there_and_back(eos::shifted_reference{eos::mie_grueneisen{}, 2e5}, 0.8, 3.3, 1e4, 1e8), 150);
}

TEST(Inverse, AgreesWithClosedForms) {
  const eos::ideal_gas air;
  EXPECT_NEAR(eos::energy_at_temperature(air, 1.2, 300).value, 717.5 * 300, 1e-8);
  EXPECT_NEAR(eos::energy_at_pressure(air, 1.2, 1e5).value, 1e5 / (0.4 * 1.2), 1e-6);
  EXPECT_NEAR(eos::density_at_pressure_energy(air, 1e5, 2e5, 1.0).value, 1e5 / (0.4 * 2e5), 1e-12);
  EXPECT_NEAR(eos::density_at_pressure_temperature(air, 1e5, 300, 1.0).value, 1e5 / (0.4 * 717.5 * 300), 1e-12);
  const auto& al = metal<phase::mixed>();
  const double rho0 = al.reference_density(); // solid at V0: e = 3 R T + G T^2/2
  EXPECT_NEAR(eos::energy_at_temperature(al, rho0, 700).value, 3 * 308. * 700 + 0.016 * 700 * 700, 1e-5);
}

TEST(Inverse, OnTheMeltingPlateauTheEnergyIsWhereMeltingBegins) {
  const auto& al = metal<phase::mixed>();
  const double rho = 1.2 * al.reference_density(), t_m = al.evaluate(rho, 2e6).melting_temperature;
  const double solidus = al.evaluate(rho, 0.0).cold_energy + t_m * (3 * 308. + 0.016 * t_m);
  const auto e = eos::energy_at_temperature(al, rho, t_m);
  EXPECT_EQ(e.what, eos::status::ok);
  expect_close(e.value, solidus, 1e-12, 0, "solidus");
}

TEST(Inverse, OfSolidAndLiquidAtOneTemperatureTheSolidIsGiven) { // the paper's variant superheats its solid: T jumps down at E_m
  const auto& al = metal<phase::paper>();
  const double rho = al.reference_density();
  const auto e = eos::energy_at_temperature(al, rho, 1400);
  EXPECT_EQ(e.what, eos::status::ok);
  EXPECT_NEAR(e.value, 3 * 308. * 1400 + 0.016 * 1400 * 1400, 1e-5);
  EXPECT_EQ(to_region(al.evaluate(rho, e.value).region), region::solid);
  EXPECT_NEAR(al.evaluate(rho, 1.56e6).temperature, 1300, 120); // a liquid that is as hot exists
}

/// Van der Waals: p = rho R T/(1 - b rho) - a rho^2, e = c_v T - a rho. A user's own, with neither box nor borders.
struct van_der_waals {
  double a = 1000, b = 1e-3, R = 300, c_v = 450; // critical point rho 1/(3b), T 8a/(27 R b) = 987.7 K, p a/(27 b^2) = 37 MPa
  template <class V> thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V one(T(1)), t = (e + T(a) * rho) * T(1 / c_v), d = one / (one - T(b) * rho), p = T(R) * rho * t * d - T(a) * rho * rho;
    const V p_e = T(R / c_v) * rho * d, p_rho = T(R) * t * d * d + p_e * T(a) - T(2 * a) * rho;
    return {p, p_rho + p * p_e / (rho * rho), t, V(T(0)), one, -T(a) * rho, V(region_value<V>(region::gas)), p_e, V(T(1 / c_v))};
  }
  double reference_density() const { return 300; }
  eos::validity_box validity() const { return {1e-6, 999, -1e6, 1e8}; }
};

TEST(Inverse, OfThreeDensitiesTheStableOneNearestTheGuess) {
  const van_der_waals fluid;
  const double T = 850, p = 15e6;
  const auto pressure = [&](double rho) { return fluid.R * rho * T / (1 - fluid.b * rho) - fluid.a * rho * rho; };
  std::vector<double> roots; // by brute force on the closed form
  for (double rho = 1; rho < 900; rho += 0.01)
    if ((pressure(rho) - p) * (pressure(rho + 0.01) - p) < 0) roots.push_back(rho + 0.005);
  ASSERT_EQ(roots.size(), 3u);
  const auto at = [&](double guess) { return eos::density_at_pressure_temperature(fluid, p, T, guess); };
  for (const double guess : {roots[0] * 0.1, roots[0], roots[0] * 1.2}) EXPECT_NEAR(at(guess).value, roots[0], 0.01) << guess;
  for (const double guess : {roots[2] * 0.9, roots[2], roots[2] * 1.3}) EXPECT_NEAR(at(guess).value, roots[2], 0.01) << guess;
  const double near_vapour = roots[1] * 0.8, near_liquid = roots[1] * 1.2; // the middle root, nearest to both, falls with density
  EXPECT_NEAR(at(near_vapour).value, std::log(near_vapour / roots[0]) < std::log(roots[2] / near_vapour) ? roots[0] : roots[2], 0.01);
  EXPECT_NEAR(at(near_liquid).value, std::log(near_liquid / roots[0]) < std::log(roots[2] / near_liquid) ? roots[0] : roots[2], 0.01);
  EXPECT_NEAR(at(std::sqrt(roots[0] * roots[2]) * 1.001).value, roots[2], 0.01);
  EXPECT_NEAR(at(std::sqrt(roots[0] * roots[2]) * 0.999).value, roots[0], 0.01);
  expect_close(pressure(at(800).value), p, 1e-10, 1e8, "p of the answer");
}

TEST(Inverse, NoAnswerIsNoNumber) {
  const auto& al = metal<phase::mixed>();
  const double rho0 = al.reference_density();
  const auto expect = [](const eos::inverse& r, eos::status what, const char* which) {
    EXPECT_EQ(r.what, what) << which << " " << eos::name(r.what);
    EXPECT_TRUE(std::isnan(r.value)) << which;
  };
  expect(eos::energy_at_pressure(al, 1.5 * rho0, 1e9), eos::status::below_cold_energy, "p below the cold curve's");
  expect(eos::energy_at_temperature(al, 6 * rho0, 3000), eos::status::outside_validity, "rho beyond the table");
  expect(eos::energy_at_temperature(al, rho0, 1e7), eos::status::outside_validity, "T above the box");
  expect(eos::energy_at_pressure(eos::tillotson{}, 2700, 1e18), eos::status::outside_validity, "p above the box");
  expect(eos::energy_at_pressure(eos::tillotson{}, 1e-9, 1e5), eos::status::outside_validity, "rho below the box");
  expect(eos::density_at_pressure_energy(al, 1e10, 1e12, rho0), eos::status::outside_validity, "e above the box");
  expect(eos::density_at_pressure_energy(al, 1e10, 1e6, 9 * rho0), eos::status::outside_validity, "guess outside the box");
  expect(eos::density_at_pressure_energy(al, -1e12, 1e6, rho0), eos::status::no_solution, "p below all");
  expect(eos::density_at_pressure_temperature(eos::ideal_gas{}, 0, 300, 1.2), eos::status::no_solution, "a gas has no p = 0");
  const auto& paper = metal<phase::paper>(); // p jumps down by GPa at V_j on the hot branch, the densities beyond cannot have it either
  const double rho_j = paper.reference_density() / 1.3471;
  const auto lower = paper.evaluate(rho_j * (1 - 1e-9), 1.2e7), upper = paper.evaluate(rho_j * (1 + 1e-9), 1.2e7);
  ASSERT_GT(upper.pressure, lower.pressure + 5e9);
  expect(eos::density_at_pressure_energy(paper, 0.5 * (lower.pressure + upper.pressure), 1.2e7, rho_j), eos::status::no_solution, "in the jump");
}

TEST(Inverse, ImpossibleQuestionsAreRefused) {
  const eos::ideal_gas air;
  const double nan = std::nan("");
  EXPECT_THROW(eos::energy_at_temperature(air, -1, 300), bad_parameter);
  EXPECT_THROW(eos::energy_at_temperature(air, 1, 0), bad_parameter);
  EXPECT_THROW(eos::energy_at_pressure(air, 1, nan), bad_parameter);
  EXPECT_THROW(eos::density_at_pressure_energy(air, 1e5, nan, 1), bad_parameter);
  EXPECT_THROW(eos::density_at_pressure_energy(air, 1e5, 1e5, 0), bad_parameter);
  EXPECT_THROW(eos::density_at_pressure_temperature(air, 1e5, -1, 1), bad_parameter);
}
} // namespace
