// SPDX-License-Identifier: MIT
// Rows and lanes: every number where it belongs, both ways, and nothing written beyond the last row.
#include "bolide/core/rows.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bolide {
namespace {

template <class V, int R> void expect_transposed() {
  using T = scalar_t<V>;
  constexpr int W = lane_width<V>;
  std::vector<T> rows(static_cast<std::size_t>(W * R));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = T(i);
  V lanes[R];
  rows_to_lanes<R>(rows.data(), lanes);
  for (int k = 0; k < W; ++k)
    for (int c = 0; c < R; ++c) EXPECT_EQ(lane(lanes[c], k), T(k * R + c)) << "number " << c << " of row " << k << " of " << W << " rows of " << R;
  for (int n = 0; n <= W; ++n) {
    V again[R];
    for (int c = 0; c < R; ++c) again[c] = lanes[c];
    std::vector<T> back(rows.size(), T(-1));
    lanes_to_rows<R>(again, back.data(), n);
    for (std::size_t i = 0; i < back.size(); ++i) EXPECT_EQ(back[i], i < static_cast<std::size_t>(n * R) ? rows[i] : T(-1)) << n << " rows";
  }
}
template <class V> void expect_all() {
  expect_transposed<V, 2>();
  expect_transposed<V, 4>();
  expect_transposed<V, 8>();
}

TEST(Rows, GoToLanesAndBack) {
  expect_all<pack<double, 2>>();
  expect_all<pack<double, 4>>();
  expect_all<pack<double, 8>>();
  expect_all<pack<float, 4>>();
  expect_all<pack<float, 8>>();
  expect_all<pack<float, 16>>();
}
TEST(Rows, AreAsWideAsARegister) {
  EXPECT_EQ(row_width(1), 2);
  EXPECT_EQ(row_width(2), 2);
  EXPECT_EQ(row_width(3), 4);
  EXPECT_EQ(row_width(4), 4);
  EXPECT_EQ(row_width(6), 8);
}

} // namespace
} // namespace bolide
