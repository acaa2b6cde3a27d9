// SPDX-License-Identifier: MIT
// Colliding rings: conservation, mirror symmetry and a boosted frame. Every scheme and transfer: collision_slow_test.cpp.
#include "verify/collision.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Collision : public testing::Test {};
using methods = testing::Types<bspline_flip_musl, bspline_apic_usf>;
TYPED_TEST_SUITE(Collision, methods, method_names);

TYPED_TEST(Collision, KeepsWhatItPromises) { check_conservation<TypeParam>(typename TypeParam::transfer_type{}, 1, 0.1); }

/// Rings started as mirror images stay mirror images but for the order of sums.
TYPED_TEST(Collision, MirrorImageOfTheSceneGivesTheMirrorImage) {
  typename TypeParam::transfer_type t{};
  auto a = colliding_rings<TypeParam>(t, 1), b = colliding_rings<TypeParam>(t, 1, true);
  const auto start = positions(a), image = positions(b);
  a.run(0.05);
  b.run(0.05);
  EXPECT_EQ(a.steps(), b.steps());
  const auto x = positions(a), y = positions(b);
  double worst = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j)
      if (std::abs(start[i][0] + image[j][0]) < 1e-6 && std::abs(start[i][1] - image[j][1]) < 1e-6) {
        ++found;
        worst = std::max(worst, (plane{-x[i][0], x[i][1]} - y[j]).norm());
      }
  EXPECT_EQ(found, x.size());
  verify::record({.section = "symmetry",
                  .problem = "elastic rings, mirror image",
                  .composition = composition<TypeParam>("plane_strain"),
                  .measure = "largest distance from the image",
                  .value = worst,
                  .bound = 1e-10,
                  .unit = "m"});
  EXPECT_LT(worst, 1e-10);
}

/// In a frame that moves by 25 m/s along both axes every particle meets another part of the grid in shorter steps. Bodies feel each other from where
/// they share a node, which depends on where the grid lies by up to a cell: half a cell is what is asked.
TYPED_TEST(Collision, BoostedFrameSeesTheSameCollision) {
  typename TypeParam::transfer_type t{};
  const plane boost{25, 25};
  auto a = colliding_rings<TypeParam>(t, 1), b = colliding_rings<TypeParam>(t, 1, false, boost);
  a.run(0.1);
  b.run(0.1);
  std::vector<plane> va(a.particle_count());
  each_velocity(a, [&](std::uint32_t id, double, const plane& v) { va[id] = v; });
  const auto xa = positions(a), xb = positions(b);
  double squares = 0;
  for (std::size_t i = 0; i < xa.size(); ++i) squares += (xb[i] - xa[i] - 0.1 * boost).squaredNorm();
  double ka = 0, kb = 0;
  for (const auto& v : va) ka += v.squaredNorm();
  each_velocity(b, [&](std::uint32_t, double, const plane& v) { kb += (v - boost).squaredNorm(); });
  const double shift = std::sqrt(squares / static_cast<double>(xa.size()));
  verify::record({.section = "symmetry",
                  .problem = "elastic rings, boost 25 m/s on both axes",
                  .composition = composition<TypeParam>("plane_strain"),
                  .measure = "RMS difference of positions after the collision over the cell",
                  .value = shift / 0.2,
                  .bound = 0.5});
  verify::record({.section = "symmetry",
                  .problem = "elastic rings, boost 25 m/s on both axes",
                  .composition = composition<TypeParam>("plane_strain"),
                  .measure = "kinetic energy in the frame of the rings, relative difference",
                  .value = kb / ka - 1,
                  .bound = 0.1});
  EXPECT_LT(shift / 0.2, 0.5);
  EXPECT_NEAR(kb / ka, 1, 0.1);
}

} // namespace
} // namespace bolide
