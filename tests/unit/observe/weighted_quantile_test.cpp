// SPDX-License-Identifier: MIT
#include "bolide/observe/weighted_quantile.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

TEST(weighted_quantile, equal_weights_count) {
  std::vector<double> value, weight;
  for (int i = 1000; i >= 1; --i) value.push_back(i), weight.push_back(0.1);
  EXPECT_EQ(weighted_quantile(value, weight, 0.999), 999);
  EXPECT_EQ(weighted_quantile(value, weight, 0.001), 1);
  EXPECT_EQ(weighted_quantile(value, weight, 0.5), 500);
  EXPECT_EQ(weighted_quantile(value, weight, 0), 1);
  EXPECT_EQ(weighted_quantile(value, weight, 1), 1000);
}

TEST(weighted_quantile, weight_decides_not_the_number) {
  EXPECT_EQ(weighted_quantile({1, 2, 3, 4}, {1, 1, 1, 97}, 0.04), 4);
  EXPECT_EQ(weighted_quantile({1, 2, 3, 4}, {97, 1, 1, 1}, 0.97), 1);
  EXPECT_EQ(weighted_quantile({1, 2, 3, 4}, {97, 1, 1, 1}, 0.975), 2);
}

TEST(weighted_quantile, numbers_that_are_none_do_not_count) {
  const double nan = std::nan(""), inf = INFINITY;
  EXPECT_EQ(weighted_quantile({nan, 2, inf, 4, 5}, {1, 1, 1, nan, 0}, 1), 2);
  EXPECT_TRUE(std::isnan(weighted_quantile({}, {}, 0.5)));
}

TEST(weighted_quantile, refuses_nonsense) {
  EXPECT_THROW(weighted_quantile({1}, {1}, 1.5), bad_parameter);
  EXPECT_THROW(weighted_quantile({1}, {1, 2}, 0.5), bad_parameter);
}

} // namespace
} // namespace bolide::observe
