// SPDX-License-Identifier: MIT
// Any embedded-atom potential from a file in DYNAMO's setfl form (LAMMPS: pair_style eam/alloy), and the writer of such files.
//
//   lines 1 to 3   comment
//   line 4         number of elements and their names
//   line 5         N_rho d_rho N_r d_r cut-off                                     (rho and angstrom)
//   per element    a line: atomic number, mass (u), lattice constant (angstrom), structure;
//                  N_rho values of F(rho), eV, from rho = 0; N_r values of f(r) from r = 0
//   per pair       i >= j: N_r values of r phi(r), eV angstrom, from r = 0
// Between the values stands the cubic Hermite polynomial with slopes from four neighbours, as in LAMMPS, so that a file means the same
// curve here and there (a C2 spline through a coarse file is another one: a public file of Cai-Ye's aluminium with d_rho = 0.22 rho_e has
// p = -13.5 MPa at x = 1 here and there, +4.5 MPa by the formula, -236 MPa with a C2 spline). The error falls like the fourth power of the
// steps; second derivatives are continuous inside a step only. F ~ sqrt(rho) of many potentials bends without limit at rho = 0, where every
// table is poor: choose d_rho small against the densities of the expanded lattice. Beyond the last rho, F goes on in a straight line (largest_density() says where); beyond the last r, pair and density
// are 0. reach() is the file's cut-off or the table's end, whichever is nearer.
// A text that is no such file is refused with its line and what was expected; nothing after the last table is accepted (a file
// of another style, adp or fs, holds more).
#pragma once

#include "bolide/concepts/potential.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/text_input.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace bolide::potential {

namespace detail {
/// The cubic Hermite polynomial through values at 0, step, 2 step ... with slopes of fourth order inside and LAMMPS's at the ends.
class uniform_spline {
public:
  uniform_spline() = default;
  uniform_spline(double step, std::vector<double> values) : step_(step), value_(std::move(values)), slope_(value_.size()) {
    const std::vector<double>& v = value_;
    const std::size_t n = v.size();
    slope_[0] = v[1] - v[0]; // per step
    slope_[1] = 0.5 * (v[2] - v[0]);
    for (std::size_t i = 2; i + 2 < n; ++i) slope_[i] = (v[i - 2] - v[i + 2] + 8 * (v[i + 1] - v[i - 1])) / 12;
    slope_[n - 2] = 0.5 * (v[n - 1] - v[n - 3]);
    slope_[n - 1] = v[n - 1] - v[n - 2];
  }

  double end() const { return step_ * double(value_.size() - 1); }
  /// For 0 <= s <= end(); NaN gives NaN.
  potential_value operator()(double s) const {
    const double steps = s / step_, last = double(value_.size()) - 2;
    const std::size_t i = steps > 0 ? static_cast<std::size_t>(std::min(steps, last)) : 0;
    const double t = steps - double(i), rise = value_[i + 1] - value_[i];
    const double c2 = 3 * rise - 2 * slope_[i] - slope_[i + 1], c3 = slope_[i] + slope_[i + 1] - 2 * rise;
    return {value_[i] + t * (slope_[i] + t * (c2 + t * c3)), (slope_[i] + t * (2 * c2 + t * 3 * c3)) / step_,
            (2 * c2 + t * 6 * c3) / (step_ * step_)};
  }

private:
  double step_ = 1;
  std::vector<double> value_, slope_;
};
} // namespace detail

class setfl {
public:
  /// `element` chooses among several; with one in the file it may be left out.
  static setfl read(const std::string& path, std::string_view element = {}) { return parse(text::read_file(path), element, path); }
  /// The same from a text; `source` is what refusals call it.
  static setfl parse(std::string_view all, std::string_view element = {}, std::string_view source = "setfl text") {
    setfl r;
    r.parse_from(text::cursor(all, source), element);
    return r;
  }

  potential_value pair(double r) const {
    if (r > z_.end()) return {0, 0, 0};
    const potential_value z = z_(r);
    const double value = z.value / r, first = (z.first - value) / r;
    return {value, first, (z.second - 2 * first) / r};
  }
  potential_value density(double r) const { return r > f_.end() ? potential_value{0, 0, 0} : f_(r); }
  potential_value embedding(double rho) const {
    const double inside = std::clamp(rho, 0.0, F_.end());
    const potential_value at = F_(inside);
    return inside == rho ? at : potential_value{at.value + at.first * (rho - inside), at.first, 0};
  }

  double reach() const { return reach_; }
  double lattice_constant() const { return lattice_constant_; }
  lattice structure() const { return structure_; }
  double mass() const { return mass_; }
  const std::string& element() const { return element_; }
  /// The last rho of the table: above it F is continued in a straight line.
  double largest_density() const { return F_.end(); }

private:
  setfl() = default;

  struct sizes {
    std::size_t n_rho, n_r;
    double d_rho, d_r;
  };

  static double number(text::cursor& at, const std::string& what) {
    const std::string_view word = at.next_word_of_line();
    double value = 0;
    if (!text::parse_number(word, value)) at.refuse("expected " + what + ", found " + (word.empty() ? "the end of the line" : text::shown(word)));
    return value;
  }
  static std::size_t whole(text::cursor& at, const std::string& what, std::size_t low, std::size_t high) {
    const std::string_view word = at.next_word_of_line();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < low || value > high)
      at.refuse("expected " + what + ", a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ", found " +
                (word.empty() ? "the end of the line" : text::shown(word)));
    return value;
  }
  static double positive(text::cursor& at, const std::string& what) {
    const std::size_t line = at.line();
    const double value = number(at, what);
    if (!(value > 0)) at.refuse_at(line, "expected " + what + " > 0, found " + to_text(value));
    return value;
  }
  static std::vector<double> values(text::cursor& at, std::size_t n, const std::string& what) {
    std::vector<double> list;
    while (list.size() < n) {
      const std::string_view word = at.next_word();
      double value = 0;
      if (!text::parse_number(word, value))
        at.refuse("expected value " + std::to_string(list.size() + 1) + " of " + std::to_string(n) + " of " + what + ", found " +
                  (word.empty() ? "the end of the text" : text::shown(word)));
      list.push_back(value);
    }
    return list;
  }
  static void skip_line(text::cursor& at, const std::string& what) {
    std::string_view line;
    if (!at.next_line(line)) at.refuse("expected " + what + ", found the end of the text");
  }

  static std::vector<std::string> names(text::cursor& at) {
    std::vector<std::string> list(whole(at, "the number of elements", 1, 100));
    for (std::string& name : list) {
      name = at.next_word_of_line();
      if (name.empty()) at.refuse("expected " + std::to_string(list.size()) + " names of elements, found the end of the line");
    }
    return list;
  }
  static std::size_t chosen(const text::cursor& at, const std::vector<std::string>& list, std::string_view element) {
    std::string all;
    for (const std::string& name : list) all.append(all.empty() ? "" : ", ").append(name);
    if (element.empty() && list.size() > 1) at.refuse("holds several elements (" + all + "): say which one");
    const auto found = element.empty() ? list.begin() : std::find(list.begin(), list.end(), element);
    if (found == list.end()) at.refuse("holds no element " + text::shown(element) + ", it has " + all);
    return static_cast<std::size_t>(found - list.begin());
  }

  void parse_from(text::cursor at, std::string_view element) {
    for (int i = 1; i <= 3; ++i) skip_line(at, "comment line " + std::to_string(i) + " of 3");
    const auto list = names(at);
    const std::size_t wanted = chosen(at, list, element);
    element_ = list[wanted];
    skip_line(at, "the line with the tables' sizes");
    const std::size_t most = 10'000'000;
    sizes n{};
    n.n_rho = whole(at, "N_rho", 5, most);
    n.d_rho = positive(at, "d_rho");
    n.n_r = whole(at, "N_r", 5, most);
    n.d_r = positive(at, "d_r (angstrom)");
    reach_ = positive(at, "the cut-off (angstrom)");
    skip_line(at, "the line of element " + list[0]);
    for (std::size_t k = 0; k < list.size(); ++k) read_element(at, n, list[k], k == wanted);
    for (std::size_t i = 0; i < list.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        auto table = values(at, n.n_r, "r phi(r) of " + list[i] + "-" + list[j]);
        if (i == wanted && j == wanted) z_ = {n.d_r, std::move(table)};
      }
    if (const std::string_view more = at.next_word(); !more.empty())
      at.refuse("expected the end of the text after the last of " + std::to_string(n.n_r) + " values, found " + text::shown(more) +
                " (wrong N_rho or N_r, or a file of another style, such as adp or fs)");
    reach_ = std::min(reach_, z_.end());
  }

  void read_element(text::cursor& at, const sizes& n, const std::string& name, bool wanted) {
    while (at_blank_end(at)) skip_line(at, "the line of element " + name);
    const std::size_t line = at.line();
    number(at, "the atomic number of " + name);
    const double m = number(at, "the mass of " + name + " (u)"), a = number(at, "the lattice constant of " + name + " (angstrom)");
    const std::string crystal(at.next_word_of_line());
    if (crystal.empty()) at.refuse("expected the structure of " + name + " (fcc or bcc), found the end of the line");
    if (wanted) take(at, line, m, a, crystal);
    skip_line(at, "the embedding energy of " + name);
    auto F = values(at, n.n_rho, "F(rho) of " + name), f = values(at, n.n_r, "f(r) of " + name);
    if (wanted) F_ = {n.d_rho, std::move(F)}, f_ = {n.d_r, std::move(f)};
  }
  /// Is nothing left on this line?
  static bool at_blank_end(text::cursor at) {
    const std::size_t line = at.line();
    const std::string_view word = at.next_word();
    return !word.empty() && at.line() != line;
  }
  void take(const text::cursor& at, std::size_t line, double m, double a, std::string crystal) {
    if (!(m > 0)) at.refuse_at(line, "expected a mass > 0 u, found " + to_text(m));
    if (!(a > 0)) at.refuse_at(line, "expected a lattice constant > 0 angstrom, found " + to_text(a));
    std::transform(crystal.begin(), crystal.end(), crystal.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (crystal != "fcc" && crystal != "bcc") at.refuse_at(line, "expected the structure fcc or bcc, found " + text::shown(crystal));
    mass_ = m;
    lattice_constant_ = a;
    structure_ = crystal == "fcc" ? lattice::fcc : lattice::bcc;
  }

  std::string element_;
  double mass_ = 0, lattice_constant_ = 0, reach_ = 0; // u, angstrom, angstrom
  lattice structure_ = lattice::fcc;
  detail::uniform_spline F_, f_, z_; // F(rho), f(r), r phi(r)
};

static_assert(EmbeddedAtomPotential<setfl>);

/// Writes the potential's functions, with 17 digits, as they are (not cut): f and phi to (n_r - 1) d_r, which must cover reach().
/// r = 0 is taken at 1e-9 angstrom.
template <EmbeddedAtomPotential Potential>
void write_setfl(const Potential& potential, int n_rho, double d_rho, int n_r, double d_r, const std::string& path, const std::string& element = "Al",
                 int atomic_number = 13) {
  require(n_rho >= 5 && n_rho <= 10'000'000, "write_setfl n_rho", n_rho, "between 5 and 1e7");
  require(n_r >= 5 && n_r <= 10'000'000, "write_setfl n_r", n_r, "between 5 and 1e7");
  require(d_rho > 0, "write_setfl d_rho", d_rho, "> 0");
  require(d_r > 0, "write_setfl d_r", d_r, "> 0", "angstrom");
  require((n_r - 1) * d_r >= potential.reach() * (1 - 1e-12), "write_setfl (n_r - 1) d_r", (n_r - 1) * d_r,
          "at least the potential's reach, " + to_text(potential.reach()), "angstrom");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"), &std::fclose);
  if (!file) throw bad_parameter("file '" + path + "': cannot be written");
  bool good =
      std::fprintf(file.get(),
                   "Embedded-atom potential in setfl form, written by bolide\nF(rho) in eV, f(r), r phi(r) in eV angstrom\n\n1 %s\n",
                   element.c_str()) > 0;
  good = std::fprintf(file.get(), "%d %.17g %d %.17g %.17g\n", n_rho, d_rho, n_r, d_r, potential.reach()) > 0 && good;
  good = std::fprintf(file.get(), "%d %.17g %.17g %s\n", atomic_number, potential.mass(), potential.lattice_constant(),
                      name(potential.structure())) > 0 &&
         good;
  const auto table = [&](int n, const auto& value) {
    for (int i = 0; i < n; ++i) good = std::fprintf(file.get(), i % 4 == 3 || i == n - 1 ? "%.17g\n" : "%.17g ", value(i)) > 0 && good;
  };
  table(n_rho, [&](int i) { return potential.embedding(i * d_rho).value; });
  const auto r = [&](int i) { return i == 0 ? 1e-9 : i * d_r; };
  table(n_r, [&](int i) { return potential.density(r(i)).value; });
  table(n_r, [&](int i) { return r(i) * potential.pair(r(i)).value; });
  if (!good || std::fflush(file.get()) != 0) throw bad_parameter("file '" + path + "': cannot be written to its end");
}

} // namespace bolide::potential
