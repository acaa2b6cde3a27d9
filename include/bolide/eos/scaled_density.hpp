// SPDX-License-Identifier: MIT
// Modifier: the same equation of state with its density scale multiplied by f:  p(rho, e) = f p_E(rho/f, e),  c^2 and T as E's.
// An alloy as the pure metal with another atomic mass, so to speak; energies per mass stay, so does the us-up line.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"

#include <utility>

namespace bolide::eos {

template <class Eos> class scaled_density {
  static_assert(EquationOfState<Eos>, "bolide: eos::scaled_density needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  scaled_density(Eos eos, double factor) : eos_(std::move(eos)), factor_(factor), inverse_(1 / factor) {
    require(factor > 0.01 && factor < 100, "eos::scaled_density factor", factor, "between 0.01 and 100");
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = eos_.evaluate(rho * T(inverse_), e);
    r.pressure = r.pressure * T(factor_);
    if constexpr (requires { r.pressure_energy; }) r.pressure_energy = r.pressure_energy * T(factor_);
    return r;
  }

  double reference_density() const { return factor_ * eos_.reference_density(); }
  double factor() const { return factor_; }
  const Eos& base() const { return eos_; }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    if constexpr (requires { eos_.outside_validity(rho, e); }) return eos_.outside_validity(rho * scalar_t<V>(inverse_), e);
    else return rho < V(scalar_t<V>(0));
  }

private:
  Eos eos_;
  double factor_, inverse_;
};

} // namespace bolide::eos
