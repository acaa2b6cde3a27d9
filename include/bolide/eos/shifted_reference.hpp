// SPDX-License-Identifier: MIT
// Modifier: the same equation of state with its energies counted from another zero:  answers(rho, e) = answers of E at (rho, e + e0).
// e0 (J/kg) is what E calls the energy of the new zero. For two materials whose tables count from 293 K and from 0 K, say. The cold
// energy is counted from the new zero too; pressure, sound speed, temperature and phases are E's.
// cold_state() (reference density, e = 0) then means the new zero.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/query.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace bolide::eos {

template <class Eos> class shifted_reference {
  static_assert(EquationOfState<Eos>, "bolide: eos::shifted_reference needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  shifted_reference(Eos eos, double e0) : eos_(std::move(eos)), e0_(e0) {
    require(std::isfinite(e0), "eos::shifted_reference e0", e0, "finite", "J/kg");
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = eos_.evaluate(rho, e + T(e0_));
    if constexpr (requires { r.cold_energy; }) r.cold_energy = r.cold_energy - T(e0_);
    return r;
  }

  double reference_density() const { return eos_.reference_density(); }
  double shift() const { return e0_; } // J/kg
  const Eos& base() const { return eos_; }
  validity_box validity() const {
    validity_box box = validity_of(eos_);
    box.energy_low -= e0_;
    box.energy_high -= e0_;
    return box;
  }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const { return continuation_mask(eos_, rho, e + scalar_t<V>(e0_)); }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e + e0_); }
  std::vector<double> energy_borders(double rho) const {
    std::vector<double> borders = energy_borders_of(eos_, rho);
    for (double& e : borders) e -= e0_;
    return borders;
  }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  Eos eos_;
  double e0_; // J/kg
};

} // namespace bolide::eos
