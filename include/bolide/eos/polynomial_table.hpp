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

  polynomial_table(double low, double step, std::size_t rows) : low_(low), step_(step), double_rows_(rows), float_rows_(rows) {
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
  double left(std::size_t i) const { return low_ + step_ * double(i); }
  std::size_t rows() const { return double_rows_.size(); }

  template <class V> BOLIDE_INLINE place<V> find(V s) const {
    using T = scalar_t<V>;
    constexpr int width = lane_width<V>;
    const V steps = (s - static_cast<T>(low_)) * static_cast<T>(1 / step_);
    const V inside = clip(steps, V(T(0)), V(static_cast<T>(rows() - 1))); // also catches NaN
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
    const T* first = data(T{});
    for (int k = 0; k < K; ++k) r.c[k] = gather<V>(first + k, index);
    return r;
  }

private:
  const double* data(double) const { return double_rows_.data()->c; }
  const float* data(float) const { return float_rows_.data()->c; }

  double low_, step_;
  std::vector<row<double>> double_rows_;
  std::vector<row<float>> float_rows_;
};

} // namespace bolide::eos
