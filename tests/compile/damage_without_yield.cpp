// SPDX-License-Identifier: MIT
// expect: bolide: material: this failure law accumulates damage with plastic strain and the strength never yields; take one that does, strength::johnson_cook or strength::elastic_perfectly_plastic
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/strength/elastic.hpp"
#include "scene.hpp"

bolide::material metal{bolide::eos::isentrope_temperature{bolide::eos::mie_grueneisen{}}, bolide::strength::elastic{27.6e9}, bolide::failure::johnson_cook_damage{}};
