// SPDX-License-Identifier: MIT
// What a new surface is checked for in one line: c^2 and dp/de are the derivatives of p, and every lane type gives the scalar's answer.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "unit/eos/lanes.hpp"

#include <string>
#include <vector>

namespace bolide::test {

template <class F> double five_point_slope(const F& f, double h) { return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h); }

/// At every (eta, e); the caller keeps off kinks by more than `relative_step` in rho.
template <class Eos>
void derivatives_are_right(const Eos& eos, const std::vector<double>& etas, const std::vector<double>& energies, double relative_step = 1e-4) {
  for (const double eta : etas)
    for (const double e : energies) {
      const double rho = eta * eos.reference_density(), dr = relative_step * rho, de = 1e-4 * std::abs(e) + 50;
      const double p_rho = five_point_slope([&](double d) { return eos.evaluate(rho + d, e).pressure; }, dr);
      const double p_e = five_point_slope([&](double d) { return eos.evaluate(rho, e + d).pressure; }, de);
      const auto r = eos.evaluate(rho, e);
      const std::string at = " at eta = " + std::to_string(eta) + ", e = " + std::to_string(e);
      const double c2 = p_rho + r.pressure * p_e / (rho * rho);
      expect_close(r.sound_speed_squared, c2, 1e-8, std::abs(p_rho) + std::abs(c2) + 1e4, "c^2" + at);
      expect_close(r.pressure_energy, p_e, 1e-8, rho, "dp/de" + at);
    }
}

template <class V, class Eos>
void one_lane_type_agrees(const Eos& eos, const std::vector<double>& etas, const std::vector<double>& energies, double scale) {
  using T = scalar_t<V>;
  for (const double eta : etas)
    for (const double e0 : energies) {
      const V rho = ramp<V>(eta, 1e-3) * T(eos.reference_density()), e = ramp<V>(e0, 1e3);
      const auto many = eos.evaluate(rho, e);
      for (int i = 0; i < lane_width<V>; ++i) {
        const auto one = eos.evaluate(static_cast<double>(lane(rho, i)), static_cast<double>(lane(e, i)));
        const std::string at = " in lane " + std::to_string(i) + " at eta = " + std::to_string(eta) + ", e = " + std::to_string(e0);
        expect_close(lane(many.pressure, i), one.pressure, epsilon<V>(200), scale * eos.reference_density(), "p" + at);
        expect_close(lane(many.sound_speed_squared, i), one.sound_speed_squared, epsilon<V>(1000), scale, "c^2" + at);
      }
    }
}
/// scale: a c^2 of the model (m2/s2), below which differences do not count.
template <class Eos> void lanes_agree(const Eos& eos, const std::vector<double>& etas, const std::vector<double>& energies, double scale) {
  one_lane_type_agrees<float>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<double, 2>>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<double, 4>>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<double, 8>>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<float, 4>>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<float, 8>>(eos, etas, energies, scale);
  one_lane_type_agrees<pack<float, 16>>(eos, etas, energies, scale);
}

/// p and c^2 are finite, however extreme the state.
template <class Eos> void finite_everywhere(const Eos& eos) {
  for (const double eta : {1e-6, 1e-3, 0.05, 0.3, 0.74, 0.9, 1.0, 1.5, 3.0, 3.96, 5.0, 50.0})
    for (const double e : {-1e8, -1e6, 0., 1e4, 1e6, 1e8, 1e10}) {
      const auto r = eos.evaluate(eta * eos.reference_density(), e);
      const auto f = eos.evaluate(static_cast<float>(eta * eos.reference_density()), static_cast<float>(e));
      EXPECT_TRUE(std::isfinite(r.pressure) && std::isfinite(r.sound_speed_squared)) << eta << " " << e;
      EXPECT_TRUE(std::isfinite(f.pressure) && std::isfinite(f.sound_speed_squared)) << "float " << eta << " " << e;
    }
}

} // namespace bolide::test
