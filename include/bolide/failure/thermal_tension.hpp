// SPDX-License-Identifier: MIT
// Tension cut-off that falls with temperature: a point fails for good when its tension exceeds
//   sigma(T) = limit (1 - T/T_m)^m,   0 at and above melting,
// T_m the melting temperature of the equation of state at the particle's density. Unlike failure::tension_or_melt, a melt under
// pressure has not failed: it fails with the first tension. m = 0 is a constant limit up to melting.
// Validity: a form, not a fit; metals lose most of their spall strength near melting (m < 1) or gradually (m = 1, default).
// Cost: one division; a power where m is neither 0 nor 1.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::failure {

struct thermal_tension {
  using particle_fields = fields<field::failed, field::material_volume>;
  static constexpr bool may_fail = true;
  static constexpr bool wants_temperature = true;
  static constexpr const char* name = "thermal_tension";

  double limit;    // of -p at 0 K, Pa
  double exponent; // m

  explicit thermal_tension(double sigma, double m = 1) : limit(sigma), exponent(m) {
    require(sigma > 0, "tension limit at 0 K", sigma, "positive", "Pa");
    require(m >= 0 && m <= 4, "exponent of the tension limit", m, "in [0, 4]");
  }

  /// sigma(T), Pa.
  template <class V> BOLIDE_INLINE V carries(V temperature, V melting_temperature) const {
    using T = scalar_t<V>;
    const V cold = max(V(T(1)) - temperature / max(melting_temperature, V(T(1))), V(T(0))); // a T_m below 1 K: no solid
    if (exponent == 1.0) return T(limit) * cold;
    return select(cold > V(T(0)), T(limit) * pow(max(cold, V(T(1e-30))), V(T(exponent))), V(T(0)));
  }
  template <class V> BOLIDE_INLINE mask_t<V> fails(V pressure, V temperature, V melting_temperature, V) const {
    return pressure < -carries(temperature, melting_temperature);
  }
};

} // namespace bolide::failure
