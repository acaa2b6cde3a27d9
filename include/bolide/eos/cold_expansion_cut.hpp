// SPDX-License-Identifier: MIT
// Modifier: the pull of cold expanded material taken off, the cure that impact codes give Tillotson's formula (it pulls -12 GPa at
// eta = 0.8 and is unstable below 0.75). With eta = rho/rho0 and f = (eta - eta_low)/(eta_high - eta_low) kept between 0 and 1:
//
//   p = f p_E where p_E < 0,   p = p_E elsewhere       dp/de = f p_E,e       c^2 = f p_E,rho + f' p_E + p dp/de/rho^2   (raw)
// p is continuous in rho and e (p_E = 0 is where it sets in). Hot material (p_E > 0) is untouched, whatever its density.
// c^2: on the ramp the pull weakens with expansion, so f' p_E < 0 drives c^2 below zero (-5e8 m2/s2 on a narrow ramp); below
// eta_low p = 0 and c^2 = 0. Compose with eos::sound_speed_floor in a time loop, as every code that cuts has a floor.
// eta_low = eta_high is a step (p then jumps): 0.8 is that of planetary codes; 0.875 and 0.925 a ramp in use, the default.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/query.hpp"

#include <utility>
#include <vector>

namespace bolide::eos {

template <class Eos> class cold_expansion_cut {
  static_assert(EquationOfState<Eos>, "bolide: eos::cold_expansion_cut needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  explicit cold_expansion_cut(Eos eos, double eta_low = 0.875, double eta_high = 0.925)
      : eos_(std::move(eos)), low_(eta_low), high_(eta_high), inverse_density_(1 / eos_.reference_density()),
        slope_(eta_high > eta_low ? 1 / (eta_high - eta_low) : 0) {
    require(eta_low > 0 && eta_low < 1, "eos::cold_expansion_cut eta_low", eta_low, "between 0 and 1");
    require(eta_high >= eta_low && eta_high <= 1, "eos::cold_expansion_cut eta_high", eta_high, "between eta_low and 1");
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = eos_.evaluate(rho, e);
    const V zero(T(0)), one(T(1)), eta = rho * T(inverse_density_), p = r.pressure;
    const auto acts = p < zero && eta < V(T(high_)), gone = eta < V(T(low_));
    if (!any(acts)) return r;
    const V f = select(acts, select(gone, zero, (eta - T(low_)) * T(slope_)), one);
    const V f_rho = select(acts, select(gone, zero, V(T(slope_ * inverse_density_))), zero);
    const V p_e = pressure_energy(eos_, rho, e), inverse = one / (rho * rho);
    r.pressure = f * p;
    const V c2 = f * (r.sound_speed_squared - p * p_e * inverse) + f_rho * p + f * f * p * p_e * inverse;
    r.sound_speed_squared = select(acts, c2, r.sound_speed_squared);
    if constexpr (requires { r.pressure_energy; }) r.pressure_energy = f * r.pressure_energy;
    return r;
  }

  double reference_density() const { return eos_.reference_density(); }
  const Eos& base() const { return eos_; }
  validity_box validity() const { return validity_of(eos_); }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const { return continuation_mask(eos_, rho, e); }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e); }
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho); }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  Eos eos_;
  double low_, high_, inverse_density_, slope_; // eta, eta, m3/kg, -
};

} // namespace bolide::eos
