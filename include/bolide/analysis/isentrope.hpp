// SPDX-License-Identifier: MIT
// The isentrope through a state of any equation of state, expanding or compressing, with the particle speed of the simple wave on it.
//
//   de = -p dV,   du = c d ln V,   followed in y = ln V by an embedded Runge-Kutta pair of order 5(4) (Dormand-Prince)
// u is the gain of speed of material that expands (du = -dp/(rho c) along the wave): a free surface moves at up + u. Compression loses.
//   isentrope    sampled evenly between two densities;   isentrope_at: at given ones
//   release      from a shock state down to a pressure, the particle speed from up on
// The step is controlled at 1e-10 of the scale (e: |e| + 1e-4 c0^2, u: |u| + 1e-4 c0, c0 the sound speed at the start); kinks and jumps
// at phase borders only shorten it (to 1e-9 in ln V at most). Where c^2 <= 0 (spinodal, or a jump of the equation of state into such
// a state) the curve ends with the last stable state and says so; nothing that was found is lost.
// Expansion ends at 1e-100 of the starting density (a gas into vacuum), compression at 1e4 times it.
// Cost: 7 calls of the equation of state per step, 50 steps and more per unit of ln V.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace bolide::analysis {

struct isentrope_state {
  double density;        // kg/m3
  double energy;         // J/kg
  double pressure;       // Pa
  double sound_speed;    // m/s
  double temperature;    // K; NaN where the model knows none
  double particle_speed; // m/s
  double melt_fraction;  // 0 where the model knows none
  double region;         // region_value; NaN where the model knows none
};

/// Why a curve ends: where it was meant to, where c^2 <= 0, or at the limits of density above.
enum class isentrope_end { reached, unstable, density_limit };
constexpr const char* name(isentrope_end end) {
  constexpr const char* names[] = {"reached", "unstable", "density_limit"};
  return names[static_cast<int>(end)];
}

struct isentrope_curve {
  std::vector<isentrope_state> states; // in the order of the path; the last is the last stable one
  isentrope_end end;
  std::string message; // a sentence unless end is reached
};

namespace detail {
/// Energy and speed against y = ln V.
struct isentrope_point {
  double y, e, u;
};
/// What errors of e and u are measured by, beside their own size.
struct isentrope_scale {
  double e, u;
};
template <class Eos> double pressure_at(const Eos& eos, const isentrope_point& a) { return eos.evaluate(std::exp(-a.y), a.e).pressure; }
template <class Eos> double squared_speed_at(const Eos& eos, const isentrope_point& a) {
  return eos.evaluate(std::exp(-a.y), a.e).sound_speed_squared;
}

/// One Dormand-Prince step of length h; error receives the scaled difference of the pair.
template <class Eos>
isentrope_point isentrope_step(const Eos& eos, const isentrope_point& a, double h, const isentrope_scale& scale, double& error) {
  static constexpr double c[7] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
  static constexpr double w[7][6] = {{},
                                     {1. / 5},
                                     {3. / 40, 9. / 40},
                                     {44. / 45, -56. / 15, 32. / 9},
                                     {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
                                     {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
                                     {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}};
  static constexpr double d[7] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
  isentrope_scale k[7]; // the slopes de/dy and du/dy
  isentrope_point p = a;
  double error_e = 0, error_u = 0;
  for (int i = 0; i < 7; ++i) {
    p = {a.y + c[i] * h, a.e, a.u};
    for (int j = 0; j < i; ++j) {
      p.e += h * w[i][j] * k[j].e;
      p.u += h * w[i][j] * k[j].u;
    }
    const auto at = eos.evaluate(std::exp(-p.y), p.e);
    k[i] = {-at.pressure * std::exp(p.y), std::sqrt(std::max(at.sound_speed_squared, 0.0))};
    error_e += h * d[i] * k[i].e;
    error_u += h * d[i] * k[i].u;
  }
  error = std::max(std::abs(error_e) / (std::abs(p.e) + scale.e), std::abs(error_u) / (std::abs(p.u) + scale.u));
  return p;
}

/// A walk along the isentrope from (rho, e), one accepted step at a time.
template <class Eos> class isentrope_walk {
public:
  isentrope_walk(const Eos& eos, double rho, double e, bool expanding)
      : eos_(eos), at_{-std::log(rho), e, 0}, start_(at_.y), limit_(start_ + (expanding ? 230.0 : -9.2)), h_(expanding ? 1e-3 : -1e-3) {
    require(rho > 0, "density at the start of an isentrope", rho, "> 0", "kg/m3");
    const double c2 = squared_speed_at(eos, at_);
    scale_ = {1e-4 * std::abs(c2), 1e-4 * std::sqrt(std::abs(c2))};
    if (!(c2 > 0)) end_ = isentrope_end::unstable;
  }

  const isentrope_point& at() const { return at_; }
  isentrope_end end() const { return end_; }

  /// The point a step of any length ahead, unchecked.
  isentrope_point ahead(double length) const {
    double error = 0;
    return isentrope_step(eos_, at_, length, scale_, error);
  }

  /// One step, at most to y = `to`; false (and end() says why) where there is none any more. At an instability at() becomes the last
  /// stable point.
  bool advance(double to) {
    if (end_ != isentrope_end::reached) return false;
    const double sign = h_ < 0 ? -1 : 1, longest = std::abs(at_.y - start_) < 7 ? 0.02 : 0.2;
    if (sign * (limit_ - at_.y) <= 0) {
      end_ = isentrope_end::density_limit;
      return false;
    }
    for (h_ = sign * std::min(std::abs(h_), longest);;) {
      const double wanted = h_, h = sign * std::min(std::abs(wanted), std::abs(to - at_.y));
      double error = 0;
      const isentrope_point b = isentrope_step(eos_, at_, h, scale_, error);
      if (!(error <= tolerance) && std::abs(h) > shortest) {
        h_ = h * (error > 0 ? std::clamp(0.9 * std::pow(tolerance / error, 0.2), 0.1, 0.5) : 0.1);
        continue;
      }
      if (!(squared_speed_at(eos_, b) > 0)) return stop_before_instability(h);
      at_ = b;
      if (h != wanted) at_.y = to;
      else h_ = h * std::clamp(0.9 * std::pow(tolerance / std::max(error, 1e-20), 0.2), 0.5, 3.0);
      return true;
    }
  }

private:
  static constexpr double tolerance = 1e-10, shortest = 1e-9;

  bool stop_before_instability(double h) {
    double stable = 0, unstable = h;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (stable + unstable);
      (squared_speed_at(eos_, ahead(middle)) > 0 ? stable : unstable) = middle;
    }
    at_ = ahead(stable);
    end_ = isentrope_end::unstable;
    return false;
  }

  const Eos& eos_;
  isentrope_point at_;
  isentrope_scale scale_{};
  double start_, limit_, h_; // in y
  isentrope_end end_ = isentrope_end::reached;
};

struct isentrope_arrival {
  isentrope_point point;
  isentrope_end end;
  int steps;
};

/// Follows the isentrope from (rho, e), expanding or compressing, until until(point) changes sign.
template <class Eos, class Until>
isentrope_arrival follow_isentrope(const Eos& eos, double rho, double e, bool expanding, const Until& until) {
  isentrope_walk walk(eos, rho, e, expanding);
  const bool sign = until(walk.at()) > 0;
  for (int steps = 0;; ++steps) {
    const isentrope_walk before = walk;
    const bool moved = walk.advance(expanding ? 1e300 : -1e300);
    if ((until(walk.at()) > 0) != sign) {
      const auto at = [&](double length) { return until(before.ahead(length)); };
      return {before.ahead(eos::bracketed_root(at, 0, walk.at().y - before.at().y)), isentrope_end::reached, steps};
    }
    if (!moved) return {walk.at(), walk.end(), steps};
  }
}

template <class Eos> isentrope_state isentrope_state_at(const Eos& eos, const isentrope_point& a, double speed) {
  const double rho = std::exp(-a.y);
  const auto at = eos.evaluate(rho, a.e);
  isentrope_state s{rho, a.e, at.pressure, std::sqrt(std::max(at.sound_speed_squared, 0.0)), std::nan(""), speed + a.u, 0, std::nan("")};
  if constexpr (ThermalEquationOfState<Eos>) {
    s.temperature = at.temperature;
    s.melt_fraction = at.melt_fraction;
    s.region = at.region;
  }
  return s;
}

inline std::string isentrope_sentence(isentrope_end end, double rho) {
  if (end == isentrope_end::reached) return {};
  const std::string at = "the isentrope ends at density " + to_text(rho) + " kg/m3: ";
  return at + (end == isentrope_end::unstable ? "beyond it c^2 <= 0, the equation of state is not stable there (spinodal, or a jump of the model)"
                                              : "the limit of density that is followed");
}

/// n densities from a to b, both included.
inline std::vector<double> even_densities(double a, double b, int n) {
  require(n >= 2, "number of points on an isentrope", n, ">= 2");
  std::vector<double> densities(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) densities[static_cast<std::size_t>(i)] = i == n - 1 ? b : a + (b - a) * i / (n - 1);
  return densities;
}
} // namespace detail

/// The isentrope through (rho, e) at the given densities, which lie in order on one side of rho (rho itself may be the first).
/// The particle speed starts from `speed` (m/s).
template <class Eos>
isentrope_curve isentrope_at(const Eos& eos, double rho, double e, const std::vector<double>& densities, double speed = 0) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::isentrope_at needs an EquationOfState.");
  require(!densities.empty(), "number of densities on an isentrope", 0, ">= 1");
  const bool expanding = densities.back() <= rho;
  isentrope_curve curve{{}, isentrope_end::reached, {}};
  detail::isentrope_walk walk(eos, rho, e, expanding);
  double last = rho;
  for (const double wanted : densities) {
    require(wanted > 0 && (expanding ? wanted <= last : wanted >= last), "density on an isentrope", wanted,
            "> 0, and further from the start than the one before", "kg/m3");
    last = wanted;
    const double y = -std::log(wanted);
    while (walk.at().y != y && walk.advance(y)) {}
    curve.states.push_back(detail::isentrope_state_at(eos, walk.at(), speed));
    if (walk.at().y == y) curve.states.back().density = wanted; // to the last digit: exp(log) is not
    curve.end = walk.end();
    if (curve.end == isentrope_end::reached) continue;
    curve.message = detail::isentrope_sentence(curve.end, curve.states.back().density);
    break;
  }
  return curve;
}

/// n states (both ends included), evenly spaced in density from rho to rho_end.
template <class Eos> isentrope_curve isentrope(const Eos& eos, double rho, double e, double rho_end, int n) {
  require(rho_end > 0, "density at the end of an isentrope", rho_end, "> 0", "kg/m3");
  return isentrope_at(eos, rho, e, detail::even_densities(rho, rho_end, n));
}

/// The release of a shock state to pressure p_end (Pa): n states evenly spaced in density, the particle speed from up on. Where the
/// pressure never falls to p_end (a gas into vacuum) or c^2 <= 0 comes first, the curve ends there and says so.
template <class Eos> isentrope_curve release(const Eos& eos, const shock_state& from, int n, double p_end = 0) {
  static_assert(EquationOfState<Eos>, "bolide: analysis::release needs an EquationOfState.");
  require(from.pressure > p_end, "pressure at the start of a release", from.pressure, "above the end pressure", "Pa");
  const auto above = [&](const detail::isentrope_point& a) { return detail::pressure_at(eos, a) - p_end; };
  const auto arrival = detail::follow_isentrope(eos, from.density, from.energy, true, above);
  const double rho = std::exp(-arrival.point.y);
  auto curve = isentrope_at(eos, from.density, from.energy, detail::even_densities(from.density, rho, n), from.particle_speed);
  curve.states.back() = detail::isentrope_state_at(eos, arrival.point, from.particle_speed);
  curve.end = arrival.end;
  curve.message = detail::isentrope_sentence(arrival.end, rho);
  return curve;
}

} // namespace bolide::analysis
