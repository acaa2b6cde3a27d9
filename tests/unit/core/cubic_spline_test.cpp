// SPDX-License-Identifier: MIT
// The spline's slopes: exact for a cubic on any points, C2 for anything else, fourth order up to the ends.
#include "bolide/core/cubic_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {
using namespace bolide;

TEST(CubicSpline, IsExactForACubic) {
  const std::vector<double> x{-1, -0.7, 0.1, 0.3, 2, 2.5};
  std::vector<double> y;
  for (const double s : x) y.push_back(1 + s * (2 + s * (-3 + s * 0.5)));
  const auto slope = spline_slopes(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(slope[i], 2 + x[i] * (-6 + x[i] * 1.5), 1e-13) << i;
}

TEST(CubicSpline, SecondDerivativeIsContinuousAndTheEndsAreNoKnots) {
  const std::vector<double> x{0, 0.5, 0.8, 2, 3, 3.1, 4}, y{1, -2, 3, 0, 0, 5, 1};
  const auto m = spline_slopes(x, y);
  const auto bend = [&](std::size_t i, double t) { // y'' in piece i, t from 0 to 1
    const double h = x[i + 1] - x[i], d = (y[i + 1] - y[i]) / h;
    return (6 * d - 4 * m[i] - 2 * m[i + 1] + 6 * t * (m[i] + m[i + 1] - 2 * d)) / h;
  };
  const auto third = [&](std::size_t i) { return (bend(i, 1) - bend(i, 0)) / (x[i + 1] - x[i]); };
  for (std::size_t i = 0; i + 2 < x.size(); ++i) EXPECT_NEAR(bend(i, 1), bend(i + 1, 0), 1e-10) << i;
  EXPECT_NEAR(third(0), third(1), 1e-9);
  EXPECT_NEAR(third(4), third(5), 1e-9);
}

TEST(CubicSpline, SlopesAreOfThirdOrderOrBetterUpToTheEnds) {
  const auto worst = [](int n) {
    std::vector<double> x, y;
    for (int i = 0; i < n; ++i) x.push_back(3.0 * i / (n - 1)), y.push_back(std::exp(-x.back()));
    const auto slope = spline_slopes(x, y);
    double most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(slope[i] + y[i]));
    return most;
  };
  EXPECT_GT(worst(101) / worst(201), 7.5);
}

TEST(CubicSpline, RefusesFewerThanFourPoints) {
  const std::vector<double> x{0, 1, 2}, y{0, 1, 2};
  EXPECT_THROW(spline_slopes(x, y), bad_parameter);
  const std::vector<double> four{0, 1, 2, 3};
  EXPECT_THROW(spline_slopes(four, y), bad_parameter);
}
} // namespace
