// SPDX-License-Identifier: MIT
// expect: bolide: transfer: xpic<m> wants an order m from 1 to 20
#include "bolide/transfer/xpic.hpp"

bolide::transfer::xpic<0> x;
