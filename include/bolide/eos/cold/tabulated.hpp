// SPDX-License-Identifier: MIT
// A table of any cold curve for the time loop: few operations and one cache line per lane, its error measured when it is built.
//
// Nodes are uniform in the density ratio eta = 1/x (no logarithm to find the place). Between nodes
//   g = p_c/eta^2 is the cubic Hermite polynomial of the exact values and slopes,  p_c = eta^2 g,
//   e_c = e_c(node) + (1/rho0) integral of g d eta                                 (because de_c/d eta = p_c/(rho0 eta^2)),
// so inside an interval p_c = -de_c/dV and slope = dp_c/dx hold exactly. p_c and its slope are continuous; e_c is exact at each
// node and steps there by the quadrature error (part of the measured error).
// Range: eta from 0 (x -> infinity: e_c -> cohesive energy, p_c -> 0) to eta_max; above it g goes on linearly in eta, so p_c grows
// like eta^3 with p_c, e_c and slope continuous. A table of a curve that jumps (cai_ye with the sharp cut-off) cannot be better than
// the jumps, about 1e-3 of (|p|+1 GPa), however fine.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/polynomial_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bolide::cold {

/// A bound on the deviation of a table from its exact curve, evaluated in double: the deviation is measured at fifteen places of every
/// interval, the ends among them. Between two of them, a and b, it is taken to rise above the larger one by at most the largest
/// difference there and next to them, as where the curve jumps or kinks; the largest of these is raised by a tenth, and by round_off.
struct table_error {
  double pressure = 0; // |p - exact| / (|p| + 1 GPa)
  double energy = 0;   // |e - exact| / (|e| + 1 GPa/rho0)
  double slope = 0;    // |dp/dx - exact| / (|dp/dx| + 1 GPa)
  double at_x = 0;     // where the pressure is worst (the middle of its interval)

  static constexpr double margin = 1.1, round_off = 1e-13;
};

class tabulated {
public:
  /// eta_max: largest tabulated density ratio; per_unit: nodes per unit of eta.
  template <class Exact> explicit tabulated(const Exact& exact, double eta_max = 5, int per_unit = 200)
      : density_(exact.reference_density()), table_(make(eta_max, per_unit)), area_to_energy_(table_.step() / density_) {
    static_assert(ColdCurve<Exact>, "bolide: cold::tabulated needs a ColdCurve: "
                                    "evaluate(x) -> {energy, pressure, slope} and reference_density().");
    fill(exact);
    measure(exact);
  }

  template <class V> BOLIDE_INLINE cold_point<V> evaluate(V x) const { return at_density_ratio(V(1) / x); }

  /// The same from eta = 1/x = rho/rho0, which saves a division.
  template <class V> BOLIDE_INLINE cold_point<V> at_density_ratio(V eta) const {
    using T = scalar_t<V>;
    const auto at = table_.find(eta);
    const V t = at.t, *c = at.c;
    const V g = c[1] + t * (c[2] + t * (c[3] + t * c[4]));
    const V dg = (c[2] + t * (T(2) * c[3] + t * (T(3) * c[4]))) * T(table_.inverse_step());
    const V area = t * (c[1] + t * (T(0.5) * c[2] + t * (T(1) / T(3) * c[3] + t * (T(0.25) * c[4]))));
    const V eta2 = eta * eta;
    return {c[0] + T(area_to_energy_) * area, eta2 * g, -(eta2 * eta) * (T(2) * g + eta * dg)};
  }

  double reference_density() const { return density_; }
  /// For x <= 5 (eta from 0.2 to eta_max), measured when the table was built.
  const table_error& error() const { return error_; }
  /// The same for x > 5, where p_c has become small.
  const table_error& error_expanded() const { return error_expanded_; }
  /// The larger of the pressure's and the energy's error, anywhere.
  double max_relative_error() const {
    return std::max({error_.pressure, error_.energy, error_expanded_.pressure, error_expanded_.energy});
  }
  double eta_max() const { return table_.left(table_.rows() - 1); }
  std::size_t intervals() const { return table_.rows() - 1; }

private:
  static eos::polynomial_table<5> make(double eta_max, int per_unit) {
    require(eta_max >= 1 && eta_max <= 1000, "cold::tabulated eta_max", eta_max, "between 1 and 1000");
    require(per_unit >= 10 && per_unit <= 100000, "cold::tabulated per_unit", per_unit, "between 10 and 100000");
    return {0.0, 1.0 / per_unit, static_cast<std::size_t>(std::ceil(eta_max * per_unit)) + 1};
  }

  struct node {
    double e, g, dg; // J/kg, Pa, Pa
  };
  /// eta = 0 is taken at x = 1e6. Where g has no finite limit there (Birch-Murnaghan's p_c ~ eta^(5/3)) it goes on in a straight line
  /// from the next node.
  template <class Exact> static node exact_node(const Exact& exact, double eta) {
    eta = std::max(eta, 1e-6);
    const cold_point<double> c = exact.evaluate(1 / eta);
    return {c.energy, c.pressure / (eta * eta), -(c.slope / eta + 2 * c.pressure) / (eta * eta * eta)};
  }

  template <class Exact> void fill(const Exact& exact) {
    const double h = table_.step();
    node a = exact_node(exact, 0);
    const node first = exact_node(exact, h);
    if (std::abs(h * a.dg) > std::abs(first.g) + std::abs(h * first.dg)) a.g = first.g - h * first.dg, a.dg = first.dg;
    for (std::size_t i = 0; i + 1 < table_.rows(); ++i) {
      const node b = exact_node(exact, table_.left(i + 1));
      const double rise = b.g - a.g;
      table_.set(i, {a.e, a.g, h * a.dg, 3 * rise - h * (2 * a.dg + b.dg), h * (a.dg + b.dg) - 2 * rise});
      a = b;
    }
    table_.set(table_.rows() - 1, {a.e, a.g, h * a.dg, 0, 0});
  }

  template <class Exact> void measure(const Exact& exact) {
    constexpr std::array places{1e-9, 0.02, 0.08, 0.16, 0.25, 0.33, 0.42, 0.5, 0.58, 0.67, 0.75, 0.84, 0.92, 0.98, 1 - 1e-9};
    for (std::size_t i = 0; i < intervals(); ++i) {
      std::array<deviation, places.size()> found;
      for (std::size_t k = 0; k < places.size(); ++k) found[k] = deviation_at(exact, i, places[k]);
      table_error& worst = found.back().x < 5 ? error_ : error_expanded_;
      const double pressure = bound(found, &deviation::pressure);
      if (pressure > worst.pressure) worst.pressure = pressure, worst.at_x = found[places.size() / 2].x;
      worst.energy = std::max(worst.energy, bound(found, &deviation::energy));
      worst.slope = std::max(worst.slope, bound(found, &deviation::slope));
    }
  }
  struct deviation {
    double x, pressure, energy, slope; // signed, relative as in table_error
  };
  template <class Exact> deviation deviation_at(const Exact& exact, std::size_t interval, double t) const {
    const double GPa = 1e9, x = 1 / (table_.left(interval) + t * table_.step());
    const cold_point<double> a = evaluate(x), b = exact.evaluate(x);
    return {x, (a.pressure - b.pressure) / (std::abs(b.pressure) + GPa), (a.energy - b.energy) / (std::abs(b.energy) + GPa / density_),
            (a.slope - b.slope) / (std::abs(b.slope) + GPa)};
  }
  /// The largest deviation that is taken to occur in an interval (see table_error).
  template <std::size_t N> static double bound(const std::array<deviation, N>& found, double deviation::*what) {
    const auto step = [&](std::size_t k) { return k + 1 < N ? std::abs(found[k + 1].*what - found[k].*what) : 0.0; };
    double most = 0;
    for (std::size_t k = 0; k + 1 < N; ++k) {
      const double steepest = std::max({step(k > 0 ? k - 1 : 0), step(k), step(k + 1)});
      most = std::max(most, std::max(std::abs(found[k].*what), std::abs(found[k + 1].*what)) + steepest);
    }
    return table_error::margin * most + table_error::round_off;
  }

  double density_; // kg/m3, 1/V0
  eos::polynomial_table<5> table_;
  double area_to_energy_; // step/rho0
  table_error error_, error_expanded_;
};

static_assert(ColdCurve<tabulated> && ColdCurve<tabulated, pack<float, 4>>);

} // namespace bolide::cold
