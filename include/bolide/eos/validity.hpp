// SPDX-License-Identifier: MIT
// The box in (rho, e) that a model is meant for. A model states it as  validity_box validity() const;  outside it the formulas still
// answer (finite, by their documented continuations), and whoever asks is told so: eos/query.hpp, eos/inverse.hpp.
// A modifier forwards the box of what it wraps, scaled or shifted as it scales or shifts. A user's model without one gets all of rho > 0.
// A model may also state where its surface has kinks or jumps, for tables that put their nodes there (eos/tabulated.hpp):
//   std::vector<double> energy_borders(double rho) const     J/kg, rising, equally many at every density
//   std::vector<double> density_borders() const              kg/m3
// The box is what can be said without a function of two variables: e below the cold curve, a pole, an unstable place inside it are
// reported beside it (status), not by it.
#pragma once

#include "bolide/core/lane.hpp"

#include <limits>
#include <vector>

namespace bolide::eos {

struct validity_box {
  double density_low, density_high; // kg/m3
  double energy_low, energy_high;   // J/kg

  /// Both borders belong to the box. NaN is outside.
  bool contains(double rho, double e) const { return rho >= density_low && rho <= density_high && e >= energy_low && e <= energy_high; }
};

/// The model's own box, or all of rho > 0.
template <class Eos> validity_box validity_of(const Eos& eos) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if constexpr (requires { eos.validity().density_low; }) return eos.validity();
  else return {0.0, infinity, -infinity, infinity};
}

/// The model's own mask of the time loop, lane by lane: where a continuation answers. Nowhere if it has none.
template <class Eos, class V> BOLIDE_INLINE mask_t<V> continuation_mask(const Eos& eos, V rho, V e) {
  if constexpr (requires { eos.outside_validity(rho, e); }) return eos.outside_validity(rho, e);
  else return rho < V(scalar_t<V>(0));
}

/// Outside the box, or where the model itself says that a continuation answers (outside_validity of the time loop).
template <class Eos> bool outside_of(const Eos& eos, double rho, double e) {
  return !validity_of(eos).contains(rho, e) || continuation_mask(eos, rho, e);
}

template <class Eos> std::vector<double> energy_borders_of(const Eos& eos, double rho) {
  if constexpr (requires { eos.energy_borders(rho); }) return eos.energy_borders(rho);
  else return {};
}
template <class Eos> std::vector<double> density_borders_of(const Eos& eos) {
  if constexpr (requires { eos.density_borders(); }) return eos.density_borders();
  else return {};
}

} // namespace bolide::eos
