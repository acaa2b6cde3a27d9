// SPDX-License-Identifier: MIT
// Derivatives and jumps of a function that may have kinks and jumps at unknown places, by its values alone.
//
// derivative_error: is `claimed` the derivative of f at 0? Quotients over one step size after the other, central (error h^6) and one-sided to
// either side (error h^4). Beside a border (a kink, a jump) at least one side sees one smooth piece only, and that one must agree; where a
// claim is wrong none does, whatever the step. So the figure is the least deviation of them all, and a border needs no detecting.
//
// find_jump: the largest jump of f between two arguments, or 0. The interval is cut in eight; each piece whose rise deviates from what its
// neighbours' rises let expect is cut again. Where f is smooth the deviation falls some 500 times at each cut, at a kink 8 times, at a jump
// it stays: what is left when the piece is as narrow as round-off allows is the jump. A piece without deviation holds none.
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

namespace detail {
template <class F> class jump_search {
public:
  jump_search(const F& f, double smallest) : f_(f), smallest_(smallest) {}

  jump run(double low, double high) {
    search(low, high, f_(low), f_(high), 0);
    return largest_;
  }

private:
  static constexpr std::size_t pieces = 8;

  void search(double low, double high, double f_low, double f_high, int cuts) {
    if (high - low <= 1e-14 * std::max(std::abs(low), std::abs(high)) || cuts == 24) {
      const double size = std::abs(f_high - f_low);
      if (size > smallest_ && size > largest_.size) largest_ = {size, low};
      return;
    }
    std::array<double, pieces + 1> x, value;
    std::array<double, pieces> rise;
    for (std::size_t i = 0; i <= pieces; ++i) x[i] = i == pieces ? high : low + (high - low) * static_cast<double>(i) / pieces;
    for (std::size_t i = 0; i <= pieces; ++i) value[i] = i == 0 ? f_low : i == pieces ? f_high : f_(x[i]);
    for (std::size_t i = 0; i < pieces; ++i) rise[i] = value[i + 1] - value[i];
    calls_ += pieces - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t middle = std::clamp<std::size_t>(i, 1, pieces - 2);
      const double expected = i == middle ? 0.5 * (rise[i - 1] + rise[i + 1]) : 2 * rise[middle] - rise[i < middle ? 2 : pieces - 3];
      if (std::abs(rise[i] - expected) > smallest_ && calls_ < most_calls) search(x[i], x[i + 1], value[i], value[i + 1], cuts + 1);
    }
  }

  static constexpr std::size_t most_calls = 5000; // a staircase has been seen by then
  const F& f_;
  double smallest_;
  jump largest_{0, std::nan("")};
  std::size_t calls_ = 0;
};
} // namespace detail

/// Jumps smaller than `smallest` are not looked for.
template <class F> jump find_jump(const F& f, double low, double high, double smallest) {
  return detail::jump_search<F>(f, smallest).run(low, high);
}

} // namespace bolide::conformance
