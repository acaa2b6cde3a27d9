// SPDX-License-Identifier: MIT
// Tiles: every particle is in one lane of one tile, in its own cell, and no two of a tile in the same; the order that fills them.
#include "bolide/solver/tiles.hpp"

#include "unit/solver/scenes.hpp"

#include <random>
#include <set>

namespace bolide {
namespace {
using namespace test;
constexpr int lanes = 8, stride = 32;

std::vector<tile> tiles_of(const std::vector<std::int32_t>& first, std::uint32_t begin = 0) {
  std::vector<tile> tiles;
  tile_layer<lanes, stride> layer(tiles);
  auto padded = first;
  padded.resize(first.size() + lanes);
  layer.add(begin, static_cast<int>(first.size()), padded.data());
  layer.close();
  return tiles;
}
void expect_sound(const std::vector<tile>& tiles, const std::vector<std::int32_t>& first, std::uint32_t begin) {
  std::size_t next = 0;
  for (const auto& t : tiles) {
    EXPECT_EQ(t.begin, begin + next);
    int count = 0;
    for (int l = 0; l < lanes; ++l) {
      if (!((t.lanes >> l) & 1)) continue;
      ASSERT_LT(next, first.size());
      EXPECT_EQ(t.base + l, first[next]) << "particle " << next << " is in another cell's lane";
      EXPECT_EQ(first[next] / stride, t.base / stride) << "a tile reaches into the next row";
      ++next, ++count;
    }
    EXPECT_EQ(t.count, count);
    EXPECT_GT(count, 0);
  }
  EXPECT_EQ(next, first.size());
}

TEST(Tiles, HoldEveryParticleInItsOwnCell) {
  std::mt19937 random(3);
  for (const int cells : {3, 20, 300}) {
    std::vector<std::int32_t> first(500);
    for (auto& x : first) x = static_cast<std::int32_t>(random() % static_cast<unsigned>(cells)) + 40;
    expect_sound(tiles_of(first, 7), first, 7);
    std::sort(first.begin(), first.end());
    expect_sound(tiles_of(first, 7), first, 7);
  }
}

TEST(Tiles, AFullLatticeFillsThem) {
  std::vector<std::int32_t> first;
  for (int rank = 0; rank < 4; ++rank)
    for (int cell = 64; cell < 72; ++cell) first.push_back(cell);
  EXPECT_EQ(tiles_of(first).size(), 4u);
  for (auto& x : first) ++x; // all fly on by a cell: side by side
  const auto moved = tiles_of(first);
  EXPECT_EQ(moved.size(), 4u);
  expect_sound(moved, first, 0);
  for (auto& x : first) x += 18; // to the end of the row: no tile goes on in the next one
  expect_sound(tiles_of(first), first, 0);
}

TEST(Tiles, InterleavingTakesOneOfEveryCellInTurnAndKeepsAll) {
  const std::vector<std::uint32_t> start{0, 2, 2, 5, 6, 6, 6, 6, 7, 8}; // cells of 2, 0, 3, 1, 0, 0, 0, 1 particles; then 1 of the next group
  std::vector<std::uint32_t> order{0, 1, 2, 3, 4, 5, 6, 7};
  interleave(start, 8, order);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 2, 5, 6, 1, 3, 4, 7}));
}

/// Where the order has decayed, the particles of a block are arranged anew: all columns move together, ids and all.
TEST(Tiles, ArrangingARangeChangesNoParticle) {
  auto sim = small_impact<linear_flip_usf>();
  for (int i = 0; i < 30; ++i) sim.step();
  sim.for_each_body([&](auto& set) {
    auto& p = set.columns;
    using point = std::array<double, 5>;
    const auto rows = [&](const auto& r) {
      std::set<point> all;
      for (std::size_t i = r.begin; i < r.end; ++i)
        all.insert({static_cast<double>(p.id()[i]), p.template get<field::position>(0)[i], p.template get<field::position>(1)[i], p.template get<field::energy>()[i],
                    p.template get<field::deviator>(2)[i]});
      return all;
    };
    std::mt19937 random(5);
    for (auto& r : set.ranges) {
      const auto before = rows(r);
      std::vector<std::uint32_t> shuffled(r.end - r.begin);
      std::iota(shuffled.begin(), shuffled.end(), 0u);
      std::shuffle(shuffled.begin(), shuffled.end(), random);
      p.reorder(r.begin, shuffled);
      EXPECT_EQ(rows(r), before);
      set.lay_tiles(r, sim.cell());
      const std::size_t disordered = r.tiles.size();
      set.arrange(r, sim.cell());
      EXPECT_EQ(rows(r), before);
      if (r.tiles.empty()) continue; // too few particles fill a tile
      EXPECT_LE(r.tiles.size(), disordered);
      std::size_t held = 0;
      for (const auto& t : r.tiles) held += static_cast<std::size_t>(t.count);
      EXPECT_EQ(held, r.end - r.begin);
    }
  });
}

} // namespace
} // namespace bolide
