// SPDX-License-Identifier: MIT
// Colliding rings and discs: energy drift of every scheme and transfer, with the loss dropped and returned as heat, and what each transfer loses.
#include "verify/collision.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(Transfers, LinearUsf) { check_transfers<shape::linear, scheme::usf>(); }
TEST(Transfers, LinearMusl) { check_transfers<shape::linear, scheme::musl>(); }
TEST(Transfers, GimpMusl) { check_transfers<shape::gimp, scheme::musl>(); }

/// PIC with linear shapes and USF does not survive the oblique rings: after 0.16 s it has taken more than twice the energy that there was (the stress
/// gives what particles that change cell make of it, without end). The run says so and stops.
TEST(Transfers, LinearUsfPicIsStoppedByTheEnergyBound) {
  using tested = method<shape::linear, transfer::pic, scheme::usf>;
  const auto t = with_heat(transfer::pic{}, 0);
  auto rings = colliding_rings<tested>(t, 1);
  EXPECT_THROW(collide<tested>(rings, 0.2), run_stopped);
  verify::record({.section = "solids",
                  .problem = "elastic rings, oblique, loss dropped",
                  .composition = composition_of<tested>(t),
                  .measure = "time reached of 0.2 s",
                  .value = rings.time(),
                  .unit = "s",
                  .note = "reported: stopped by the energy bound; take a smooth shape, MUSL or FLIP"});
}

} // namespace
} // namespace bolide
