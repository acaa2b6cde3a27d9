// SPDX-License-Identifier: MIT
// A cold curve from a user's two columns: a volume and a pressure, or a volume and an energy.
//
//   pressure given:  p_c(x) is the C2 cubic spline through the points (not-a-knot ends); where it would overshoot between points that
//                    rise or fall together, the slopes there are cut back (Hyman 1983), so p_c is monotone there too, and C1; next to a
//                    turning point of the points nothing is cut; e_c = -(1/rho0) integral of p_c dx, exact, zero at x = 1
//   energy given:    e_c(x) is the C2 cubic spline less its value at x = 1; p_c = -rho0 de_c/dx, its slope continuous. Nothing is cut
//                    back: an energy is no monotone function. The pressure has an order less than the energy's fourth: give many
//                    digits and points
// Inside and outside p_c = -de_c/dV and slope = dp_c/dx hold exactly. Outside the points the curve goes on with p_c, e_c and slope
// continuous (outside_validity() says where):
//   compression      p_c = p_a + (K_a/4) [(x_a/x)^4 - 1], K_a = -x_a dp_c/dx >= 0: Murnaghan's with B' = 4 (K_a < 0: in a straight line)
//   expansion        p_c = [p_b + (s_b + k p_b) (x - x_b)] exp[-k (x - x_b)]: it dies out; k = -s_b/p_b where that is a pull that relaxes, else
//                    3/x_b
// Text: two numbers a line, blanks, commas or semicolons between them; empty lines and what follows # are skipped; a first line of words is a
// header. Volumes rise or fall throughout. Every refusal names the line or the point. Cost: a binary search; for the time loop
// wrap it in cold::tabulated.
#pragma once

#include "bolide/concepts/cold_curve.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/cubic_spline.hpp"
#include "bolide/core/text_input.hpp"
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/cold/each_lane.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::cold {

/// What the first column measures: V/V0, kg/m3, m3/kg or m3 per atom.
enum class volume_column { ratio, density, specific_volume, atomic_volume };
/// What the second column measures: Pa, J/kg or J per atom.
enum class value_column { pressure, specific_energy, atomic_energy };

/// What the two columns are. A unit is the factor to SI: unit::GPa, unit::g / (unit::cm * unit::cm * unit::cm), unit::eV ...
struct table_columns {
  volume_column volume = volume_column::ratio;
  double volume_unit = 1;
  value_column value = value_column::pressure;
  double value_unit = 1;
  double reference_density = 0; // kg/m3 at x = 1; 0: where p_c = 0 (then the first column is not `ratio`)
  double atomic_mass = 0;       // kg; needed by the columns per atom
};

class user_table {
public:
  user_table(std::span<const double> volumes, std::span<const double> values, const table_columns& columns)
      : user_table(points(volumes, values, columns), columns) {}

  /// From a text file; from_text takes the text itself, `source` is what refusals call it.
  static user_table read(const std::string& path, const table_columns& columns) { return from_text(text::read_file(path), columns, path); }
  static user_table from_text(std::string_view all, const table_columns& columns, std::string_view source = "table") {
    return {columns_of(all, columns, source), columns};
  }

  /// Exact in double; a pack or a float is answered lane by lane in double.
  template <class V> cold_point<V> evaluate(V x) const {
    return detail::each_lane(x, [this](double one) { return exact(one); });
  }
  double reference_density() const { return density_; }
  /// The first and the last x of the points.
  double x_low() const { return x_.front(); }
  double x_high() const { return x_.back(); }
  template <class V> mask_t<V> outside_validity(V x) const {
    using T = scalar_t<V>;
    return x < V(T(x_low())) || x > V(T(x_high()));
  }

private:
  /// Points in SI before they are a curve: specific volume (x where the column is a ratio), pressure or specific energy.
  struct point {
    double volume, value;
  };
  /// c_0 .. c_4 of rho0 e_c in t = x - x_i, Pa.
  struct piece {
    double c[5];
  };

  user_table(std::vector<point> list, const table_columns& columns) : density_(columns.reference_density) {
    const bool ratio = columns.volume == volume_column::ratio, pressure = columns.value == value_column::pressure;
    if (list.front().volume > list.back().volume) std::reverse(list.begin(), list.end());
    if (density_ == 0) density_ = 1 / free_volume(list, pressure);
    std::vector<double> y;
    for (const point& p : list) {
      x_.push_back(ratio ? p.volume : p.volume * density_);
      y.push_back(pressure ? p.value : p.value * density_);
    }
    fill(y, pressure);
    require(x_low() <= 1 && x_high() >= 1, "cold::user_table x = V/V0 = 1", 1,
            "among the points, which run from " + to_text(x_low()) + " to " + to_text(x_high()));
    const double at_one = inside(1).energy;
    for (piece& p : pieces_) p.c[0] -= density_ * at_one;
    low_ = inside(x_low());
    high_ = inside(x_high());
  }

  // ---- what comes in -----------------------------------------------------------------------------------------------------------
  static void check(const table_columns& c) {
    require(c.volume_unit > 0 && std::isfinite(c.volume_unit), "cold::user_table volume_unit", c.volume_unit, "> 0 and finite");
    require(c.value_unit > 0 && std::isfinite(c.value_unit), "cold::user_table value_unit", c.value_unit, "> 0 and finite");
    require(c.reference_density >= 0 && std::isfinite(c.reference_density), "cold::user_table reference_density", c.reference_density,
            ">= 0 and finite", "kg/m3");
    require(c.volume != volume_column::ratio || c.reference_density > 0, "cold::user_table reference_density", c.reference_density,
            "> 0 where the first column is V/V0", "kg/m3");
    const bool atoms = c.volume == volume_column::atomic_volume || c.value == value_column::atomic_energy;
    require(!atoms || (c.atomic_mass > 0 && std::isfinite(c.atomic_mass)), "cold::user_table atomic_mass", c.atomic_mass,
            "> 0 where a column is per atom", "kg");
  }
  static point in_si(double volume, double value, const table_columns& c) {
    const double v = volume * c.volume_unit, y = value * c.value_unit;
    return {c.volume == volume_column::density && v > 0 ? 1 / v : c.volume == volume_column::atomic_volume ? v / c.atomic_mass : v,
            c.value == value_column::atomic_energy ? y / c.atomic_mass : y};
  }
  /// `where(i)` names point i, `say` refuses with a sentence about it.
  template <class Say> static void check_order(const std::vector<point>& list, const Say& say) {
    if (list.size() < 4) say(list.size(), "the table has " + std::to_string(list.size()) + " points, at least 4 are needed");
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!std::isfinite(list[i].volume) || !std::isfinite(list[i].value)) say(i, "not a finite number");
      if (!(list[i].volume > 0)) say(i, "expected a volume or density > 0");
      if (i > 0 && list[i].volume == list[i - 1].volume) say(i, "the volume is that of the point before");
      if (i > 1 && (list[i].volume > list[i - 1].volume) != (list[1].volume > list[0].volume))
        say(i, "the volumes are not sorted: they must rise or fall throughout");
    }
  }
  static std::vector<point> points(std::span<const double> volumes, std::span<const double> values, const table_columns& columns) {
    check(columns);
    require(volumes.size() == values.size(), "cold::user_table number of values", double(values.size()),
            "that of the volumes, " + to_text(double(volumes.size())));
    std::vector<point> list;
    for (std::size_t i = 0; i < volumes.size(); ++i) list.push_back(in_si(volumes[i], values[i], columns));
    check_order(list, [](std::size_t i, const std::string& what) {
      throw bad_parameter("cold::user_table point " + std::to_string(i + 1) + ": " + what);
    });
    return list;
  }
  static std::vector<point> columns_of(std::string_view all, const table_columns& columns, std::string_view source) {
    check(columns);
    std::string plain(all);
    std::replace_if(plain.begin(), plain.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    text::cursor at(plain, source);
    std::vector<point> list;
    std::vector<std::size_t> lines;
    bool header = false;
    std::string_view line;
    for (std::size_t number = at.line(); at.next_line(line); number = at.line()) {
      text::cursor words(line.substr(0, line.find('#')), source);
      const std::string_view first = words.next_word_of_line(), second = words.next_word_of_line();
      if (first.empty()) continue;
      double volume = 0, value = 0;
      const bool one = text::parse_number(first, volume), two = text::parse_number(second, value);
      if (!one && !two && list.empty() && !header) {
        header = true;
        continue;
      }
      if (!one || !two) at.refuse_at(number, "expected two numbers, found " + text::shown(line));
      if (const std::string_view third = words.next_word_of_line(); !third.empty())
        at.refuse_at(number, "expected two columns, found a third, " + text::shown(third));
      list.push_back(in_si(volume, value, columns));
      lines.push_back(number);
    }
    check_order(list, [&](std::size_t i, const std::string& what) { at.refuse_at(i < lines.size() ? lines[i] : at.line(), what); });
    return list;
  }

  // ---- the curve ---------------------------------------------------------------------------------------------------------------
  /// Cuts slopes back so that each piece is monotone where the points around it are; next to a turning point nothing is cut.
  static void keep_monotone(std::span<const double> x, std::span<const double> y, std::vector<double>& slope) {
    const std::size_t last = x.size() - 2;
    const auto d = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double left = d(i > 0 ? i - 1 : 0), right = d(std::min(i, last)), far_left = d(i > 1 ? i - 2 : 0), far_right = d(std::min(i + 1, last));
      if (left * right < 0 || far_left * right < 0 || left * far_right < 0) continue;
      const double most = 3 * std::min(std::abs(left), std::abs(right));
      slope[i] = left + right > 0 ? std::clamp(slope[i], 0.0, most) : std::clamp(slope[i], -most, 0.0);
    }
  }

  /// y: pressure (Pa) or rho0 times specific energy (Pa).
  void fill(const std::vector<double>& y, bool pressure) {
    std::vector<double> slope = spline_slopes(x_, y);
    if (pressure) keep_monotone(x_, y, slope);
    double energy = 0;
    pieces_.clear();
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      const double h = x_[i + 1] - x_[i], d = (y[i + 1] - y[i]) / h;
      const double a = y[i], b = slope[i], c = (3 * d - 2 * slope[i] - slope[i + 1]) / h, e = (slope[i] + slope[i + 1] - 2 * d) / (h * h);
      if (pressure) {
        pieces_.push_back({{energy, -a, -b / 2, -c / 3, -e / 4}});
        energy -= h * (a + h * (b / 2 + h * (c / 3 + h * (e / 4))));
      } else pieces_.push_back({{a, b, c, e, 0}});
    }
  }

  cold_point<double> inside(double x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
    const std::size_t i = static_cast<std::size_t>(above - x_.begin()) - 1;
    const double t = x - x_[i];
    const double* c = pieces_[i].c;
    return {(c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])))) / density_, -(c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4]))),
            -(2 * c[2] + t * (6 * c[3] + t * 12 * c[4]))};
  }
  cold_point<double> compressed(double x) const {
    const double a = x_low(), K = -a * low_.slope, t = x - a;
    if (K < 0) return {low_.energy - t * (low_.pressure + t * low_.slope / 2) / density_, low_.pressure + low_.slope * t, low_.slope};
    const double r = a / x, r2 = r * r, r4 = r2 * r2;
    return {low_.energy - ((low_.pressure - K / 4) * t + K / 12 * a * (1 - r * r2)) / density_, low_.pressure + K / 4 * (r4 - 1), -K * r4 / x};
  }
  cold_point<double> expanded(double x) const {
    const double p = high_.pressure, s = high_.slope, k = p < 0 && s > 0 ? -s / p : 3 / x_high(), c = s + k * p;
    const double t = x - x_high(), decay = std::exp(-k * t);
    const double area = (p + c / k) * (1 - decay) / k - c * t * decay / k; // integral of p_c from x_b to x
    return {high_.energy - area / density_, (p + c * t) * decay, (c - k * (p + c * t)) * decay};
  }
  cold_point<double> exact(double x) const { return x < x_low() ? compressed(x) : x > x_high() ? expanded(x) : inside(x); }

  /// The specific volume at which p_c = 0, from a curve in the specific volume itself.
  static double free_volume(const std::vector<point>& list, bool pressure) {
    user_table raw;
    std::vector<double> y;
    for (const point& p : list) {
      raw.x_.push_back(p.volume);
      y.push_back(p.value);
    }
    raw.fill(y, pressure);
    const auto p_c = [&](double volume) { return raw.inside(volume).pressure; };
    for (std::size_t i = 0; i + 1 < raw.x_.size(); ++i)
      if (p_c(raw.x_[i]) > 0 && p_c(raw.x_[i + 1]) <= 0) return eos::bracketed_root(p_c, raw.x_[i], raw.x_[i + 1]);
    throw bad_parameter("cold::user_table: nowhere among the points does the pressure fall through 0: state reference_density");
  }
  user_table() = default;

  double density_ = 1; // kg/m3, 1/V0
  std::vector<double> x_;
  std::vector<piece> pieces_;
  cold_point<double> low_{}, high_{}; // at the ends
};

static_assert(ColdCurve<user_table>);

} // namespace bolide::cold
