// SPDX-License-Identifier: MIT
// A mirror plane against the obvious reference: the same particles together with their mirror images on a grid without a plane.
#include "bolide/grid/mirror.hpp"
#include "bolide/grid/node_column.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"

#include <gtest/gtest.h>

#include <random>

namespace bolide::grid {
namespace {

using map2 = block_map<2>;
using values = node_column<double, 3>; // m, P_0, P_1

struct point {
  double x[2], v[2];
};

template <class Shape> void add(const map2& map, values& sums, const point& p) {
  double n[2][Shape::support];
  cell_index<2> first;
  for (std::size_t d = 0; d < 2; ++d) {
    first[d] = static_cast<std::int32_t>(std::floor(p.x[d] - Shape::offset));
    Shape::value(p.x[d] - first[d], n[d]);
  }
  for (int i = 0; i < Shape::support; ++i)
    for (int j = 0; j < Shape::support; ++j) {
      const auto node = map.node({first[0] + i, first[1] + j});
      ASSERT_GE(node, 0);
      const double w = n[0][i] * n[1][j];
      for (int c = 0; c < 3; ++c) sums(c, static_cast<std::size_t>(node)) += w * (c == 0 ? 1 : p.v[c - 1]);
    }
}

template <class Shape> class Mirror : public testing::Test {};
using shapes = testing::Types<shape::linear, shape::quadratic_bspline>;
TYPED_TEST_SUITE(Mirror, shapes);

TYPED_TEST(Mirror, GivesWhatParticlesAndTheirImagesGive) {
  for (const auto& plane : {mirror{0, 0.0, true}, mirror{0, 3.0, true}, mirror{1, -2.0, false}, mirror{1, 5.0, true}}) {
    SCOPED_TRACE("axis " + std::to_string(plane.axis) + " at " + std::to_string(plane.position));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> near(0, 3), along(-6, 6), speed(-1, 1);
    std::vector<point> real, all;
    for (int i = 0; i < 200; ++i) {
      point p;
      const auto a = static_cast<std::size_t>(plane.axis), b = 1 - a;
      p.x[a] = plane.position + (plane.material_above ? 1 : -1) * near(random);
      p.x[b] = along(random);
      p.v[0] = speed(random), p.v[1] = speed(random);
      real.push_back(p);
      all.push_back(p);
      p.x[a] = 2 * plane.position - p.x[a];
      p.v[a] = -p.v[a];
      all.push_back(p);
    }
    map2 map;
    std::vector<cell_index<2>> blocks;
    for (const auto& p : all) blocks.push_back(map2::block_of({static_cast<std::int32_t>(std::floor(p.x[0])), static_cast<std::int32_t>(std::floor(p.x[1]))}));
    map.rebuild(blocks);
    values ours;
    ours.resize(map.size() * map2::nodes_per_block);
    values reference = ours;
    for (const auto& p : real) add<TypeParam>(map, ours, p);
    for (const auto& p : all) add<TypeParam>(map, reference, p);
    mirror_nodes<2> m(plane, 1.0);
    m.rebuild(map);
    m.complete(ours, 1);
    // Compared where a real particle can look: on the plane, on the material's side, and as far beyond as a support reaches.
    int images = 0;
    for (std::size_t b = 0; b < map.size(); ++b)
      for (int local = 0; local < map2::nodes_per_block; ++local) {
        const auto node = b * map2::nodes_per_block + static_cast<std::size_t>(local);
        const int at[] = {map.coordinate(b)[0] * map2::side + local / map2::side, map.coordinate(b)[1] * map2::side + local % map2::side};
        const double depth = (plane.material_above ? 1 : -1) * (plane.position - at[plane.axis]);
        EXPECT_EQ(m.is_image(node), depth > 0);
        if (depth > 1) continue;
        if (depth > 0) ++images;
        if (TypeParam::support == 2 && depth > 0) continue; // linear shapes reach no image node: what lies there is never read
        const double share = depth == 0 ? 0.5 : 1;          // a node on the plane belongs to both halves
        for (int c = 0; c < 3; ++c) {
          const double expected = depth == 0 && c == 1 + plane.axis ? 0 : share * reference(c, static_cast<std::size_t>(node));
          EXPECT_NEAR(ours(c, static_cast<std::size_t>(node)), expected, 1e-12) << "node " << at[0] << " " << at[1] << " component " << c;
        }
      }
    EXPECT_GT(images, 0);
  }
}

TYPED_TEST(Mirror, TwoPlanesFoldIntoACorner) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> near(0, 3), speed(-1, 1);
  std::vector<point> real, all;
  for (int i = 0; i < 100; ++i) {
    const point p{{near(random), near(random)}, {speed(random), speed(random)}};
    real.push_back(p);
    for (int a : {1, -1})
      for (int b : {1, -1}) all.push_back({{a * p.x[0], b * p.x[1]}, {a * p.v[0], b * p.v[1]}});
  }
  map2 map;
  map.rebuild({{0, 0}, {-1, -1}});
  values ours;
    ours.resize(map.size() * map2::nodes_per_block);
    values reference = ours;
  for (const auto& p : real) add<TypeParam>(map, ours, p);
  for (const auto& p : all) add<TypeParam>(map, reference, p);
  std::vector<mirror_nodes<2>> mirrors;
  for (int axis : {0, 1}) {
    mirrors.emplace_back(mirror{axis, 0.0, true}, 1.0);
    mirrors.back().rebuild(map);
  }
  for (const auto& m : mirrors) m.complete(ours, 1);
  for (int i = TypeParam::support == 2 ? 0 : -1; i < 5; ++i)
    for (int j = TypeParam::support == 2 ? 0 : -1; j < 5; ++j) {
      const auto node = static_cast<std::size_t>(map.node({i, j}));
      const double share = (i == 0 ? 0.5 : 1) * (j == 0 ? 0.5 : 1);
      for (int c = 0; c < 3; ++c) {
        const double expected = (c == 1 && i == 0) || (c == 2 && j == 0) ? 0 : share * reference(c, static_cast<std::size_t>(node));
        EXPECT_NEAR(ours(c, static_cast<std::size_t>(node)), expected, 1e-12) << i << " " << j << " component " << c;
      }
    }
}

TEST(MirrorPlane, MustLieOnAGridLine) {
  EXPECT_NO_THROW(mirror_nodes<2>({1, 3e-4, true}, 1e-4));
  EXPECT_THROW(mirror_nodes<2>({1, 3.5e-4, true}, 1e-4), bad_parameter);
  EXPECT_THROW(mirror_nodes<2>({2, 0, true}, 1e-4), bad_parameter);
  EXPECT_THROW(mirror_nodes<1>({-1, 0, true}, 1e-4), bad_parameter);
  try {
    mirror_nodes<2>({1, 3.5e-4, true}, 1e-4);
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("mirror position = 0.00035 m: must be on a grid line (a multiple of the grid spacing 1e-04 m)"), std::string::npos) << e.what();
  }
}

} // namespace
} // namespace bolide::grid
