// SPDX-License-Identifier: MIT
// Quantiles by weight: the smallest value v such that the samples <= v carry at least the share q of the whole weight.
//
// So the 99.9 % mass quantile of z is a particle's own z, not an interpolation, and no single light particle moves it. A sample whose
// value or weight is not finite, or whose weight is not positive, does not count. Without samples the answer is NaN.
// Cost: one sort, n log n.
#pragma once

#include "bolide/core/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace bolide::observe {

/// Samples sorted once, to be asked for several quantiles.
class weighted_samples {
 public:
  void add(double value, double weight) {
    if (!std::isfinite(value) || !std::isfinite(weight) || !(weight > 0)) return;
    samples_.emplace_back(value, weight);
    sorted_ = false;
  }
  std::size_t size() const { return samples_.size(); }
  double weight() const {
    double sum = 0;
    for (const auto& s : samples_) sum += s.second;
    return sum;
  }

  /// Smallest value with at least the share `q` (0..1) of the weight at or below it.
  double quantile(double q) {
    require(q >= 0 && q <= 1, "quantile", q, "in 0..1");
    if (samples_.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (!sorted_) std::sort(samples_.begin(), samples_.end());
    sorted_ = true;
    // the slack absorbs the rounding of the running sum, so that 999 of 1000 equal weights are 99.9 %
    const double wanted = q * weight() * (1 - 1e-12);
    double sum = 0;
    for (const auto& s : samples_)
      if ((sum += s.second) >= wanted) return s.first;
    return samples_.back().first;
  }
  double median() { return quantile(0.5); }

 private:
  std::vector<std::pair<double, double>> samples_; // value, weight
  bool sorted_ = true;
};

inline double weighted_quantile(const std::vector<double>& values, const std::vector<double>& weights, double q) {
  require(values.size() == weights.size(), "number of weights", static_cast<double>(weights.size()), "the number of values");
  weighted_samples samples;
  for (std::size_t i = 0; i < values.size(); ++i) samples.add(values[i], weights[i]);
  return samples.quantile(q);
}

} // namespace bolide::observe
