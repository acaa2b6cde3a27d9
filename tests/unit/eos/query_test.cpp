// SPDX-License-Identifier: MIT
// query(): every derivative against central differences, NaN where a model has no such quantity, every status, the validity boxes.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/query.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/lanes.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

template <class F> double slope(const F& f, double h) { return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h); }

template <class Eos> void derivatives_agree(const Eos& eos, double rho, double e) {
  const eos::full_state s = eos::query(eos, rho, e);
  const double dr = 1e-4 * rho, de = 1e-4 * std::abs(e) + 10;
  const auto p = [&](double r, double energy) { return eos.evaluate(r, energy).pressure; };
  expect_close(s.pressure_density, slope([&](double d) { return p(rho + d, e); }, dr), 1e-8, 1e6, "dp/drho");
  expect_close(s.pressure_energy, slope([&](double d) { return p(rho, e + d); }, de), 1e-8, 1, "dp/de");
  expect_close(s.pressure_volume, slope([&](double d) { return p(1 / (1 / rho + d), e); }, 1e-4 / rho), 1e-8, 1e6 * rho * rho, "dp/dV");
  EXPECT_DOUBLE_EQ(s.grueneisen, s.pressure_energy / rho);
}

const auto& grover() {
  static const eos::grover g{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  return g;
}

TEST(Query, DerivativesAreThoseOfThePressure) {
  derivatives_agree(grover(), 2900, 5e5);
  derivatives_agree(grover(), 3500, 2e7);
  derivatives_agree(eos::mie_grueneisen{}, 3600, 3e6);
  derivatives_agree(eos::tillotson{}, 2000, 8e6);
  derivatives_agree(eos::tillotson{}, 3000, 8e6);
  derivatives_agree(eos::ideal_gas{}, 1.0, 2e5);
  derivatives_agree(eos::stiffened_gas{}, 1100, 2e5);
}

TEST(Query, HeatCapacityAndWhatAModelHasNot) {
  const eos::ideal_gas air;
  const auto a = eos::query(air, 1.2, air.energy(300));
  EXPECT_NEAR(a.temperature, 300, 1e-10);
  EXPECT_NEAR(a.specific_heat, 717.5, 1e-9);
  EXPECT_NEAR(a.grueneisen, 0.4, 1e-15);
  EXPECT_EQ(a.what, eos::status::ok);
  const auto t = eos::query(eos::tillotson{}, 2800, 1e6);
  EXPECT_TRUE(std::isnan(t.temperature) && std::isnan(t.specific_heat) && std::isnan(t.region) && std::isnan(t.cold_energy));
  EXPECT_TRUE(std::isnan(t.melting_temperature) && std::isnan(t.melt_fraction));
  EXPECT_TRUE(std::isfinite(t.pressure) && std::isfinite(t.sound_speed_squared));
  const double rho0 = grover().reference_density();
  const auto mixed = eos::query(grover(), rho0, 1.3e6); // between E_ms 1.151 and E_m 1.531 MJ/kg
  EXPECT_EQ(to_region(mixed.region), region::mixed);
  EXPECT_TRUE(std::isinf(mixed.specific_heat));
  const auto solid = eos::query(grover(), rho0, 3 * 308. * 300 + 0.016 * 300 * 300);
  EXPECT_NEAR(solid.temperature, 300, 1e-9);
  EXPECT_NEAR(solid.specific_heat, 3 * 308 + 0.032 * 300, 1e-9);
}

TEST(Query, StatusSaysWhatIsWrong) {
  const double rho0 = grover().reference_density();
  EXPECT_EQ(eos::query(grover(), rho0, 5e5).what, eos::status::ok);
  const auto below = eos::query(grover(), 1.3 * rho0, 1e5); // the cold curve is at some 1 MJ/kg there
  EXPECT_EQ(below.what, eos::status::below_cold_energy);
  EXPECT_GT(below.cold_energy, 1e5);
  EXPECT_EQ(eos::query(grover(), 5.01 * rho0, 1e9).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(grover(), rho0, 1e10).what, eos::status::outside_validity);
  const auto spinodal = eos::query(grover(), rho0 / 1.6, grover().evaluate(rho0 / 1.6, 0.0).cold_energy + 1e5);
  EXPECT_EQ(spinodal.what, eos::status::unstable);
  EXPECT_LT(spinodal.sound_speed_squared, 0); // raw
  const eos::grover helm{cold::tabulated{cold::cai_ye{}}, phase::helm{}};
  EXPECT_EQ(eos::query(helm, rho0 / 6, 3e7).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(grover(), rho0 / 6, 3e7).what, eos::status::ok);
  const eos::mie_grueneisen mie;
  EXPECT_EQ(eos::query(mie, mie.guard_density() * 1.01, 0).what, eos::status::outside_validity);
  EXPECT_EQ(eos::query(eos::tillotson{}, 0.5 * 2700, 1e5).what, eos::status::unstable);
  EXPECT_STREQ(eos::name(eos::status::below_cold_energy), "below_cold_energy");
  EXPECT_STREQ(eos::name(eos::status::not_converged), "not_converged");
}

TEST(Query, ImpossibleQuestionsAreRefused) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double rho : {0.0, -1.0, nan, inf}) EXPECT_THROW(eos::query(eos::tillotson{}, rho, 0), bad_parameter) << rho;
  for (const double e : {nan, inf, -inf}) EXPECT_THROW(eos::query(eos::tillotson{}, 2700, e), bad_parameter) << e;
}

struct linear_liquid { // a user's own, with the least that the role asks for
  template <class V> eos_point<V> evaluate(V rho, V e) const {
    const V p = V(2e9) * (rho / V(1000) - V(1)) + rho * e;
    return {p, V(2e6) + e + p / rho};
  }
  double reference_density() const { return 1000; }
};

TEST(Query, AUsersModelNeedsNeitherBoxNorDerivatives) {
  const linear_liquid eos;
  const auto s = eos::query(eos, 1100, 3e4);
  expect_close(s.pressure_energy, 1100, 1e-8, 0, "dp/de by difference");
  expect_close(s.pressure_density, 2e6 + 3e4, 1e-7, 0, "dp/drho");
  EXPECT_EQ(s.what, eos::status::ok);
  EXPECT_TRUE(eos::validity_of(eos).contains(1e-30, -1e30));
  EXPECT_FALSE(eos::validity_of(eos).contains(-1, 0));
  EXPECT_STREQ(eos::region_name(eos, 1100, 0), "single");
}

TEST(Validity, ModifiersForwardTheBoxAsTheyScale) {
  const eos::tillotson raw;
  const auto box = raw.validity(), scaled = eos::scaled_density{raw, 1.25}.validity();
  EXPECT_DOUBLE_EQ(scaled.density_high, 1.25 * box.density_high);
  EXPECT_DOUBLE_EQ(scaled.density_low, 1.25 * box.density_low);
  EXPECT_EQ(scaled.energy_high, box.energy_high);
  EXPECT_EQ((eos::sound_speed_floor{raw, 0.1}).validity().density_high, box.density_high);
  EXPECT_LE((eos::isentrope_temperature{raw}).validity().density_high, box.density_high);
  EXPECT_GE((eos::isentrope_temperature{raw}).validity().density_low, box.density_low);
}

TEST(Validity, BranchNames) {
  const eos::tillotson t;
  EXPECT_STREQ(eos::region_name(t, 2700, 1e7), "compressed");
  EXPECT_STREQ(eos::region_name(t, 2000, 1e6), "expanded_cold");
  EXPECT_STREQ(eos::region_name(t, 2000, 3.0e6), "expanded_cold"); // e <= E_iv
  EXPECT_STREQ(eos::region_name(t, 2000, 5e6), "transition");
  EXPECT_STREQ(eos::region_name(t, 2000, 13.9e6), "expanded_hot"); // e >= E_cv
  EXPECT_STREQ(eos::region_name(eos::isentrope_temperature{t}, 2000, 5e6), "transition");
  EXPECT_STREQ(eos::region_name(eos::scaled_density{t, 2.0}, 5400, 1e7), "compressed");
  EXPECT_STREQ(eos::region_name(eos::mie_grueneisen{}, 3000, 0), "single");
  EXPECT_STREQ(eos::region_name(eos::ideal_gas{}, 1, 1), "single");
  EXPECT_STREQ(eos::region_name(grover(), grover().reference_density(), 1.3e6), "mixed");
}
} // namespace
