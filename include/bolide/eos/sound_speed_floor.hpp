// SPDX-License-Identifier: MIT
// Modifier: sound speed at least `fraction` of the one at (reference density, e = 0). Pressure and temperature are untouched.
// The models are raw and have c^2 <= 0 where their surface is unstable (cold expansion); who needs a bound wraps them in this. The
// solver's material has a floor of its own that it counts, so a scene does not need this; floored() tells where it acts.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/query.hpp"

#include <utility>
#include <vector>

namespace bolide::eos {

template <class Eos> class sound_speed_floor {
  static_assert(EquationOfState<Eos>, "bolide: eos::sound_speed_floor needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");

public:
  explicit sound_speed_floor(Eos eos, double fraction = 0.05) : eos_(std::move(eos)) {
    require(fraction > 0 && fraction <= 1, "eos::sound_speed_floor fraction", fraction, "above 0 and at most 1");
    const double c2 = eos_.evaluate(eos_.reference_density(), 0.0).sound_speed_squared;
    require(c2 > 0, "eos::sound_speed_floor sound speed squared at the reference density", c2, "> 0", "m2/s2");
    least_ = fraction * fraction * c2;
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    auto r = eos_.evaluate(rho, e);
    r.sound_speed_squared = select(floored(r), V(scalar_t<V>(least_)), r.sound_speed_squared);
    return r;
  }
  /// Where the floor acts on the raw point r of the wrapped model (NaN counts as below).
  template <class Point> BOLIDE_INLINE auto floored(const Point& r) const {
    using V = decltype(r.sound_speed_squared);
    return !(r.sound_speed_squared >= V(scalar_t<V>(least_)));
  }

  double reference_density() const { return eos_.reference_density(); }
  double least_sound_speed_squared() const { return least_; } // m2/s2
  const Eos& base() const { return eos_; }
  validity_box validity() const { return validity_of(eos_); }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const { return continuation_mask(eos_, rho, e); }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e); }
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho); }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  Eos eos_;
  double least_ = 0; // m2/s2
};

} // namespace bolide::eos
