// SPDX-License-Identifier: MIT
// expect: bolide: material: the first argument is no equation of state: it must have evaluate(rho, e) that gives pressure and sound_speed_squared, and reference_density()
#include "scene.hpp"

struct pressure_only {
  template <class V> struct answer { V pressure; };
  template <class V> answer<V> evaluate(V rho, V e) const { return {rho * e}; }
  double reference_density() const { return 1; }
};
bolide::material metal{pressure_only{}, bolide::strength::none{}, bolide::failure::none{}};
