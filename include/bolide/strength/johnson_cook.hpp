// SPDX-License-Identifier: MIT
// Johnson-Cook yield stress (paper eq. 11 with its exponent n restored):
//   s_y = (A + B eps^n) (1 + C ln max(edot, 1)) (1 - T*^q),  T* = (T - T_room)/(T_m - T_room) clipped to [0, 1]
// with the equivalent plastic strain eps, the equivalent strain rate edot in 1/s (reference rate 1 /s) and the melting
// temperature T_m of the equation of state at the particle's density. The limits are part of the model, not floors.
// Validity: fitted at rates up to about 1e4 /s and below melting; extrapolated without limit here.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::strength {

struct johnson_cook {
  using particle_fields = fields<field::deviator, field::plastic_strain>;
  static constexpr bool carries_shear = true;
  static constexpr bool wants_temperature = true;
  static constexpr const char* name = "johnson_cook";

  double shear_modulus = 27.6e9; // G, Pa (paper, section 2)
  double a = 265e6;              // A, Pa
  double b = 426e6;              // B, Pa
  double n = 0.34;
  double c = 0.015;
  double q = 1.0;
  double room_temperature = 293; // K

  /// Throws bad_parameter where a parameter is outside its range.
  void validate() const {
    require(shear_modulus > 0, "Johnson-Cook shear modulus", shear_modulus, "positive", "Pa");
    require(a > 0, "Johnson-Cook A", a, "positive", "Pa");
    require(b >= 0, "Johnson-Cook B", b, "non-negative", "Pa");
    require(n > 0 && n <= 2, "Johnson-Cook n", n, "in (0, 2]");
    require(c >= 0, "Johnson-Cook C", c, "non-negative");
    require(q > 0, "Johnson-Cook q", q, "positive");
    require(room_temperature >= 0, "Johnson-Cook room temperature", room_temperature, "non-negative", "K");
  }

  /// 1 - T*^q
  template <class V> BOLIDE_INLINE V softening(V temperature, V melting) const {
    using T = scalar_t<V>;
    const V span = max(melting - T(room_temperature), V(T(1)));
    const V t = clip((temperature - T(room_temperature)) / span, V(T(0)), V(T(1)));
    if (q == 1.0) return T(1) - t;
    return select(t > V(T(0)), T(1) - pow(max(t, V(T(1e-30))), V(T(q))), V(T(1)));
  }
  /// A lower bound of the yield stress that costs no logarithm: a particle stressed less is elastic.
  template <class V> BOLIDE_INLINE V yield_floor(V temperature, V melting) const { return scalar_t<V>(a) * softening(temperature, melting); }
  template <class V> BOLIDE_INLINE V yield_stress(V plastic_strain, V rate, V temperature, V melting) const {
    using T = scalar_t<V>;
    const V strain = max(plastic_strain, V(T(1e-30)));
    V power;
    if constexpr (lane_width<V> == 1) power = pow(strain, V(T(n)));
    else power = exp(T(n) * log(strain)); // pow carries more digits than A + B eps^n can show: eps^n |ln eps^n| < 0.37 below eps = 1
    const V hardening = select(plastic_strain > V(T(0)), T(b) * power, V(T(0)));
    return (T(a) + hardening) * (T(1) + T(c) * log(max(rate, V(T(1))))) * softening(temperature, melting);
  }
};

} // namespace bolide::strength
