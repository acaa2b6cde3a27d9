// SPDX-License-Identifier: MIT
// expect: bolide: material: this strength wants a temperature and the equation of state gives none; wrap it in eos::isentrope_temperature
#include "bolide/strength/steinberg_guinan.hpp"
#include "scene.hpp"

bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::steinberg_guinan::copper(), bolide::failure::none{}};
