// SPDX-License-Identifier: MIT
// Where solid and liquid of eos::reference exist side by side: equal T, p and Gibbs energy, from 0 K (where the tension of some
// -10 GPa holds them together) to 3e5 K (where the solid is compressed a hundredfold). Built once, in double.
//
// With G_m(T) and p_m(T) the mixture is closed:  F = G_m - p_m V,  S = -G_m' + p_m' V,  e = G_m - T G_m' + V (T p_m' - p_m),
//   C = -T (G_m'' - p_m'' V),  c^2 = T V^2 p_m'^2/C,  melt fraction (V - V_s)/(V_l - V_s).
// p_m' = dS/dV (Clapeyron), G_m' = -S_s + V_s p_m' and the second derivatives are exact at the nodes; between them both are quintic
// polynomials of z = ln(1 + T/100 K), so that the mixture is one free energy to round-off and meets the phases to 1e-10.
// The edges T_s(V), T_l(V) and their energies are cubic polynomials of ln(1e-4 + d), d = ln x(0 K) - ln x (T squared: it is that which is
// smooth at 0 K), good to 1e-8.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/eos/polynomial_table.hpp"
#include "bolide/eos/reference/free_energy.hpp"

#include <cmath>
#include <vector>

namespace bolide::eos::detail {

/// One phase at (L, T), set-up work.
struct phase_state {
  double log_x, volume, temperature, energy, entropy, gibbs, pressure, heat, cross, stiffness; // stiffness: F_LL - F_L = V K_T
};

/// Solid and liquid in equilibrium at T, with the slopes by T along the line.
struct coexistence_point {
  double temperature;
  phase_state solid, liquid;
  double pressure_slope, pressure_curvature, gibbs_slope, gibbs_curvature, solid_slope, liquid_slope; // the last two: dL/dT
};

inline phase_state state_of(const reference_phases& phases, bool is_liquid, double log_x, double temperature) {
  const auto v = phases.at(std::exp(log_x));
  const auto cold = phases.solid_cold(v), own = is_liquid ? phases.liquid_cold(v, cold) : cold;
  const auto lattice = is_liquid ? phases.liquid_lattice(v) : phases.solid_lattice(v);
  const auto f = phases.evaluate(v, own, lattice, temperature);
  const double entropy = phases.entropy(v, lattice, temperature), volume = v.x / phases.parameters().rho0;
  return {log_x,   volume, temperature, f.energy, entropy, f.energy - temperature * entropy - f.slope, -f.slope / volume, f.heat,
          f.cross, f.curvature - f.slope};
}

/// Newton's method in both volumes from a guess near by. Throws bad_parameter where the parameters allow no equilibrium.
inline coexistence_point equilibrium(const reference_phases& phases, double temperature, double log_x_solid, double log_x_liquid) {
  coexistence_point c{};
  c.temperature = temperature;
  double change = 1;
  for (int i = 0; i < 100; ++i) {
    c.solid = state_of(phases, false, log_x_solid, temperature);
    c.liquid = state_of(phases, true, log_x_liquid, temperature);
    if (change < 1e-12) break;
    const double dp = c.solid.pressure - c.liquid.pressure, dg = c.solid.gibbs - c.liquid.gibbs;
    const double a = (dg / c.liquid.volume - dp) / (1 / c.liquid.volume - 1 / c.solid.volume);
    const double ds = a / c.solid.stiffness, dl = (a - dg) / c.liquid.stiffness;
    change = std::fmax(std::abs(ds), std::abs(dl));
    const double part = change > 0.02 ? 0.02 / change : 1;
    log_x_solid += part * ds;
    log_x_liquid += part * dl;
  }
  require(change < 1e-9 && c.solid.stiffness > 0 && c.liquid.stiffness > 0 && log_x_liquid > log_x_solid, "reference: melting equilibrium at",
          temperature, "found from 0 to 3e5 K: these parameters have none there", "K");
  const double dv = c.liquid.volume - c.solid.volume;
  c.pressure_slope = (c.liquid.entropy - c.solid.entropy) / dv;
  const auto along = [&](const phase_state& s) { return -(c.pressure_slope * s.volume + s.cross) / s.stiffness; };
  c.solid_slope = along(c.solid);
  c.liquid_slope = along(c.liquid);
  const double solid_entropy = c.solid.heat / temperature - c.solid.cross * c.solid_slope;
  const double liquid_entropy = c.liquid.heat / temperature - c.liquid.cross * c.liquid_slope;
  const double solid_volume = c.solid.volume * c.solid_slope, liquid_volume = c.liquid.volume * c.liquid_slope;
  c.pressure_curvature = (liquid_entropy - solid_entropy - c.pressure_slope * (liquid_volume - solid_volume)) / dv;
  c.gibbs_slope = -c.solid.entropy + c.solid.volume * c.pressure_slope;
  c.gibbs_curvature = -solid_entropy + solid_volume * c.pressure_slope + c.solid.volume * c.pressure_curvature;
  return c;
}

/// Coefficients in t = (z - z0)/h of the quintic with these values, first and second derivatives (by z) at both ends.
inline std::array<double, 6> quintic(double h, const std::array<double, 3>& left, const std::array<double, 3>& right) {
  const double f = left[0], g = h * left[1], k = 0.5 * h * h * left[2];
  const double d = right[0] - f - g - k, d1 = h * right[1] - g - 2 * k, d2 = h * h * right[2] - 2 * k;
  return {f, g, k, 10 * d - 4 * d1 + 0.5 * d2, -15 * d + 7 * d1 - d2, 6 * d - 3 * d1 + 0.5 * d2};
}
/// The same for the cubic with values and first derivatives.
inline std::array<double, 4> cubic(double h, double f0, double d0, double f1, double d1) {
  return {f0, h * d0, 3 * (f1 - f0) - h * (2 * d0 + d1), 2 * (f0 - f1) + h * (d0 + d1)};
}

/// A function of T on the line, with its first two derivatives.
template <class V> struct line_value {
  V value, slope, curvature;
};

class coexistence {
public:
  static constexpr double scale = 100, coldest = 0.01, hottest = 3e5; // K
  static constexpr std::size_t rows = 1024, edge_rows = 1024;

  explicit coexistence(const reference_phases& phases) : coexistence(phases, trace(phases)) {}

  double solid_end() const { return solid_end_; }   // ln x of the solid at 0 K: no solid beyond
  double liquid_end() const { return liquid_end_; } // ln x of the liquid at 0 K: liquid at every T from here on

  /// p_m and G_m at T (K).
  template <class V> BOLIDE_INLINE line_value<V> pressure(V temperature) const { return read(pressure_, temperature); }
  template <class V> BOLIDE_INLINE line_value<V> gibbs(V temperature) const { return read(gibbs_, temperature); }
  /// ln x of either phase at T, for the melt fraction.
  template <class V> BOLIDE_INLINE V solid_volume(V temperature) const { return read(solid_, place_of(temperature)); }
  template <class V> BOLIDE_INLINE V liquid_volume(V temperature) const { return read(liquid_, place_of(temperature)); }

  /// T_s^2, T_l^2 (K2) and the energies (J/kg) there, of ln x. Meaningful below solid_end and liquid_end.
  template <class V> BOLIDE_INLINE V solidus_square(V log_x) const { return read_edge(solidus_, solid_end_, log_x); }
  template <class V> BOLIDE_INLINE V liquidus_square(V log_x) const { return read_edge(liquidus_, liquid_end_, log_x); }
  template <class V> BOLIDE_INLINE V solidus_energy(V log_x) const { return read_edge(solidus_energy_, solid_end_, log_x); }
  template <class V> BOLIDE_INLINE V liquidus_energy(V log_x) const { return read_edge(liquidus_energy_, liquid_end_, log_x); }

private:
  double solid_end_, liquid_end_;
  polynomial_table<6> pressure_, gibbs_;
  polynomial_table<4> solid_, liquid_, solidus_, liquidus_, solidus_energy_, liquidus_energy_;

  static double lowest() { return std::log1p(coldest / scale); }
  static double step() { return (std::log1p(hottest / scale) - lowest()) / double(rows); }

  /// The line, node by node from the melting point at p = 0 both ways.
  static std::vector<coexistence_point> trace(const reference_phases& phases) {
    const auto temperature = [](std::size_t i) { return scale * std::expm1(lowest() + step() * double(i)); };
    std::vector<coexistence_point> line(rows + 1);
    std::size_t start = 0;
    while (start < rows && temperature(start) < 1000) ++start;
    line[start] = equilibrium(phases, temperature(start), std::log(1.05), std::log(1.13));
    for (std::size_t i = start; i < rows; ++i) line[i + 1] = equilibrium(phases, temperature(i + 1), line[i].solid.log_x, line[i].liquid.log_x);
    for (std::size_t i = start; i > 0; --i) line[i - 1] = equilibrium(phases, temperature(i - 1), line[i].solid.log_x, line[i].liquid.log_x);
    return line;
  }

  coexistence(const reference_phases& phases, const std::vector<coexistence_point>& line)
      : solid_end_(line.front().solid.log_x), liquid_end_(line.front().liquid.log_x), pressure_(lowest(), step(), rows),
        gibbs_(lowest(), step(), rows), solid_(lowest(), step(), rows), liquid_(lowest(), step(), rows),
        solidus_(edge_table(line.back().solid.log_x, solid_end_)), liquidus_(edge_table(line.back().liquid.log_x, liquid_end_)),
        solidus_energy_(solidus_), liquidus_energy_(liquidus_) {
    const double h = step();
    for (std::size_t i = 0; i < rows; ++i) {
      const auto &a = line[i], &b = line[i + 1];
      const double ja = a.temperature + scale, jb = b.temperature + scale; // dT/dz
      const auto node = [](double f, double slope, double curvature, double j) {
        return std::array<double, 3>{f, slope * j, curvature * j * j + slope * j};
      };
      pressure_.set(i, quintic(h, node(a.solid.pressure, a.pressure_slope, a.pressure_curvature, ja),
                               node(b.solid.pressure, b.pressure_slope, b.pressure_curvature, jb)));
      gibbs_.set(i, quintic(h, node(a.solid.gibbs, a.gibbs_slope, a.gibbs_curvature, ja), node(b.solid.gibbs, b.gibbs_slope, b.gibbs_curvature, jb)));
      solid_.set(i, cubic(h, a.solid.log_x, a.solid_slope * ja, b.solid.log_x, b.solid_slope * jb));
      liquid_.set(i, cubic(h, a.liquid.log_x, a.liquid_slope * ja, b.liquid.log_x, b.liquid_slope * jb));
    }
    fill_edges(phases, line, false, solidus_, solidus_energy_);
    fill_edges(phases, line, true, liquidus_, liquidus_energy_);
  }

  static constexpr double near_end = 1e-4; // in ln x: how fine the edges are at 0 K
  static polynomial_table<4> edge_table(double low, double high) {
    return {std::log(near_end), std::log1p((high - low) / near_end) / double(edge_rows), edge_rows};
  }
  template <class V> static BOLIDE_INLINE V read_edge(const polynomial_table<4>& table, double end, V log_x) {
    using T = scalar_t<V>;
    return read(table, log(T(near_end) + max(T(end) - log_x, V(T(0)))));
  }

  /// Walks up the line in T and along the edge together; each node is met by Newton's method in T squared.
  static void fill_edges(const reference_phases& phases, const std::vector<coexistence_point>& line, bool is_liquid, polynomial_table<4>& square,
                         polynomial_table<4>& energy) {
    const auto log_x = [&](const coexistence_point& c) { return is_liquid ? c.liquid.log_x : c.solid.log_x; };
    const auto slope = [&](const coexistence_point& c) { return is_liquid ? c.liquid_slope : c.solid_slope; };
    std::size_t i = 0;
    std::array<double, 4> before{};
    for (std::size_t k = 0; k <= edge_rows; ++k) {
      const double distance = std::exp(square.left(k)), wanted = log_x(line.front()) + near_end - distance;
      while (i + 2 < line.size() && log_x(line[i + 1]) >= wanted) ++i;
      coexistence_point c = line[i];
      for (int n = 0; n < 12 && std::abs(wanted - log_x(c)) > 1e-14; ++n) {
        const double w = c.temperature * c.temperature, next = w + (wanted - log_x(c)) * 2 * c.temperature / slope(c);
        const double low = line[i].temperature, high = line[i + 1].temperature;
        c = equilibrium(phases, std::sqrt(std::fmin(std::fmax(next, low * low), high * high)), c.solid.log_x, c.liquid.log_x);
      }
      const phase_state& s = is_liquid ? c.liquid : c.solid;
      const double volume_slope = -s.pressure * s.volume - s.temperature * s.cross; // de/dL at constant T
      const std::array<double, 4> here{c.temperature * c.temperature, -2 * c.temperature / slope(c) * distance, s.energy,
                                       -(volume_slope + s.heat / slope(c)) * distance};
      if (k > 0) {
        square.set(k - 1, cubic(square.step(), before[0], before[1], here[0], here[1]));
        energy.set(k - 1, cubic(square.step(), before[2], before[3], here[2], here[3]));
      }
      before = here;
    }
  }

  template <class V> static BOLIDE_INLINE V place_of(V temperature) {
    using T = scalar_t<V>;
    return log(V(T(1)) + temperature * T(1 / scale));
  }
  template <class V> static BOLIDE_INLINE V read(const polynomial_table<4>& table, V s) {
    const auto p = table.find(s);
    return p.c[0] + p.t * (p.c[1] + p.t * (p.c[2] + p.t * p.c[3]));
  }
  template <class V> static BOLIDE_INLINE line_value<V> read(const polynomial_table<6>& table, V temperature) {
    using T = scalar_t<V>;
    const auto p = table.find(place_of(temperature));
    const V t = p.t, inverse = V(T(1)) / (temperature + T(scale)), by_step = inverse * T(table.inverse_step());
    const V value = p.c[0] + t * (p.c[1] + t * (p.c[2] + t * (p.c[3] + t * (p.c[4] + t * p.c[5]))));
    const V first = p.c[1] + t * (T(2) * p.c[2] + t * (T(3) * p.c[3] + t * (T(4) * p.c[4] + t * (T(5) * p.c[5]))));
    const V second = T(2) * p.c[2] + t * (T(6) * p.c[3] + t * (T(12) * p.c[4] + t * (T(20) * p.c[5])));
    return {value, first * by_step, (second * by_step - first * inverse) * by_step};
  }
};

} // namespace bolide::eos::detail
