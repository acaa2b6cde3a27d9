// SPDX-License-Identifier: MIT
// Particle storage and field lists: union without duplicates, sizes pinned, order kept through sorts.
#include "bolide/core/field.hpp"
#include "bolide/particles/column_view.hpp"
#include "bolide/particles/columns.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/planar_1d.hpp"

#include <gtest/gtest.h>

namespace bolide {
namespace {

TEST(FieldUnion, RemovesDuplicatesAndKeepsTheOrderOfFirstMention) {
  using a = fields<field::mass, field::energy>;
  using b = fields<field::energy, field::deviator>;
  using u = field_union_t<a, b, fields<>, fields<field::mass>>;
  EXPECT_TRUE((std::is_same_v<u, fields<field::mass, field::energy, field::deviator>>));
  EXPECT_EQ(u::count, 3);
  EXPECT_TRUE(u::contains<field::deviator>);
  EXPECT_FALSE(u::contains<field::failed>);
  EXPECT_TRUE((std::is_same_v<field_union_t<>, fields<>>));
  EXPECT_TRUE((std::is_same_v<field_union_t<fields<>, fields<>>, fields<>>));
}

using some = fields<field::mass, field::position, field::deviator, field::affine_velocity>;

TEST(Columns, RanksTakeWhatTheSpaceSays) {
  EXPECT_EQ((particles::columns<double, space::axisymmetric, some>::column_count), 1 + 2 + 3 + 4);
  EXPECT_EQ((particles::columns<double, space::planar_1d, some>::column_count), 4);
  EXPECT_EQ((particles::columns<double, space::axisymmetric, some>::bytes_per_particle), 10 * 8 + 4u);
  EXPECT_EQ((particles::columns<float, space::axisymmetric, some>::bytes_per_particle), 10 * 4 + 4u);
}

TEST(Columns, ComponentsDoNotAlias) {
  particles::columns<double, space::axisymmetric, some> p;
  for (std::uint32_t i = 0; i < 5; ++i) p.append(i);
  double x = 0;
  for (int d = 0; d < 2; ++d) p.get<field::position>(d)[3] = ++x;
  for (int d = 0; d < 3; ++d) p.get<field::deviator>(d)[3] = ++x;
  for (int d = 0; d < 4; ++d) p.get<field::affine_velocity>(d)[3] = ++x;
  p.get<field::mass>()[3] = ++x;
  EXPECT_EQ(p.get<field::position>(0)[3], 1);
  EXPECT_EQ(p.get<field::deviator>(2)[3], 5);
  EXPECT_EQ(p.get<field::affine_velocity>(0)[3], 6);
  EXPECT_EQ(p.get<field::affine_velocity>(3)[3], 9);
  EXPECT_EQ(p.get<field::mass>()[3], 10);
  EXPECT_EQ(p.get<field::mass>()[2], 0);
}

TEST(Columns, ReorderMovesEveryFieldAndDropsWhoIsNotNamed) {
  particles::columns<float, space::axisymmetric, some> p;
  for (std::uint32_t i = 0; i < 6; ++i) {
    p.append(10 + i);
    p.get<field::mass>()[i] = static_cast<float>(i);
    p.get<field::deviator>(1)[i] = static_cast<float>(100 + i);
  }
  p.reorder({5, 0, 3});
  ASSERT_EQ(p.size(), 3u);
  EXPECT_EQ(p.id()[0], 15u);
  EXPECT_EQ(p.get<field::mass>()[2], 3);
  EXPECT_EQ(p.get<field::deviator>(1)[0], 105);
  for (std::size_t pad = 3; pad < 19; ++pad) EXPECT_EQ(p.get<field::mass>()[pad], 3) << "a lane reads a copy of the last particle past the end";
  p.reorder({});
  EXPECT_EQ(p.size(), 0u);
  EXPECT_EQ(p.append(7), 0u);
  EXPECT_EQ(p.get<field::mass>()[0], 0) << "a new particle starts from zeros";
}

TEST(ColumnView, SeesTheColumnsItNames) {
  particles::columns<double, space::axisymmetric, some> p;
  p.append(4);
  particles::column_view<double, space::axisymmetric, fields<field::deviator, field::mass>> view(p);
  view.get<field::deviator>(2)[0] = 8;
  view.get<field::mass>()[0] = 2;
  EXPECT_EQ(p.get<field::deviator>(2)[0], 8);
  EXPECT_EQ(p.get<field::mass>()[0], 2);
  EXPECT_EQ(view.id()[0], 4u);
  EXPECT_FALSE((decltype(view)::has<field::position>));
}

} // namespace
} // namespace bolide
