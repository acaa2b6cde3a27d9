// SPDX-License-Identifier: MIT
// Axisymmetric space r-z: two coordinates, a full 3-D state of stress, the axis r = 0 as a mirror.
//
// A particle is a ring: mass, volume and energy are those of the whole ring (2 pi r times its cross-section), so sums over
// particles are the body's in SI. Velocity gradient (paper eqs. 1-3):
//   L = { v_r,r  v_r,z  v_z,r  v_z,z  v_r/r }.   Independent components of a deviator: { s_rr  s_zz  s_rz },  s_tt = -(s_rr + s_zz).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <array>
#include <numbers>

namespace bolide::space {

struct axisymmetric {
  static constexpr int dim = 2;
  static constexpr int gradient_size = 5, deviator_size = 3;
  static constexpr bool hoop = true; // axis 0 is a radius: hoop terms v_r/r and s_tt/r, mirror at r = 0
  static constexpr const char* name = "axisymmetric";

  template <class V> using gradient = std::array<V, gradient_size>;
  template <class V> using deviator = std::array<V, deviator_size>;

  static constexpr int components(rank r) {
    switch (r) {
    case rank::vector: return dim;
    case rank::deviator: return deviator_size;
    case rank::gradient: return dim * dim; // affine velocity of APIC: in-plane only
    default: return 1;
    }
  }
  /// Volume (m3) of a particle of cross-section `area` (m2) whose centre is at radius r (m).
  static double volume(const double* position, double area) { return 2 * std::numbers::pi * position[0] * area; }

  template <class V> BOLIDE_INLINE static V divergence(const gradient<V>& l) { return l[0] + l[3] + l[4]; }
  /// det(I + dt L)
  template <class V> BOLIDE_INLINE static V jacobian(const gradient<V>& l, V dt) {
    return ((V(1) + dt * l[0]) * (V(1) + dt * l[3]) - dt * dt * l[1] * l[2]) * (V(1) + dt * l[4]);
  }
  /// Largest of |components|: how fast the particle is being deformed, 1/s.
  template <class V> BOLIDE_INLINE static V magnitude(const gradient<V>& l) {
    return max(max(max(abs(l[0]), abs(l[3])), abs(l[4])), max(abs(l[1]), abs(l[2])));
  }
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
  /// Stress -p I + s as { s_rr s_rz / s_zr s_zz } (row-major, dim x dim) and the hoop stress.
  template <class V> BOLIDE_INLINE static std::array<V, 4> in_plane(V p, const deviator<V>& s) { return {s[0] - p, s[2], s[2], s[1] - p}; }
  template <class V> BOLIDE_INLINE static V hoop_stress(V p, const deviator<V>& s) { return -p - s[0] - s[1]; }
};

} // namespace bolide::space
