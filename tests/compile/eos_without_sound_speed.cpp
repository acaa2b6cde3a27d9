// SPDX-License-Identifier: MIT
// expect: sound_speed_squared
// An equation of state that forgets the sound speed is refused, and the compiler names what is missing.
#include "bolide/concepts/equation_of_state.hpp"

struct pressure_only {
  template <class V> struct answer { V pressure; };
  template <class V> answer<V> evaluate(V rho, V e) const { return {rho * e}; }
  double reference_density() const { return 1; }
};
static_assert(bolide::EquationOfState<pressure_only>, "bolide: an equation of state gives pressure and sound_speed_squared");
