// SPDX-License-Identifier: MIT
// The slopes of the cubic spline through given points, for set-up work.
//
//   value and slope continuous, second derivative too (C2); at both ends the first two pieces are one cubic ("not a knot"), so that
//   the error falls like h^4 up to the ends and nothing is assumed about them
// A piece is the cubic Hermite polynomial of its ends' values and slopes. Cost: O(n), one tridiagonal solution.
#pragma once

#include "bolide/core/contract.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace bolide {

/// dy/dx at every point; x strictly ascending, at least four points.
inline std::vector<double> spline_slopes(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  require(n >= 4, "spline_slopes number of points", double(n), ">= 4");
  require(y.size() == n, "spline_slopes number of values", double(y.size()), "that of the points");
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto d = [&](std::size_t i) { return (y[i + 1] - y[i]) / h(i); };
  std::vector<double> upper(n), slope(n); // the eliminated rows: slope_i + upper_i slope_{i+1} = right-hand side, kept in slope
  {
    const double a = h(0), b = h(1), both = a + b;
    upper[0] = both / b;
    slope[0] = ((a + 2 * both) * b * d(0) + a * a * d(1)) / (both * b);
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = h(i - 1), after = h(i), diagonal = 2 * (before + after) - after * upper[i - 1];
    upper[i] = before / diagonal;
    slope[i] = (3 * (after * d(i - 1) + before * d(i)) - after * slope[i - 1]) / diagonal;
  }
  {
    const double a = h(n - 2), b = h(n - 3), both = a + b;
    const double right = (a * a * d(n - 3) + (2 * both + a) * b * d(n - 2)) / both;
    slope[n - 1] = (right - both * slope[n - 2]) / (b - both * upper[n - 2]);
  }
  for (std::size_t i = n - 1; i-- > 0;) slope[i] -= upper[i] * slope[i + 1];
  return slope;
}

} // namespace bolide
