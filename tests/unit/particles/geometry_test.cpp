// SPDX-License-Identifier: MIT
// Seeding: the paper's 58,010 points, lattice positions, masses beside the geometric ones.
#include "bolide/core/unit.hpp"
#include "bolide/particles/geometry.hpp"
#include "bolide/space/axisymmetric.hpp"

#include <gtest/gtest.h>

namespace bolide {
namespace {
using unit::mm;
using point = vec<double, 2>;

template <class Geometry> std::vector<point> fill(const Geometry& g, double dx) {
  std::vector<point> all;
  for_each_lattice_point(g, g.anchor(), dx, true, [&](const point& x) { all.push_back(x); });
  return all;
}
double ring_volume(const std::vector<point>& all, double dx) {
  double v = 0;
  for (const auto& x : all) v += space::axisymmetric::volume(x.data(), dx * dx);
  return v;
}

TEST(Seeding, PaperSphereHas14010Points) {
  const sphere ball{point{0, -4.75 * mm}, 4.75 * mm};
  const auto all = fill(ball, 0.05 * mm);
  EXPECT_EQ(all.size(), 14010u);
  for (const auto& x : all) {
    EXPECT_GT(x[0], 0);
    EXPECT_LE((x - ball.centre).norm(), 4.725 * mm);
  }
}

TEST(Seeding, PaperSphereIs1p7PercentLight) {
  const sphere ball{point{0, 0}, 4.75 * mm};
  const double light = 1 - ring_volume(fill(ball, 0.05 * mm), 0.05 * mm) / ball.volume(true);
  EXPECT_NEAR(light, 0.017, 0.0015);
  const double finer = 1 - ring_volume(fill(ball, 0.0125 * mm), 0.0125 * mm) / ball.volume(true);
  EXPECT_NEAR(finer / light, 0.25, 0.05) << "the error is of first order in the spacing";
}

TEST(Seeding, PaperPlateHas44By1000Points) {
  const box plate{point{0, 0}, point{50 * mm, 2.2 * mm}};
  const auto all = fill(plate, 0.05 * mm);
  EXPECT_EQ(all.size(), 44000u);
  EXPECT_NEAR(ring_volume(all, 0.05 * mm) / plate.volume(true), 1, 1e-12) << "the midpoint rule is exact for the measure 2 pi r";
  // half-offset lattice, last axis fastest
  EXPECT_NEAR(all[0][0], 0.025 * mm, 1e-12);
  EXPECT_NEAR(all[0][1], 0.025 * mm, 1e-12);
  EXPECT_NEAR(all[1][1], 0.075 * mm, 1e-12);
  EXPECT_NEAR(all.back()[0], 49.975 * mm, 1e-12);
}

TEST(Seeding, ABoxAcrossTheAxisKeepsToPositiveRadii) {
  const auto all = fill(box{point{-1 * mm, 0}, point{1 * mm, 1 * mm}}, 0.1 * mm);
  EXPECT_EQ(all.size(), 100u);
  for (const auto& x : all) EXPECT_GT(x[0], 0);
}

TEST(Seeding, OneAxis) {
  int n = 0;
  const box<1> slab{vec<double, 1>{-4 * mm}, vec<double, 1>{0}};
  for_each_lattice_point(slab, slab.anchor(), 0.05 * mm, false, [&](const vec<double, 1>&) { ++n; });
  EXPECT_EQ(n, 80);
  EXPECT_NEAR(slab.volume(false), 4 * mm, 1e-18);
}

TEST(Seeding, VolumesAreThoseOfTheSpace) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR((sphere{point{0, 0}, 2.0}.volume(false)), 4 * pi, 1e-14) << "a disc of one metre depth";
  EXPECT_NEAR((sphere{point{0, 0}, 2.0}.volume(true)), 32 * pi / 3, 1e-13);
  EXPECT_NEAR((shell{point{0, 0}, 1.0, 2.0}.volume(false)), 3 * pi, 1e-14);
  EXPECT_NEAR((shell{vec<double, 3>{0, 0, 0}, 1.0, 2.0}.volume(false)), 28 * pi / 3, 1e-13);
  EXPECT_NEAR((box{point{-1, 0}, point{1, 2}}.volume(false)), 4, 1e-15);
  EXPECT_NEAR((box{point{-1, 0}, point{1, 2}}.volume(true)), 2 * pi, 1e-15) << "only positive radii count";
  // midpoint membership: the lattice has the volume on average
  double n = 0;
  const shell ring{vec<double, 3>{0.1, 0.2, 0.3}, 0.5, 1.0};
  for_each_lattice_point(ring, ring.anchor(), 0.05, false, [&](const vec<double, 3>&) { n += 0.05 * 0.05 * 0.05; });
  EXPECT_NEAR(n / ring.volume(false), 1, 0.01);
  EXPECT_THROW((shell{point{0, 0}, 1.0, 0.5}), bad_parameter);
}

TEST(Seeding, BadShapesAreRefusedWithASentence) {
  EXPECT_THROW((sphere{point{0, 0}, -1.0}), bad_parameter);
  try {
    box{point{0, 2 * mm}, point{1 * mm, 0}};
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "box edge = -0.002 m: must be positive (unit: m)");
  }
  EXPECT_THROW(fill(sphere{point{0, 0}, 1.0}, 0.0), bad_parameter);
}

} // namespace
} // namespace bolide
