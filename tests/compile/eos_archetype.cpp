// SPDX-License-Identifier: MIT
// expect: ok
// The least that is an equation of state. If this stops compiling, the concept has grown unseen.
#include "bolide/concepts/equation_of_state.hpp"

struct least_eos {
  template <class V> bolide::eos_point<V> evaluate(V rho, V e) const { return {rho * e, e}; }
  double reference_density() const { return 1; }
};
static_assert(bolide::EquationOfState<least_eos>);
static_assert(bolide::EquationOfState<least_eos, float>);
static_assert(bolide::EquationOfState<least_eos, bolide::native_pack<double>>);
static_assert(!bolide::ThermalEquationOfState<least_eos>);
