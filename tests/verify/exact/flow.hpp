// SPDX-License-Identifier: MIT
// What an exact solution of gas flow says of a place and time: density, velocity along the only coordinate (x, or r outwards), pressure. SI, or
// the problem's own units where it has none.
#pragma once

namespace bolide::verify {
struct flow {
  double rho = 0, u = 0, p = 0;
};
} // namespace bolide::verify
