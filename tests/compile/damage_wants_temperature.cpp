// SPDX-License-Identifier: MIT
// expect: bolide: material: this failure law wants a temperature and the equation of state gives none; wrap it in eos::isentrope_temperature
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "scene.hpp"

bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::elastic_perfectly_plastic{27.6e9, 0.3e9}, bolide::failure::johnson_cook_damage{}};
