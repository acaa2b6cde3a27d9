// SPDX-License-Identifier: MIT
// Modifier: any equation of state as a fast table for the time loop, its error measured when it is built.
//
// Coordinates  u = ln(rho/rho0)  and, at a density, the place z of e between the energy borders b_0(rho) <= b_1(rho) <= ... of the model:
// b_0 is the cold curve (a model without one: energy_low), the next ones are what energy_borders() gives (solidus, liquidus, ...), the last
// lies energy_span above; in this uppermost patch the cells grow with e, in the lowest one from its lower end too. Density borders, and the
// densities at which a patch vanishes, are borders of cells. So no cell straddles a kink or a jump that the model states, the two sides of
// a jump are kept apart, and a border is met where the interpolated b_k(rho) lies, within 1e-7 of its energy: in this sliver the other
// side of a jump may answer.
//
// In a cell p and T are bicubic Hermite polynomials of node values and slopes (C1 inside a patch; exact in e where p is linear in e).
// dp/de and c^2 = dp/drho + p (dp/de)/rho^2 are the derivatives of this polynomial: they belong to its p exactly, are one order less
// accurate than p, and c^2 is continuous only. cold_energy is b_0.
// Phases, by what the model is found to do: one region per patch (grover: melt_fraction linear in e, T_m cubic in u); or solid and liquid
// told by T > T_m(V) (isentrope_temperature; better: tabulate the model inside it and wrap the table); else the region is that of the
// nearest node, melt_fraction and T_m are bilinear between the nodes of a patch (eos::reference).
// Outside the table's range, told by validity() and outside_validity(), the exact model answers, lane by lane in double: at the ends p and T
// step by the table's error. The polynomials must not go on there: near eta_low = 0.2 p at a constant e rises with expansion (cohesion
// fades), so vapour would do work without end (mixed at eta = 0.1 and 15.5 MJ/kg: 1.8 GPa instead of 0.4). Below the cold curve, which is
// no end of the range, p and T go on linearly in e.
//
// error() is twice the worst of 25 samples in every cell, in p, c^2, T and melt fraction each; random points have not exceeded it
// (tests/unit/eos/tabulated_test.cpp). base() is the exact model, kept for set-up work. With the default (p, c^2, T):
//   grover with mixed 3e-5, 7e-5, 8e-4     with helm 1.5e-6, 1e-4, 4e-5     tillotson 8e-6, 1e-3     mie_grueneisen 2e-6, 8e-5
// Where a quantum lattice freezes out (eos::reference, within some 10 kJ/kg of 0 K) T(e), and under tension p, bend within a cell and error()
// is large (1e-2 in p); above 200 K it is 2e-5 in p and 3e-4 in c^2.
// Cost: two log, four to six cache lines per lane, some 250 flops, 13 to 24 ns per lane in pack<double, 8> whatever the model costs: for
// models that cost more (an exact lattice sum: 800 ns). A lane outside costs a scalar call of the model on top (mixed: 50 ns). Memory with
// the default: 0.7 to 2.7 MB in double, half of it in float. Set-up: some 150 calls of the exact model per cell.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/math.hpp"
#include "bolide/eos/polynomial_table.hpp"
#include "bolide/eos/pressure_energy.hpp"
#include "bolide/eos/query.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bolide::eos {

struct tabulated_parameters {
  double eta_low = 0.2, eta_high = 4; // rho/rho0, cut to the model's box
  double energy_low = 0;              // J/kg, lower end for a model without a cold curve, cut to its box
  double energy_span = 1e8;           // J/kg, height of the uppermost patch
  int density_cells = 320;            // over all of ln(eta)
  int energy_cells = 32;              // of each patch between two energy borders
};

/// The largest deviations of a table from its exact model.
struct surface_error {
  double pressure = 0;            // |p - exact| / (|p| + 0.01 K0), K0 = rho0 c^2(rho0, e = 0), the bulk modulus
  double sound_speed_squared = 0; // |c^2 - exact| / (|c^2| + 0.01 K0/rho0)
  double temperature = 0;         // |T - exact| / (T + 100 K); 0 for a model without a temperature
  double melt_fraction = 0;       // |nu - exact|
};

template <class Eos> class tabulated {
  static_assert(EquationOfState<Eos>, "bolide: eos::tabulated needs an EquationOfState: evaluate(rho, e) -> {pressure, "
                                      "sound_speed_squared} and reference_density().");
  static constexpr bool thermal = ThermalEquationOfState<Eos>;
  static constexpr int most_borders = 4, most_segments = 4;
  static constexpr double least_width = 0.01; // J/kg

public:
  explicit tabulated(Eos eos, const tabulated_parameters& p = {}) : eos_(std::move(eos)), q_(p) {
    require(q_.eta_low > 0 && q_.eta_low < 1, "eos::tabulated eta_low", q_.eta_low, "between 0 and 1");
    require(q_.eta_high > 1 && q_.eta_high <= 1000, "eos::tabulated eta_high", q_.eta_high, "above 1 and at most 1000");
    require(std::isfinite(q_.energy_low), "eos::tabulated energy_low", q_.energy_low, "finite", "J/kg");
    require(q_.energy_span > 0 && std::isfinite(q_.energy_span), "eos::tabulated energy_span", q_.energy_span, "> 0 and finite", "J/kg");
    require(q_.density_cells >= 8 && q_.density_cells <= 100000, "eos::tabulated density_cells", q_.density_cells, "between 8 and 100000");
    require(q_.energy_cells >= 4 && q_.energy_cells <= 10000, "eos::tabulated energy_cells", q_.energy_cells, "between 4 and 10000");
    lay_out();
    fill();
    measure();
  }

  template <class V> BOLIDE_INLINE auto evaluate(V rho, V e) const {
    auto r = read_table(rho, e);
    if (any(outside_validity(rho, e))) r = with_model(r, rho, e);
    return r;
  }

  double reference_density() const { return eos_.reference_density(); }
  const Eos& base() const { return eos_; }
  const tabulated_parameters& values() const { return q_; }
  /// Twice the worst of what was sampled in the table's range.
  const surface_error& error() const { return error_; }
  std::size_t bytes() const { return (nodes_double_.size() + borders_double_.size()) * sizeof(record<double>); } // of the double table
  /// The table's range, where error() holds.
  validity_box validity() const {
    validity_box box = validity_of(eos_);
    box.density_low = density_low_, box.density_high = density_high_;
    box.energy_high = std::min(box.energy_high, energy_high_);
    if constexpr (!thermal) box.energy_low = std::max(box.energy_low, energy_low_);
    return box;
  }
  template <class V> BOLIDE_INLINE mask_t<V> outside_validity(V rho, V e) const {
    using T = scalar_t<V>;
    const auto in = rho >= V(T(density_low_)) && rho <= V(T(density_high_)) && e <= V(T(energy_high_)); // NaN is outside
    if constexpr (thermal) return !in;
    else return !(in && e >= V(T(energy_low_)));
  }
  const char* branch_name(double rho, double e) const { return region_name(eos_, rho, e); }
  std::vector<double> energy_borders(double rho) const { return energy_borders_of(eos_, rho); }
  std::vector<double> density_borders() const { return density_borders_of(eos_); }

private:
  template <class V> BOLIDE_INLINE auto read_table(V rho, V e) const {
    using T = scalar_t<V>;
    const column_place<V> c = find_column(log(rho * T(inverse_density_)));
    const weights<V> in_u(c.t);
    const patch_place<V> at = find_patch(c, in_u, e);
    const weights<V> in_z(at.s, at.height, V(T(1)) / at.height);

    std::int32_t lower[lane_width<V>], upper[lane_width<V>];
    rows_of<8>(at.node, lower);
    rows_of<8>(at.node + T(nodes_per_column_), upper);
    const T* nodes = data(nodes_double_, nodes_float_, T{});
    V n00[8], n01[8], n10[8], n11[8];
    row_reader<8, 8>::template columns<V>(nodes, lower, n00);
    row_reader<8, 8>::template columns<V>(nodes + 8, lower, n01);
    row_reader<8, 8>::template columns<V>(nodes, upper, n10);
    row_reader<8, 8>::template columns<V>(nodes + 8, upper, n11);

    // d/de and d/drho at constant e of what is a function of (t, z).
    const sheet<V> p = read<0>(in_u, in_z, n00, n01, n10, n11, at.beyond);
    const V inverse_rho = V(T(1)) / rho, z_t = -at.inverse_wide * (at.low_u + at.z * at.wide_u);
    const V p_e = p.z * at.inverse_wide, p_rho = (p.t + p.z * z_t) * c.inverse_step * inverse_rho;
    const V c2 = p_rho + p.value * p_e * inverse_rho * inverse_rho;
    if constexpr (!thermal) return caloric_point<V>{p.value, c2, p_e};
    else {
      const sheet<V> t = read<4>(in_u, in_z, n00, n01, n10, n11, at.beyond);
      const phase_place<V> f = find_phase(c, in_u, at, t.value);
      return thermal_point<V>{p.value, c2, t.value, f.melting, f.melt_fraction, at.lowest, f.region, p_e, t.z * at.inverse_wide};
    }
  }
  /// r with the model's answer in the lanes outside. Out of line: most packs of particles have none.
  template <class V, class Point> __attribute__((noinline)) Point with_model(Point r, V rho, V e) const {
    using T = scalar_t<V>;
    for (int i = 0; i < lane_width<V>; ++i) {
      const double rho_i = static_cast<double>(lane(rho, i)), e_i = static_cast<double>(lane(e, i));
      if (!outside_validity(lane(rho, i), lane(e, i))) continue;
      const auto exact = eos_.evaluate(rho_i, e_i);
      set_lane(r.pressure, i, static_cast<T>(exact.pressure));
      set_lane(r.sound_speed_squared, i, static_cast<T>(exact.sound_speed_squared));
      if constexpr (!thermal) set_lane(r.pressure_energy, i, static_cast<T>(pressure_energy(eos_, rho_i, e_i)));
      else {
        set_lane(r.temperature, i, static_cast<T>(exact.temperature));
        set_lane(r.melting_temperature, i, static_cast<T>(exact.melting_temperature));
        set_lane(r.melt_fraction, i, static_cast<T>(exact.melt_fraction));
        set_lane(r.cold_energy, i, static_cast<T>(exact.cold_energy));
        set_lane(r.region, i, static_cast<T>(exact.region));
        set_lane(r.pressure_energy, i, static_cast<T>(exact.pressure_energy));
        set_lane(r.temperature_energy, i, static_cast<T>(exact.temperature_energy));
      }
    }
    return r;
  }

  /// p, dp/dt, dp/dz, d2p/dtdz, then the same of T: one cache line in double. t counts cells of u, z is 0 .. 1 from border to border.
  /// Of borders: b_0, db_0/dt, b_1, ...
  template <class T> struct alignas(8 * sizeof(T)) record {
    T c[8] = {};
  };
  /// A range of ln(eta) without a density border inside.
  struct segment {
    double u = 0, step = 0, inverse_step = 0;
    int cells = 0, column = 0; // column: of its first node
  };
  struct phase {
    double region = 0, melt_begin = 0, melt_end = 0;
  };
  /// How region, melt_fraction and T_m are found.
  enum class rule { patch, temperature, node };
  /// The cubic Hermite polynomial on [0, 1] and its derivative; differences of values come first, so that a constant has slope 0 exactly.
  template <class V> struct weights {
    V rise, first, second, rise_slope, first_slope, second_slope;
    BOLIDE_INLINE explicit weights(V t, V width = V(scalar_t<V>(1)), V inverse_width = V(scalar_t<V>(1))) { // of the interval that t divides
      using T = scalar_t<V>;
      const V one(T(1)), back = one - t;
      rise = t * t * (T(3) - T(2) * t);
      first = width * t * back * back;
      second = -width * t * t * back;
      rise_slope = inverse_width * T(6) * t * back;
      first_slope = back * (one - T(3) * t);
      second_slope = t * (T(3) * t - T(2));
    }
    BOLIDE_INLINE V value(V f0, V m0, V f1, V m1) const { return f0 + (f1 - f0) * rise + m0 * first + m1 * second; }
    BOLIDE_INLINE V slope(V f0, V m0, V f1, V m1) const { return (f1 - f0) * rise_slope + m0 * first_slope + m1 * second_slope; }
  };
  template <class V> struct sheet { V value, t, z; };

  /// Where a density lies: between `column` and the next, t of the way.
  template <class V> struct column_place { V column, first, t, inverse_step; };
  template <class V> BOLIDE_INLINE column_place<V> find_column(V u) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1));
    V start(T(segments_[0].u)), inverse_step(T(segments_[0].inverse_step)), cells(T(segments_[0].cells)), first(T(segments_[0].column));
    for (int k = 1; k < segment_count_; ++k) {
      const segment& g = segments_[static_cast<std::size_t>(k)];
      const auto above = u >= V(T(g.u));
      start = select(above, V(T(g.u)), start);
      inverse_step = select(above, V(T(g.inverse_step)), inverse_step);
      cells = select(above, V(T(g.cells)), cells);
      first = select(above, V(T(g.column)), first);
    }
    const V steps = clip((u - start) * inverse_step, zero, cells), cell = clip(floor(steps), zero, cells - one);
    return {first + cell, first, steps - cell, inverse_step};
  }

  /// Where e lies at a density: z of the way from one border to the next (`wide` apart), in the cell above `node`, s of its `height` in z.
  template <class V> struct patch_place { V lowest, low_u, wide_u, inverse_wide, patch, z, node, s, height, beyond; };
  template <class V> BOLIDE_INLINE patch_place<V> find_patch(const column_place<V>& c, const weights<V>& in_u, V e) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1)), equal(T(q_.energy_cells)), span(T(q_.energy_span));
    V border[most_borders] = {V(T(energy_low_)), zero, zero, zero}, border_u[most_borders] = {zero, zero, zero, zero};
    if (thermal || border_count_ > 1) read_borders(c, in_u, border, border_u);
    V low = border[0], low_u = border_u[0], patch = zero, wide = span, wide_u = zero;
    if (border_count_ > 1) wide = border[1] - border[0], wide_u = border_u[1] - border_u[0];
    for (int k = 1; k < border_count_; ++k) {
      const auto above = e > border[k];
      const bool last = k + 1 == border_count_;
      low = select(above, border[k], low);
      low_u = select(above, border_u[k], low_u);
      wide = select(above, last ? span : border[last ? k : k + 1] - border[k], wide);
      wide_u = select(above, last ? zero : border_u[last ? k : k + 1] - border_u[k], wide_u);
      patch = select(above, V(T(k)), patch);
    }
    const V inverse_wide = one / max(wide, V(T(least_width))), z = (e - low) * inverse_wide, z_in = clip(z, zero, one);
    const auto top = patch > V(T(border_count_) - T(1.5)), bottom = patch < V(T(0.5));
    const V grown = log(one + T(stretch_) * z_in) * T(q_.energy_cells * inverse_log_stretch_);
    const V grade = select(top, grown, select(bottom, sqrt(z_in), z_in) * equal), cell = clip(floor(grade), zero, equal - one);
    const V level = patch * (equal + one) + cell;
    std::int32_t index[lane_width<V>];
    rows_of<1>(level, index);
    const T* heights = data(heights_double_, heights_float_, T{});
    const V z_low = gather<V>(heights, index), height = gather<V>(heights + 1, index) - z_low;
    const V s_raw = (z - z_low) / height, s = clip(s_raw, zero, one);
    return {border[0], low_u, wide_u, inverse_wide, patch, z, c.column * T(nodes_per_column_) + level, s, height, (s_raw - s) * height};
  }
  /// The borders and their slopes in t.
  template <class V> BOLIDE_INLINE void read_borders(const column_place<V>& c, const weights<V>& in_u, V* border, V* border_u) const {
    using T = scalar_t<V>;
    std::int32_t left[lane_width<V>], right[lane_width<V>];
    rows_of<8>(c.column, left);
    rows_of<8>(c.column + T(1), right);
    V a[8], b[8];
    const T* borders = data(borders_double_, borders_float_, T{});
    row_reader<8, 8>::template columns<V>(borders, left, a);
    row_reader<8, 8>::template columns<V>(borders, right, b);
    for (int k = 0; k < most_borders; ++k) {
      border[k] = in_u.value(a[2 * k], a[2 * k + 1], b[2 * k], b[2 * k + 1]);
      border_u[k] = in_u.slope(a[2 * k], a[2 * k + 1], b[2 * k], b[2 * k + 1]);
    }
  }

  /// T_m, melt fraction and region by the model's rule.
  template <class V> struct phase_place { V melting, melt_fraction, region; };
  template <class V>
  BOLIDE_INLINE phase_place<V> find_phase(const column_place<V>& c, const weights<V>& in_u, const patch_place<V>& at, V temperature) const {
    using T = scalar_t<V>;
    if (phase_rule_ == rule::node) return phase_of_nodes(c, at);
    const V zero(T(0)), one(T(1)), t_m = melting(c.column, in_u);
    if (phase_rule_ == rule::temperature) {
      const auto molten = temperature > t_m;
      return {t_m, select(molten, one, zero), select(molten, V(region_value<V>(region::liquid)), V(region_value<V>(region::solid)))};
    }
    V where = zero, begin = zero, end = zero;
    for (int g = 0; g < segment_count_; ++g)
      for (int k = 0; k < border_count_; ++k) {
        const phase& f = phases_[static_cast<std::size_t>(g * most_borders + k)];
        const auto here = c.first == V(T(segments_[static_cast<std::size_t>(g)].column)) && at.patch == V(T(k));
        where = select(here, V(T(f.region)), where);
        begin = select(here, V(T(f.melt_begin)), begin);
        end = select(here, V(T(f.melt_end)), end);
      }
    return {t_m, clip(begin + at.z * (end - begin), zero, one), where};
  }
  template <class V> BOLIDE_INLINE phase_place<V> phase_of_nodes(const column_place<V>& c, const patch_place<V>& at) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1)), half(T(0.5)), next = V(T(nodes_per_column_));
    std::int32_t left[lane_width<V>], right[lane_width<V>], nearest[lane_width<V>];
    rows_of<4>(at.node, left);
    rows_of<4>(at.node + next, right);
    rows_of<4>(at.node + select(c.t > half, next, zero) + select(at.s > half, one, zero), nearest);
    const T* from = data(phase_double_, phase_float_, T{});
    const auto mean = [&](int k) {
      const V a = gather<V>(from + k, left) * (one - at.s) + gather<V>(from + 4 + k, left) * at.s;
      const V b = gather<V>(from + k, right) * (one - at.s) + gather<V>(from + 4 + k, right) * at.s;
      return a * (one - c.t) + b * c.t;
    };
    return {mean(0), mean(1), gather<V>(from + 2, nearest)};
  }

  /// The function that begins at number K of a node, with its derivatives in t and z; linear in z beyond the last border.
  template <int K, class V>
  static BOLIDE_INLINE sheet<V> read(const weights<V>& in_u, const weights<V>& in_z, const V* n00, const V* n01, const V* n10, const V* n11,
                                     V beyond) {
    const V f0 = in_z.value(n00[K], n00[K + 2], n01[K], n01[K + 2]), f1 = in_z.value(n10[K], n10[K + 2], n11[K], n11[K + 2]);
    const V g0 = in_z.value(n00[K + 1], n00[K + 3], n01[K + 1], n01[K + 3]), g1 = in_z.value(n10[K + 1], n10[K + 3], n11[K + 1], n11[K + 3]);
    const V f0_z = in_z.slope(n00[K], n00[K + 2], n01[K], n01[K + 2]), f1_z = in_z.slope(n10[K], n10[K + 2], n11[K], n11[K + 2]);
    const V g0_z = in_z.slope(n00[K + 1], n00[K + 3], n01[K + 1], n01[K + 3]), g1_z = in_z.slope(n10[K + 1], n10[K + 3], n11[K + 1], n11[K + 3]);
    sheet<V> r;
    const V value = in_u.value(f0, g0, f1, g1), slope_t = in_u.slope(f0, g0, f1, g1), twist = in_u.slope(f0_z, g0_z, f1_z, g1_z);
    r.t = slope_t + beyond * twist;
    r.z = in_u.value(f0_z, g0_z, f1_z, g1_z);
    r.value = value + beyond * r.z;
    return r;
  }
  /// Where row `number` of the records begins, lane by lane.
  template <int stride, class V> static BOLIDE_INLINE void rows_of(V number, std::int32_t* index) {
    store_whole(number, index);
    for (int i = 0; i < lane_width<V>; ++i) index[i] *= stride;
  }
  static const double* data(const std::vector<record<double>>& wide, const std::vector<record<float>>&, double) { return wide.data()->c; }
  static const float* data(const std::vector<record<double>>&, const std::vector<record<float>>& slim, float) { return slim.data()->c; }
  static const double* data(const std::vector<double>& wide, const std::vector<float>&, double) { return wide.data(); }
  static const float* data(const std::vector<double>&, const std::vector<float>& slim, float) { return slim.data(); }
  /// T_m in the record beside the column's borders.
  template <class V> BOLIDE_INLINE V melting(V column, const weights<V>& in_u) const {
    using T = scalar_t<V>;
    std::int32_t at[lane_width<V>];
    rows_of<2>(column, at);
    const T* from = data(melting_double_, melting_float_, T{});
    const V m0 = gather<V>(from, at), d0 = gather<V>(from + 1, at), m1 = gather<V>(from + 2, at), d1 = gather<V>(from + 3, at);
    return in_u.value(m0, d0, m1, d1);
  }

  // ---- set-up ---------------------------------------------------------------------------------------------------------------
  /// b_0 .. b_{n-1} at a density.
  std::array<double, most_borders> borders_at(double rho) const {
    std::array<double, most_borders> b{};
    if constexpr (thermal) b[0] = eos_.evaluate(rho, 0.0).cold_energy;
    else b[0] = energy_low_;
    const std::vector<double> inner = energy_borders_of(eos_, rho);
    for (int k = 1; k < border_count_; ++k) b[static_cast<std::size_t>(k)] = inner[static_cast<std::size_t>(k - 1)];
    return b;
  }
  double density_at(double u) const { return eos_.reference_density() * std::exp(u); }

  void lay_out() {
    const double rho0 = eos_.reference_density();
    const validity_box box = validity_of(eos_);
    inverse_density_ = 1 / rho0;
    density_low_ = std::max(box.density_low, q_.eta_low * rho0);
    density_high_ = std::min(box.density_high, q_.eta_high * rho0);
    require(density_low_ < rho0 && density_high_ > rho0, "eos::tabulated reference density", rho0, "inside the model's validity box", "kg/m3");
    const double c2 = eos_.evaluate(rho0, 0.0).sound_speed_squared, in_zpan = eos_.evaluate(rho0, 0.05 * q_.energy_span).sound_speed_squared;
    stiffness_ = c2 > 0 ? c2 : in_zpan;
    require(stiffness_ > 0, "eos::tabulated sound speed squared at the reference density", stiffness_, "> 0", "m2/s2");
    energy_low_ = std::max(box.energy_low, q_.energy_low);
    border_count_ = 1 + static_cast<int>(energy_borders_of(eos_, rho0).size());
    require(border_count_ <= most_borders, "eos::tabulated energy borders of the model", border_count_ - 1, "at most 3");
    for (int i = 0; i <= 200; ++i) {
      const std::array<double, most_borders> b = borders_at(density_low_ * std::pow(density_high_ / density_low_, i / 200.0));
      for (std::size_t k = 1; k < static_cast<std::size_t>(border_count_); ++k)
        require(b[k] >= b[k - 1], "eos::tabulated energy border of the model", b[k],
                "no lower than the one before it and the cold energy at every density (tabulate the model inside isentrope_temperature and "
                "wrap the table)", "J/kg");
    }
    stretch_ = q_.energy_span / (c2 > 0 ? 0.05 * c2 : 0.02 * q_.energy_span);
    inverse_log_stretch_ = 1 / std::log1p(stretch_);
    for (int patch = 0; patch < border_count_; ++patch)
      for (int j = 0; j <= q_.energy_cells; ++j) {
        const double part = double(j) / q_.energy_cells;
        const bool last = patch + 1 == border_count_;
        const double graded = last ? std::expm1(part / inverse_log_stretch_) / stretch_ : patch == 0 ? part * part : part;
        heights_double_.push_back(j == q_.energy_cells ? 1 : graded);
      }
    heights_float_.assign(heights_double_.begin(), heights_double_.end());

    std::vector<double> ends{std::log(density_low_ / rho0)};
    std::vector<double> inner = density_borders_of(eos_);
    for (int k = 1; k < border_count_; ++k) add_ends_of_patch(k, inner);
    std::sort(inner.begin(), inner.end());
    for (const double rho : inner)
      if (rho > density_low_ * 1.001 && rho < density_high_ * 0.999) ends.push_back(std::log(rho / rho0));
    ends.push_back(std::log(density_high_ / rho0));
    segment_count_ = static_cast<int>(ends.size()) - 1;
    require(segment_count_ <= most_segments, "eos::tabulated density borders of the model", segment_count_ - 1, "at most 3");
    int column = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double length = ends[k + 1] - ends[k];
      const int cells = std::max(4, static_cast<int>(std::lround(q_.density_cells * length / (ends.back() - ends.front()))));
      segments_[k] = {ends[k], length / cells, cells / length, cells, column};
      column += cells + 1;
    }
    columns_ = column;
    nodes_per_column_ = border_count_ * (q_.energy_cells + 1);
    require(double(columns_) * nodes_per_column_ < 1 << 24, "eos::tabulated nodes", double(columns_) * nodes_per_column_, "below 2^24");
  }

  /// The densities at which the patch below border k gets or loses its width.
  void add_ends_of_patch(int k, std::vector<double>& densities) const {
    const auto flat = [&](double rho) {
      const std::array<double, most_borders> b = borders_at(rho);
      return b[static_cast<std::size_t>(k)] - b[static_cast<std::size_t>(k - 1)] < least_width;
    };
    const double step = std::pow(density_high_ / density_low_, 1.0 / 400);
    for (double low = density_low_; low * step <= density_high_; low *= step) {
      double a = low, b = low * step;
      if (flat(a) == flat(b)) continue;
      const bool flat_below = flat(a);
      while (b - a > 1e-14 * b) (flat(0.5 * (a + b)) == flat_below ? a : b) = 0.5 * (a + b);
      densities.push_back(b);
    }
  }

  /// z at s in cell j of a patch.
  double place(int patch, int j, double s) const {
    const auto k = static_cast<std::size_t>(patch * (q_.energy_cells + 1) + j);
    return heights_double_[k] + (s > 0 ? s * (heights_double_[k + 1] - heights_double_[k]) : 0);
  }
  double height_of(int patch, const std::array<double, most_borders>& border) const {
    const auto k = static_cast<std::size_t>(patch);
    return patch + 1 < border_count_ ? border[k + 1] - border[k] : q_.energy_span;
  }
  /// The energy of a node of a patch; kept off borders by 1e-11 of their energy, so that the patch's own side answers.
  double energy_at(const std::array<double, most_borders>& border, int patch, int node) const {
    const auto k = static_cast<std::size_t>(patch);
    const double e = border[k] + height_of(patch, border) * place(patch, node, 0);
    if (patch > 0 && node == 0) return e + 1e-11 * std::abs(e);
    if (patch + 1 < border_count_ && node == q_.energy_cells) return border[k + 1] - 1e-11 * std::abs(border[k + 1]);
    return e;
  }
  /// p, dp/dz, T, dT/dz at a node of a patch.
  struct sample { double p, p_z, T, T_z; };
  sample at(double rho, const std::array<double, most_borders>& border, int patch, int node) const {
    const double wide = height_of(patch, border), e = energy_at(border, patch, node);
    const auto r = eos_.evaluate(rho, e);
    sample f{r.pressure, pressure_energy(eos_, rho, e) * wide, 0, 0};
    if constexpr (thermal) {
      f.T = r.temperature, f.T_z = r.temperature_energy * wide;
      if (node == 0) { // a quantum lattice has dT/de infinite at 0 K: there the slope that meets the middle of the first cell
        const double e_next = energy_at(border, patch, 1), step = place(patch, 1, 0);
        const auto next = eos_.evaluate(rho, e_next), middle = eos_.evaluate(rho, 0.5 * (e + e_next));
        const auto meeting = [&](double f0, double f_half, double f1, double slope1) {
          const double steepest = 3 * std::abs(f1 - f0) / step;
          return std::clamp(slope1 + (8 * f_half - 4 * (f0 + f1)) / step, -steepest, steepest);
        };
        if (f.T_z > 3 * std::abs(next.temperature - f.T) / step) {
          f.T_z = meeting(f.T, middle.temperature, next.temperature, next.temperature_energy * wide);
          f.p_z = meeting(f.p, middle.pressure, next.pressure, pressure_energy(eos_, rho, e_next) * wide);
        }
      }
    }
    return f;
  }

  /// Offsets and weights of a five-point difference: central inside a segment, one-sided at its ends.
  struct stencil { std::array<double, 5> offset, weight; };
  static stencil stencil_at(bool first, bool last) {
    if (first) return {{0, 1, 2, 3, 4}, {-25. / 12, 4, -3, 4. / 3, -1. / 4}};
    if (last) return {{0, -1, -2, -3, -4}, {25. / 12, -4, 3, -4. / 3, 1. / 4}};
    return {{-2, -1, 0, 1, 2}, {1. / 12, -2. / 3, 0, 2. / 3, -1. / 12}};
  }

  void fill() {
    nodes_double_.resize(static_cast<std::size_t>(columns_ * nodes_per_column_));
    borders_double_.resize(static_cast<std::size_t>(columns_));
    melting_double_.resize(static_cast<std::size_t>(2 * columns_));
    energy_high_ = std::numeric_limits<double>::infinity();
    for (int g = 0; g < segment_count_; ++g) {
      const segment& seg = segments_[static_cast<std::size_t>(g)];
      for (int i = 0; i <= seg.cells; ++i) fill_column(seg, i);
    }
    if constexpr (thermal) {
      bool by_patch = true, by_temperature = true;
      for (int g = 0; g < segment_count_; ++g) find_phases(g, by_patch, by_temperature);
      phase_rule_ = by_patch ? rule::patch : by_temperature ? rule::temperature : rule::node;
      if (phase_rule_ == rule::node) fill_phases();
    }
    nodes_float_.resize(nodes_double_.size());
    borders_float_.resize(borders_double_.size());
    const auto slim = [](const record<double>& from) {
      record<float> to;
      for (std::size_t k = 0; k < 8; ++k) to.c[k] = static_cast<float>(from.c[k]);
      return to;
    };
    std::transform(nodes_double_.begin(), nodes_double_.end(), nodes_float_.begin(), slim);
    std::transform(borders_double_.begin(), borders_double_.end(), borders_float_.begin(), slim);
    melting_float_.assign(melting_double_.begin(), melting_double_.end());
  }

  void fill_column(const segment& seg, int i) {
    const double reach = 0.02, inside = 1e-10; // of a step: of the difference, and how far a node keeps off a density border
    const stencil d = stencil_at(i == 0, i == seg.cells);
    const double off_border = i == 0 ? inside : i == seg.cells ? -inside : 0;
    std::array<double, 5> rho{};
    std::array<std::array<double, most_borders>, 5> border{};
    std::size_t centre = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      rho[k] = density_at(seg.u + seg.step * (i + off_border + reach * d.offset[k]));
      border[k] = borders_at(rho[k]);
      if (d.offset[k] == 0) centre = k;
    }
    const auto slope = [&](const auto& f) { // d/dt, per cell
      double sum = 0;
      for (std::size_t k = 0; k < 5; ++k)
        if (d.weight[k] != 0) sum += d.weight[k] * f(k);
      return sum / reach;
    };
    const auto column = static_cast<std::size_t>(seg.column + i);
    for (std::size_t b = 0; b < most_borders; ++b) {
      borders_double_[column].c[2 * b] = border[centre][b];
      borders_double_[column].c[2 * b + 1] = slope([&](std::size_t k) { return border[k][b]; });
    }
    energy_high_ = std::min(energy_high_, border[centre][static_cast<std::size_t>(border_count_ - 1)] + q_.energy_span);
    if constexpr (thermal) {
      melting_double_[2 * column] = eos_.evaluate(rho[centre], 0.0).melting_temperature;
      melting_double_[2 * column + 1] = slope([&](std::size_t k) { return eos_.evaluate(rho[k], 0.0).melting_temperature; });
    }
    for (int patch = 0; patch < border_count_; ++patch)
      for (int j = 0; j <= q_.energy_cells; ++j) {
        std::array<sample, 5> f{};
        for (std::size_t k = 0; k < 5; ++k) f[k] = at(rho[k], border[k], patch, j);
        const int number = (seg.column + i) * nodes_per_column_ + patch * (q_.energy_cells + 1) + j;
        record<double>& r = nodes_double_[static_cast<std::size_t>(number)];
        r.c[0] = f[centre].p;
        r.c[1] = slope([&](std::size_t k) { return f[k].p; });
        r.c[2] = f[centre].p_z;
        r.c[3] = slope([&](std::size_t k) { return f[k].p_z; });
        r.c[4] = f[centre].T;
        r.c[5] = slope([&](std::size_t k) { return f[k].T; });
        r.c[6] = f[centre].T_z;
        r.c[7] = slope([&](std::size_t k) { return f[k].T_z; });
        require(std::isfinite(r.c[0]) && std::isfinite(r.c[3]) && std::isfinite(r.c[7]), "eos::tabulated pressure in the table's range", r.c[0],
                "finite with its derivatives (the model must answer all over the range)", "Pa");
      }
  }

  /// Region and melt fraction of the patches of a segment; whether each is one region, linear in e, and whether T > T_m tells all.
  void find_phases(int g, bool& by_patch, bool& by_temperature) {
    const segment& seg = segments_[static_cast<std::size_t>(g)];
    for (int patch = 0; patch < border_count_; ++patch) {
      phase& f = phases_[static_cast<std::size_t>(g * most_borders + patch)];
      for (int i = 0; i < 2 * seg.cells; ++i) {
        const double rho = density_at(seg.u + seg.step * (0.5 * i + 0.25));
        const std::array<double, most_borders> border = borders_at(rho);
        const auto k = static_cast<std::size_t>(patch);
        const double wide = height_of(patch, border);
        if (wide < least_width) {
          by_patch = false;
          continue;
        }
        const double t_m = eos_.evaluate(rho, 0.0).melting_temperature;
        for (const double z : {1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1 - 1e-6}) {
          const auto r = eos_.evaluate(rho, border[k] + z * wide);
          if (i == 0 && z == 1e-6) f.region = r.region, f.melt_begin = r.melt_fraction < 1e-5 ? 0 : r.melt_fraction;
          if (i == 0) f.melt_end = r.melt_fraction > 1 - 1e-5 ? 1 : r.melt_fraction;
          const bool molten = r.temperature > t_m, same_melting = std::abs(r.melting_temperature - t_m) <= 1e-9 * t_m;
          if (r.region != f.region || !same_melting) by_patch = false;
          if (std::abs(r.melt_fraction - f.melt_begin - z * (f.melt_end - f.melt_begin)) > 2e-5 && i > 0) by_patch = false;
          const bool as_told = r.region == region_value<double>(molten ? region::liquid : region::solid) && r.melt_fraction == molten;
          if (!as_told || !same_melting) by_temperature = false;
        }
      }
    }
  }

  /// T_m, melt fraction and region of every node.
  void fill_phases() {
    phase_double_.resize(4 * nodes_double_.size());
    for (int g = 0; g < segment_count_; ++g) {
      const segment& seg = segments_[static_cast<std::size_t>(g)];
      for (int i = 0; i <= seg.cells; ++i) {
        const double rho = density_at(seg.u + seg.step * (i + (i == 0 ? 1e-10 : i == seg.cells ? -1e-10 : 0)));
        const std::array<double, most_borders> border = borders_at(rho);
        for (int patch = 0; patch < border_count_; ++patch)
          for (int j = 0; j <= q_.energy_cells; ++j) {
            const auto r = eos_.evaluate(rho, energy_at(border, patch, j));
            double* to = &phase_double_[4 * static_cast<std::size_t>((seg.column + i) * nodes_per_column_ + patch * (q_.energy_cells + 1) + j)];
            to[0] = r.melting_temperature, to[1] = r.melt_fraction, to[2] = r.region;
          }
      }
    }
    phase_float_.assign(phase_double_.begin(), phase_double_.end());
  }

  void measure() {
    const double floor_c2 = 0.01 * stiffness_, floor_p = floor_c2 * eos_.reference_density();
    for (int g = 0; g < segment_count_; ++g) {
      const segment& seg = segments_[static_cast<std::size_t>(g)];
      for (int i = 0; i < seg.cells; ++i)
        for (const double t : {0.03, 0.21, 0.5, 0.79, 0.97}) {
          const double rho = density_at(seg.u + seg.step * (i + t));
          const std::array<double, most_borders> border = borders_at(rho);
          for (int patch = 0; patch < border_count_; ++patch)
            for (int j = 0; j < q_.energy_cells; ++j)
              for (const double s : {0.03, 0.21, 0.5, 0.79, 0.97}) {
                const double e = border[static_cast<std::size_t>(patch)] + height_of(patch, border) * place(patch, j, s);
                if (height_of(patch, border) < least_width || outside_of(eos_, rho, e)) continue;
                const auto a = evaluate(rho, e);
                const auto b = eos_.evaluate(rho, e);
                error_.pressure = std::max(error_.pressure, std::abs(a.pressure - b.pressure) / (std::abs(b.pressure) + floor_p));
                error_.sound_speed_squared = std::max(error_.sound_speed_squared,
                    std::abs(a.sound_speed_squared - b.sound_speed_squared) / (std::abs(b.sound_speed_squared) + floor_c2));
                if constexpr (thermal) error_.melt_fraction = std::max(error_.melt_fraction, std::abs(a.melt_fraction - b.melt_fraction));
                if constexpr (thermal)
                  error_.temperature = std::max(error_.temperature, std::abs(a.temperature - b.temperature) / (std::abs(b.temperature) + 100));
              }
        }
    }
    error_.pressure *= 2;
    error_.sound_speed_squared *= 2;
    error_.temperature *= 2;
    error_.melt_fraction *= 2;
  }

  Eos eos_;
  tabulated_parameters q_;
  double inverse_density_ = 0, density_low_ = 0, density_high_ = 0; // m3/kg, kg/m3
  double energy_low_ = 0, energy_high_ = 0, stiffness_ = 0;         // J/kg, J/kg, m2/s2
  double stretch_ = 0, inverse_log_stretch_ = 0;
  int border_count_ = 0, segment_count_ = 0, columns_ = 0, nodes_per_column_ = 0;
  rule phase_rule_ = rule::patch;
  std::array<segment, most_segments> segments_{};
  std::array<phase, most_segments * most_borders> phases_{};
  std::vector<record<double>> nodes_double_, borders_double_;
  std::vector<record<float>> nodes_float_, borders_float_;
  std::vector<double> melting_double_, heights_double_, phase_double_; // T_m and its slope by column; z of the uppermost patch's nodes; T_m,
  std::vector<float> melting_float_, heights_float_, phase_float_;     // melt fraction, region and a space by node
  surface_error error_;
};

} // namespace bolide::eos
