// SPDX-License-Identifier: MIT
// A lane: the number that per-particle physics is written in.
//
// A per-particle function is a template on its number type. Instantiated with `double` or `float` it treats one particle; with
// `pack<T, W>` it treats W particles at once in one SIMD register. A branch is written as `select(condition, yes, no)`, which
// is a plain conditional for a scalar and a blend for a pack; a fast path for W equal answers asks `all(m)` or `any(m)`.
//
// The pack sits on the vector extensions of g++ and clang (intrinsics only for the square root, which the compilers do not
// offer there, and for the mask registers of AVX-512). W is 2, 4, 8 or 16; `native_pack<T>` is the widest register of the target.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define BOLIDE_INLINE inline __attribute__((always_inline))

namespace bolide {

namespace detail {
template <class T, int W> struct simd_register; // g++ refuses a vector_size that depends on a template parameter
template <> struct simd_register<double, 2> { using ints __attribute__((vector_size(8))) = std::int32_t; using value __attribute__((vector_size(16))) = double; using bits __attribute__((vector_size(16))) = std::int64_t; using words __attribute__((vector_size(16))) = std::uint64_t; };
template <> struct simd_register<double, 4> { using ints __attribute__((vector_size(16))) = std::int32_t; using value __attribute__((vector_size(32))) = double; using bits __attribute__((vector_size(32))) = std::int64_t; using words __attribute__((vector_size(32))) = std::uint64_t; };
template <> struct simd_register<double, 8> { using ints __attribute__((vector_size(32))) = std::int32_t; using value __attribute__((vector_size(64))) = double; using bits __attribute__((vector_size(64))) = std::int64_t; using words __attribute__((vector_size(64))) = std::uint64_t; };
template <> struct simd_register<float, 2> { using ints __attribute__((vector_size(8))) = std::int32_t; using value __attribute__((vector_size(8))) = float; using bits __attribute__((vector_size(8))) = std::int32_t; using words __attribute__((vector_size(8))) = std::uint32_t; };
template <> struct simd_register<float, 4> { using ints __attribute__((vector_size(16))) = std::int32_t; using value __attribute__((vector_size(16))) = float; using bits __attribute__((vector_size(16))) = std::int32_t; using words __attribute__((vector_size(16))) = std::uint32_t; };
template <> struct simd_register<float, 8> { using ints __attribute__((vector_size(32))) = std::int32_t; using value __attribute__((vector_size(32))) = float; using bits __attribute__((vector_size(32))) = std::int32_t; using words __attribute__((vector_size(32))) = std::uint32_t; };
template <> struct simd_register<float, 16> { using ints __attribute__((vector_size(64))) = std::int32_t; using value __attribute__((vector_size(64))) = float; using bits __attribute__((vector_size(64))) = std::int32_t; using words __attribute__((vector_size(64))) = std::uint32_t; };
} // namespace detail

/// W answers to a comparison of packs. Where the target has mask registers (AVX-512) a full-width mask is one bit per element; elsewhere
/// every bit of an element is set where the answer is yes.
template <class T, int W> struct lane_mask {
  using bits_type = typename detail::simd_register<T, W>::bits;
  bits_type bits;

  bool operator[](int lane) const { return bits[lane] != 0; }
  friend BOLIDE_INLINE lane_mask operator&&(lane_mask a, lane_mask b) { return {a.bits & b.bits}; }
  friend BOLIDE_INLINE lane_mask operator||(lane_mask a, lane_mask b) { return {a.bits | b.bits}; }
  friend BOLIDE_INLINE lane_mask operator!(lane_mask a) { return {~a.bits}; }
};

#if defined(__AVX512F__)
namespace detail {
/// The mask register of a 512-bit pack.
template <class T, int W, class Bits> struct bit_mask {
  Bits bits;
  bool operator[](int lane) const { return ((bits >> lane) & 1) != 0; }
  friend BOLIDE_INLINE lane_mask<T, W> operator&&(lane_mask<T, W> a, lane_mask<T, W> b) { return {{static_cast<Bits>(a.bits & b.bits)}}; }
  friend BOLIDE_INLINE lane_mask<T, W> operator||(lane_mask<T, W> a, lane_mask<T, W> b) { return {{static_cast<Bits>(a.bits | b.bits)}}; }
  friend BOLIDE_INLINE lane_mask<T, W> operator!(lane_mask<T, W> a) { return {{static_cast<Bits>(~a.bits)}}; }
};
} // namespace detail
template <> struct lane_mask<double, 8> : detail::bit_mask<double, 8, std::uint8_t> {};
template <> struct lane_mask<float, 16> : detail::bit_mask<float, 16, std::uint16_t> {};

namespace detail {
template <int Predicate> BOLIDE_INLINE lane_mask<double, 8> compare(simd_register<double, 8>::value a, simd_register<double, 8>::value b) {
  return {{static_cast<std::uint8_t>(_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, Predicate))}};
}
template <int Predicate> BOLIDE_INLINE lane_mask<float, 16> compare(simd_register<float, 16>::value a, simd_register<float, 16>::value b) {
  return {{static_cast<std::uint16_t>(_mm512_cmp_ps_mask((__m512)a, (__m512)b, Predicate))}};
}
BOLIDE_INLINE simd_register<double, 8>::value blend(lane_mask<double, 8> m, simd_register<double, 8>::value yes, simd_register<double, 8>::value no) {
  return (simd_register<double, 8>::value)_mm512_mask_blend_pd(m.bits, (__m512d)no, (__m512d)yes);
}
BOLIDE_INLINE simd_register<float, 16>::value blend(lane_mask<float, 16> m, simd_register<float, 16>::value yes, simd_register<float, 16>::value no) {
  return (simd_register<float, 16>::value)_mm512_mask_blend_ps(m.bits, (__m512)no, (__m512)yes);
}
} // namespace detail
#define BOLIDE_COMPARE(a, b, op, predicate)                                                                                                          \
  if constexpr (sizeof((a).v) == 64) return detail::compare<predicate>((a).v, (b).v);                                                                \
  else return {(a).v op (b).v}
#else
#define BOLIDE_COMPARE(a, b, op, predicate) return {(a).v op (b).v}
#endif

/// W numbers that are treated as one.
template <class T, int W> struct pack {
  using scalar = T;
  using value_type = typename detail::simd_register<T, W>::value;
  using mask = lane_mask<T, W>;
  static constexpr int width = W;
  value_type v;

  pack() = default;
  BOLIDE_INLINE pack(value_type x) : v(x) {}
  template <class S>
    requires std::is_arithmetic_v<S>
  BOLIDE_INLINE pack(S x) : v(static_cast<T>(x) - value_type{}) {}

  /// {f(0), f(1), ...}, built in the register: element-wise stores to memory followed by one wide load would stall.
  template <class F> BOLIDE_INLINE static pack make(F&& f) {
    return [&]<int... I>(std::integer_sequence<int, I...>) { return pack(value_type{static_cast<T>(f(I))...}); }(std::make_integer_sequence<int, W>{});
  }
  BOLIDE_INLINE static pack load(const T* from) {
    pack r;
    std::memcpy(&r.v, from, sizeof r.v);
    return r;
  }
  BOLIDE_INLINE void store(T* to) const { std::memcpy(to, &v, sizeof v); }
  T operator[](int lane) const { return v[lane]; }
  void set(int lane, T x) { v[lane] = x; }

  friend BOLIDE_INLINE pack operator+(pack a, pack b) { return a.v + b.v; }
  friend BOLIDE_INLINE pack operator-(pack a, pack b) { return a.v - b.v; }
  friend BOLIDE_INLINE pack operator*(pack a, pack b) { return a.v * b.v; }
  friend BOLIDE_INLINE pack operator/(pack a, pack b) { return a.v / b.v; }
  friend BOLIDE_INLINE pack operator-(pack a) { return -a.v; }
  BOLIDE_INLINE pack& operator+=(pack b) { v += b.v; return *this; }
  BOLIDE_INLINE pack& operator-=(pack b) { v -= b.v; return *this; }
  BOLIDE_INLINE pack& operator*=(pack b) { v *= b.v; return *this; }
  BOLIDE_INLINE pack& operator/=(pack b) { v /= b.v; return *this; }
  friend BOLIDE_INLINE mask operator<(pack a, pack b) { BOLIDE_COMPARE(a, b, <, _CMP_LT_OQ); }
  friend BOLIDE_INLINE mask operator>(pack a, pack b) { BOLIDE_COMPARE(a, b, >, _CMP_GT_OQ); }
  friend BOLIDE_INLINE mask operator<=(pack a, pack b) { BOLIDE_COMPARE(a, b, <=, _CMP_LE_OQ); }
  friend BOLIDE_INLINE mask operator>=(pack a, pack b) { BOLIDE_COMPARE(a, b, >=, _CMP_GE_OQ); }
  friend BOLIDE_INLINE mask operator==(pack a, pack b) { BOLIDE_COMPARE(a, b, ==, _CMP_EQ_OQ); }
  friend BOLIDE_INLINE mask operator!=(pack a, pack b) { BOLIDE_COMPARE(a, b, !=, _CMP_NEQ_UQ); }
};

#undef BOLIDE_COMPARE

namespace detail {
template <class V> struct lane_traits { using scalar = V; using mask = bool; static constexpr int width = 1; };
template <class T, int W> struct lane_traits<pack<T, W>> { using scalar = T; using mask = lane_mask<T, W>; static constexpr int width = W; };
} // namespace detail

/// double or float behind a lane type.
template <class V> using scalar_t = typename detail::lane_traits<V>::scalar;
/// What a comparison of V gives: bool or lane_mask.
template <class V> using mask_t = typename detail::lane_traits<V>::mask;
/// Particles per lane value.
template <class V> inline constexpr int lane_width = detail::lane_traits<V>::width;

/// The number types that per-particle physics is written for.
template <class V>
concept Lane = std::floating_point<V> || (std::floating_point<scalar_t<V>> && lane_width<V> > 1);

#if defined(__AVX512F__)
inline constexpr int native_bytes = 64;
#elif defined(__AVX__)
inline constexpr int native_bytes = 32;
#else
inline constexpr int native_bytes = 16;
#endif
template <class T> inline constexpr int native_width = native_bytes / int(sizeof(T));
template <class T> using native_pack = pack<T, native_width<T>>;

// ---- branches ---------------------------------------------------------------------------------------------------------------
template <std::floating_point T> BOLIDE_INLINE T select(bool m, std::type_identity_t<T> yes, T no) { return m ? yes : no; }
template <std::floating_point T> BOLIDE_INLINE T select(bool m, T yes, int no) { return m ? yes : T(no); }
template <class T, int W> BOLIDE_INLINE pack<T, W> select(lane_mask<T, W> m, std::type_identity_t<pack<T, W>> yes, std::type_identity_t<pack<T, W>> no) {
#if defined(__AVX512F__)
  if constexpr (sizeof(yes.v) == 64) return detail::blend(m, yes.v, no.v);
  else
#endif
    return m.bits ? yes.v : no.v;
}
BOLIDE_INLINE bool any(bool m) { return m; }
BOLIDE_INLINE bool all(bool m) { return m; }
template <class T, int W> BOLIDE_INLINE bool any(lane_mask<T, W> m) {
  if constexpr (std::is_integral_v<decltype(m.bits)>) return m.bits != 0;
  else {
    std::uint64_t word[sizeof(m.bits) / 8], sum = 0;
    std::memcpy(word, &m.bits, sizeof m.bits);
    for (auto w : word) sum |= w;
    return sum != 0;
  }
}
template <class T, int W> BOLIDE_INLINE bool all(lane_mask<T, W> m) { return !any(!m); }
BOLIDE_INLINE int count(bool m) { return m ? 1 : 0; }
template <class T, int W> BOLIDE_INLINE int count(lane_mask<T, W> m) {
  if constexpr (std::is_integral_v<decltype(m.bits)>) return std::popcount(m.bits);
  else {
    int n = 0;
    for (int i = 0; i < W; ++i) n += m[i] ? 1 : 0;
    return n;
  }
}
/// The first n lanes (all of a scalar's single one).
template <class V> BOLIDE_INLINE mask_t<V> first_lanes(int n) {
  if constexpr (lane_width<V> == 1) return n > 0;
  else if constexpr (std::is_integral_v<decltype(mask_t<V>::bits)>) {
    using bits = decltype(mask_t<V>::bits);
    return {{static_cast<bits>(n >= lane_width<V> ? ~0u : (1u << n) - 1u)}};
  } else {
    V index;
    for (int i = 0; i < lane_width<V>; ++i) index.set(i, scalar_t<V>(i));
    return index < V(scalar_t<V>(n));
  }
}

// ---- lanes and memory -------------------------------------------------------------------------------------------------------
template <class V> BOLIDE_INLINE V load(const scalar_t<V>* from) {
  if constexpr (lane_width<V> == 1) return *from;
  else return V::load(from);
}
template <std::floating_point T> BOLIDE_INLINE void store(T x, T* to) { *to = x; }
template <class T, int W> BOLIDE_INLINE void store(pack<T, W> x, T* to) { x.store(to); }
template <std::floating_point T> BOLIDE_INLINE T lane(T x, int) { return x; }
template <class T, int W> BOLIDE_INLINE T lane(pack<T, W> x, int i) { return x[i]; }
template <std::floating_point T> BOLIDE_INLINE void set_lane(T& x, int, T value) { x = value; }
template <class T, int W> BOLIDE_INLINE void set_lane(pack<T, W>& x, int i, std::type_identity_t<T> value) { x.set(i, value); }
/// Stores the first n lanes.
template <class V> BOLIDE_INLINE void store_first(V x, scalar_t<V>* to, int n) {
  if (n >= lane_width<V>) store(x, to);
#if defined(__AVX512F__)
  else if constexpr (std::is_same_v<V, pack<double, 8>>) _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1u << n) - 1), (__m512d)x.v);
  else if constexpr (std::is_same_v<V, pack<float, 16>>) _mm512_mask_storeu_ps(to, static_cast<__mmask16>((1u << n) - 1), (__m512)x.v);
#endif
  else
    for (int i = 0; i < n; ++i) to[i] = lane(x, i);
}
/// The bits of a mask as lanes: lane i is yes where bit i is set.
template <class V> BOLIDE_INLINE mask_t<V> lanes_of(unsigned bits) {
  if constexpr (lane_width<V> == 1) return bits != 0;
  else if constexpr (std::is_integral_v<decltype(mask_t<V>::bits)>) return {{static_cast<decltype(mask_t<V>::bits)>(bits)}};
  else {
    V one;
    for (int i = 0; i < lane_width<V>; ++i) one.set(i, scalar_t<V>((bits >> i) & 1));
    return one > V(scalar_t<V>(0));
  }
}
template <class V> inline constexpr unsigned all_lanes = lane_width<V> == 32 ? ~0u : (1u << lane_width<V>) - 1;
/// Consecutive numbers from `from` on go to the lanes whose bit is set, one after the other; the others are 0. A whole register is read.
template <class V> BOLIDE_INLINE V spread(const scalar_t<V>* from, unsigned bits) {
  if (bits == all_lanes<V>) return load<V>(from);
  if constexpr (lane_width<V> == 1) return V(0);
#if defined(__AVX512F__)
  else if constexpr (std::is_same_v<V, pack<double, 8>>) return (typename V::value_type)_mm512_maskz_expand_pd(static_cast<__mmask8>(bits), _mm512_loadu_pd(from));
  else if constexpr (std::is_same_v<V, pack<float, 16>>) return (typename V::value_type)_mm512_maskz_expand_ps(static_cast<__mmask16>(bits), _mm512_loadu_ps(from));
#endif
  else {
    V r(scalar_t<V>(0));
    for (int i = 0; i < lane_width<V>; ++i)
      if ((bits >> i) & 1) r.set(i, *from++);
    return r;
  }
}
/// The reverse: the lanes whose bit is set go to consecutive places. A whole register is written; what follows the last lane is 0.
template <class V> BOLIDE_INLINE void squeeze(V x, unsigned bits, scalar_t<V>* to) {
  if (bits == all_lanes<V>) return store(x, to);
  if constexpr (lane_width<V> == 1) *to = 0;
#if defined(__AVX512F__)
  else if constexpr (std::is_same_v<V, pack<double, 8>>) _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), (__m512d)x.v));
  else if constexpr (std::is_same_v<V, pack<float, 16>>) _mm512_storeu_ps(to, _mm512_maskz_compress_ps(static_cast<__mmask16>(bits), (__m512)x.v));
#endif
  else {
    V r(scalar_t<V>(0));
    int n = 0;
    for (int i = 0; i < lane_width<V>; ++i)
      if ((bits >> i) & 1) r.set(n++, lane(x, i));
    store(r, to);
  }
}
/// {0, 1, 2, ...}
template <class V> BOLIDE_INLINE V lane_numbers() {
  if constexpr (lane_width<V> == 1) return V(0);
  else return V::make([](int i) { return i; });
}
/// from[index[i]] for each lane i.
template <class V, class Index> BOLIDE_INLINE V gather(const scalar_t<V>* from, const Index& index) {
  if constexpr (lane_width<V> == 1) return from[index[0]];
  else return V::make([&](int i) { return from[index[i]]; });
}
/// Stores each lane, a whole number of magnitude below 2^31, as an integer.
template <std::floating_point T> BOLIDE_INLINE void store_whole(T x, std::int32_t* to) { *to = static_cast<std::int32_t>(x); }
template <class T, int W> BOLIDE_INLINE void store_whole(pack<T, W> x, std::int32_t* to) {
  const auto i = __builtin_convertvector(x.v, typename detail::simd_register<T, W>::ints);
  std::memcpy(to, &i, sizeof i);
}

} // namespace bolide
