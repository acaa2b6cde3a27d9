// SPDX-License-Identifier: MIT
// The 2-D table: its reported bound against a million random points, borders and jumps kept apart, derivatives that belong to its own
// pressure, every lane type, and what happens outside.
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
#include "bolide/eos/reference.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/surface.hpp"

#include <random>

namespace {
using namespace bolide;
using bolide::test::expect_close;

template <class Phase> using metal = eos::grover<cold::tabulated, Phase>;
template <class Eos> const eos::tabulated<Eos>& table() {
  static const eos::tabulated<Eos> t = [] {
    if constexpr (requires(Eos e) { e.cold; }) return eos::tabulated{Eos{cold::tabulated{cold::cai_ye{}}}};
    else return eos::tabulated{Eos{}};
  }();
  return t;
}

template <class Eos> double lowest_energy(const Eos& eos, double rho) {
  if constexpr (ThermalEquationOfState<Eos>) return eos.evaluate(rho, 0.0).cold_energy;
  else return eos.validity().energy_low;
}

/// A point of the table's range: ln rho uniform, heights above the lowest energy over six decades.
struct point { double rho, e; };
template <class Table> class points {
public:
  points(const Table& t, unsigned seed) : t_(t), box_(t.validity()), random_(seed) {}
  point next() {
    for (;;) {
      const double rho = box_.density_low * std::pow(box_.density_high / box_.density_low, unit_(random_)), low = lowest_energy(t_.base(), rho);
      const double start = ThermalEquationOfState<Table> ? low : box_.energy_low;
      const double e = start + (box_.energy_high - start) * std::pow(10.0, -6 * unit_(random_));
      if (box_.contains(rho, e) && !eos::outside_of(t_.base(), rho, e)) return {rho, e};
    }
  }

private:
  const Table& t_;
  eos::validity_box box_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

/// Closer to a jump than the place of a border is known: either side may answer.
template <class Eos> bool on_border(const Eos& eos, double rho, double e) {
  for (const double border : eos::energy_borders_of(eos, rho))
    if (std::abs(e - border) < 1e-7 * std::abs(border)) return true;
  for (const double border : eos::density_borders_of(eos))
    if (std::abs(rho - border) < 1e-9 * border) return true;
  return false;
}

template <class Eos> struct Tables : ::testing::Test {};
using tabulated_models = ::testing::Types<metal<phase::mixed>, metal<phase::paper>, metal<phase::helm>, eos::tillotson, eos::mie_grueneisen,
                                          eos::ideal_gas, eos::stiffened_gas>;
TYPED_TEST_SUITE(Tables, tabulated_models);

TYPED_TEST(Tables, RandomPointsNeverExceedTheReportedBound) {
  const auto& t = table<TypeParam>();
  const auto& exact = t.base();
  const double rho0 = exact.reference_density();
  double c2 = exact.evaluate(rho0, 0.0).sound_speed_squared;
  if (!(c2 > 0)) c2 = exact.evaluate(rho0, 0.05 * t.values().energy_span).sound_speed_squared;
  eos::surface_error worst;
  points from(t, 20260101);
  for (int i = 0; i < 300000; ++i) {
    const auto [rho, e] = from.next();
    if (on_border(exact, rho, e)) continue;
    const auto a = t.evaluate(rho, e);
    const auto b = exact.evaluate(rho, e);
    worst.pressure = std::max(worst.pressure, std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + 0.01 * rho0 * c2));
    const double off_c2 = std::abs(a.sound_speed_squared - b.sound_speed_squared) / (std::abs(b.sound_speed_squared) + 0.01 * c2);
    worst.sound_speed_squared = std::max(worst.sound_speed_squared, off_c2);
    if constexpr (ThermalEquationOfState<TypeParam>)
      worst.temperature = std::max(worst.temperature, std::abs(a.temperature - b.temperature) / (b.temperature + 100));
  }
  const auto bound = t.error();
  const double round_off = 1e-13;
  EXPECT_LE(worst.pressure, bound.pressure + round_off);
  EXPECT_LE(worst.sound_speed_squared, bound.sound_speed_squared + round_off);
  EXPECT_LE(worst.temperature, bound.temperature + round_off);
  EXPECT_GE(worst.pressure, 0.1 * bound.pressure) << "the bound says something";
  EXPECT_LT(bound.pressure, 1e-4);
  EXPECT_LT(bound.temperature, 2e-3);
  EXPECT_LT(bound.sound_speed_squared, (std::is_same_v<TypeParam, eos::tillotson> ? 3e-3 : 1e-3));
}

TYPED_TEST(Tables, DerivativesBelongToTheTablesOwnPressure) {
  const auto& t = table<TypeParam>();
  points from(t, 7);
  for (int i = 0; i < 3000; ++i) {
    const point x = from.next();
    const double rho = x.rho, e = x.e;
    const double dr = 1e-6 * rho, de = 1e-5 * (e - lowest_energy(t.base(), rho)), scale = std::abs(t.base().evaluate(rho, e).sound_speed_squared);
    const auto r = t.evaluate(rho, e);
    const auto p = [&](double a, double b) { return t.evaluate(rho + a, e + b).pressure; };
    const double p_rho = (p(dr, 0) - p(-dr, 0)) / (2 * dr), p_e = (p(0, de) - p(0, -de)) / (2 * de);
    // Where a stencil straddles a border or the edge of a cell, both sides differ by the table's error: not looked at.
    const double bend = (p(dr, 0) - 2 * p(0, 0) + p(-dr, 0)) / dr, bend_e = (p(0, de) - 2 * p(0, 0) + p(0, -de)) / de;
    if (std::abs(bend) > 1e-4 * (std::abs(p_rho) + scale) || std::abs(bend_e) > 1e-4 * (std::abs(p_e) + rho)) continue;
    const std::string at = " at rho = " + std::to_string(rho) + ", e = " + std::to_string(e);
    expect_close(r.sound_speed_squared, p_rho + r.pressure * r.pressure_energy / (rho * rho), 1e-5, scale + std::abs(p_rho) + 1e4, "c^2" + at);
    expect_close(r.pressure_energy, p_e, 1e-5, rho + 1e-9 * std::abs(r.pressure) / de, "dp/de" + at);
  }
}

template <class V, class Table> void lanes_agree(const Table& t) {
  using T = scalar_t<V>;
  points from(t, 99);
  const bool is_float = sizeof(T) == 4;
  const double tolerance = is_float ? 1e-3 : 1e-9; // float: 6e-8 in rho and e, felt a thousandfold by c^2 and by what is above the cold curve
  for (int n = 0; n < 300; ++n) {
    V rho(T(1)), e(T(0));
    for (int i = 0; i < lane_width<V>; ++i) {
      const point x = from.next();
      if constexpr (lane_width<V> == 1) rho = T(x.rho), e = T(x.e);
      else rho.set(i, T(x.rho)), e.set(i, T(x.e));
    }
    const auto many = t.evaluate(rho, e);
    for (int i = 0; i < lane_width<V>; ++i) {
      const double r = static_cast<double>(lane(rho, i)), ei = static_cast<double>(lane(e, i));
      bool near = false; // a jump within a float's round-off
      for (const double border : eos::energy_borders_of(t.base(), r)) near = near || std::abs(ei - border) < 1e-4 * std::abs(border);
      for (const double border : eos::density_borders_of(t.base())) near = near || std::abs(r - border) < 1e-5 * border;
      if (near) continue;
      const auto one = t.evaluate(r, ei);
      const std::string at = " at rho = " + std::to_string(r) + ", e = " + std::to_string(ei);
      const double stiff = std::abs(one.sound_speed_squared) + 1e6;
      expect_close(lane(many.pressure, i), one.pressure, tolerance, r * stiff, "p" + at);
      expect_close(lane(many.sound_speed_squared, i), one.sound_speed_squared, 10 * tolerance, stiff, "c^2" + at);
      if constexpr (ThermalEquationOfState<Table>) {
        expect_close(lane(many.temperature, i), one.temperature, tolerance, 100 + std::abs(one.cold_energy) / 900, "T" + at);
        expect_close(lane(many.melting_temperature, i), one.melting_temperature, tolerance, 1, "T_m" + at);
        EXPECT_EQ(static_cast<double>(lane(many.region, i)), one.region) << at;
        expect_close(lane(many.melt_fraction, i), one.melt_fraction, 1, is_float ? 1 : 1e-9, "melt fraction" + at);
      }
    }
  }
}

TYPED_TEST(Tables, EveryLaneTypeGivesTheScalarAnswer) {
  const auto& t = table<TypeParam>();
  lanes_agree<float>(t);
  lanes_agree<pack<double, 8>>(t);
  lanes_agree<pack<float, 4>>(t);
  if constexpr (std::is_same_v<TypeParam, metal<phase::mixed>>) { // every width once
    lanes_agree<pack<double, 2>>(t);
    lanes_agree<pack<double, 4>>(t);
    lanes_agree<pack<float, 8>>(t);
    lanes_agree<pack<float, 16>>(t);
  }
}

TYPED_TEST(Tables, OutsideTheAnswerIsFiniteAndSaysSo) {
  const auto& t = table<TypeParam>();
  test::finite_everywhere(t);
  const auto box = t.validity();
  EXPECT_EQ(eos::query(t, box.density_low * 0.999, 1e7).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(t, box.density_high * 1.001, 1e7).what, eos::status::outside_validity);
  EXPECT_TRUE(t.outside_validity(box.density_high * 1.001, 1e7));
  EXPECT_TRUE(t.outside_validity(t.reference_density(), 1.001 * (t.values().energy_span + 1e9)));
  const double rho0 = t.reference_density(), stiff = t.base().evaluate(rho0, 0.05 * t.values().energy_span).sound_speed_squared;
  for (const double rho : {box.density_low, box.density_high}) { // the model takes over within the table's error
    const auto in = t.evaluate(rho * (1 - 1e-10), 2e7), out = t.evaluate(rho * (1 + 1e-10), 2e7);
    expect_close(in.pressure, out.pressure, t.error().pressure + 1e-9, 0.01 * rho0 * stiff, "p at the end of the table");
  }
}

template <class A, class B> void same_point(const A& a, const B& b, const std::string& at) {
  EXPECT_EQ(a.pressure, b.pressure) << at;
  EXPECT_EQ(a.sound_speed_squared, b.sound_speed_squared) << at;
  if constexpr (requires { b.temperature; }) {
    EXPECT_EQ(a.temperature, b.temperature) << at;
    EXPECT_EQ(a.melting_temperature, b.melting_temperature) << at;
    EXPECT_EQ(a.melt_fraction, b.melt_fraction) << at;
    EXPECT_EQ(a.cold_energy, b.cold_energy) << at;
    EXPECT_EQ(a.region, b.region) << at;
    EXPECT_EQ(a.temperature_energy, b.temperature_energy) << at;
  }
}

TYPED_TEST(Tables, OutsideTheModelItselfAnswersLaneByLane) {
  const auto& t = table<TypeParam>();
  const auto& exact = t.base();
  const auto box = t.validity();
  const double inside = t.reference_density();
  const double low = box.density_low, high = box.density_high;
  for (const double rho : {0.999 * low, 0.1 * low, 1e-4 * low, 1.001 * high, 1.5 * high, inside})
    for (const double e : {1.001 * box.energy_high, 3e7, 1e7, -1e6}) {
      if (!t.outside_validity(rho, e)) continue;
      const std::string at = "at rho = " + std::to_string(rho) + ", e = " + std::to_string(e);
      const auto one = t.evaluate(rho, e);
      same_point(one, exact.evaluate(rho, e), at);
      EXPECT_EQ(one.pressure_energy, eos::pressure_energy(exact, rho, e)) << at;
      using V = pack<double, 4>;
      V some_rho(inside), some_e(2e6); // lane 2 outside, the others in the table
      some_rho.set(2, rho), some_e.set(2, e);
      const auto many = t.evaluate(some_rho, some_e);
      EXPECT_EQ(lane(many.pressure, 2), one.pressure) << at;
      EXPECT_EQ(lane(many.sound_speed_squared, 2), one.sound_speed_squared) << at;
      EXPECT_EQ(lane(many.pressure_energy, 2), one.pressure_energy) << at;
      const auto in = t.evaluate(V(inside), V(2e6));
      for (const int i : {0, 1, 3}) EXPECT_EQ(lane(many.pressure, i), lane(in.pressure, i)) << at;
    }
  const auto is_nan = [](const auto& r) { return std::isnan(r.pressure) || std::isnan(r.sound_speed_squared); };
  EXPECT_TRUE(is_nan(t.evaluate(std::nan(""), 1e6)));
  EXPECT_TRUE(is_nan(t.evaluate(inside, std::nan(""))));
}

/// e at rho_end on the isentrope from (rho, e): de/drho = p/rho^2, classical Runge-Kutta in ln rho.
template <class Eos> double energy_after_expansion(const Eos& eos, double rho, double e, double rho_end) {
  const int steps = 2000;
  const double h = std::log(rho_end / rho) / steps;
  const auto slope = [&](double u, double energy) { return eos.evaluate(std::exp(u), energy).pressure / std::exp(u); };
  for (int i = 0; i < steps; ++i) {
    const double u = std::log(rho), k1 = slope(u, e);
    const double k2 = slope(u + h / 2, e + h / 2 * k1), k3 = slope(u + h / 2, e + h / 2 * k2), k4 = slope(u + h, e + h * k3);
    e += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), rho *= std::exp(h);
  }
  return e;
}

TEST(Tabulated, VapourThatExpandsThroughTheEndOfTheTableDoesTheModelsWork) { // as the hottest particle of an impact did, and blew the run up
  const auto& t = table<metal<phase::mixed>>();
  const double rho0 = t.reference_density(), e0 = 18.24e6;
  for (const double eta : {0.1, 0.05, 0.02}) {
    const double ours = energy_after_expansion(t, 0.21 * rho0, e0, eta * rho0);
    const double models = energy_after_expansion(t.base(), 0.21 * rho0, e0, eta * rho0);
    EXPECT_NEAR(ours, models, 1e-4 * (e0 - models)) << eta;
  }
}

TEST(TabulatedPhases, RegionAndMeltFractionAreTheModels) {
  const auto agree = [](const auto& t) {
    points from(t, 5);
    for (int i = 0; i < 100000; ++i) {
      const auto [rho, e] = from.next();
      if (on_border(t.base(), rho, e)) continue;
      const auto a = t.evaluate(rho, e), b = t.base().evaluate(rho, e);
      ASSERT_EQ(a.region, b.region) << rho << " " << e;
      ASSERT_NEAR(a.melt_fraction, b.melt_fraction, 1e-5) << rho << " " << e;
      if (to_region(b.region) == region::mixed) {
        ASSERT_EQ(a.temperature_energy, 0) << rho << " " << e;
        ASSERT_NEAR(a.temperature, b.melting_temperature, 1e-4 * b.melting_temperature);
      }
      expect_close(a.melting_temperature, b.melting_temperature, 1e-7, 10, "T_m");
      expect_close(a.cold_energy, b.cold_energy, 1e-6, 1e5, "e_c");
    }
  };
  agree(table<metal<phase::mixed>>());
  agree(table<metal<phase::paper>>());
  agree(table<metal<phase::helm>>());
}

TEST(TabulatedPhases, TheTwoSidesOfAJumpAreKeptApart) {
  const auto& t = table<metal<phase::paper>>();
  for (const double eta : {0.8, 1.0, 1.4, 2.0}) { // at E_m the paper's variant drops from its superheated solid to T_m, and p jumps up
    const double rho = eta * t.reference_density(), border = t.base().energy_borders(rho).at(0);
    for (const double side : {-1e-6, 1e-6}) {
      const auto a = t.evaluate(rho, border * (1 + side)), b = t.base().evaluate(rho, border * (1 + side));
      expect_close(a.temperature, b.temperature, 1e-5, 0, "T");
      expect_close(a.pressure, b.pressure, 1e-5, 1e9, "p");
      expect_close(a.sound_speed_squared, b.sound_speed_squared, 1e-4, 1e6, "c^2");
    }
    EXPECT_LT(t.evaluate(rho, border * (1 + 1e-6)).temperature, 0.8 * t.evaluate(rho, border * (1 - 1e-6)).temperature);
  }
  const double rho_j = t.base().density_borders().at(0); // V_j, where the gas begins
  for (const double side : {-1e-6, 1e-6}) {
    const double e = t.base().evaluate(rho_j, 0.0).cold_energy + 1e7;
    const auto a = t.evaluate(rho_j * (1 + side), e), b = t.base().evaluate(rho_j * (1 + side), e);
    expect_close(a.pressure, b.pressure, 1e-5, 1e9, "p at V_j");
    expect_close(a.temperature, b.temperature, 1e-5, 0, "T at V_j");
  }
}

TEST(TabulatedPhases, PatchesThatVanishAndMeltingAtEqualPressure) { // the reference: no solid below a density, no melting below another
  const eos::reference exact;
  const eos::tabulated t{exact};
  const double rho0 = exact.reference_density(), c2 = exact.evaluate(rho0, 0.0).sound_speed_squared;
  points from(t, 11);
  int other_region = 0, tried = 0;
  double p_worst = 0, c2_worst = 0, melt_worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto [rho, e] = from.next();
    const auto a = t.evaluate(rho, e), b = exact.evaluate(rho, e);
    p_worst = std::max(p_worst, std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + 0.01 * rho0 * c2));
    if (b.temperature < 200 || b.pressure < -3e9 || on_border(exact, rho, e)) continue; // where c_v freezes out the bound is far larger, and says so
    ++tried;
    other_region += a.region != b.region ? 1 : 0;
    c2_worst = std::max(c2_worst, std::abs(a.sound_speed_squared - b.sound_speed_squared) / (std::abs(b.sound_speed_squared) + 0.01 * c2));
    melt_worst = std::max(melt_worst, std::abs(a.melt_fraction - b.melt_fraction));
  }
  EXPECT_GT(tried, 50000);
  EXPECT_LE(p_worst, t.error().pressure);
  EXPECT_LT(t.error().pressure, 0.02);
  EXPECT_LT(c2_worst, 1e-3);
  EXPECT_LT(melt_worst, 1e-3);
  EXPECT_LT(other_region, tried / 100); // gas and hot liquid begin where no border is stated: the nearest node's
}

TEST(Tabulated, ErrorFallsAsCellsShrink) {
  const eos::tillotson exact;
  const eos::tabulated coarse{exact, {.eta_low = 0.5, .density_cells = 60, .energy_cells = 12}};
  const eos::tabulated fine{exact, {.eta_low = 0.5, .density_cells = 120, .energy_cells = 24}};
  EXPECT_LT(fine.error().pressure, coarse.error().pressure / 8); // fourth order: 16, less where the surface turns within a cell
  EXPECT_LT(fine.error().sound_speed_squared, coarse.error().sound_speed_squared / 3);
  EXPECT_GT(fine.bytes(), coarse.bytes());
}

TEST(Tabulated, AnExactColdCurveBecomesFast) {
  const eos::grover exact{cold::cai_ye{}, phase::helm{}};
  const eos::tabulated t{exact, {.eta_low = 0.7, .eta_high = 2, .energy_span = 2e7, .density_cells = 100, .energy_cells = 12}};
  EXPECT_LT(t.error().pressure, 2e-5);
  EXPECT_LT(t.error().temperature, 1e-4);
  const auto a = eos::ambient_state(t), b = eos::ambient_state(exact);
  EXPECT_NEAR(a.density, b.density, 0.01);
  EXPECT_NEAR(a.sound_speed, b.sound_speed, 0.2);
}

/// The least that a user's own model gives.
struct stiff_liquid {
  template <class V> eos_point<V> evaluate(V rho, V e) const {
    const V p = V(2e9) * (rho / V(1000) - V(1)) + V(0.5) * rho * e;
    return {p, V(2e6) + V(0.5) * e + V(0.5) * p / rho};
  }
  double reference_density() const { return 1000; }
};

TEST(Tabulated, TakesAUsersModelAndOtherModifiers) {
  const eos::tabulated mine{stiff_liquid{}};
  EXPECT_LT(mine.error().pressure, 1e-6);
  EXPECT_LT(mine.error().sound_speed_squared, 1e-4);
  const eos::isentrope_temperature warm{eos::tabulated{eos::tillotson{}}}; // this way round
  EXPECT_NEAR(warm.evaluate(2700.0, 0.0).temperature, 293, 1e-6);
  const eos::scaled_density scaled{table<eos::tillotson>(), 1.03};
  EXPECT_EQ(scaled.evaluate(2781.0, 1e6).pressure, table<eos::tillotson>().evaluate(2700.0, 1e6).pressure * 1.03);
  EXPECT_DOUBLE_EQ(eos::tabulated{scaled}.density_borders().at(0), 2781);
}

TEST(Tabulated, BadParametersAreRefused) {
  const auto refused = [](eos::tabulated_parameters p) { EXPECT_THROW((eos::tabulated{eos::tillotson{}, p}), bad_parameter); };
  refused({.eta_low = 0});
  refused({.eta_low = 1.2});
  refused({.eta_high = 0.9});
  refused({.energy_span = -1});
  refused({.density_cells = 2});
  refused({.energy_cells = 1});
  refused({.density_cells = 90000, .energy_cells = 9000});
  try {
    const eos::tabulated t{eos::isentrope_temperature{eos::tillotson{}}}; // its cold energy crosses E_iv
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("wrap the table"), std::string::npos) << e.what();
  }
}
} // namespace
