// SPDX-License-Identifier: MIT
// The conformance suite of the role "cold curve": what any model must do, the library's or a user's, measured.
//
//   const auto report = bolide::conformance::check(my_cold_curve{});
//   std::cout << report;
//   return report.passed() ? 0 : 1;
//
// Over 0.2 <= x <= 1e6, x = V/V0, unless the options say otherwise:
//   finite           no answer is NaN or infinite
//   pressure         p_c = -de_c/dV against difference quotients of e_c
//   slope            dp_c/dx against difference quotients of p_c
//   zero_energy      e_c(1) = 0
//   pressure_jump    p_c and e_c are continuous: jumps are looked for in every interval of the grid
//   energy_jump
//   compression      p_c rises and e_c rises as x falls below 1, over the whole range
//   bulk_modulus     -dp_c/dx at x = 1 is above 0; c0^2, by which all energies are measured, follows from it
//   expanded_limit   p_c x -> 0 and e_c has arrived at the cohesive energy: free atoms
//   lane ...         every lane type gives the scalar's answer
// Whether p_c(1) is 0 is the model's; it is reported. A violation that is known is stated, as for an equation of state.
// Cost: some 50 thousand calls of evaluate().
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/conformance/difference.hpp"
#include "bolide/conformance/report.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace bolide::conformance {

struct cold_curve_options {
  std::string name = "cold curve";         // printed above the table
  double smallest = 0.2, largest = 1e6;    // x = V/V0
  int volumes = 400;                       // of the grid
  std::vector<stated_violation> stated = {};
};

namespace detail {

template <class Cold> class cold_curve_suite {
public:
  cold_curve_suite(const Cold& cold, const cold_curve_options& options) : cold_(cold), o_(options), V0_(1 / cold.reference_density()) {
    require(std::isfinite(V0_) && V0_ > 0, "conformance reference density", cold.reference_density(), "> 0", "kg/m3");
    require(o_.smallest > 0 && o_.smallest < 1, "conformance smallest volume ratio", o_.smallest, "between 0 and 1");
    require(o_.largest > 1, "conformance largest volume ratio", o_.largest, "above 1");
    require(o_.volumes >= 10, "conformance volumes of the grid", o_.volumes, "at least 10");
    report_.subject = o_.name;
    make_grid();
    c2_ = -V0_ * at(1).slope;
  }

  report run() {
    values();
    derivatives();
    jumps();
    limits();
    lanes<float>("lane float");
    lanes<pack<double, 2>>("lane pack<double, 2>");
    lanes<pack<double, 4>>("lane pack<double, 4>");
    lanes<pack<double, 8>>("lane pack<double, 8>");
    lanes<pack<float, 4>>("lane pack<float, 4>");
    lanes<pack<float, 8>>("lane pack<float, 8>");
    lanes<pack<float, 16>>("lane pack<float, 16>");
    require_known_checks(report_, o_.stated);
    return report_;
  }

private:
  /// Evenly in ln x: a quarter below 1, half to 5, a quarter beyond; 1 among them.
  void make_grid() {
    const auto spread = [&](double from, double to, int n) {
      for (int i = 0; i < n; ++i) x_.push_back(from * std::pow(to / from, (i + 0.5) / n));
    };
    const double far = std::min(5.0, o_.largest);
    x_.push_back(o_.smallest);
    spread(o_.smallest, 1, o_.volumes / 4);
    x_.push_back(1);
    spread(1, far, o_.volumes / 2);
    if (far < o_.largest) spread(far, o_.largest, o_.volumes / 4);
    x_.push_back(o_.largest);
  }

  cold_point<double> at(double x) const { return cold_.evaluate(x); }
  /// Pa, of p_c, and J/kg, of e_c and p_c V: what they are made of. Where p_c has vanished, 1e-12 of the bulk modulus is as good as 0.
  double pressure_scale(const cold_point<double>& c, double x) const {
    return std::abs(c.pressure) + x * std::abs(c.slope) + 1e-12 * std::abs(c2_) / V0_;
  }
  double energy_scale(const cold_point<double>& c, double x) const { return std::abs(c.energy) + x * V0_ * pressure_scale(c, x); }

  measure start(const char* check, double bound) const { return {check, bound, o_.stated}; }
  void close(const measure& m, std::string note = "") {
    report_.findings.push_back(m.close([](double x, double) { return "x " + short_text(x); }, std::move(note)));
  }

  void values() {
    measure bad = start("finite", 0), zero = start("zero_energy", 1e-12), stiff = start("bulk_modulus", 0);
    for (const double x : x_) {
      const auto c = at(x);
      bad.add(std::isfinite(c.energy) && std::isfinite(c.pressure) && std::isfinite(c.slope) ? 0 : 1, x);
    }
    close(bad);
    const auto one = at(1);
    zero.add(std::abs(one.energy) / std::abs(c2_), 1);
    close(zero);
    stiff.add(one.slope < 0 ? 0 : 1, 1);
    close(stiff, "at x = 1: " + short_text(-one.slope / 1e9) + " GPa, p " + short_text(one.pressure / 1e6) + " MPa");
  }

  void derivatives() {
    measure pressure = start("pressure", derivative_bound), slope = start("slope", derivative_bound);
    std::size_t beside_border = 0;
    for (const double x : x_) {
      const auto c = at(x);
      const double scale_e = energy_scale(c, x), scale_p = pressure_scale(c, x);
      const auto p = derivative_error([&](double h) { return at(x * (1 + h)).energy; }, -c.pressure * x * V0_, {1e-2, 1e-3, 1e-4, 1e-5},
                                      1e-3 * derivative_bound * scale_e);
      const auto s = derivative_error([&](double h) { return at(x * (1 + h)).pressure; }, c.slope * x, {1e-2, 1e-3, 1e-4, 1e-5},
                                      1e-3 * derivative_bound * scale_p);
      pressure.add(p.error / scale_e, x);
      slope.add(s.error / scale_p, x);
      beside_border += p.one_sided || s.one_sided ? 1 : 0;
    }
    close(pressure);
    close(slope, std::to_string(beside_border) + " of " + std::to_string(slope.points()) + " points lie beside a border: one-sided");
  }

  void jumps() {
    measure pressure = start("pressure_jump", jump_bound), energy = start("energy_jump", jump_bound);
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      const double a = x_[i], b = x_[i + 1];
      const double scale_p = std::max(pressure_scale(at(a), a), pressure_scale(at(b), b));
      const double scale_e = std::max(energy_scale(at(a), a), energy_scale(at(b), b));
      const jump p = find_jump([&](double x) { return at(x).pressure; }, a, b, jump_bound * scale_p);
      const jump e = find_jump([&](double x) { return at(x).energy; }, a, b, jump_bound * scale_e);
      pressure.add(p.size / scale_p, p.size > 0 ? p.at : a);
      energy.add(e.size / scale_e, e.size > 0 ? e.at : a);
    }
    close(pressure);
    close(energy);
  }

  void limits() {
    measure compression = start("compression", 1e-12), expanded = start("expanded_limit", 1e-3);
    for (std::size_t i = 0; i + 1 < x_.size() && x_[i] < 1; ++i) {
      const auto a = at(x_[i]), b = at(x_[i + 1]);
      const double energy_falls = b.pressure > 0 ? (b.energy - a.energy) / energy_scale(a, x_[i]) : 0;
      compression.add(std::max({(b.pressure - a.pressure) / pressure_scale(a, x_[i]), energy_falls, 0.0}), x_[i]);
    }
    close(compression);
    const double x = o_.largest;
    const auto end = at(x), before = at(x / 10);
    expanded.add(std::max(std::abs(end.pressure) * x * V0_, std::abs(end.energy - before.energy)) / std::abs(end.energy), x);
    close(expanded, "e_c " + short_text(end.energy / 1e6) + " MJ/kg");
  }

  template <class V> void lanes(const char* check) {
    measure m = start(check, sizeof(scalar_t<V>) == 8 ? double_lane_bound : float_lane_bound);
    if constexpr (ColdCurve<Cold, V>) {
      using T = scalar_t<V>;
      std::mt19937 random(1);
      std::uniform_real_distribution<double> far(std::log(o_.smallest), std::log(o_.largest)), near(std::log(0.5), std::log(2.0));
      for (int n = 0; n < 1024 / lane_width<V>; ++n) {
        T x[lane_width<V>];
        for (int i = 0; i < lane_width<V>; ++i) x[i] = static_cast<T>(std::exp((n + i) % 2 == 0 ? far(random) : near(random)));
        const auto many = cold_.evaluate(load<V>(x));
        for (int i = 0; i < lane_width<V>; ++i) {
          const cold_point<double> one{static_cast<double>(lane(many.energy, i)), static_cast<double>(lane(many.pressure, i)),
                                       static_cast<double>(lane(many.slope, i))};
          m.add(lane_error<T>(one, static_cast<double>(x[i])), static_cast<double>(x[i]));
        }
      }
    }
    close(m, ColdCurve<Cold, V> ? "" : "evaluate() does not take this type");
  }
  /// Against the scalar's answer there, or some round-offs beside (a curve that jumps).
  template <class T> double lane_error(const cold_point<double>& one, double x) const {
    const double eps = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    double least = std::numeric_limits<double>::infinity();
    for (const double beside : {0.0, -eps, eps}) {
      const double y = x * (1 + beside);
      const auto c = at(y);
      const double scale_p = pressure_scale(c, y), scale_e = energy_scale(c, y) + 0.01 * c2_;
      const double off = std::max({std::abs(one.energy - c.energy) / scale_e, std::abs(one.pressure - c.pressure) / scale_p,
                                   std::abs(one.slope - c.slope) * y / scale_p});
      if (std::isnan(off + one.energy + one.pressure + one.slope)) return std::nan("");
      least = std::min(least, off);
    }
    return least;
  }

  static constexpr double derivative_bound = 1e-6, jump_bound = 1e-6, double_lane_bound = 1e-12, float_lane_bound = 5e-4;

  const Cold& cold_;
  const cold_curve_options& o_;
  double V0_, c2_ = 0; // m3/kg; m2/s2, of the bulk modulus at x = 1
  std::vector<double> x_;
  report report_;
};

} // namespace detail

template <ColdCurve Cold> report check(const Cold& cold, const cold_curve_options& options = {}) {
  return detail::cold_curve_suite<Cold>(cold, options).run();
}

} // namespace bolide::conformance
