// SPDX-License-Identifier: MIT
// Grover's equation of state in its variants, on tables and on exact cold curves.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "unit/conformance/expect.hpp"
#include "unit/conformance/stated.hpp"

namespace {
using namespace bolide;
using namespace bolide::test;
using conformance::check;

TEST(Grover, Mixed) {
  const eos::grover eos{table(), phase::mixed{}};
  expect_passed(check(eos, {.name = "grover mixed", .stated = of_the_paper()}));
  expect_fails(check(eos), {"maxwell", "pressure_jump", "temperature_jump"});
}

TEST(Grover, Paper) {
  const eos::grover eos{table(), phase::paper{}};
  violations stated = of_the_paper();
  expect_fails(check(eos, {.stated = stated}), {"pressure_jump", "temperature_jump", "monotone_pressure"});
  stated.push_back({"pressure_jump", 0.02, "superheated solid to E_m, where p jumps up"});
  stated.push_back({"temperature_jump", 0.3, "and T down"});
  stated.push_back({"monotone_pressure", 0.02, "so p falls where compression at constant e makes the liquid solid"});
  expect_passed(check(eos, {.name = "grover paper", .stated = stated}));
}

TEST(Grover, HelmIsThermodynamicallyExact) {
  const auto report = check(eos::grover{table(), phase::helm{}}, {.name = "grover helm"});
  expect_passed(report);
  EXPECT_LT(report.at("maxwell").worst, 1e-8);
  EXPECT_LT(report.at("sound_speed").worst, 1e-8);
}

TEST(Grover, OnExactColdCurves) {
  expect_passed(check(eos::grover{cold::cai_ye{}, phase::helm{}}, {.name = "grover helm, cai_ye exact"}));
  expect_passed(check(eos::grover{cold::cai_ye{}, phase::mixed{}}, {.name = "grover mixed, cai_ye exact", .stated = of_the_paper()}));
  expect_passed(check(eos::grover{cold::rose{}, phase::helm{}}, {.name = "grover helm, rose exact"}));
}

} // namespace
