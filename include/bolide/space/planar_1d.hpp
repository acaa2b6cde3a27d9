// SPDX-License-Identifier: MIT
// Planar 1-D space: plane waves along x in uniaxial strain. A particle stands for a slab of one square metre.
//
// Velocity gradient L = { v_x,x }; a deviator has the one independent component s_xx (s_yy = s_zz = -s_xx / 2).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <array>

namespace bolide::space {

struct planar_1d {
  static constexpr int dim = 1;
  static constexpr int gradient_size = 1, deviator_size = 1;
  static constexpr bool hoop = false;
  static constexpr const char* name = "planar_1d";

  template <class V> using gradient = std::array<V, gradient_size>;
  template <class V> using deviator = std::array<V, deviator_size>;

  static constexpr int components(rank) { return 1; }
  /// Volume (m3) of a slab of thickness `length` (m) and one square metre.
  static double volume(const double*, double length) { return length; }

  template <class V> BOLIDE_INLINE static V divergence(const gradient<V>& l) { return l[0]; }
  template <class V> BOLIDE_INLINE static V jacobian(const gradient<V>& l, V dt) { return V(1) + dt * l[0]; }
  template <class V> BOLIDE_INLINE static V magnitude(const gradient<V>& l) { return abs(l[0]); }
  template <class V> BOLIDE_INLINE static deviator<V> deviatoric_rate(const gradient<V>& l) { return {l[0] * scalar_t<V>(2.0 / 3)}; }
  template <class V> BOLIDE_INLINE static V contract(const deviator<V>& a, const deviator<V>& b) { return scalar_t<V>(1.5) * a[0] * b[0]; }
  template <class V> BOLIDE_INLINE static deviator<V> jaumann_rate(const deviator<V>&, const gradient<V>&) { return {V(0)}; }
  template <class V> BOLIDE_INLINE static std::array<V, 1> in_plane(V p, const deviator<V>& s) { return {s[0] - p}; }
};

} // namespace bolide::space
