// SPDX-License-Identifier: MIT
// Modifiers: what they wrap still conforms.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/cold_expansion_cut.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/pressure_cutoff.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/shifted_reference.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/conformance/expect.hpp"
#include "unit/conformance/stated.hpp"

namespace {
using namespace bolide;
using namespace bolide::test;
using conformance::check;

TEST(Modifiers, Conform) {
  const eos::grover mixed{table(), phase::mixed{}};
  expect_passed(check(eos::scaled_density{mixed, 1.05}, {.name = "scaled_density", .stated = of_the_paper()}));
  expect_passed(check(eos::shifted_reference{eos::grover{table(), phase::helm{}}, 2e5}, {.name = "shifted_reference"}));
  expect_passed(check(eos::sound_speed_floor{mixed, 0.05}, {.name = "sound_speed_floor", .stated = of_the_paper()}));
}

TEST(Modifiers, CutOffs) {
  const eos::grover helm{table(), phase::helm{}};
  expect_passed(check(eos::pressure_cutoff{eos::mie_grueneisen{}, -1.5e9}, {.name = "pressure_cutoff"}));
  expect_passed(check(eos::pressure_cutoff{helm, -1.5e9},
                      {.name = "pressure_cutoff of helm", .stated = {{"maxwell", 2000, "a cut-off is not thermodynamics", 0, 1}}}));
  expect_passed(check(eos::cold_expansion_cut{eos::tillotson{}}, {.name = "cold_expansion_cut", .stated = of_tillotson()}));
}
} // namespace
