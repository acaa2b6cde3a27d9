// SPDX-License-Identifier: MIT
// A root of a continuous function inside a bracket, for set-up work: regula falsi in its Illinois form with bisection as the fallback.
// Stops when the bracket is as narrow as round-off allows, so that a caller never states a tolerance. A sign change at a jump is
// found too: whoever must tell it from a root looks at the value there.
#pragma once

#include <cmath>

namespace bolide::eos {

/// f(low) and f(high) must differ in sign (or one be zero); otherwise NaN.
template <class F> double bracketed_root(const F& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  if (!(f_low * f_high < 0)) return std::nan("");
  double w_low = f_low, w_high = f_high; // the weights of the secant; halved at an end that stays
  for (int i = 0; i < 200; ++i) {
    const bool slow = i % 3 == 2; // every third step bisects: 66 halvings at most
    double x = slow ? 0.5 * (low + high) : (low * w_high - high * w_low) / (w_high - w_low);
    if (!(x > std::fmin(low, high) && x < std::fmax(low, high))) x = 0.5 * (low + high);
    if (x == low || x == high) break;
    const double fx = f(x);
    if (fx == 0) return x;
    if ((fx < 0) == (f_low < 0)) {
      low = x, f_low = w_low = fx;
      if (!slow) w_high *= 0.5;
    } else {
      high = x, f_high = w_high = fx;
      if (!slow) w_low *= 0.5;
    }
    if (std::abs(high - low) <= 2e-16 * (std::abs(low) + std::abs(high))) break;
  }
  return std::abs(f_low) < std::abs(f_high) ? low : high;
}

} // namespace bolide::eos
