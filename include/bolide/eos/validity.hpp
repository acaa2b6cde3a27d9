// SPDX-License-Identifier: MIT
// The box in (rho, e) that a model is meant for. A model states it as  validity_box validity() const;  outside it the formulas still
// answer (finite, by their documented continuations), and whoever asks is told so: eos/query.hpp, eos/inverse.hpp.
// A modifier forwards the box of what it wraps, scaled or shifted as it scales or shifts. A user's model without one gets all of rho > 0.
// The box is what can be said without a function of two variables: e below the cold curve, a pole, an unstable place inside it are
// reported beside it (status), not by it.
#pragma once

#include <limits>

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

/// Outside the box, or where the model itself says that a continuation answers (outside_validity of the time loop).
template <class Eos> bool outside_of(const Eos& eos, double rho, double e) {
  if (!validity_of(eos).contains(rho, e)) return true;
  if constexpr (requires { eos.outside_validity(rho, e); }) return eos.outside_validity(rho, e);
  else return false;
}

} // namespace bolide::eos
