// SPDX-License-Identifier: MIT
// expect: bolide: failure::cohesive wants a law that may fail
#include "bolide/failure/softening.hpp"
#include "scene.hpp"

bolide::failure::cohesive law{bolide::failure::none{}, 1e3};
