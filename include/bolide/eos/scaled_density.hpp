// SPDX-License-Identifier: MIT
// Modifier: the same equation of state with its density scale multiplied by f:  p(rho, e) = f p_E(rho/f, e),  c^2 and T as E's.
// An alloy as the pure metal with another atomic mass, so to speak; energies per mass stay, so does the us-up line.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/query.hpp"

#include <utility>
#include <vector>

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
  validity_box validity() const {
    validity_box box = validity_of(eos_);
    box.density_low *= factor_;
    box.density_high *= factor_;
    return box;
  }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    return continuation_mask(eos_, rho * scalar_t<V>(inverse_), e);
  }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho * inverse_, e); }
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho * inverse_); }
  std::vector<double> density_borders() const {
    std::vector<double> borders = density_borders_of(eos_);
    for (double& rho : borders) rho *= factor_;
    return borders;
  }

private:
  Eos eos_;
  double factor_, inverse_;
};

} // namespace bolide::eos
