// SPDX-License-Identifier: MIT
// Settings of a run are checked at the door.
#include "bolide/time/courant.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bolide {
namespace {

template <class T> class Controls : public testing::Test {};
using scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Controls, scalars);

TYPED_TEST(Controls, DefaultsAreInRange) { EXPECT_NO_THROW(controls<TypeParam>{}.validate()); }

TYPED_TEST(Controls, EverySettingIsChecked) {
  using settings = controls<TypeParam>;
  const auto refused = [](auto&& change, const char* sentence) {
    settings c;
    change(c);
    try {
      c.validate();
      ADD_FAILURE() << "not refused: " << sentence;
    } catch (const bad_parameter& e) {
      EXPECT_STREQ(e.what(), sentence);
    }
  };
  refused([](settings& c) { c.courant = 1.6; }, "Courant number = 1.6: must be in (0, 1.5]");
  refused([](settings& c) { c.courant = std::nan(""); }, "Courant number = nan: must be in (0, 1.5]");
  refused([](settings& c) { c.first_step = 0; }, "first step = 0: must be in (0, 1] of the allowed step");
  refused([](settings& c) { c.growth = 1; }, "growth = 1: must be in (1, 10]");
  refused([](settings& c) { c.dt_floor = 1; }, "dt floor = 1: must be in (0, 1) of the first step");
  refused([](settings& c) { c.energy_bound = 0; }, "energy bound = 0: must be positive");
  refused([](settings& c) { c.step_cap = 0; }, "step cap = 0: must be positive");
  refused([](settings& c) { c.threads = -1; }, "threads = -1: must be in [0, 1024]");
}

} // namespace
} // namespace bolide
