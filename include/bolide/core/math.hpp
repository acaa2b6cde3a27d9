// SPDX-License-Identifier: MIT
// Elementary functions for every lane type: abs, min, max, sqrt, log, exp, pow, cbrt.
//
// For a scalar they are the standard library's. For a pack they are branch-free polynomials:
//   log x = k ln 2 + 2 atanh(s),  x = 2^k m,  m in [1/sqrt2, sqrt2),  s = (m-1)/(m+1)     to s^15 (double), s^7 (float)
//   exp x = 2^k e^r,  k = round(x/ln 2),  |r| <= ln2/2                                     to r^11 (double), r^6 (float)
// Their coefficients interpolate (atanh(s)/s - 1)/s^2 over s^2, and (e^r - 1 - r)/r^2, at Chebyshev points: 5e-18 and 2e-17 of the whole in double, 3e-9
// and 1e-8 in float, where Taylor's of the same length leave 4e-14 and 6e-15.
// Relative error at most 2e-15 in double and 3e-7 in float for normal arguments and results (tests/unit/core/math_test.cpp).
// log of zero, of a negative or of a denormal number is not answered by the packs (assert in the caller, or select around it);
// exp saturates at 0 and at the largest power of two instead of overflowing to infinity.
// pow(x, y) = exp(y log x), x > 0. In double y log x is carried in two numbers: at most 2e-15 for |y log x| <= 10, 5e-15 up to 700 (measured: 5e-16
// and 4e-15). In float its error grows as |y log x| times the machine epsilon, and so does that of cbrt.
#pragma once

#include "bolide/core/lane.hpp"

#include <array>

namespace bolide {

template <std::floating_point T> BOLIDE_INLINE T abs(T x) { return std::fabs(x); }
template <std::floating_point T> BOLIDE_INLINE T min(T a, std::type_identity_t<T> b) { return a < b ? a : b; }
template <std::floating_point T> BOLIDE_INLINE T max(T a, std::type_identity_t<T> b) { return a > b ? a : b; }
template <std::floating_point T> BOLIDE_INLINE T sqrt(T x) { return std::sqrt(x); }
template <std::floating_point T> BOLIDE_INLINE T log(T x) { return std::log(x); }
template <std::floating_point T> BOLIDE_INLINE T exp(T x) { return std::exp(x); }
template <std::floating_point T> BOLIDE_INLINE T pow(T x, std::type_identity_t<T> y) { return std::pow(x, y); }
template <std::floating_point T> BOLIDE_INLINE T cbrt(T x) { return std::cbrt(x); }
template <std::floating_point T> BOLIDE_INLINE T floor(T x) { return std::floor(x); }

template <class T, int W> BOLIDE_INLINE pack<T, W> abs(pack<T, W> x) { return select(x < pack<T, W>(0), -x, x); }
template <class T, int W> BOLIDE_INLINE pack<T, W> min(pack<T, W> a, std::type_identity_t<pack<T, W>> b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(a.v) == 64) { // one instruction, the same answer: b where one is NaN; g++ makes a comparison and a blend of the line below
    if constexpr (sizeof(T) == 8) return pack<T, W>((decltype(a.v))_mm512_maskz_min_pd(static_cast<__mmask8>(-1), (__m512d)a.v, (__m512d)b.v));
    else return pack<T, W>((decltype(a.v))_mm512_maskz_min_ps(static_cast<__mmask16>(-1), (__m512)a.v, (__m512)b.v));
  }
#endif
  return select(a < b, a, b);
}
template <class T, int W> BOLIDE_INLINE pack<T, W> max(pack<T, W> a, std::type_identity_t<pack<T, W>> b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(a.v) == 64) { // one instruction, the same answer: b where one is NaN; g++ makes a comparison and a blend of the line below
    if constexpr (sizeof(T) == 8) return pack<T, W>((decltype(a.v))_mm512_maskz_max_pd(static_cast<__mmask8>(-1), (__m512d)a.v, (__m512d)b.v));
    else return pack<T, W>((decltype(a.v))_mm512_maskz_max_ps(static_cast<__mmask16>(-1), (__m512)a.v, (__m512)b.v));
  }
#endif
  return select(a > b, a, b);
}

template <class T, int W> BOLIDE_INLINE pack<T, W> sqrt(pack<T, W> x) {
  pack<T, W> r;
#if defined(__AVX512F__)
  if constexpr (sizeof(x.v) == 64) { // the masked form: g++ 12 warns of the plain one's undefined pass-through
    if constexpr (sizeof(T) == 8) r.v = (decltype(r.v))_mm512_maskz_sqrt_pd(static_cast<__mmask8>(-1), (__m512d)x.v);
    else r.v = (decltype(r.v))_mm512_maskz_sqrt_ps(static_cast<__mmask16>(-1), (__m512)x.v);
    return r;
  }
#endif
#if defined(__AVX__)
  if constexpr (sizeof(x.v) == 32) {
    if constexpr (sizeof(T) == 8) r.v = (decltype(r.v))_mm256_sqrt_pd((__m256d)x.v);
    else r.v = (decltype(r.v))_mm256_sqrt_ps((__m256)x.v);
    return r;
  }
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(x.v) == 16) {
    if constexpr (sizeof(T) == 8) r.v = (decltype(r.v))_mm_sqrt_pd((__m128d)x.v);
    else r.v = (decltype(r.v))_mm_sqrt_ps((__m128)x.v);
    return r;
  }
#endif
  for (int i = 0; i < W; ++i) r.v[i] = std::sqrt(x.v[i]);
  return r;
}

namespace detail {
template <class T> struct float_layout;
template <> struct float_layout<double> {
  static constexpr int mantissa_bits = 52;
  static constexpr std::uint64_t half_root = 0x3FE6A09E667F3BCD; // bits of 1/sqrt 2
  static constexpr double ln2_high = 0x1.62e42fefa3800p-1, ln2_low = 0x1.ef35793c76730p-45, round_magic = 0x1.8p52;
  static constexpr double exp_low = -708.0, exp_high = 709.0;
  static constexpr std::array<double, 7> log_series{0x1.5555555555558p-2, 0x1.99999999952e2p-3, 0x1.2492492df148dp-3, 0x1.c71c62e5800a1p-4,
                                                    0x1.7462b4ab2ef6bp-4, 0x1.39fe606542ddep-4, 0x1.2b584aae78a57p-4};
  static constexpr std::array<double, 12> exp_series{1, 1, 0x1.0000000000001p-1, 0x1.5555555555556p-3, 0x1.5555555553d63p-5, 0x1.11111111109b3p-7,
                                                     0x1.6c16c1788bd90p-10, 0x1.a01a01a7c41d5p-13, 0x1.a019b90d2ae7ap-16, 0x1.71de0dae63bb3p-19,
                                                     0x1.289185613a3d6p-22, 0x1.af38a9b0ec855p-26};
};
template <> struct float_layout<float> {
  static constexpr int mantissa_bits = 23;
  static constexpr std::uint32_t half_root = 0x3F3504F3;
  static constexpr float ln2_high = 0x1.62e4p-1f, ln2_low = 0x1.7f7d1cp-20f, round_magic = 0x1.8p23f;
  static constexpr float exp_low = -87.0f, exp_high = 88.0f;
  static constexpr std::array<float, 3> log_series{0x1.55555cp-2f, 0x1.997c30p-3f, 0x1.2ee610p-3f};
  static constexpr std::array<float, 7> exp_series{1, 1, 0x1p-1f, 0x1.5554dcp-3f, 0x1.55551ap-5f, 0x1.120b6ep-7f, 0x1.6d110ap-10f};
};
} // namespace detail

namespace detail {
template <std::size_t N, class V> BOLIDE_INLINE V combine(V x, const std::array<V, N>& c) {
  if constexpr (N == 1) return c[0];
  else {
    std::array<V, (N + 1) / 2> pair;
    for (std::size_t i = 0; i + 1 < N; i += 2) pair[i / 2] = c[i] + c[i + 1] * x;
    if constexpr (N % 2 == 1) pair[N / 2] = c[N - 1];
    return combine<(N + 1) / 2>(x * x, pair);
  }
}
/// c[0] + c[1] x + ... + c[N-1] x^(N-1) by Estrin's scheme: pairs first, so that the chain of dependent operations is short.
template <std::size_t N, class V, class T> BOLIDE_INLINE V polynomial(V x, const std::array<T, N>& c) {
  std::array<V, (N + 1) / 2> pair;
  for (std::size_t i = 0; i + 1 < N; i += 2) pair[i / 2] = V(c[i]) + V(c[i + 1]) * x;
  if constexpr (N % 2 == 1) pair[N / 2] = V(c[N - 1]);
  return combine<(N + 1) / 2>(x * x, pair);
}
} // namespace detail

template <class T, int W> BOLIDE_INLINE pack<T, W> log(pack<T, W> x) {
  using layout = detail::float_layout<T>;
  using bits = typename detail::simd_register<T, W>::bits;
  using words = typename detail::simd_register<T, W>::words; // of negative x, whose answer nobody reads, the differences wrap around
  const bits k = (bits)((words)x.v - layout::half_root) >> layout::mantissa_bits; // arithmetic shift: floor
  const pack<T, W> m((typename pack<T, W>::value_type)((words)x.v - ((words)k << layout::mantissa_bits)));
  const pack<T, W> kf(__builtin_convertvector(k, typename pack<T, W>::value_type));
  const pack<T, W> s = (m - T(1)) / (m + T(1)), z = s * s;
  const pack<T, W> sum = detail::polynomial(z, layout::log_series);
  return kf * layout::ln2_high + (T(2) * s + (T(2) * s * z * sum + kf * layout::ln2_low));
}

template <class T, int W> BOLIDE_INLINE pack<T, W> exp(pack<T, W> x) {
  using layout = detail::float_layout<T>;
  using words = typename detail::simd_register<T, W>::words;
  x = min(max(x, pack<T, W>(layout::exp_low)), pack<T, W>(layout::exp_high));
  const pack<T, W> shifted = x * T(1.4426950408889634074) + layout::round_magic;
  const words k = (words)shifted.v - (words)pack<T, W>(layout::round_magic).v;
  const pack<T, W> kf = shifted - layout::round_magic;
  const pack<T, W> r = (x - kf * layout::ln2_high) - kf * layout::ln2_low;
  const pack<T, W> sum = detail::polynomial(r, layout::exp_series);
  return pack<T, W>((typename pack<T, W>::value_type)((words)sum.v + (k << layout::mantissa_bits)));
}

namespace detail {
/// x without the lower half of its mantissa: the product of two such numbers is exact.
template <int W> BOLIDE_INLINE pack<double, W> upper_half(pack<double, W> x) {
  using bits = typename simd_register<double, W>::bits;
  return pack<double, W>((typename pack<double, W>::value_type)((bits)x.v & ~std::int64_t{0x7FFFFFF}));
}
/// exp(y log x) with log x and its product with y carried in two numbers each: the series is that of log, s to twice the digits.
template <int W> BOLIDE_INLINE pack<double, W> accurate_pow(pack<double, W> x, pack<double, W> y) {
  using V = pack<double, W>;
  using layout = float_layout<double>;
  using bits = typename simd_register<double, W>::bits;
  using words = typename simd_register<double, W>::words;
  const bits k = (bits)((words)x.v - layout::half_root) >> layout::mantissa_bits;
  const V m((typename V::value_type)((words)x.v - ((words)k << layout::mantissa_bits))), kf(__builtin_convertvector(k, typename V::value_type));
  const V a = m - 1.0, d = m + 1.0, d_lost = m - (d - 1.0), inverse = V(1.0) / d, d_high = upper_half(d), d_low = d - d_high;
  const V s_high = upper_half(a * inverse), s_low = (((a - s_high * d_high) - s_high * d_low) - s_high * d_lost) * inverse;
  const V s = s_high + s_low, z = s * s;
  const V whole = kf * layout::ln2_high, twice = 2.0 * s_high, sum = whole + twice;
  const V rest = (twice - (sum - whole)) + (kf * layout::ln2_low + (2.0 * s_low + 2.0 * s * z * polynomial(z, layout::log_series)));
  const V log_high = sum + rest, log_low = rest - (log_high - sum);
  const V power = y * log_high, u = upper_half(y), v = upper_half(log_high), u_low = y - u, v_low = log_high - v;
  const V lost = (((u * v - power) + u * v_low) + u_low * v) + u_low * v_low + y * log_low;
  const V r = exp(power);
  return r + r * lost;
}
} // namespace detail

template <class T, int W> BOLIDE_INLINE pack<T, W> pow(pack<T, W> x, std::type_identity_t<pack<T, W>> y) {
  if constexpr (sizeof(T) == 8) return detail::accurate_pow(x, y);
  else return exp(y * log(x));
}
template <class T, int W> BOLIDE_INLINE pack<T, W> cbrt(pack<T, W> x) { return exp(T(1) / T(3) * log(x)); }
template <class T, int W> BOLIDE_INLINE pack<T, W> floor(pack<T, W> x) {
  const pack<T, W> t(__builtin_convertvector(__builtin_convertvector(x.v, typename detail::simd_register<T, W>::bits), typename pack<T, W>::value_type));
  return select(t > x, t - T(1), t);
}

/// Clips x to [low, high].
template <class V> BOLIDE_INLINE V clip(V x, std::type_identity_t<V> low, std::type_identity_t<V> high) { return min(max(x, low), high); }
template <class V> BOLIDE_INLINE V square(V x) { return x * x; }

} // namespace bolide
