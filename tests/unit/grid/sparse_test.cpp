// SPDX-License-Identifier: MIT
// Blocks, windows and runs of the sparse grid against a dense reference that is addressed by coordinates alone.
#include "bolide/grid/sparse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace bolide::grid {
namespace {

template <class Dim> class SparseGrid : public testing::Test {
protected:
  static constexpr int axes = Dim::value;
  using blocks = block_map<axes>;
  using index = cell_index<axes>;

  /// Some blocks: a clump at the origin (both signs) and one far away.
  static std::vector<index> some_blocks() {
    std::vector<index> b;
    std::mt19937 random(3);
    std::uniform_int_distribution<int> near(-4, 3);
    for (int i = 0; i < 12; ++i) {
      index at;
      for (auto& x : at) x = near(random);
      b.push_back(at);
      b.push_back(at); // twice: duplicates do no harm
    }
    index far;
    far.fill(50'000'000);
    b.push_back(far);
    return b;
  }
  static std::vector<index> around(const index& b) {
    std::vector<index> r{b};
    for (std::size_t d = 0; d < axes; ++d) {
      const auto n = r.size();
      for (std::size_t i = 0; i < n; ++i)
        for (int s : {-1, 1}) {
          r.push_back(r[i]);
          r.back()[d] += s;
        }
    }
    return r;
  }
};
using dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SparseGrid, dimensions);

TYPED_TEST(SparseGrid, HoldsTheOccupiedBlocksAndTheirNeighboursAndNoOther) {
  using fixture = SparseGrid<TypeParam>;
  typename fixture::blocks map;
  const auto occupied = fixture::some_blocks();
  map.rebuild(occupied);
  std::set<typename fixture::index> expected;
  for (const auto& b : occupied)
    for (const auto& n : fixture::around(b)) expected.insert(n);
  EXPECT_EQ(map.size(), expected.size());
  for (const auto& b : expected) EXPECT_GE(map.find(b), 0);
  auto missing = occupied.back();
  missing[0] += 5;
  EXPECT_EQ(map.find(missing), -1);
  EXPECT_EQ(map.node(missing), -1);
  for (std::size_t i = 1; i < map.size(); ++i) EXPECT_LT(map.coordinate(i - 1), map.coordinate(i)) << "lexicographic order fixes every sum over nodes";
}

TYPED_TEST(SparseGrid, EveryNodeOfEveryBlockHasItsOwnNumber) {
  using fixture = SparseGrid<TypeParam>;
  using map_type = typename fixture::blocks;
  map_type map;
  map.rebuild(fixture::some_blocks());
  std::set<std::int32_t> seen;
  for (std::size_t b = 0; b < map.size(); ++b)
    for (int local = 0; local < map_type::nodes_per_block; ++local) {
      typename fixture::index at;
      int rest = local;
      for (int d = fixture::axes - 1; d >= 0; --d) {
        const auto k = static_cast<std::size_t>(d);
        at[k] = map.coordinate(b)[k] * map_type::side + rest % map_type::side;
        rest /= map_type::side;
      }
      EXPECT_EQ(map_type::block_of(at), map.coordinate(b));
      const auto node = map.node(at);
      EXPECT_EQ(node, static_cast<std::int32_t>(b) * map_type::nodes_per_block + local);
      EXPECT_TRUE(seen.insert(node).second);
    }
}

TYPED_TEST(SparseGrid, NegativeCellsBelongToNegativeBlocks) {
  using fixture = SparseGrid<TypeParam>;
  typename fixture::index at;
  at.fill(-1);
  typename fixture::index block;
  block.fill(-1);
  EXPECT_EQ(fixture::blocks::block_of(at), block);
  at.fill(-fixture::blocks::side);
  EXPECT_EQ(fixture::blocks::block_of(at), block);
  at.fill(-fixture::blocks::side - 1);
  block.fill(-2);
  EXPECT_EQ(fixture::blocks::block_of(at), block);
}

/// for_each_run covers each node of a range exactly once and pairs it with its place in the window; window::nodes lists the same.
TYPED_TEST(SparseGrid, RunsPairWindowAndColumnNodes) {
  using fixture = SparseGrid<TypeParam>;
  using map_type = typename fixture::blocks;
  constexpr int dim = fixture::axes;
  using win = window<dim>;
  map_type map;
  const auto occupied = fixture::some_blocks();
  map.rebuild(occupied);
  std::mt19937 random(11);
  constexpr int least = -win::reach, most = win::stride - win::reach - 1;
  for (int trial = 0; trial < 60; ++trial) {
    const auto& block = occupied[static_cast<std::size_t>(trial) % occupied.size()];
    node_range<dim> range;
    for (std::size_t d = 0; d < dim; ++d) {
      int a = std::uniform_int_distribution<int>(least, most)(random), b = std::uniform_int_distribution<int>(least, most)(random);
      if (trial == 0) a = least, b = most; // the whole window
      if (trial == 1) a = b = most;        // one node
      range.low[d] = std::min(a, b);
      range.high[d] = std::max(a, b);
    }
    const auto nodes = win::nodes(map.neighbourhood(block));
    std::map<std::int32_t, int> pairs; // column node -> window offset
    for_each_run<dim>(map.neighbourhood(block), range, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; ++i) EXPECT_TRUE(pairs.emplace(node + i, at + i).second) << "a node was met twice";
    });
    std::size_t expected = 1;
    for (std::size_t d = 0; d < dim; ++d) expected *= static_cast<std::size_t>(range.high[d] - range.low[d] + 1);
    EXPECT_EQ(pairs.size(), expected);
    std::array<int, dim> at = range.low;
    for (;;) { // dense reference: coordinates only
      typename fixture::index global;
      for (std::size_t d = 0; d < dim; ++d) global[d] = block[d] * map_type::side + at[d];
      const auto found = pairs.find(map.node(global));
      ASSERT_NE(found, pairs.end());
      EXPECT_EQ(found->second, win::offset(at));
      EXPECT_LT(found->second, win::size);
      EXPECT_GE(found->second, 0);
      EXPECT_EQ(nodes[static_cast<std::size_t>(found->second)], found->first);
      int d = dim - 1;
      for (; d >= 0; --d) {
        if (++at[static_cast<std::size_t>(d)] <= range.high[static_cast<std::size_t>(d)]) break;
        at[static_cast<std::size_t>(d)] = range.low[static_cast<std::size_t>(d)];
      }
      if (d < 0) break;
    }
  }
}

/// What makes parallel scatters safe and reproducible: full windows of two blocks of one colour share no node.
TYPED_TEST(SparseGrid, WindowsOfOneColourAreDisjoint) {
  using fixture = SparseGrid<TypeParam>;
  using map_type = typename fixture::blocks;
  constexpr int dim = fixture::axes;
  using win = window<dim>;
  map_type map;
  const auto occupied = fixture::some_blocks();
  map.rebuild(occupied);
  std::set<typename fixture::index> once(occupied.begin(), occupied.end());
  node_range<dim> whole;
  whole.low.fill(-win::reach);
  whole.high.fill(win::stride - win::reach - 1);
  std::map<std::int32_t, std::set<int>> colours_of_node;
  for (const auto& b : once)
    for_each_run<dim>(map.neighbourhood(b), whole, [&](std::int32_t node, int, int count) {
      for (int i = 0; i < count; ++i)
        EXPECT_TRUE(colours_of_node[node + i].insert(map_type::colour_of(b)).second) << "two blocks of colour " << map_type::colour_of(b) << " share node " << node + i;
    });
}

TEST(SparseGridSpacing, IsChecked) {
  EXPECT_THROW(sparse(0), bad_parameter);
  EXPECT_THROW(sparse(-1e-4), bad_parameter);
  EXPECT_THROW(sparse(std::nan("")), bad_parameter);
  try {
    sparse h(-1e-4);
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "grid spacing = -1e-04 m: must be positive and finite (unit: m)");
  }
}

} // namespace
} // namespace bolide::grid
