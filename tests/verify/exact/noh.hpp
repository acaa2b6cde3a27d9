// SPDX-License-Identifier: MIT
// Noh's implosion (Noh 1987): cold gas of density 1 runs with speed 1 onto a plane (k = 1), an axis (2) or a centre (3).
//   shock at r_s = (gamma - 1) t/2;   behind it u = 0, rho = ((gamma + 1)/(gamma - 1))^k, e = 1/2, p = (gamma - 1) rho/2
//   ahead u = -1, p = 0, rho = (1 + t/r)^(k - 1)
#pragma once

#include "verify/exact/flow.hpp"

#include <cmath>

namespace bolide::verify {

struct noh {
  int k;
  double gamma = 5.0 / 3;
  double shock(double t) const { return 0.5 * (gamma - 1) * t; }
  double plateau() const { return std::pow((gamma + 1) / (gamma - 1), k); }
  flow at(double r, double t) const {
    if (r < shock(t)) return {plateau(), 0, 0.5 * (gamma - 1) * plateau()};
    return {std::pow(1 + t / r, k - 1), -1, 0};
  }
};

} // namespace bolide::verify
