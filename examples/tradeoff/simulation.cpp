// SPDX-License-Identifier: MIT
// From a composition's number to its type, and what scenes are made of.
#include "compositions.hpp"

#include <cstdio>
#include <ctime>
#include <numbers>

namespace tradeoff {

std::string name(const settings& s) {
  const composition& c = compositions[s.composition];
  std::string text;
  for (const auto word : {c.shape, c.transfer, c.scheme, c.precision}) text.append(text.empty() ? "" : " ").append(word);
  char rest[60];
  std::snprintf(rest, sizeof rest, ", %d per axis, CFL %g", s.per_axis, s.courant);
  return text + rest + (s.table ? ", EOS table" : "") + (s.skip ? "" : ", nothing skipped");
}

region block(point low, point high) {
  return {low, high, low, {}, std::numbers::pi * (high[0] * high[0] - low[0] * low[0]) * (high[1] - low[1])};
}
region half_ball(double radius) {
  return {{0, 0}, {radius, radius}, {0, 0}, [radius](const point& x) { return x.norm() < radius; }, 2.0 / 3 * std::numbers::pi * radius * radius * radius};
}

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::unique_ptr<simulation> compose(const settings& s, const scene& of) {
  static constexpr maker* makers[] = {linear_flip_usf,  linear_flip_musl,  linear_flip_usf_float,  bspline_flip_usf,  bspline_flip_usl, bspline_flip_usf_float,
                                      bspline_apic_usf, bspline_apic_musl, bspline_apic_usf_float, bspline_xpic2_usf, cubic_apic_usf,   gimp_flip_usf};
  static_assert(sizeof makers / sizeof makers[0] == number_of_compositions);
  return makers[s.composition](s, of);
}

} // namespace tradeoff
