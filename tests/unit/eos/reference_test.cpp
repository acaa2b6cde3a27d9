// SPDX-License-Identifier: MIT
// The reference equation of state: one free energy, exact derivatives, no jump, an ideal gas at the end. Its agreement with measurements
// is tests/validate/reference_eos_test.cpp.
#include "bolide/eos/reference.hpp"
#include "bolide/eos/state.hpp"
#include "unit/eos/lanes.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

const eos::reference& model() {
  static const eos::reference r;
  return r;
}
const double rho0 = eos::reference_parameters{}.rho0;

/// Fourth-order central difference.
template <class F> double slope(const F& f, double h) { return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h); }

/// What tells the smooth pieces of the surface apart.
int piece(double rho, double e) {
  const auto p = model().evaluate(rho, e);
  const int phase = p.region >= 2 ? 2 : static_cast<int>(p.region);
  return phase + (p.temperature <= 0 ? 10 : 0);
}

// ---- one free energy -----------------------------------------------------------------------------------------------------------
TEST(Reference, PressureAndEntropyAreTheSlopesOfOneFreeEnergy) {
  int tried[3] = {};
  for (double x = 0.22; x < 900; x *= 1.061)
    for (double t = 21; t < 1e5; t *= 1.173) {
      const auto at = [&](double dx, double dt) { return model().at_temperature(rho0 / (x * (1 + dx)), t * (1 + dt)); };
      const double h = 2e-4;
      const auto s = at(0, 0);
      const int phase = s.where >= region::liquid ? 2 : static_cast<int>(s.where);
      bool same = true;
      for (const double k : {-2., 2.})
        for (const auto& o : {at(k * h, 0), at(0, k * h)}) same = same && (o.where >= region::liquid ? 2 : static_cast<int>(o.where)) == phase;
      if (!same) continue;
      const std::string where = " at x = " + std::to_string(x) + " T = " + std::to_string(t);
      const double volume = x / rho0, scale = std::abs(s.free_energy) + std::abs(s.pressure) * volume + 1e5;
      const double f_v = slope([&](double d) { return at(d, 0).free_energy; }, h), f_t = slope([&](double d) { return at(0, d).free_energy; }, h);
      EXPECT_NEAR(s.pressure * volume, -f_v, 3e-10 * scale) << "p = -F_V" << where;
      EXPECT_NEAR(s.entropy * t, -f_t, 3e-10 * scale) << "S = -F_T" << where;
      const double p_t = slope([&](double d) { return at(0, d).pressure; }, h), s_v = slope([&](double d) { return at(d, 0).entropy; }, h);
      EXPECT_NEAR(p_t * volume, s_v * t, 1e-8 * scale) << "Maxwell" << where;
      expect_close(s.energy, s.free_energy + t * s.entropy, 1e-12, scale, "e = F + TS" + where);
      ++tried[phase];
    }
  EXPECT_GT(tried[0], 500);
  EXPECT_GT(tried[1], 50);
  EXPECT_GT(tried[2], 3000);
}

TEST(Reference, EnergyToTemperatureAndBack) {
  for (double x = 0.2; x < 1e6; x *= 1.043)
    for (double excess = 10; excess < 1e10; excess *= 1.31) {
      const double rho = rho0 / x, cold = model().evaluate(rho, 0.0).cold_energy, e = cold + excess;
      const auto p = model().evaluate(rho, e);
      ASSERT_GT(p.temperature, 0);
      const auto s = model().at_temperature(rho, p.temperature);
      const std::string where = " at x = " + std::to_string(x) + " e = " + std::to_string(e);
      expect_close(s.energy, e, 1e-12, 1e6 + std::abs(cold), "e -> T -> e" + where);
      expect_close(s.pressure, p.pressure, 1e-10, 1e9 * std::fmin(1, 1 / x) + 1e-9 * std::abs(p.pressure), "p" + where);
      EXPECT_EQ(static_cast<int>(s.where), static_cast<int>(p.region)) << where;
    }
}

TEST(Reference, SoundSpeedAndItsPartsAreTheDerivatives) {
  int tried = 0;
  for (double x = 0.2; x < 300; x *= 1.0371)
    for (double e = -1.01e6; e < 9e7; e += 1.3e5 + 0.07 * std::abs(e)) {
      const double rho = rho0 / x, dr = 1e-5 * rho, de = 50 + 1e-6 * std::abs(e);
      const int here = piece(rho, e);
      bool same = true;
      for (const double k : {-2., 2.}) same = same && piece(rho + k * dr, e) == here && piece(rho, e + k * de) == here;
      const auto p = model().evaluate(rho, e);
      same = same && std::fmin(model().evaluate(rho + 2 * dr, e).temperature, model().evaluate(rho - 2 * dr, e).temperature) > 150;
      if (!same) continue; // near 0 K the stencil is too coarse: 1/C is without bound there
      const double p_rho = slope([&](double d) { return model().evaluate(rho + d, e).pressure; }, dr);
      const double p_e = slope([&](double d) { return model().evaluate(rho, e + d).pressure; }, de);
      const std::string where = " at x = " + std::to_string(x) + " e = " + std::to_string(e);
      expect_close(p.sound_speed_squared, p_rho + p.pressure * p_e / (rho * rho), 1e-6, 1e6, "c^2" + where);
      expect_close(p.pressure_energy, p_e, 1e-6, 0.01 * rho, "dp/de" + where);
      expect_close(p.temperature_energy, slope([&](double d) { return model().evaluate(rho, e + d).temperature; }, de), 1e-6, 1e-3, "dT/de" + where);
      ++tried;
    }
  EXPECT_GT(tried, 6000);
}

// ---- edges ------------------------------------------------------------------------------------------------------------------------
TEST(Reference, PressureAndTemperatureAreContinuousAcrossMelting) {
  for (double x = 0.2; x < 1.54; x += 0.0137) {
    const double rho = rho0 / x;
    const auto borders = model().energy_borders(rho);
    const bool has_solid = x < 1.19;
    for (const double border : {borders[0], borders[1]}) {
      if (border == borders[0] && !has_solid) continue;
      const double step = 1e-9 * border;
      const auto below = model().evaluate(rho, border - step), above = model().evaluate(rho, border + step);
      const std::string where = " at x = " + std::to_string(x) + " e = " + std::to_string(border);
      EXPECT_NE(below.region, above.region) << where;
      const double dt = 2 * step * std::fmax(above.temperature_energy, below.temperature_energy);
      const double dp = 2 * step * std::fmax(above.pressure_energy, below.pressure_energy);
      EXPECT_NEAR(above.temperature, below.temperature, dt + 1e-8 * below.temperature) << where;
      EXPECT_NEAR(above.pressure, below.pressure, dp + 1e-8 * (std::abs(below.pressure) + 1e9)) << where;
      expect_close(above.melt_fraction, below.melt_fraction, 1e-6, 1, "melt fraction" + where);
      if (border == borders[0]) EXPECT_LT(above.sound_speed_squared, below.sound_speed_squared) << where;
      else EXPECT_GT(above.sound_speed_squared, below.sound_speed_squared) << where;
      expect_close(above.melting_temperature, above.temperature, 1e-6, 100, "T_m" + where);
      expect_close(below.melting_temperature, below.temperature, 1e-6, 100, "T_m" + where);
    }
  }
}

TEST(Reference, EverythingIsContinuousInVolume) { // x_join, where the liquid's cold curve changes, V_j of the paper, the critical volume
  const auto& q = model().values();
  for (const double x : {q.x_join, 1.0, 1.3471, rho0 / model().critical().density})
    for (const double e : {4e6, 6e6, 1e7, 3e7}) {
      const auto a = model().evaluate(rho0 / (x * (1 - 1e-10)), e), b = model().evaluate(rho0 / (x * (1 + 1e-10)), e);
      const std::string where = " at x = " + std::to_string(x) + " e = " + std::to_string(e);
      expect_close(a.pressure, b.pressure, 1e-8, 1e9, "p" + where);
      expect_close(a.temperature, b.temperature, 1e-8, 0, "T" + where);
      expect_close(a.sound_speed_squared, b.sound_speed_squared, 1e-8, 1e6, "c^2" + where);
    }
}

TEST(Reference, BelowTheColdCurveTemperatureGoesOnAlone) {
  for (double x = 0.25; x < 1e4; x *= 1.21) {
    const double rho = rho0 / x, cold = model().evaluate(rho, 0.0).cold_energy;
    const auto at = model().evaluate(rho, cold);
    EXPECT_NEAR(model().evaluate(rho, cold + 1e-2).pressure, at.pressure, 0.1 * rho + 1e-8 * std::abs(at.pressure)) << "x = " << x;
    for (const double excess : {-1e3, -1e6, -1e8}) {
      const auto p = model().evaluate(rho, cold + excess);
      expect_close(p.temperature, excess / (3 * model().values().R()), 1e-6, 0, "T");
      EXPECT_EQ(p.pressure, at.pressure);
      EXPECT_EQ(p.pressure_energy, 0);
    }
  }
}

// ---- melting ------------------------------------------------------------------------------------------------------------------------
TEST(Reference, MeltingIsEquilibriumOfEqualPressureAndGibbsEnergy) {
  for (double t = 30; t < 2e4; t *= 1.37) {
    const double shift = 1e-8; // the edges are interpolated to that
    const auto c = model().melting_at(t);
    const auto phase = [&](double volume, double by) { return model().at_temperature(1 / (volume * (1 + by)), t); };
    const auto s = phase(c.solid.volume, -shift), l = phase(c.liquid.volume, shift);
    ASSERT_EQ(s.where, region::solid) << t;
    ASSERT_GE(l.where, region::liquid) << t;
    const double gs = s.free_energy + s.pressure * c.solid.volume * (1 - shift), gl = l.free_energy + l.pressure * c.liquid.volume * (1 + shift);
    const double dp_shift = shift * (c.solid.stiffness / c.solid.volume + c.liquid.stiffness / c.liquid.volume);
    EXPECT_NEAR(s.pressure, l.pressure, 1.1 * dp_shift + 10) << "T = " << t;
    EXPECT_NEAR(gs, gl, 1.1 * dp_shift * c.liquid.volume + 1e-3) << "T = " << t;
    const double dp = slope([&](double d) { return model().melting_at(t * (1 + d)).solid.pressure; }, 1e-4) / t;
    expect_close((l.entropy - s.entropy) / (c.liquid.volume - c.solid.volume), dp, 1e-5, 1e4, "Clapeyron at T = " + std::to_string(t));
  }
}

TEST(Reference, MeltingAtConstantPressureKeepsTheTemperature) {
  const auto c = model().melting_at(1500);
  for (const double part : {0.01, 0.3, 0.5, 0.77, 0.99}) {
    const double volume = (1 - part) * c.solid.volume + part * c.liquid.volume, e = (1 - part) * c.solid.energy + part * c.liquid.energy;
    const auto p = model().evaluate(1 / volume, e);
    expect_close(p.temperature, 1500, 1e-9, 0, "T");
    expect_close(p.pressure, c.solid.pressure, 1e-9, 0, "p");
    EXPECT_NEAR(p.melt_fraction, part, 1e-8);
    EXPECT_EQ(p.region, region_value<double>(region::mixed));
  }
}

// ---- expansion ------------------------------------------------------------------------------------------------------------------------
TEST(Reference, ItEndsAsTheIdealGasOfFreeAtoms) {
  const auto& q = model().values();
  const double R = q.R(), rho = 1e-6 * rho0, m = q.atomic_mass * 1.66053906660e-27, k = 1.380649e-23, h = 6.62607015e-34;
  for (const double t : {1000., 3000., 8000.}) {
    const auto s = model().at_temperature(rho, t);
    const auto p = model().evaluate(rho, s.energy);
    const double fermi = 9 * R * q.electron_saturation / (q.G * (1 + q.electron_saturation)); // T_F at x -> infinity
    const double electrons = 4.5 * R * t * t / (t + fermi), their_entropy = 4.5 * R * std::log1p(t / fermi) + electrons / t; // and no pressure
    expect_close(p.pressure, rho * R * t, 2e-3, 0, "p = rho R T");
    expect_close(s.energy, q.E_coh + 1.5 * R * t + electrons, 2e-3, 0, "e");
    // Sackur and Tetrode, with six states of the atom.
    const double ideal = R * (std::log(6 * m / rho * std::pow(2 * std::numbers::pi * m * k * t / (h * h), 1.5)) + 2.5);
    EXPECT_NEAR(s.entropy - their_entropy, ideal, 0.01 * R) << t;
  }
}

TEST(Reference, TheSoundSpeedIsImaginaryInTheSpinodalOnly) {
  int unstable = 0;
  for (double x = 0.2; x < 1e6; x *= 1.021)
    for (double e = 1e4; e < 1e10; e *= 1.11) {
      const double rho = rho0 / x;
      const auto p = model().evaluate(rho, e);
      if (p.sound_speed_squared >= 0 || p.temperature <= 0) continue;
      const auto pressure = [&](double d) { return model().at_temperature(rho * (1 + d), p.temperature).pressure; };
      EXPECT_LT(slope(pressure, 1e-4), 0) << "x = " << x << " T = " << p.temperature; // rising with volume: no phase can be there
      EXPECT_GE(p.region, 2) << "x = " << x << " T = " << p.temperature;
      EXPECT_GT(x, 1.4);
      EXPECT_LT(p.temperature, model().critical().temperature);
      ++unstable;
    }
  EXPECT_GT(unstable, 100);
}

TEST(Reference, TheCriticalPointIsOne) {
  const auto c = model().critical();
  const auto pressure = [&](double d) { return model().at_temperature(c.density * (1 + d), c.temperature).pressure; };
  const double first = slope(pressure, 1e-3), second = (pressure(1e-2) - 2 * pressure(0) + pressure(-1e-2)) / 1e-4;
  EXPECT_NEAR(pressure(0), c.pressure, 1e-6 * c.pressure);
  EXPECT_LT(std::abs(first), 1e-4 * c.pressure);
  EXPECT_LT(std::abs(second), 1e-2 * c.pressure);
  EXPECT_GT(slope([&](double d) { return model().at_temperature(c.density * (1 + d), 1.01 * c.temperature).pressure; }, 1e-3), 0);
}

// ---- any input, any lane ----------------------------------------------------------------------------------------------------------------
TEST(Reference, NothingIsNaNAnywhere) {
  for (double eta = 1e-6; eta < 50; eta *= 1.17)
    for (const double e : {-1e8, -1e6, -1e3, 0., 1., 1e4, 1e6, 3e6, 1.39e7, 1e8, 1e9, 1e10}) {
      const auto p = model().evaluate(eta * rho0, e);
      for (const double value : {p.pressure, p.sound_speed_squared, p.temperature, p.melting_temperature, p.melt_fraction, p.cold_energy, p.region,
                                 p.pressure_energy, p.temperature_energy})
        EXPECT_TRUE(std::isfinite(value)) << "eta = " << eta << " e = " << e;
      EXPECT_GE(p.melting_temperature, 0);
      EXPECT_EQ(model().outside_validity(eta * rho0, e), eta > 5 || e > 1e8) << "eta = " << eta << " e = " << e;
    }
}

template <class V> struct ReferenceLanes : ::testing::Test {};
TYPED_TEST_SUITE(ReferenceLanes, bolide::test::every_lane);
TYPED_TEST(ReferenceLanes, GiveTheScalarAnswer) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const double eps = test::epsilon<V>(400);
  for (double eta = 0.05; eta < 3.4; eta += 0.0913)
    for (double e0 = -1e5; e0 < 2e7; e0 += 2e5 + 0.2 * std::abs(e0)) {
      const V rho = test::ramp<V>(eta, 0.0187) * T(rho0), e = test::ramp<V>(e0, 1e3 + 0.13 * std::abs(e0));
      const auto many = model().evaluate(rho, e);
      for (int i = 0; i < lane_width<V>; ++i) {
        const double r = static_cast<double>(lane(rho, i)), ei = static_cast<double>(lane(e, i));
        const double dr = 2e-7 * r, de = 2e-7 * std::abs(ei) + 1;
        if (piece(r + dr, ei) != piece(r - dr, ei) || piece(r, ei + de) != piece(r, ei - de)) continue;
        const auto one = model().evaluate(r, ei);
        const std::string at = " at eta = " + std::to_string(r / rho0) + ", e = " + std::to_string(ei);
        expect_close(lane(many.pressure, i), one.pressure, eps, 1e9, "p" + at);
        expect_close(lane(many.sound_speed_squared, i), one.sound_speed_squared, 4 * eps, 1e6, "c^2" + at);
        expect_close(lane(many.temperature, i), one.temperature, eps, 100 + std::abs(one.cold_energy) / 900, "T" + at);
        expect_close(lane(many.melting_temperature, i), one.melting_temperature, eps, 100, "T_m" + at);
        expect_close(lane(many.melt_fraction, i), one.melt_fraction, eps, 10, "melt fraction" + at);
        expect_close(lane(many.cold_energy, i), one.cold_energy, eps, 1e6, "e_c" + at);
      }
    }
}

TEST(Reference, StatesAndParameters) {
  const auto ambient = eos::ambient_state(model(), 293);
  EXPECT_LT(std::abs(ambient.pressure), 1e-3);
  EXPECT_NEAR(ambient.temperature, 293, 1e-9);
  EXPECT_EQ(eos::cold_state(model()).energy, 0);
  EXPECT_EQ(model().validity().density_high, 5 * rho0);
  EXPECT_NEAR(eos::reference_parameters{}.R(), 308.154, 1e-3);
  const auto refused = [](auto change) {
    eos::reference_parameters p;
    change(p);
    EXPECT_THROW(eos::reference{p}, bad_parameter);
  };
  refused([](auto& p) { p.K0 = -1; });
  refused([](auto& p) { p.theta = std::nan(""); });
  refused([](auto& p) { p.b0 = 1e9; });  // repulsive vapour
  refused([](auto& p) { p.c = 0.02; });  // a liquid that the solid never meets
  EXPECT_THROW(model().at_temperature(-1, 300), bad_parameter);
  EXPECT_THROW(model().at_temperature(2700, 0), bad_parameter);
  EXPECT_THROW(model().melting_at(1e6), bad_parameter);
}
} // namespace
