// SPDX-License-Identifier: MIT
// Every pair of choices that can be combined (space, shape, transfer, scheme, grid, precision) in at least one composition that is run: a
// covering array of 19 of the 624 allowed combinations, of which combinations_test.cpp runs five.
#include "combinations/run_once.hpp"

#include <gtest/gtest.h>

namespace bolide {
namespace {
using namespace combinations;

TEST(Combinations, EveryPairOfChoicesRuns) {
  tally t;
  try_one<double, space::axisymmetric, grid::sparse, shape::linear, transfer::xpic<2>, scheme::usf>(t);
  try_one<double, space::axisymmetric, grid::uniform, shape::quadratic_bspline, transfer::flip, scheme::musl>(t);
  try_one<float, space::axisymmetric, grid::sparse, shape::quadratic_bspline, transfer::pic, scheme::musl>(t);
  try_one<float, space::cartesian_3d, grid::sparse, shape::cubic_bspline, transfer::flip, scheme::usl>(t);
  try_one<double, space::cartesian_3d, grid::uniform, shape::gimp, transfer::pic, scheme::usl>(t);
  try_one<double, space::cartesian_3d, grid::uniform, shape::quadratic_bspline, transfer::apic, scheme::usf>(t);
  try_one<double, space::planar_1d, grid::uniform, shape::cubic_bspline, transfer::pic, scheme::usf>(t);
  try_one<double, space::planar_1d, grid::uniform, shape::cubic_bspline, transfer::xpic<2>, scheme::musl>(t);
  try_one<float, space::planar_1d, grid::uniform, shape::linear, transfer::flip, scheme::musl>(t);
  try_one<float, space::planar_1d, grid::sparse, shape::quadratic_bspline, transfer::apic, scheme::usl>(t);
  try_one<double, space::plane_strain, grid::sparse, shape::cubic_bspline, transfer::apic, scheme::usf>(t);
  try_one<float, space::plane_strain, grid::uniform, shape::gimp, transfer::flip, scheme::musl>(t);
  try_one<float, space::plane_strain, grid::uniform, shape::gimp, transfer::xpic<2>, scheme::usf>(t);
  try_one<double, space::plane_strain, grid::sparse, shape::linear, transfer::pic, scheme::musl>(t);
  EXPECT_EQ(t.run, 14);
  EXPECT_EQ(t.wrong, 0);
}

} // namespace
} // namespace bolide
