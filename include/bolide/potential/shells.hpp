// SPDX-License-Identifier: MIT
// The neighbour shells of the cubic crystals: how many neighbours sit at which distance, and how they lie to the axes.
//
// Sites are (a/2)(i, j, k): fcc those with i + j + k even, bcc those with i, j, k all even or all odd. Shells lie at
// d = (a/2) sqrt(i^2 + j^2 + k^2): fcc 12, 6, 24, 12, 24, 8 ... atoms, bcc 8, 6, 12, 24, 8, 6 ...
// Set-up work: counting to d = 13 a takes about a millisecond.
#pragma once

#include "bolide/concepts/potential.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace bolide::potential {

struct shell {
  double distance; // in lattice constants
  double atoms;
  double fourth; // sum of (x/distance)^4 over the atoms; that of (x y/distance^2)^2 is (atoms - 3 fourth)/6, by symmetry
};

/// Is (a/2)(i, j, k) a site of the crystal?
constexpr bool is_site(lattice structure, int i, int j, int k) {
  const int i2 = i & 1, j2 = j & 1, k2 = k & 1;
  return structure == lattice::fcc ? ((i2 + j2 + k2) & 1) == 0 : i2 == j2 && j2 == k2;
}

/// All shells with distance <= reach (in lattice constants), nearest first, the origin left out.
inline std::vector<shell> shells(lattice structure, double reach) {
  const int n_max = static_cast<int>(4 * reach * reach), side = static_cast<int>(2 * reach) + 1;
  struct tally {
    long atoms = 0;
    double fourth = 0; // sum of i^4 + j^4 + k^4
  };
  std::vector<tally> found(static_cast<std::size_t>(n_max) + 1);
  for (int i = -side; i <= side; ++i)
    for (int j = -side; j <= side; ++j)
      for (int k = -side; k <= side; ++k) {
        const int ii = i * i, jj = j * j, kk = k * k, n = ii + jj + kk;
        if (n == 0 || n > n_max || !is_site(structure, i, j, k)) continue;
        tally& t = found[static_cast<std::size_t>(n)];
        ++t.atoms;
        t.fourth += double(ii) * ii + double(jj) * jj + double(kk) * kk;
      }
  std::vector<shell> list;
  for (std::size_t n = 1; n < found.size(); ++n)
    if (found[n].atoms > 0) list.push_back({std::sqrt(0.25 * double(n)), double(found[n].atoms), found[n].fourth / (3 * double(n) * double(n))});
  return list;
}

} // namespace bolide::potential
