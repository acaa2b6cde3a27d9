// SPDX-License-Identifier: MIT
// expect: bolide: material: the third argument is no failure law: it must have particle_fields, may_fail, wants_temperature and, if it may fail, fails(p, T, T_m, melt_fraction)
#include "scene.hpp"

struct says_nothing {
  using particle_fields = bolide::fields<>;
  static constexpr bool may_fail = true, wants_temperature = false;
};
bolide::material metal{bolide::eos::mie_grueneisen{}, bolide::strength::none{}, says_nothing{}};
