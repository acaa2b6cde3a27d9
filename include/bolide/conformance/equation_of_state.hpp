// SPDX-License-Identifier: MIT
// The conformance suite of the role "equation of state": what any model must do, the library's or a user's, measured.
//
//   const auto report = bolide::conformance::check(my_eos{});
//   std::cout << report;
//   return report.passed() ? 0 : 1;
//
// Over 1e-6 <= rho/rho0 <= 5 and -1 <= e <= 1e4 MJ/kg, unless the options say otherwise:
//   finite              no answer is NaN or infinite
//   sound_speed         c^2 = p_rho + p p_e/rho^2, which is dp/drho along (1, p/rho^2), against difference quotients of p
//   pressure_energy     dp/de against difference quotients, where the model gives it
//   temperature_energy  dT/de likewise
//   continuation        the same three outside the stated validity and below cold_energy, where a model goes on by its documented continuation
//   maxwell             (de/dV)_T = T (dp/dT)_V - p, in the form d ln T/d ln rho = (dp/de)/rho along an isentrope, which holds where
//                       solid and liquid coexist too; T > 1 K, inside the stated validity
//   pressure_jump       p is continuous over every border inside the domain, stated or not: jumps are looked for in every grid interval,
//   temperature_jump    at every change of region, and at the model's own energy_borders(rho) and density_borders(), if it has them
//   monotone_pressure   p rises with rho at constant e >= 0 for rho >= rho0, up to a pole or guard and through it
//   stability           c^2 >= 0 for rho >= rho0, e >= 0; in expansion the extent of c^2 < 0 (the spinodal) is reported
//   thin_limit          at rho/rho0 = 1e-6 p/rho and c^2 are of the order of the energies that are there
//   cold_limit          T = 0 at e = cold_energy and T < 0 below
//   hugoniot            mass, momentum and energy over three shocks, with the model's own p behind them
//   shock_stability     us > c ahead and us - up < c behind
//   release             analysis::release_isentrope from these shocks against an independent Runge-Kutta integration in rho
//   lane ...            every lane type gives the scalar's answer, on random points that mix the branches within a pack
//   lane continuation   the same where a continuation answers
// Inside the stated validity (eos/validity.hpp; a model without one has all of rho > 0): the derivatives, maxwell, monotone_pressure, stability
// and the two limits. All others wherever the model answers.
// A violation that is known is stated, with its size and its reason:  check(eos, {.stated = {{"maxwell", 0.3, "constant G'"}}}).
// Cost: about two million calls of evaluate(); a second or less for a model of the time loop.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/release_isentrope.hpp"
#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/conformance/difference.hpp"
#include "bolide/conformance/report.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/validity.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace bolide::conformance {

struct equation_of_state_options {
  std::string name = "equation of state";                          // printed above the table
  double lowest_density_ratio = 1e-6, highest_density_ratio = 5;   // of reference_density()
  double lowest_energy = -1e6, highest_energy = 1e10;              // J/kg
  int densities = 80, energies = 48;                               // of the grid
  std::optional<eos::material_state> initial = {};                 // ahead of the shocks; default: ambient, or cold if there is none
  std::vector<stated_violation> stated = {};
};

namespace detail {

/// All that a point may hold, in double; what a model has not stays 0.
struct eos_sample {
  double pressure = 0, sound_speed_squared = 0, pressure_energy = 0, temperature = 0, melting_temperature = 0, melt_fraction = 0;
  double cold_energy = 0, region = 0, temperature_energy = 0;
};
template <class Point> eos_sample sample_of(const Point& p, int i = 0) {
  eos_sample s;
  s.pressure = static_cast<double>(lane(p.pressure, i));
  s.sound_speed_squared = static_cast<double>(lane(p.sound_speed_squared, i));
  if constexpr (requires { p.pressure_energy; }) s.pressure_energy = static_cast<double>(lane(p.pressure_energy, i));
  if constexpr (requires { p.temperature; }) s.temperature = static_cast<double>(lane(p.temperature, i));
  if constexpr (requires { p.melting_temperature; }) s.melting_temperature = static_cast<double>(lane(p.melting_temperature, i));
  if constexpr (requires { p.melt_fraction; }) s.melt_fraction = static_cast<double>(lane(p.melt_fraction, i));
  if constexpr (requires { p.cold_energy; }) s.cold_energy = static_cast<double>(lane(p.cold_energy, i));
  if constexpr (requires { p.region; }) s.region = static_cast<double>(lane(p.region, i));
  if constexpr (requires { p.temperature_energy; }) s.temperature_energy = static_cast<double>(lane(p.temperature_energy, i));
  return s;
}
inline bool finite(const eos_sample& s) {
  return std::isfinite(s.pressure) && std::isfinite(s.sound_speed_squared) && std::isfinite(s.pressure_energy) && std::isfinite(s.temperature) &&
         std::isfinite(s.melting_temperature) && std::isfinite(s.melt_fraction) && std::isfinite(s.cold_energy) && std::isfinite(s.region) &&
         std::isfinite(s.temperature_energy);
}
/// Largest deviation of `a` from `b` at (rho, e), each member against the size of the terms that it is made of.
inline double deviation(const eos_sample& a, const eos_sample& b, double rho, double e) {
  const double speed2 = std::abs(b.sound_speed_squared) + std::abs(b.pressure) / rho + std::abs(e) + std::abs(b.cold_energy);
  double worst = 0;
  const auto compare = [&](double x, double y, double scale) {
    const double off = std::abs(x - y) / (std::abs(y) + scale + 1e-300);
    worst = off <= worst ? worst : off; // NaN stays
  };
  compare(a.pressure, b.pressure, rho * speed2);
  compare(a.sound_speed_squared, b.sound_speed_squared, speed2);
  compare(a.pressure_energy, b.pressure_energy, rho);
  compare(a.temperature, b.temperature, 1 + speed2 * std::abs(b.temperature_energy));
  compare(a.melting_temperature, b.melting_temperature, 1);
  compare(a.melt_fraction, b.melt_fraction, 1);
  compare(a.cold_energy, b.cold_energy, speed2);
  compare(a.region, b.region, 0);
  compare(a.temperature_energy, b.temperature_energy, 0);
  return worst;
}

template <class Eos> class equation_of_state_suite {
public:
  equation_of_state_suite(const Eos& eos, const equation_of_state_options& options) : eos_(eos), o_(options), rho0_(eos.reference_density()) {
    require(std::isfinite(rho0_) && rho0_ > 0, "conformance reference density", rho0_, "> 0", "kg/m3");
    require(o_.lowest_density_ratio > 0 && o_.lowest_density_ratio < 1 && o_.highest_density_ratio > 1, "conformance density ratios",
            o_.lowest_density_ratio, "lowest between 0 and 1, highest above 1");
    require(o_.highest_energy > o_.lowest_energy, "conformance highest energy", o_.highest_energy, "above the lowest", "J/kg");
    require(o_.densities >= 10 && o_.energies >= 10, "conformance grid", std::min(o_.densities, o_.energies), "at least 10 x 10");
    report_.subject = o_.name;
    make_grid();
    find_initial_state();
  }

  report run() {
    finiteness();
    derivatives();
    jumps();
    compression();
    limits();
    shocks();
    measure continuation = start("lane continuation", 1);
    lanes<float>("lane float", continuation);
    lanes<pack<double, 2>>("lane pack<double, 2>", continuation);
    lanes<pack<double, 4>>("lane pack<double, 4>", continuation);
    lanes<pack<double, 8>>("lane pack<double, 8>", continuation);
    lanes<pack<float, 4>>("lane pack<float, 4>", continuation);
    lanes<pack<float, 8>>("lane pack<float, 8>", continuation);
    lanes<pack<float, 16>>("lane pack<float, 16>", continuation);
    close(continuation, "in units of the bound of each type");
    require_known_checks(report_, o_.stated);
    return report_;
  }

private:
  static constexpr bool has_pressure_energy = requires(const Eos q, double x) { q.evaluate(x, x).pressure_energy; };
  static constexpr bool has_temperature = ThermalEquationOfState<Eos>;

  // ---- the grid and the state ahead of the shocks --------------------------------------------------------------------------------
  /// Densities: a quarter of them evenly in ln rho up to 0.3 rho0, the others from there on, rho0 itself among them. Energies: evenly
  /// in asinh(e/100 kJ/kg).
  void make_grid() {
    const auto spread = [&](double from, double to, int n) {
      for (int i = 0; i < n; ++i) rho_.push_back(rho0_ * from * std::pow(to / from, (i + 0.5) / n));
    };
    const double dense = std::max(0.3, o_.lowest_density_ratio);
    rho_.push_back(rho0_ * o_.lowest_density_ratio);
    if (dense > o_.lowest_density_ratio) spread(o_.lowest_density_ratio, dense, o_.densities / 4);
    spread(dense, 1, o_.densities / 4);
    rho_.push_back(rho0_);
    spread(1, o_.highest_density_ratio, o_.densities / 2);
    rho_.push_back(rho0_ * o_.highest_density_ratio);
    const double unit = 1e5, low = std::asinh(o_.lowest_energy / unit), high = std::asinh(o_.highest_energy / unit);
    for (int i = 0; i < o_.energies; ++i) e_.push_back(unit * std::sinh(low + (high - low) * i / (o_.energies - 1)));
  }

  void find_initial_state() {
    initial_ = o_.initial;
    try {
      if (!initial_) initial_ = eos::ambient_state(eos_);
    } catch (const bad_parameter&) { // no state of p = 0: a gas
    }
    for (double e = 0; !initial_ && e < 1e8; e = e == 0 ? 1e4 : 10 * e)
      if (eos_.evaluate(rho0_, e).sound_speed_squared > 0) initial_ = eos::state_at(eos_, rho0_, e);
    c2_ = initial_ ? initial_->sound_speed * initial_->sound_speed : 1e6;
  }

  // ---- help ----------------------------------------------------------------------------------------------------------------------
  eos_sample at(double rho, double e) const { return sample_of(eos_.evaluate(rho, e)); }
  bool outside(double rho, double e) const { return eos::outside_of(eos_, rho, e); }
  /// By the model itself, and not by a continuation: inside the stated validity and not below the cold energy.
  bool answers(const eos_sample& s, double rho, double e) const { return !outside(rho, e) && !(has_temperature && e < s.cold_energy); }
  /// Of a pressure: what it is made of.
  double pressure_scale(const eos_sample& s, double rho, double e) const {
    return std::abs(s.pressure) + rho * (std::abs(s.sound_speed_squared) + std::abs(e) + 1e-9 * c2_);
  }
  measure start(const char* check, double bound) const { return {check, bound, o_.stated}; }
  void close(const measure& m, std::string note = "") {
    const auto where = [](double ratio, double e) { return "rho/rho0 " + short_text(ratio) + ", e " + short_text(e / 1e6) + " MJ/kg"; };
    report_.findings.push_back(m.close(where, std::move(note)));
  }

  // ---- the checks ----------------------------------------------------------------------------------------------------------------
  void finiteness() {
    measure bad = start("finite", 0);
    std::size_t count = 0;
    for (const double rho : rho_)
      for (const double e : e_) {
        const bool good = finite(at(rho, e));
        count += good ? 0 : 1;
        bad.add(good ? 0 : 1, rho / rho0_, e);
      }
    close(bad, std::to_string(count) + " of " + std::to_string(bad.points()) + " answers are NaN or infinite");
  }

  void derivatives() {
    measure sound = start("sound_speed", derivative_bound), pressure_energy = start("pressure_energy", derivative_bound);
    measure temperature_energy = start("temperature_energy", derivative_bound), maxwell = start("maxwell", derivative_bound);
    measure continuation = start("continuation", derivative_bound);
    std::size_t beside_border = 0;
    double maxwell_pascal = 0;
    for (const double rho : rho_)
      for (const double e : e_) {
        const eos_sample s = at(rho, e);
        const auto m = sound_speed_error(s, rho, e);
        const bool valid = answers(s, rho, e);
        (valid ? sound : continuation).add(m.error, rho / rho0_, e);
        beside_border += m.one_sided && m.error <= derivative_bound ? 1 : 0;
        if constexpr (has_pressure_energy) (valid ? pressure_energy : continuation).add(pressure_energy_error(s, rho, e), rho / rho0_, e);
        if constexpr (has_temperature) {
          (valid ? temperature_energy : continuation).add(temperature_energy_error(s, rho, e), rho / rho0_, e);
          if (!(s.temperature > 1) || !valid) continue;
          const double off = maxwell_error(s, rho, e);
          maxwell.add(off / (s.temperature * (1 + std::abs(s.pressure_energy) / rho)), rho / rho0_, e);
          if (s.temperature_energy > 0) maxwell_pascal = std::max(maxwell_pascal, off * rho / s.temperature_energy);
        }
      }
    close(sound, std::to_string(beside_border) + " of " + std::to_string(rho_.size() * e_.size()) + " points lie beside a border: one-sided");
    close(pressure_energy, has_pressure_energy ? "" : "the model gives no dp/de");
    close(temperature_energy, has_temperature ? "" : no_temperature);
    close(continuation, continuation.points() == 0 ? "the stated validity covers the domain" : "derivatives outside the validity or below the cold energy");
    close(maxwell, !has_temperature        ? std::string(no_temperature)
                   : maxwell.points() == 0 ? std::string("no point with T > 1 K inside the validity")
                                           : "|T dp/dT - p - de/dV| at most " + short_text(maxwell_pascal / 1e9) + " GPa");
  }
  difference_match sound_speed_error(const eos_sample& s, double rho, double e) const {
    const auto along = [&](double h) { return at(rho * (1 + h), e + h * s.pressure / rho).pressure; };
    const double scale = pressure_scale(s, rho, e), enough = 1e-3 * derivative_bound * scale;
    auto m = derivative_error(along, rho * s.sound_speed_squared, {1e-2, 1e-3, 1e-4, 1e-5}, enough);
    if constexpr (requires { eos_.least_sound_speed_squared(); }) { // a floored model: right if it is the floor and the raw one lies below
      const double floor = eos_.least_sound_speed_squared();
      if (s.sound_speed_squared == floor && central_quotient(along, 1e-3) < rho * floor) return {0, false};
    }
    if constexpr (has_pressure_energy) // p/rho may be so large that no step along the isentrope is small in e: then dp/drho, with dp/de
      if (!(m.error <= derivative_bound * scale)) {
        const double slope = rho * s.sound_speed_squared - s.pressure * s.pressure_energy / rho;
        const auto r = derivative_error([&](double h) { return at(rho * (1 + h), e).pressure; }, slope, {1e-2, 1e-3, 1e-4, 1e-5}, enough);
        if (r.error < m.error) m = r;
      }
    m.error /= scale;
    return m;
  }
  double pressure_energy_error(const eos_sample& s, double rho, double e) const {
    const double round_off = 1e-6 * std::abs(s.pressure) / energy_size(e); // of the quotients, over the bound
    return energy_derivative_error(&eos_sample::pressure, s.pressure_energy, std::abs(s.pressure_energy) + rho + round_off, rho, e);
  }
  double temperature_energy_error(const eos_sample& s, double rho, double e) const {
    const double scale = std::abs(s.temperature_energy) + temperature_energy_scale();
    return energy_derivative_error(&eos_sample::temperature, s.temperature_energy, scale, rho, e);
  }
  double energy_size(double e) const { return std::abs(e) + 1e-9 * c2_; }
  double energy_derivative_error(double eos_sample::*member, double claimed, double scale, double rho, double e) const {
    const double size = energy_size(e);
    const auto along = [&](double h) { return at(rho, e + h).*member; };
    return derivative_error(along, claimed, {1e-2 * (size + 0.01 * c2_), 1e-2 * size, 1e-3 * size, 1e-4 * size},
                            1e-3 * derivative_bound * scale).error / scale;
  }
  /// |dT/d ln rho along the isentrope - Gamma T|, K.
  double maxwell_error(const eos_sample& s, double rho, double e) const {
    const auto along = [&](double h) { return at(rho * (1 + h), e + h * s.pressure / rho).temperature; };
    return derivative_error(along, s.temperature * s.pressure_energy / rho, {1e-2, 1e-3, 1e-4, 1e-5}, 1e-3 * derivative_bound * s.temperature).error;
  }
  double temperature_energy_scale() const { return initial_ ? std::abs(at(initial_->density, initial_->energy).temperature_energy) : 1e-3; }

  struct jump_search {
    double eos_sample::*member;
    measure found;
    double largest = 0; // Pa or K
    std::size_t places = 0;
  };
  double jump_scale(const jump_search& j, const eos_sample& s, double rho, double e) const {
    return j.member == &eos_sample::pressure ? pressure_scale(s, rho, e) : std::abs(s.temperature) + 100;
  }
  /// Along a line from (rho_a, e_a) to (rho_b, e_b), one of which does not change.
  void look(jump_search& j, double rho_a, double e_a, double rho_b, double e_b) const {
    const bool in_energy = rho_a == rho_b;
    const auto value = [&](double s) { return in_energy ? at(rho_a, s) : at(s, e_a); };
    double low = in_energy ? e_a : rho_a, high = in_energy ? e_b : rho_b;
    const eos_sample a = value(low), b = value(high);
    const double scale = std::max(jump_scale(j, a, rho_a, e_a), jump_scale(j, b, rho_b, e_b));
    const auto take = [&](double size, double where) {
      j.found.add(size / scale, (in_energy ? rho_a : where) / rho0_, in_energy ? where : e_a);
      j.largest = std::max(j.largest, size);
      j.places += size > j.found.bound() * scale ? 1 : 0;
    };
    const jump f = find_jump([&](double s) { return value(s).*(j.member); }, low, high, j.found.bound() * scale);
    take(f.size, f.size > 0 ? f.at : low);
    if (a.region == b.region) return;
    for (int i = 0; i < 200 && low < high; ++i) { // to the change of region itself
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (value(middle).region == a.region ? low : high) = middle;
    }
    if (f.size == 0) take(std::abs(value(high).*(j.member) - value(low).*(j.member)), low);
  }
  void look_everywhere(jump_search& j) const {
    const double beside = 1e-9;
    for (const double rho : rho_) {
      for (std::size_t i = 0; i + 1 < e_.size(); ++i) look(j, rho, e_[i], rho, e_[i + 1]);
      if constexpr (requires { eos_.energy_borders(rho); })
        for (const double e : eos_.energy_borders(rho))
          if (e > o_.lowest_energy && e < o_.highest_energy) look(j, rho, e - beside * std::abs(e), rho, e + beside * std::abs(e));
    }
    for (const double e : e_) {
      for (std::size_t i = 0; i + 1 < rho_.size(); ++i) look(j, rho_[i], e, rho_[i + 1], e);
      if constexpr (requires { eos_.density_borders(); })
        for (const double rho : eos_.density_borders())
          if (rho > rho_.front() && rho < rho_.back()) look(j, rho * (1 - beside), e, rho * (1 + beside), e);
    }
  }
  void jumps() {
    jump_search p{&eos_sample::pressure, start("pressure_jump", pressure_jump_bound)};
    look_everywhere(p);
    close(p.found, jump_note(p, 1e9, " GPa"));
    jump_search t{&eos_sample::temperature, start("temperature_jump", temperature_jump_bound)};
    if constexpr (has_temperature) look_everywhere(t);
    close(t.found, has_temperature ? jump_note(t, 1, " K") : std::string(no_temperature));
  }
  static std::string jump_note(const jump_search& j, double unit, const char* name) {
    return j.places == 0 ? std::string() : "seen " + std::to_string(j.places) + " times, at most " + short_text(j.largest / unit) + name;
  }

  /// p over rho at constant e, in steps fine enough to meet a pole; c^2 in compression and in expansion.
  void compression() {
    measure falls = start("monotone_pressure", 1e-12), unstable = start("stability", 0);
    const int steps = 2000;
    for (std::size_t k = 0; k < e_.size(); k += 3) {
      const double e = std::max(e_[k], 0.0);
      double last = std::nan("");
      for (int i = 0; i <= steps; ++i) {
        const double rho = rho0_ * std::pow(o_.highest_density_ratio, double(i) / steps);
        if (outside(rho, e)) {
          last = std::nan("");
          continue;
        }
        const eos_sample s = at(rho, e);
        unstable.add(std::max(-s.sound_speed_squared / c2_, 0.0), rho / rho0_, e);
        if (!std::isnan(last)) falls.add(std::max((last - s.pressure) / pressure_scale(s, rho, e), 0.0), rho / rho0_, e);
        last = s.pressure;
      }
    }
    close(falls, falls.points() == 0 ? "no state of rho >= rho0, e >= 0 inside the validity" : "");
    close(unstable, unstable.points() == 0 ? "no state of rho >= rho0, e >= 0 inside the validity" : spinodal());
  }
  std::string spinodal() const {
    double low = std::numeric_limits<double>::infinity(), high = 0, energy = -low;
    for (const double rho : rho_)
      for (const double e : e_) {
        const eos_sample s = at(rho, e);
        if (!(rho < rho0_) || !(s.sound_speed_squared < 0) || (has_temperature && !(s.temperature >= 0)) || outside(rho, e)) continue;
        low = std::min(low, rho), high = std::max(high, rho), energy = std::max(energy, e);
      }
    if (high == 0) return "no c^2 < 0 in expansion";
    return "spinodal in expansion: rho/rho0 " + short_text(low / rho0_) + " to " + short_text(high / rho0_) + ", e up to " +
           short_text(energy / 1e6) + " MJ/kg";
  }

  void limits() {
    measure thin = start("thin_limit", 100), cold = start("cold_limit", 1e-6);
    const double rho = rho0_ * o_.lowest_density_ratio;
    for (const double e : e_)
      if (!outside(rho, e)) {
        const eos_sample s = at(rho, e);
        thin.add(std::max(std::abs(s.pressure) / rho, std::abs(s.sound_speed_squared)) / (std::abs(e) + c2_), rho / rho0_, e);
      }
    close(thin, thin.points() == 0 ? "outside the stated validity" : "max(p/rho, |c^2|)/(|e| + c0^2)");
    if constexpr (has_temperature)
      for (const double r : rho_) {
        const double e_c = at(r, 0).cold_energy, above = at(r, e_c + 1e6).temperature;
        if (outside(r, e_c)) continue;
        cold.add(std::abs(at(r, e_c).temperature) / above, r / rho0_, e_c);
        for (const double below : {1e3, 1e5, 1e7, 1e9}) cold.add(at(r, e_c - below).temperature < 0 ? 0 : 1, r / rho0_, e_c - below);
      }
    close(cold, !has_temperature ? no_temperature : cold.points() == 0 ? "cold_energy lies outside the stated validity" : "");
  }

  // ---- shocks and releases -------------------------------------------------------------------------------------------------------
  void shocks() {
    measure jump_conditions = start("hugoniot", 1e-9), stable = start("shock_stability", 1), release = start("release", 1e-6);
    std::string why_none = initial_ ? "" : "no state of c^2 > 0 found to start from", why_no_release = why_none;
    double reference_error = 0;
    if (initial_)
      for (const double mach : {0.1, 0.3, 1.0}) {
        const double c0 = initial_->sound_speed, up = mach * c0;
        try {
          const auto s = analysis::hugoniot(eos_, *initial_, up);
          shock(s, jump_conditions, stable);
          follow_release(s, release, reference_error, why_no_release);
        } catch (const bad_parameter& refused) { // no shock of that strength: the role does not promise one inside a model's range
          why_none = refused.what();
        }
      }
    if (!why_none.empty() && why_no_release.empty()) why_no_release = why_none;
    close(jump_conditions, why_none);
    close(stable, why_none);
    if (reference_error > 1e-9 && why_no_release.empty()) why_no_release = "the reference itself is known to " + short_text(reference_error);
    close(release, why_no_release);
  }
  void shock(const analysis::shock_state& s, measure& conditions, measure& stable) const {
    const eos_sample b = at(s.density, s.energy);
    const double rho0 = initial_->density, p0 = initial_->pressure, us = s.shock_speed, up = s.particle_speed;
    const double mass = s.density * (us - up) / (rho0 * us) - 1;
    const double momentum = (b.pressure - p0) / (rho0 * us * up) - 1;
    const double energy = (s.energy - initial_->energy - 0.5 * (b.pressure + p0) * (1 / rho0 - 1 / s.density)) / (0.5 * up * up);
    conditions.add(std::max({std::abs(mass), std::abs(momentum), std::abs(energy)}), s.density / rho0_, s.energy);
    stable.add(std::max(initial_->sound_speed / us, (us - up) / std::sqrt(std::max(b.sound_speed_squared, 0.0))), s.density / rho0_, s.energy);
  }

  struct path {
    double energy, speed;
  };
  /// de = p/rho^2 drho, du = -c/rho drho in n equal steps of rho, 4th order.
  path runge_kutta(double rho, double e, double rho_end, int n) const {
    const double h = (rho_end - rho) / n;
    path y{e, 0};
    const auto rate = [&](double r, double energy) {
      const auto s = eos_.evaluate(r, energy);
      return path{s.pressure / (r * r), -std::sqrt(std::max(s.sound_speed_squared, 0.0)) / r};
    };
    for (int i = 0; i < n; ++i) {
      const double r = rho + h * i;
      const path a = rate(r, y.energy), b = rate(r + h / 2, y.energy + h / 2 * a.energy), c = rate(r + h / 2, y.energy + h / 2 * b.energy);
      const path d = rate(r + h, y.energy + h * c.energy);
      y.energy += h / 6 * (a.energy + 2 * b.energy + 2 * c.energy + d.energy);
      y.speed += h / 6 * (a.speed + 2 * b.speed + 2 * c.speed + d.speed);
    }
    return y;
  }
  /// To the pressure ahead of the shock. Steps are doubled until two answers agree to 1e-10 or there are 65536 (a jump on the way).
  void follow_release(const analysis::shock_state& s, measure& m, double& reference_error, std::string& why_none) const {
    analysis::released_state end;
    try {
      end = analysis::release_isentrope(eos_, s.density, s.energy, initial_->pressure);
    } catch (const bad_parameter& refused) {
      why_none = refused.what();
      return;
    }
    const double scale_e = std::abs(end.energy - s.energy), scale_u = end.speed_gain;
    path coarse = runge_kutta(s.density, s.energy, end.density, 128);
    double error = 1;
    for (int n = 256; n <= 65536 && error > 1e-10; n *= 2) {
      const path fine = runge_kutta(s.density, s.energy, end.density, n);
      error = std::max(std::abs(fine.energy - coarse.energy) / scale_e, std::abs(fine.speed - coarse.speed) / scale_u);
      coarse = fine;
    }
    const double off = std::max(std::abs(end.energy - coarse.energy) / scale_e, std::abs(end.speed_gain - coarse.speed) / scale_u);
    reference_error = std::max(reference_error, error);
    m.add(std::max(off - error, 0.0), s.density / rho0_, s.energy);
  }

  // ---- lanes ---------------------------------------------------------------------------------------------------------------------
  template <class V> void lanes(const char* check, measure& continuation) {
    measure m = start(check, sizeof(scalar_t<V>) == 8 ? double_lane_bound : float_lane_bound);
    if constexpr (EquationOfState<Eos, V>) {
      using T = scalar_t<V>;
      std::mt19937 random(1);
      std::uniform_real_distribution<double> thin(std::log(rho_.front()), std::log(rho_.back())), dense(std::log(0.5 * rho0_), std::log(2 * rho0_));
      std::uniform_real_distribution<double> place(std::asinh(o_.lowest_energy / 1e5), std::asinh(o_.highest_energy / 1e5));
      for (int n = 0; n < 4096 / lane_width<V>; ++n) {
        T rho[lane_width<V>], e[lane_width<V>];
        for (int i = 0; i < lane_width<V>; ++i) {
          rho[i] = static_cast<T>(std::exp((n + i) % 2 == 0 ? thin(random) : dense(random)));
          e[i] = static_cast<T>(1e5 * std::sinh(place(random)));
        }
        const V many_rho = load<V>(rho), many_e = load<V>(e);
        const auto many = eos_.evaluate(many_rho, many_e);
        for (int i = 0; i < lane_width<V>; ++i) {
          const double r = static_cast<double>(rho[i]), energy = static_cast<double>(e[i]), off = lane_error<T>(sample_of(many, i), r, energy);
          if (answers(at(r, energy), r, energy)) m.add(off, r / rho0_, energy);
          else continuation.add(off / m.bound(), r / rho0_, energy);
        }
      }
    }
    close(m, EquationOfState<Eos, V> ? "" : "evaluate() does not take this type");
  }
  /// Against the scalar's answer there, or some round-offs beside: within that distance of a border a lane may take the other branch.
  template <class T> double lane_error(const eos_sample& one, double rho, double e) const {
    if (!finite(one)) return std::nan("");
    const double eps = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const eos_sample here = at(rho, e);
    double least = deviation(one, here, rho, e);
    const double de = eps * (std::abs(e) + std::abs(here.cold_energy));
    for (const double dr : {-eps, 0.0, eps})
      for (const double d : {-de, 0.0, de})
        if (least > 1e-7 * eps) least = std::min(least, deviation(one, at(rho * (1 + dr), e + d), rho, e));
    return least;
  }

  static constexpr double derivative_bound = 1e-6, pressure_jump_bound = 1e-6, temperature_jump_bound = 1e-5;
  static constexpr double double_lane_bound = 1e-12, float_lane_bound = 5e-4;
  static constexpr const char* no_temperature = "the model gives no temperature";

  const Eos& eos_;
  const equation_of_state_options& o_;
  double rho0_, c2_ = 0;                        // kg/m3; m2/s2, of the initial state
  std::optional<eos::material_state> initial_;
  std::vector<double> rho_, e_;                 // kg/m3, J/kg
  report report_;
};

} // namespace detail

template <EquationOfState Eos> report check(const Eos& eos, const equation_of_state_options& options = {}) {
  return detail::equation_of_state_suite<Eos>(eos, options).run();
}

} // namespace bolide::conformance
