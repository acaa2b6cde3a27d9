// SPDX-License-Identifier: MIT
// Plane strain: two coordinates x, y, nothing moves along z. A particle is a prism of one metre depth.
//
// Velocity gradient L = { v_x,x  v_x,y  v_y,x  v_y,y }. Independent components of a deviator: { s_xx  s_yy  s_xy },  s_zz = -(s_xx + s_yy).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <array>

namespace bolide::space {

struct plane_strain {
  static constexpr int dim = 2;
  static constexpr int gradient_size = 4, deviator_size = 3;
  static constexpr bool hoop = false;
  static constexpr const char* name = "plane_strain";

  template <class V> using gradient = std::array<V, gradient_size>;
  template <class V> using deviator = std::array<V, deviator_size>;

  static constexpr int components(rank r) {
    switch (r) {
    case rank::vector: return dim;
    case rank::deviator: return deviator_size;
    case rank::gradient: return dim * dim;
    default: return 1;
    }
  }
  /// Volume (m3) of a prism of cross-section `area` (m2) and one metre depth.
  static double volume(const double*, double area) { return area; }

  template <class V> BOLIDE_INLINE static V divergence(const gradient<V>& l) { return l[0] + l[3]; }
  /// det(I + dt L)
  template <class V> BOLIDE_INLINE static V jacobian(const gradient<V>& l, V dt) { return (V(1) + dt * l[0]) * (V(1) + dt * l[3]) - dt * dt * l[1] * l[2]; }
  /// Largest of |components|: how fast the particle is being deformed, 1/s.
  template <class V> BOLIDE_INLINE static V magnitude(const gradient<V>& l) { return max(max(abs(l[0]), abs(l[3])), max(abs(l[1]), abs(l[2]))); }
  /// Deviator of the rate of deformation, D - tr(D)/3 I.
  template <class V> BOLIDE_INLINE static deviator<V> deviatoric_rate(const gradient<V>& l) {
    const V third = divergence(l) * scalar_t<V>(1.0 / 3);
    return {l[0] - third, l[3] - third, scalar_t<V>(0.5) * (l[1] + l[2])};
  }
  /// a : b, all components counted.
  template <class V> BOLIDE_INLINE static V contract(const deviator<V>& a, const deviator<V>& b) {
    return a[0] * b[0] + a[1] * b[1] + (a[0] + a[1]) * (b[0] + b[1]) + scalar_t<V>(2) * a[2] * b[2];
  }
  /// Jaumann rate of s from the spin, W s - s W (paper eq. 10).
  template <class V> BOLIDE_INLINE static deviator<V> jaumann_rate(const deviator<V>& s, const gradient<V>& l) {
    const V w = scalar_t<V>(0.5) * (l[1] - l[2]);
    const V twice = scalar_t<V>(2) * w * s[2];
    return {twice, -twice, w * (s[1] - s[0])};
  }
  /// Stress -p I + s as { s_xx s_xy / s_yx s_yy } (row-major).
  template <class V> BOLIDE_INLINE static std::array<V, 4> in_plane(V p, const deviator<V>& s) { return {s[0] - p, s[2], s[2], s[1] - p}; }
};

} // namespace bolide::space
