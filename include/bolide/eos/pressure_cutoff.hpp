// SPDX-License-Identifier: MIT
// Modifier: no pressure below p_min.  p = max(p_E, p_min); where it acts, p does not depend on rho and e any more, so dp/de = 0 and, by
// c^2 = dp/drho + (p/rho^2) dp/de,  c^2 = 0 there. That is the raw truth of this surface and ends a run's time step if nothing bounds
// it: a time loop composes it with eos::sound_speed_floor, or relies on its material's floor, which is counted. T and the phases stay.
// A cut-off is not thermodynamics: energy spent in expansion at p_min is not that of any free energy. cut() tells where it acts.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/query.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace bolide::eos {

template <class Eos> class pressure_cutoff {
  static_assert(EquationOfState<Eos>, "bolide: eos::pressure_cutoff needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  /// p_min in Pa: 0 for no tension at all, -1.5e9 for a tensile limit of 1.5 GPa.
  pressure_cutoff(Eos eos, double p_min) : eos_(std::move(eos)), p_min_(p_min) {
    require(std::isfinite(p_min) && p_min <= 0, "eos::pressure_cutoff p_min", p_min, "finite and at most 0", "Pa");
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = eos_.evaluate(rho, e);
    const auto acts = cut(r);
    r.pressure = select(acts, V(T(p_min_)), r.pressure);
    r.sound_speed_squared = select(acts, V(T(0)), r.sound_speed_squared);
    if constexpr (requires { r.pressure_energy; }) r.pressure_energy = select(acts, V(T(0)), r.pressure_energy);
    return r;
  }
  /// Where the cut-off acts on the raw point r of the wrapped model.
  template <class Point> BOLIDE_INLINE auto cut(const Point& r) const {
    using V = decltype(r.pressure);
    return r.pressure < V(static_cast<scalar_t<V>>(p_min_));
  }

  double reference_density() const { return eos_.reference_density(); }
  double least_pressure() const { return p_min_; } // Pa
  const Eos& base() const { return eos_; }
  validity_box validity() const { return validity_of(eos_); }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const { return continuation_mask(eos_, rho, e); }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e); }
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho); }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  Eos eos_;
  double p_min_; // Pa
};

} // namespace bolide::eos
