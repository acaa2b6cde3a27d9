// SPDX-License-Identifier: MIT
// Tables of whole surfaces: c^2, dp/de and dT/de belong to the table's own p and T exactly, and to the model's outside; the Maxwell relation
// holds within the table's error, and so do p and T where the model takes over.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/conformance/expect.hpp"
#include "unit/conformance/stated.hpp"

namespace {
using namespace bolide;
using namespace bolide::test;
using conformance::check;
using conformance::outcome;

violations of_a_table() {
  return {{"maxwell", 1e-3, "p and T are interpolated one by one"}};
}

TEST(Tabulated, OfHelm) {
  violations stated = of_a_table();
  stated.push_back({"temperature_jump", 3e-5, "the model takes over at the table's highest energy"});
  const auto report = check(eos::tabulated{eos::grover{table(), phase::helm{}}}, {.name = "tabulated helm", .stated = stated});
  expect_passed(report);
  EXPECT_EQ(report.at("sound_speed").result, outcome::passed);
  EXPECT_EQ(report.at("pressure_jump").result, outcome::passed);
}
TEST(Tabulated, OfMixedKeepsItsJumpAndNoMore) {
  const eos::tabulated eos{eos::grover{table(), phase::mixed{}}};
  violations stated = of_the_paper();
  stated.push_back({"lane continuation", 1e5,
                    "below the cold energy where T_m is far below 1 K: melting is narrower than a float tells", 0, 0.5});
  stated.push_back({"pressure_jump", 5e-6, "the model takes over at the table's highest energy"});
  stated.push_back({"temperature_jump", 5e-4, "the model takes over at the table's highest energy"});
  expect_passed(check(eos, {.name = "tabulated mixed", .stated = stated}));
}
// The reference's T(e) is vertical at 0 K (oscillators freeze) and its solidus meets other borders: there a table is poorer.
TEST(Tabulated, OfTheReference) {
  violations stated = of_a_table();
  stated.push_back({"maxwell", 0.02, "p and T are interpolated one by one"});
  stated.push_back({"temperature_jump", 0.02, "cells that a border crosses"});
  stated.push_back({"temperature_jump", 1, "below the cold energy the table keeps T = 0 where there is no solid", 0.2 - 1e-9, 0.2 + 1e-9});
  stated.push_back({"cold_limit", 1, "T(e) is vertical at 0 K"});
  expect_passed(check(eos::tabulated{eos::reference{}}, {.name = "tabulated reference", .stated = stated}));
}
TEST(Tabulated, OfTillotson) {
  expect_passed(check(eos::tabulated{eos::tillotson{}}, {.name = "tabulated tillotson", .stated = of_a_table()}));
}
} // namespace
