// SPDX-License-Identifier: MIT
// expect: simd_register
// A pack has the width of a register: 2, 4, 8 (double) or 4, 8, 16 (float).
#include "bolide/core/lane.hpp"

bolide::pack<double, 3> odd;
