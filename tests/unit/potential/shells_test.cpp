// SPDX-License-Identifier: MIT
// The neighbour shells of fcc and bcc against the numbers of every textbook and against a count of sites in floating point.
#include "bolide/potential/shells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;

TEST(Shells, FirstOnesOfBcc) {
  const auto shells = potential::shells(lattice::bcc, 3);
  const double atoms[] = {8, 6, 12, 24, 8, 6, 24, 24, 24}, squared[] = {0.75, 1, 2, 2.75, 3, 4, 4.75, 5, 6};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(shells[i].atoms, atoms[i]) << i;
    EXPECT_NEAR(shells[i].distance * shells[i].distance, squared[i], 1e-14) << i;
  }
}
TEST(Shells, FirstOnesOfFcc) {
  const auto shells = potential::shells(lattice::fcc, 3);
  const double atoms[] = {12, 6, 24, 12, 24, 8, 48, 6, 36}, fourth[] = {2, 2, 8, 2};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(shells[i].atoms, atoms[i]) << i;
  EXPECT_NEAR(shells[0].fourth, fourth[0], 1e-14); // (1 1 0): 8 atoms with x^4/r^4 = 1/4
  EXPECT_NEAR(shells[1].fourth, fourth[1], 1e-14); // (2 0 0): 2 with 1
}
TEST(Shells, SumsOfFourthPowersAreThoseOfTheSites) {
  for (const lattice structure : {lattice::fcc, lattice::bcc}) {
    const double reach = 4.05;
    double xxxx = 0, xxyy = 0, atoms = 0;
    const int n = 6;
    const double fcc[4][3] = {{0, 0, 0}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0}}, bcc[2][3] = {{0, 0, 0}, {.5, .5, .5}};
    for (int i = -n; i <= n; ++i)
      for (int j = -n; j <= n; ++j)
        for (int k = -n; k <= n; ++k)
          for (int b = 0; b < atoms_per_cell(structure); ++b) {
            const double* s = structure == lattice::fcc ? fcc[b] : bcc[b];
            const double x = i + s[0], y = j + s[1], z = k + s[2], r2 = x * x + y * y + z * z;
            if (r2 < 0.1 || r2 > reach * reach) continue;
            atoms += 1;
            xxxx += x * x * x * x * std::exp(-r2);
            xxyy += x * x * y * y * std::exp(-r2);
          }
    double counted = 0, xxxx_shells = 0, xxyy_shells = 0;
    for (const auto& s : potential::shells(structure, reach)) {
      const double d2 = s.distance * s.distance, weight = d2 * d2 * std::exp(-d2);
      counted += s.atoms;
      xxxx_shells += s.fourth * weight;
      xxyy_shells += (s.atoms - 3 * s.fourth) / 6 * weight;
    }
    EXPECT_EQ(counted, atoms);
    EXPECT_NEAR(xxxx_shells, xxxx, 1e-12);
    EXPECT_NEAR(xxyy_shells, xxyy, 1e-12);
  }
}
} // namespace
