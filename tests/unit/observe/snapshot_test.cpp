// SPDX-License-Identifier: MIT
#include "bolide/observe/snapshot.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

snapshot two_particles() {
  snapshot s;
  s.add("position", "m", 2, {1, 2, 3, 4});
  s.add("mass", "kg", 1, {0.5, 0.25});
  return s;
}

TEST(snapshot, reads_components_and_size) {
  const snapshot s = two_particles();
  EXPECT_EQ(s.size(), 2u);
  EXPECT_EQ(s.at("position")(1, 0), 3);
  EXPECT_EQ(s.at("position")(1, 1), 4);
  EXPECT_EQ(s.at("mass")(1), 0.25);
  EXPECT_EQ(snapshot{}.size(), 0u);
}

TEST(snapshot, absent_column_is_null_or_a_sentence) {
  const snapshot s = two_particles();
  EXPECT_EQ(s.find("temperature"), nullptr);
  try {
    s.at("temperature");
    FAIL() << "no exception";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "the snapshot has no column \"temperature\"; it has position, mass");
  }
}

TEST(snapshot, refuses_columns_that_do_not_fit) {
  snapshot s = two_particles();
  EXPECT_THROW(s.add("pressure", "Pa", 1, {1, 2, 3}), bad_parameter);
  EXPECT_THROW(s.add("velocity", "m/s", 2, {1, 2, 3}), bad_parameter);
  EXPECT_THROW(s.add("mass", "kg", 1, {1, 2}), bad_parameter);
  EXPECT_THROW(s.add("velocity", "m/s", 0, {}), bad_parameter);
}

} // namespace
} // namespace bolide::observe
