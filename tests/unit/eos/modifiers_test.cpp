// SPDX-License-Identifier: MIT
// The modifiers that cut a pressure or shift the zero of energy: what changes, what must not, and that they stay equations of state.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/inverse.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/pressure_cutoff.hpp"
#include "bolide/eos/query.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/shifted_reference.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/surface.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

const auto& metal() {
  static const eos::grover g{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  return g;
}

TEST(PressureCutoff, ActsBelowOnlyAndItsSurfaceIsFlatThere) {
  const eos::pressure_cutoff eos{metal(), -1.5e9};
  const double rho0 = metal().reference_density();
  const auto raw = metal().evaluate(0.9 * rho0, 1e5), cut = eos.evaluate(0.9 * rho0, 1e5);
  ASSERT_LT(raw.pressure, -1.5e9);
  EXPECT_EQ(cut.pressure, -1.5e9);
  EXPECT_EQ(cut.pressure_energy, 0);
  EXPECT_EQ(cut.sound_speed_squared, 0);
  EXPECT_EQ(cut.temperature, raw.temperature);
  EXPECT_EQ(cut.region, raw.region);
  const auto above = eos.evaluate(1.1 * rho0, 1e6), same = metal().evaluate(1.1 * rho0, 1e6);
  EXPECT_EQ(above.pressure, same.pressure);
  EXPECT_EQ(above.sound_speed_squared, same.sound_speed_squared);
  EXPECT_TRUE(eos.cut(raw));
  EXPECT_FALSE(eos.cut(same));
  test::derivatives_are_right(eos, {0.85, 0.9, 1.05, 1.4}, {2e5, 1e6, 2.5e6});
  test::lanes_agree(eos, {0.85, 0.9, 1.05, 1.4}, {2e5, 1e6, 2.5e6}, 3e7);
  EXPECT_EQ(eos::query(eos, 0.9 * rho0, 1e5 + raw.cold_energy).what, eos::status::unstable);
  EXPECT_GT((eos::sound_speed_floor{eos, 0.05}).evaluate(0.9 * rho0, 1e5).sound_speed_squared, 0);
  EXPECT_THROW((eos::pressure_cutoff{metal(), 1e5}), bad_parameter);
  EXPECT_THROW((eos::pressure_cutoff{metal(), std::nan("")}), bad_parameter);
}

TEST(ShiftedReference, CountsEnergiesFromAnotherZero) {
  const double rho0 = metal().reference_density(), warm = eos::energy_at_temperature(metal(), rho0, 293).value;
  const eos::shifted_reference eos{metal(), warm};
  const auto a = eos.evaluate(rho0, 0.0), b = metal().evaluate(rho0, warm);
  EXPECT_EQ(a.pressure, b.pressure);
  EXPECT_EQ(a.sound_speed_squared, b.sound_speed_squared);
  EXPECT_NEAR(a.temperature, 293, 1e-9);
  EXPECT_DOUBLE_EQ(a.cold_energy, b.cold_energy - warm);
  EXPECT_DOUBLE_EQ(eos.validity().energy_high, metal().validity().energy_high - warm);
  const auto here = eos::ambient_state(eos), there = eos::ambient_state(metal());
  EXPECT_NEAR(here.density, there.density, 1e-9);
  EXPECT_NEAR(here.energy, there.energy - warm, 1e-6);
  EXPECT_EQ(eos::query(eos, 1.3 * rho0, 1e5 - warm).what, eos::status::below_cold_energy);
  EXPECT_STREQ(eos.branch_name(rho0, 1.3e6 - warm), "mixed");
  test::derivatives_are_right(eos, {0.95, 1.4, 2.0}, {1e5, 3e6, 2e7});
  test::lanes_agree(eos, {0.95, 1.4, 2.0}, {1e5, 3e6, 2e7}, 3e7);
  EXPECT_THROW((eos::shifted_reference{metal(), std::nan("")}), bad_parameter);
}

TEST(Modifiers, WrapEachOtherInAnyOrderAndForwardTheirBoxes) {
  const eos::isentrope_temperature all{
      eos::sound_speed_floor{eos::pressure_cutoff{eos::scaled_density{eos::shifted_reference{eos::tillotson{}, 1e5}, 1.03}, -2e9}, 0.05}};
  const auto box = all.validity();
  EXPECT_DOUBLE_EQ(box.density_high, 4 * 1.03 * 2700); // the isentrope's end
  EXPECT_DOUBLE_EQ(box.energy_low, -0.05 * 5e6 - 1e5);
  EXPECT_STREQ(all.branch_name(2000 * 1.03, 5e6), "transition");
  EXPECT_EQ(all.energy_borders(2000).size(), 2u);
  EXPECT_DOUBLE_EQ(all.energy_borders(2000)[0], 3.0e6 - 1e5);
  EXPECT_DOUBLE_EQ(all.density_borders().at(0), 2700 * 1.03);
  test::lanes_agree(all, {0.7, 0.95, 1.2}, {1e5, 2e6, 2e7}, 3e7);
  EXPECT_TRUE(all.outside_validity(1350., -1.3e6)); // Tillotson's own guard, through all of them
}
} // namespace
