// SPDX-License-Identifier: MIT
// The published design figures of the other cold curves (Rose, Zhou 2004) under the mixed-phase model, 300 K start, to the digits printed:
// us against up, pressure and temperature at 3320 m/s, melting on the Hugoniot and on release, end states of the release.
// (Cai-Ye and Tillotson: shock_test.cpp.)
#include "bolide/analysis/melt_thresholds.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/potential/zhou04.hpp"

#include <gtest/gtest.h>

namespace {
using namespace bolide;

const double up[] = {1000, 2000, 3000, 3320, 4000, 5000, 6000};

template <class Eos> void expect_row(const Eos& eos, const double (&us)[7]) {
  const auto ahead = eos::ambient_state(eos, 300);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(analysis::hugoniot(eos, ahead, up[i]).shock_speed, us[i], 0.6) << up[i];
}

TEST(ReferenceFigures, Rose) {
  const eos::grover rose{cold::rose{}, phase::mixed{}};
  expect_row(rose, {6686, 8014, 9349, 9775, 10677, 12242, 13517});
  const auto ahead = eos::ambient_state(rose, 300);
  EXPECT_NEAR(2697.8 / ahead.density, 1.0216, 0.00006);
  const auto s = analysis::hugoniot(rose, ahead, 3320);
  EXPECT_NEAR(s.pressure / 1e9, 85.7, 0.06);
  EXPECT_NEAR(s.temperature, 2913, 1);
  const auto scaled = eos::scaled_to(rose, 2700, 300);
  EXPECT_NEAR(analysis::hugoniot(scaled, eos::ambient_state(scaled, 300), 3320).pressure / 1e9, 87.6, 0.06);
  const auto m = analysis::find_melt_thresholds(rose, ahead);
  EXPECT_NEAR(m.hugoniot_begin.pressure / 1e9, 124, 0.6);
  EXPECT_NEAR(m.hugoniot_begin.temperature, 4988, 10);
  EXPECT_NEAR(m.hugoniot_end.pressure / 1e9, 153, 0.6);
  EXPECT_NEAR(m.release_begin.pressure / 1e9, 67.1, 0.06);
  EXPECT_NEAR(m.release_end.pressure / 1e9, 84.0, 0.06);
}

TEST(ReferenceFigures, Zhou2004) {
  const eos::grover zhou{cold::tabulated{cold::lattice{potential::zhou04{}}}, phase::mixed{}};
  expect_row(zhou, {6621, 7858, 8984, 9400, 10330, 11958, 13289});
  EXPECT_NEAR(analysis::hugoniot(zhou, eos::ambient_state(zhou, 300), 3320).pressure / 1e9, 82.3, 0.06);
}

TEST(ReferenceFigures, ReleaseFromThePapersImpact) { // up 3320 m/s: a liquid of 860 K (mixed, 300 K), a superheated solid of 980 K (paper, 0 K)
  const cold::tabulated cai_ye{cold::cai_ye{}};
  const eos::grover mixed{cai_ye, phase::mixed{}};
  const eos::grover paper{cai_ye, phase::paper{}};
  const auto warm = eos::ambient_state(mixed, 300), cold = eos::cold_state(paper);
  const auto shocked = analysis::hugoniot(mixed, warm, 3320);
  const auto liquid = analysis::release(mixed, shocked, 5).states.back();
  EXPECT_NEAR(liquid.temperature, 860, 5);
  EXPECT_EQ(to_region(liquid.region), region::liquid);
  EXPECT_NEAR(warm.density / liquid.density, 1.10, 0.01);
  const auto solid = analysis::release(paper, analysis::hugoniot(paper, cold, 3320), 5).states.back();
  EXPECT_NEAR(solid.temperature, 980, 5);
  EXPECT_EQ(to_region(solid.region), region::solid);
  EXPECT_GT(solid.temperature, paper.evaluate(solid.density, solid.energy).melting_temperature);
}
} // namespace
