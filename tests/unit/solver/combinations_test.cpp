// SPDX-License-Identifier: MIT
// Every choice that can be combined (space, shape, transfer, scheme, grid, precision) in at least one composition that is run: five of the
// 624 allowed combinations. Together with the fourteen of combinations_slow_test.cpp they are a covering array: every pair of choices runs.
// tests/combinations runs them all (label exhaustive).
#include "combinations/run_once.hpp"

#include <gtest/gtest.h>

namespace bolide {
namespace {
using namespace combinations;

TEST(Combinations, EveryChoiceRuns) {
  tally t;
  try_one<double, space::axisymmetric, grid::uniform, shape::cubic_bspline, transfer::apic, scheme::musl>(t);
  try_one<float, space::axisymmetric, grid::sparse, shape::gimp, transfer::pic, scheme::usl>(t);
  try_one<float, space::cartesian_3d, grid::sparse, shape::linear, transfer::xpic<2>, scheme::musl>(t);
  try_one<double, space::planar_1d, grid::uniform, shape::gimp, transfer::flip, scheme::usf>(t);
  try_one<float, space::plane_strain, grid::sparse, shape::quadratic_bspline, transfer::xpic<2>, scheme::usl>(t);
  EXPECT_EQ(t.run, 5);
  EXPECT_EQ(t.wrong, 0);
}

} // namespace
} // namespace bolide
