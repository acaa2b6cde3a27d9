// SPDX-License-Identifier: MIT
// expect: bolide: failure::softening wants a law that may fail
#include "bolide/failure/softening.hpp"
#include "scene.hpp"

bolide::failure::softening law{bolide::failure::none{}, 1e-7};
