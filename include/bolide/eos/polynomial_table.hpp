// SPDX-License-Identifier: MIT
// A function of one variable as K-coefficient polynomials on equal intervals, read by every lane type.
//
// Row i holds c_0 .. c_{K-1} of a polynomial in t = (s - s_i)/step. The first and the last row also answer for everything below and
// above the table (t then leaves [0, 1]), so whoever fills them chooses the continuation: no clamp, no NaN.
// Kept in double and in float; a row is one aligned 64-byte line at most, so a lane touches one line.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide::eos {

/// Reads K columns of rows that are `stride` numbers apart, one row per lane.
template <int K, int stride> class row_reader {
public:
  /// c[k] = first[index[i] + k] for lane i.
  template <class V> static BOLIDE_INLINE void columns(const scalar_t<V>* first, const std::int32_t* index, V* c) {
    if constexpr (sizeof(V) == 64 && lane_width<V> == 8 && stride == 8) transpose(first, index, c);
    else
      for (int k = 0; k < K; ++k) c[k] = gather<V>(first + k, index);
  }

private:
  /// Eight whole rows loaded and transposed in registers: a third faster than 8 K single loads. Written out, because g++ keeps
  /// arrays that small loops touch in memory.
  template <class V> static BOLIDE_INLINE void transpose(const scalar_t<V>* first, const std::int32_t* index, V* c) {
    const V r0 = V::load(first + index[0]), r1 = V::load(first + index[1]), r2 = V::load(first + index[2]), r3 = V::load(first + index[3]);
    const V r4 = V::load(first + index[4]), r5 = V::load(first + index[5]), r6 = V::load(first + index[6]), r7 = V::load(first + index[7]);
    const V e0 = even(r0, r1), e1 = even(r2, r3), e2 = even(r4, r5), e3 = even(r6, r7);
    const V o0 = odd(r0, r1), o1 = odd(r2, r3), o2 = odd(r4, r5), o3 = odd(r6, r7);
    const V a0 = low_pairs(e0, e1), b0 = low_pairs(e2, e3), a2 = high_pairs(e0, e1), b2 = high_pairs(e2, e3); // columns 0 4, 2 6
    const V a1 = low_pairs(o0, o1), b1 = low_pairs(o2, o3), a3 = high_pairs(o0, o1), b3 = high_pairs(o2, o3); // columns 1 5, 3 7
    c[0] = low_half(a0, b0);
    c[1] = low_half(a1, b1);
    if constexpr (K > 2) c[2] = low_half(a2, b2);
    if constexpr (K > 3) c[3] = low_half(a3, b3);
    if constexpr (K > 4) c[4] = high_half(a0, b0);
    if constexpr (K > 5) c[5] = high_half(a1, b1);
    if constexpr (K > 6) c[6] = high_half(a2, b2);
    if constexpr (K > 7) c[7] = high_half(a3, b3);
  }
  template <class V> static BOLIDE_INLINE V even(V a, V b) { return __builtin_shufflevector(a.v, b.v, 0, 8, 2, 10, 4, 12, 6, 14); }
  template <class V> static BOLIDE_INLINE V odd(V a, V b) { return __builtin_shufflevector(a.v, b.v, 1, 9, 3, 11, 5, 13, 7, 15); }
  template <class V> static BOLIDE_INLINE V low_pairs(V a, V b) { return __builtin_shufflevector(a.v, b.v, 0, 1, 8, 9, 4, 5, 12, 13); }
  template <class V> static BOLIDE_INLINE V high_pairs(V a, V b) { return __builtin_shufflevector(a.v, b.v, 2, 3, 10, 11, 6, 7, 14, 15); }
  template <class V> static BOLIDE_INLINE V low_half(V a, V b) { return __builtin_shufflevector(a.v, b.v, 0, 1, 2, 3, 8, 9, 10, 11); }
  template <class V> static BOLIDE_INLINE V high_half(V a, V b) { return __builtin_shufflevector(a.v, b.v, 4, 5, 6, 7, 12, 13, 14, 15); }
};

template <int K> class polynomial_table {
  static_assert(K >= 2 && K <= 8, "bolide: a row of polynomial_table holds 2 to 8 coefficients.");
  static constexpr int stride = K <= 4 ? 4 : 8;
  template <class T> struct alignas(stride * sizeof(T)) row {
    T c[stride] = {};
  };

public:
  using coefficients = std::array<double, K>;

  /// A lane's place in the table: c[k] its coefficients, t its distance from the row's left edge in steps.
  template <class V> struct place {
    V c[K];
    V t;
  };

  polynomial_table(double low, double step, std::size_t rows)
      : low_(low), step_(step), inverse_step_(1 / step), last_(double(rows) - 1), double_rows_(rows), float_rows_(rows) {
    require(step > 0, "polynomial_table step", step, "> 0");
    require(rows >= 1 && rows < 1u << 24, "polynomial_table rows", double(rows), "between 1 and 2^24");
  }

  void set(std::size_t i, const coefficients& c) {
    for (std::size_t k = 0; k < K; ++k) {
      double_rows_[i].c[k] = c[k];
      float_rows_[i].c[k] = static_cast<float>(c[k]);
    }
  }

  double step() const { return step_; }
  double inverse_step() const { return inverse_step_; }
  double left(std::size_t i) const { return low_ + step_ * double(i); }
  std::size_t rows() const { return double_rows_.size(); }

  template <class V> BOLIDE_INLINE place<V> find(V s) const {
    using T = scalar_t<V>;
    constexpr int width = lane_width<V>;
    const V steps = (s - static_cast<T>(low_)) * static_cast<T>(inverse_step_);
    const V inside = clip(steps, V(T(0)), V(static_cast<T>(last_))); // also catches NaN
    std::int32_t index[width];
    place<V> r;
    if constexpr (width == 1) {
      index[0] = static_cast<std::int32_t>(inside);
      r.t = steps - static_cast<T>(index[0]);
    } else {
      const V whole = floor(inside);
      for (int i = 0; i < width; ++i) index[i] = static_cast<std::int32_t>(whole[i]) * stride;
      r.t = steps - whole;
    }
    if constexpr (width == 1) index[0] *= stride;
    row_reader<K, stride>::template columns<V>(data(T{}), index, r.c);
    return r;
  }

private:
  const double* data(double) const { return double_rows_.data()->c; }
  const float* data(float) const { return float_rows_.data()->c; }

  double low_, step_, inverse_step_, last_; // last_: index of the last row
  std::vector<row<double>> double_rows_;
  std::vector<row<float>> float_rows_;
};

} // namespace bolide::eos
