// SPDX-License-Identifier: MIT
// expect: bolide: material: this failure law wants a temperature and the equation of state gives none; wrap it in eos::isentrope_temperature
#include "bolide/failure/tension_or_melt.hpp"
#include "scene.hpp"

bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::none{}, bolide::failure::tension_or_melt{}};
