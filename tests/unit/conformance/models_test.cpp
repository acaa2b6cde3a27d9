// SPDX-License-Identifier: MIT
// The analytic equations of state of the library.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/conformance/expect.hpp"
#include "unit/conformance/stated.hpp"

namespace {
using namespace bolide;
using namespace bolide::test;
using conformance::check;
using conformance::outcome;

TEST(Tillotson, Conforms) {
  expect_passed(check(eos::tillotson{}, {.name = "tillotson", .stated = of_tillotson()}));
}

TEST(MieGrueneisen, InAllItsExpansions) {
  expect_passed(check(eos::mie_grueneisen{}, {.name = "mie_grueneisen"}));
  expect_passed(check(eos::mie_grueneisen({.constant_gamma = true}), {.name = "mie_grueneisen, constant gamma"}));
  expect_passed(check(eos::mie_grueneisen({.fading_expansion = true}), {.name = "mie_grueneisen, fading"}));
  expect_passed(check(eos::mie_grueneisen({.s2 = 1e-5}), {.name = "mie_grueneisen, quadratic"}));
}

TEST(Reference, IsThermodynamicallyExactAndContinuous) {
  const auto report = check(eos::reference{}, {.name = "reference"});
  expect_passed(report);
  EXPECT_LT(report.at("maxwell").worst, 1e-8);
}

TEST(Gases, Conform) {
  expect_passed(check(eos::ideal_gas{}, {.name = "ideal_gas"}));
  expect_passed(check(eos::stiffened_gas{}, {.name = "stiffened_gas"}));
  const eos::jwl tnt{{.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.30}};
  expect_passed(check(tnt, {.name = "jwl"}));
}

// T from an isentrope and a constant c_v is exact where p is linear in e, as Mie-Grueneisen's is, and only there.
TEST(IsentropeTemperature, IsExactOfMieGrueneisenAndNotOfTillotson) {
  const auto exact = check(eos::isentrope_temperature{eos::mie_grueneisen{}}, {.name = "mie_grueneisen with T"});
  expect_passed(exact);
  EXPECT_EQ(exact.at("maxwell").result, outcome::passed);
  violations stated = of_tillotson();
  stated.push_back({"maxwell", 2, "constant c_v with a pressure that is not linear in e"});
  const auto report = check(eos::isentrope_temperature{eos::tillotson{}}, {.name = "tillotson with T", .stated = stated});
  expect_passed(report);
  EXPECT_EQ(report.at("maxwell").result, outcome::stated);
}

} // namespace
