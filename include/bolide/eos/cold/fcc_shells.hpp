// SPDX-License-Identifier: MIT
// The neighbour shells of the face-centred cubic lattice: how many neighbours sit at which distance.
//
// Sites are (a/2)(i, j, k) with i + j + k even, so the shells lie at d = a sqrt(n/2), n = 1, 2, 3 ... (12, 6, 24, 12, 24, 8 ... atoms;
// n = 14 is empty). Set-up work: counting to d = 13 a takes about a millisecond.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace bolide::cold {

struct fcc_shell {
  double distance; // in lattice constants
  double atoms;
};

/// All shells with distance <= reach (in lattice constants), nearest first, the origin left out.
inline std::vector<fcc_shell> fcc_shells(double reach) {
  const int n_max = static_cast<int>(2 * reach * reach), side = static_cast<int>(2 * reach) + 1;
  std::vector<int> atoms(static_cast<std::size_t>(n_max) + 1, 0);
  for (int i = -side; i <= side; ++i)
    for (int j = -side; j <= side; ++j)
      for (int k = -side + ((i + j + side) & 1); k <= side; k += 2) {
        const int n = (i * i + j * j + k * k) / 2;
        if (n <= n_max) ++atoms[static_cast<std::size_t>(n)];
      }
  std::vector<fcc_shell> shells;
  for (int n = 1; n <= n_max; ++n)
    if (const int count = atoms[static_cast<std::size_t>(n)]; count > 0) shells.push_back({std::sqrt(0.5 * n), double(count)});
  return shells;
}

} // namespace bolide::cold
