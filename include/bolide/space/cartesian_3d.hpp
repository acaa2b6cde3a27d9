// SPDX-License-Identifier: MIT
// Three-dimensional space x, y, z.
//
// Velocity gradient L row by row: l[3 i + j] = v_i,j. Independent components of a deviator: { s_xx  s_yy  s_xy  s_xz  s_yz },
// s_zz = -(s_xx + s_yy).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

#include <array>

namespace bolide::space {

struct cartesian_3d {
  static constexpr int dim = 3;
  static constexpr int gradient_size = 9, deviator_size = 5;
  static constexpr bool hoop = false;
  static constexpr const char* name = "cartesian_3d";

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
  /// Volume (m3) of a particle that stands for `volume` (m3) of the lattice.
  static double volume(const double*, double volume) { return volume; }

  template <class V> BOLIDE_INLINE static V divergence(const gradient<V>& l) { return l[0] + l[4] + l[8]; }
  /// det(I + dt L)
  template <class V> BOLIDE_INLINE static V jacobian(const gradient<V>& l, V dt) {
    const V a = V(1) + dt * l[0], b = dt * l[1], c = dt * l[2], d = dt * l[3], e = V(1) + dt * l[4], f = dt * l[5], g = dt * l[6], h = dt * l[7], i = V(1) + dt * l[8];
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  }
  /// Largest of |components|: how fast the particle is being deformed, 1/s.
  template <class V> BOLIDE_INLINE static V magnitude(const gradient<V>& l) {
    V most = abs(l[0]);
    for (std::size_t i = 1; i < gradient_size; ++i) most = max(most, abs(l[i]));
    return most;
  }
  /// Deviator of the rate of deformation, D - tr(D)/3 I.
  template <class V> BOLIDE_INLINE static deviator<V> deviatoric_rate(const gradient<V>& l) {
    const scalar_t<V> half(0.5);
    const V third = divergence(l) * scalar_t<V>(1.0 / 3);
    return {l[0] - third, l[4] - third, half * (l[1] + l[3]), half * (l[2] + l[6]), half * (l[5] + l[7])};
  }
  /// a : b, all components counted.
  template <class V> BOLIDE_INLINE static V contract(const deviator<V>& a, const deviator<V>& b) {
    return a[0] * b[0] + a[1] * b[1] + (a[0] + a[1]) * (b[0] + b[1]) + scalar_t<V>(2) * (a[2] * b[2] + a[3] * b[3] + a[4] * b[4]);
  }
  /// Jaumann rate of s from the spin, W s - s W (paper eq. 10), with W = (L - L^T)/2.
  template <class V> BOLIDE_INLINE static deviator<V> jaumann_rate(const deviator<V>& s, const gradient<V>& l) {
    const scalar_t<V> half(0.5), two(2);
    const V xy = half * (l[1] - l[3]), xz = half * (l[2] - l[6]), yz = half * (l[5] - l[7]); // W_xy, W_xz, W_yz
    const V zz = -(s[0] + s[1]);
    return {two * (xy * s[2] + xz * s[3]), two * (yz * s[4] - xy * s[2]), xy * (s[1] - s[0]) + xz * s[4] + yz * s[3], xz * (zz - s[0]) + xy * s[4] - yz * s[2],
            yz * (zz - s[1]) - xy * s[3] - xz * s[2]};
  }
  /// Stress -p I + s (row-major, 3 x 3).
  template <class V> BOLIDE_INLINE static std::array<V, 9> in_plane(V p, const deviator<V>& s) {
    return {s[0] - p, s[2], s[3], s[2], s[1] - p, s[4], s[3], s[4], -p - s[0] - s[1]};
  }
};

} // namespace bolide::space
