// SPDX-License-Identifier: MIT
// The two engines of the transfers (solver/by_tiles.hpp, solver/by_rows.hpp) give the same step but for the order of the sums.
#include "unit/solver/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace bolide {
namespace {
using namespace test;

/// Every range by tiles, or every range by rows. The next sort may choose anew.
template <class Sim> void choose(Sim& sim, bool tiles) {
  sim.for_each_body([&](auto& set) {
    for (auto& r : set.ranges) {
      r.tiles.clear();
      if (tiles) set.lay_tiles(r, sim.cell());
      r.tiles_at_best = r.tiles.size();
    }
  });
}
template <class Sim> std::size_t ranges_with_tiles(Sim& sim) {
  std::size_t n = 0;
  sim.for_each_body([&](auto& set) { n += static_cast<std::size_t>(std::count_if(set.ranges.begin(), set.ranges.end(), [](const auto& r) { return !r.tiles.empty(); })); });
  return n;
}
/// The largest difference of a field of the particles, by their ids, over its largest value.
template <class Tag, class Sim> double difference(Sim& a, Sim& b, int component) {
  const auto values = [&](Sim& sim) {
    std::vector<double> x(sim.particle_count());
    sim.for_each_body([&](auto& set) {
      for (std::size_t i = 0; i < set.columns.size(); ++i) x[set.columns.id()[i]] = static_cast<double>(set.columns.template get<Tag>(component)[i]);
    });
    return x;
  };
  const auto x = values(a), y = values(b);
  double most = 0, scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i])), scale = std::max(scale, std::abs(x[i]));
  EXPECT_GT(scale, 0);
  return most / scale;
}

template <class Method> class Engines : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_musl,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Engines, methods, method_names);

TYPED_TEST(Engines, GiveTheSameStep) {
  auto tiles = small_impact<TypeParam>(), rows = small_impact<TypeParam>();
  for (int i = 0; i < 20; ++i) tiles.step(), rows.step();
  choose(tiles, true);
  choose(rows, false);
  EXPECT_GT(ranges_with_tiles(tiles), 2u);
  EXPECT_EQ(ranges_with_tiles(rows), 0u);
  tiles.step(), rows.step();
  using T = typename TypeParam::scalar;
  const double round_off = 2e3 * static_cast<double>(std::numeric_limits<T>::epsilon());
  for (int d = 0; d < 2; ++d) {
    EXPECT_LT((difference<field::velocity>(tiles, rows, d)), round_off);
    EXPECT_LT((difference<field::position>(tiles, rows, d)), round_off);
  }
  EXPECT_LT((difference<field::pressure>(tiles, rows, 0)), round_off);
  EXPECT_LT((difference<field::energy>(tiles, rows, 0)), round_off);
  for (int c = 0; c < 3; ++c) EXPECT_LT((difference<field::deviator>(tiles, rows, c)), round_off);
}

} // namespace
} // namespace bolide
