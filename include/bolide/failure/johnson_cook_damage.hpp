// SPDX-License-Identifier: MIT
// Johnson and Cook's cumulative damage (Eng. Fract. Mech. 21 (1985) 31): a point fails when D = 1,
//   D = sum d(eps) / eps_f,   eps_f = [D1 + D2 exp(D3 sigma*)] [1 + D4 ln(max(edot, 1))] [1 + D5 T*],   eps_f at least `least_strain`
// with the equivalent plastic strain eps, its rate edot in 1/s (reference rate 1 /s), the triaxiality sigma* = -p / s_eq (tension positive) and
// T* = (T - T_room)/(T_m - T_room) clipped to [0, 1]; T_m is that of the equation of state.
// Limits that are part of the model: sigma* at most 1.5, the end of the authors' data (their straight line beyond it is left to
// `tension`: a point also fails at once when its tension exceeds that limit; infinity: damage alone); D3 sigma* at most 40, so that deep
// compression does no damage; eps_f at least `least_strain` (the authors' eps_f,min), which also stands where D1 < 0 makes the bracket negative.
// Point of failure: D is known at the end of a step, and the point fails in the next one.
// Validity: ductile fracture by growth of voids, from tension tests of notched bars; thin or no data in shear (sigma* near 0).
// Cost: a square root, an exponential and a logarithm in packs where a point yields; 8 bytes more per particle (field::damage).
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <limits>

namespace bolide::failure {

struct johnson_cook_damage {
  using particle_fields = fields<field::failed, field::material_volume, field::damage>;
  static constexpr bool may_fail = true;
  static constexpr bool wants_temperature = true;
  static constexpr const char* name = "johnson_cook_damage";

  double d1 = 0.54, d2 = 4.89, d3 = -3.03, d4 = 0.014, d5 = 1.12; // OFHC copper (the authors' table)
  double tension = std::numeric_limits<double>::infinity();      // of -p, Pa
  double least_strain = 1e-3;
  double room_temperature = 293; // K

  /// The authors' other two metals.
  static johnson_cook_damage armco_iron() { return {-2.20, 5.43, -0.47, 0.016, 0.63}; }
  static johnson_cook_damage steel_4340() { return {0.05, 3.44, -2.12, 0.002, 0.61}; }

  /// Throws bad_parameter where a parameter is outside its range.
  void validate() const {
    require(d1 > -10 && d1 < 100, "Johnson-Cook D1", d1, "in (-10, 100)");
    require(d2 >= 0 && d2 < 1000, "Johnson-Cook D2", d2, "in [0, 1000)");
    require(d3 > -100 && d3 < 100, "Johnson-Cook D3", d3, "in (-100, 100)");
    require(d4 > -0.05 && d4 < 1, "Johnson-Cook D4", d4, "in (-0.05, 1)");
    require(d5 > -1 && d5 < 1000, "Johnson-Cook D5", d5, "in (-1, 1000)");
    require(tension > 0, "tension limit", tension, "positive", "Pa");
    require(least_strain > 0, "least strain to failure", least_strain, "positive");
    require(room_temperature >= 0, "Johnson-Cook room temperature", room_temperature, "non-negative", "K");
  }

  /// eps_f
  template <class V> BOLIDE_INLINE V strain_to_failure(V rate, V pressure, V equivalent_stress, V temperature, V melting_temperature) const {
    using T = scalar_t<V>;
    const V stress = max(equivalent_stress, V(std::numeric_limits<T>::min()));
    const V triaxiality = max(min(-pressure / stress, V(T(1.5))), V(T(-1e6)));
    const V shape = T(d1) + T(d2) * exp(min(T(d3) * triaxiality, V(T(40))));
    const V star = clip((temperature - T(room_temperature)) / max(melting_temperature - T(room_temperature), V(T(1))), V(T(0)), V(T(1)));
    const V strain = shape * (T(1) + T(d4) * log(max(rate, V(T(1))))) * (T(1) + T(d5) * star);
    return max(strain, V(T(least_strain)));
  }
  template <class V> BOLIDE_INLINE V damage_increment(V plastic_increment, V rate, V pressure, V equivalent_stress, V temperature, V melting_temperature) const {
    return plastic_increment / strain_to_failure(rate, pressure, equivalent_stress, temperature, melting_temperature);
  }
  template <class V> BOLIDE_INLINE mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(scalar_t<V>(-tension)); }
};

} // namespace bolide::failure
