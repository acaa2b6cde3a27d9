// SPDX-License-Identifier: MIT
// Derivatives and jumps of a function that may have kinks and jumps at unknown places, by its values alone.
//
// derivative_error: is `claimed` the derivative of f at 0? Quotients over one step size after the other, central (error h^6) and one-sided to
// either side (error h^4). Beside a border (a kink, a jump) at least one side sees one smooth piece only, and that one must agree; where a
// claim is wrong none does, whatever the step. So the figure is the least deviation of them all, and a border needs no detecting.
//
// find_jump: the largest jump of f between two arguments, or 0. The interval is cut in eight, and the piece whose rise deviates most from
// the median rise is cut again: for a smooth f the deviation falls 64 times at each cut, at a kink 8 times, at a jump it stays. What is left
// when the piece is as narrow as round-off allows is the jump.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace bolide::conformance {

struct difference_match {
  double error;    // |claimed - quotient| of the best quotient
  bool one_sided;  // no central quotient was good enough
};

namespace detail {
/// d/ds at 0 from f(+-h), f(+-h/2), f(+-h/4), extrapolated twice.
template <class F> double central_quotient(const F& f, double h) {
  const auto d = [&](double s) { return (f(s) - f(-s)) / (2 * s); };
  const double a = d(h), b = d(h / 2), c = d(h / 4);
  return (64 * c - 20 * b + a) / 45;
}
/// d/ds at 0 from f(0), f(h/4) .. f(h); h < 0 looks to the left.
template <class F> double one_sided_quotient(const F& f, double h) {
  const double q = h / 4;
  return (-25 * f(0) + 48 * f(q) - 36 * f(2 * q) + 16 * f(3 * q) - 3 * f(4 * q)) / (12 * q);
}
} // namespace detail

/// Stops looking when a quotient is within `enough` of the claim.
template <class F> difference_match derivative_error(const F& f, double claimed, std::initializer_list<double> steps, double enough) {
  difference_match best{std::nan(""), false};
  const auto consider = [&](double quotient, bool one_sided) {
    const double error = std::abs(quotient - claimed);
    if (!(error >= best.error)) best = std::isnan(error) ? best : difference_match{error, one_sided};
    return best.error <= enough;
  };
  for (const double h : steps)
    if (consider(detail::central_quotient(f, h), false)) return best;
  for (const double h : steps)
    if (consider(detail::one_sided_quotient(f, h), true) || consider(detail::one_sided_quotient(f, -h), true)) return best;
  return best;
}

struct jump {
  double size; // >= 0
  double at;
};

/// Jumps smaller than `smallest` are not looked for.
template <class F> jump find_jump(const F& f, double low, double high, double smallest) {
  constexpr std::size_t pieces = 8;
  for (int cut = 0; cut < 24; ++cut) {
    std::array<double, pieces + 1> value;
    std::array<double, pieces> rise, sorted;
    const auto place = [&](std::size_t i) { return low + (high - low) * static_cast<double>(i) / pieces; };
    for (std::size_t i = 0; i <= pieces; ++i) value[i] = f(i == pieces ? high : place(i));
    for (std::size_t i = 0; i < pieces; ++i) sorted[i] = rise[i] = value[i + 1] - value[i];
    std::nth_element(sorted.begin(), sorted.begin() + pieces / 2, sorted.end());
    const double median = sorted[pieces / 2];
    const auto off = [&](std::size_t i) { return std::abs(rise[i] - median); };
    std::size_t worst = 0;
    for (std::size_t i = 1; i < pieces; ++i)
      if (off(i) > off(worst)) worst = i;
    if (!(off(worst) > smallest)) return {0, low};
    const double left = place(worst), right = worst + 1 == pieces ? high : place(worst + 1);
    low = left, high = right;
    if (high - low <= 1e-14 * std::max(std::abs(low), std::abs(high))) break;
  }
  const double size = std::abs(f(high) - f(low));
  return {size > smallest ? size : 0, low};
}

} // namespace bolide::conformance
