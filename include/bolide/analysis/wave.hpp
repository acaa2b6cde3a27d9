// SPDX-License-Identifier: MIT
// One nonlinear wave into one material, and where the waves into two materials meet: what impedance matching and Riemann's problem share.
//
// wave_curve(eos, rho, e) answers "what pressure does it take to change the speed of this material by push?":
//   push > 0   a shock, by the jump conditions (hugoniot: the largest us)         push < 0   a rarefaction, by the isentrope
// meet(left, u_left, right, u_right) finds the common velocity u* and pressure p* of two materials in contact:
//   p_left(u_left - u*) = p_right(u* - u_right)
// by a bracketed root in u*. The pressure on either side rises with its push, so that there is one answer while the curves are
// continuous; a shock that the equation of state cannot carry (hugoniot finds none) counts as infinite pressure.
// Each side has at most one wave. Composite waves (two shocks, a shock inside a fan) arise where p is not convex along the path, as across
// the melting jump of phase::paper or where c rises on expansion; they are looked for and reported (not_convex), not solved:
//   rarefaction  the characteristics must spread: d(u + c)/d ln V < 0 everywhere in the fan (fundamental derivative > 0)
//   shock        one root of the Hugoniot, us > c ahead, us - up < c behind (Lax), and no weaker shock of larger us (Liu, 24 samples)
// Separation: two rarefactions that do not meet in a stable state leave a gap. A gas fills it to density 0; condensed matter, which
// first holds in tension down to c^2 = 0 (no strength of a real material!), ends in a free surface of p = 0 at finite density.
// Cost: some 30 Hugoniots of 800 calls of the equation of state, and one isentrope of up to 1500 steps per side.
#pragma once

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/isentrope.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/eos/bracketed_root.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bolide::analysis {

enum class wave_kind { none, shock, rarefaction };
constexpr const char* name(wave_kind k) {
  constexpr const char* names[] = {"none", "shock", "rarefaction"};
  return names[static_cast<int>(k)];
}

/// ok: solved. vacuum: solved, with a gap between the materials. not_convex: the waves given satisfy their equations, but the true
/// answer is a composite wave. no_solution: the numbers are not to be used. Beside each but the first stands a sentence.
enum class wave_status { ok, vacuum, not_convex, no_solution };
constexpr const char* name(wave_status s) {
  constexpr const char* names[] = {"ok", "vacuum", "not_convex", "no_solution"};
  return names[static_cast<int>(s)];
}

/// A wave and the state behind it.
struct wave {
  wave_kind kind;
  double head, tail; // m/s, speeds of its front and rear edge; the same for a shock
  double velocity;   // m/s, of the material behind the wave
  double density;    // kg/m3, behind the wave
  double energy;     // J/kg
  double pressure;   // Pa
};

/// The waves that can run into one material. Holds a copy of the equation of state.
template <class Eos> class wave_curve {
  static_assert(EquationOfState<Eos>, "bolide: analysis::wave_curve needs an EquationOfState.");

public:
  static constexpr double infinite = 1e300; // Pa, stands for the pressure where no shock carries the push

  wave_curve(Eos eos, double rho, double e) : eos_(std::move(eos)), rho_(rho), e_(e) {
    require(rho > 0, "density ahead of a wave", rho, "> 0", "kg/m3");
    const auto at = eos_.evaluate(rho, e);
    require(at.sound_speed_squared > 0, "sound speed squared ahead of a wave", at.sound_speed_squared, "> 0 (a stable state)", "m2/s2");
    p_ = at.pressure;
    c_ = std::sqrt(at.sound_speed_squared);
    detail::isentrope_walk walk(eos_, rho, e, true);
    path_.push_back(walk.at());
    while (walk.advance(1e300)) path_.push_back(walk.at());
    if (walk.at().y > path_.back().y) path_.push_back(walk.at());
  }

  const Eos& eos() const { return eos_; }
  double density() const { return rho_; }
  double energy() const { return e_; }
  double pressure() const { return p_; }
  double sound_speed() const { return c_; }
  double impedance() const { return rho_ * c_; } // kg/(m2 s)

  /// The speed that expansion can give at most (m/s): into vacuum, or to where c^2 = 0.
  double largest_gain() const { return path_.back().u; }

  /// Pa; beyond the largest gain the pressure there, and infinity where no shock carries the push.
  double pressure_at(double push) const {
    if (push > weakest * c_) {
      const auto s = shock(push);
      return s ? s->pressure : infinite;
    }
    if (push >= -weakest * c_) return p_ + impedance() * push;
    return detail::pressure_at(eos_, at_gain(std::min(-push, largest_gain())));
  }

  std::optional<shock_state> shock(double push) const {
    std::optional<shock_state> found;
    detail::scan_hugoniot(eos_, rho_, e_, p_, push, [&](const shock_state& s) {
      found = s;
      return false;
    });
    return found;
  }

  /// The state of the rarefaction where the material has gained `gain` >= 0.
  detail::isentrope_point at_gain(double gain) const {
    return at([&](const detail::isentrope_point& a) { return a.u - gain; });
  }
  /// The state where the characteristic runs into the material ahead with speed w = c - gain (w <= c ahead).
  detail::isentrope_point at_characteristic(double w) const {
    return at([&](const detail::isentrope_point& a) { return w - characteristic(a); });
  }
  double characteristic(const detail::isentrope_point& a) const { return std::sqrt(std::max(detail::squared_speed_at(eos_, a), 0.0)) - a.u; }

  /// The push that leaves p = 0 behind the wave (a free surface), or the largest expansion where p never falls to 0.
  double free_surface_push() const {
    if (p_ > 0) return -at([&](const detail::isentrope_point& a) { return -detail::pressure_at(eos_, a); }).u;
    double high = -2 * p_ / impedance();
    while (pressure_at(high) < 0) high *= 2;
    return eos::bracketed_root([&](double push) { return pressure_at(push); }, 0, high);
  }

  /// The wave that changes the speed by push; its speeds are those into the material, which is at rest.
  wave wave_for(double push) const {
    if (push > weakest * c_) {
      const auto s = shock(push);
      if (!s) return {wave_kind::shock, std::nan(""), std::nan(""), push, std::nan(""), std::nan(""), infinite};
      return {wave_kind::shock, s->shock_speed, s->shock_speed, push, s->density, s->energy, s->pressure};
    }
    if (push >= -weakest * c_) return {wave_kind::none, c_, c_, push, rho_, e_, p_};
    const auto a = at_gain(std::min(-push, largest_gain()));
    return {wave_kind::rarefaction, c_, characteristic(a), -a.u, std::exp(-a.y), a.e, detail::pressure_at(eos_, a)};
  }

  /// A sentence where the wave for push cannot be simple; empty where it can.
  std::string loss_of_convexity(double push) const {
    if (push > weakest * c_) return shock_splits(push);
    if (push >= -weakest * c_) return {};
    double last = c_;
    for (const auto& a : path_) {
      if (a.u > -push) break;
      const double w = characteristic(a);
      if (w > last + 1e-7 * c_)
        return "the sound speed rises on expansion at density " + to_text(std::exp(-a.y)) + " kg/m3: the rarefaction holds a shock";
      last = w;
    }
    return {};
  }

private:
  static constexpr double weakest = 1e-8; // of c: below, a wave is an acoustic one to round-off
  /// Where f, negative at the start of the path, becomes positive: the path's end if it never does.
  template <class F> detail::isentrope_point at(const F& f) const {
    const auto beyond = std::find_if(path_.begin(), path_.end(), [&](const detail::isentrope_point& a) { return f(a) >= 0; });
    if (beyond == path_.end()) return path_.back();
    if (beyond == path_.begin()) return *beyond;
    const auto& from = *(beyond - 1);
    const detail::isentrope_scale any{1, 1};
    double error = 0;
    const auto ahead = [&](double h) { return detail::isentrope_step(eos_, from, h, any, error); };
    const double h = eos::bracketed_root([&](double length) { return f(ahead(length)); }, 0, beyond->y - from.y);
    return std::isfinite(h) ? ahead(h) : *beyond;
  }

  std::string shock_splits(double push) const {
    const auto all = hugoniot_all(eos_, rho_, e_, p_, push);
    if (all.size() > 1) return "the Hugoniot has " + std::to_string(all.size()) + " shocks of this strength (the one of largest speed is taken)";
    if (all.empty()) return {};
    const shock_state& s = all.front();
    constexpr double slack = 1e-6; // of the speeds: what round-off does to a weak shock
    for (int i = 1; i < 24; ++i) {
      const auto weaker = shock(push * i / 24);
      if (weaker && weaker->shock_speed > s.shock_speed * (1 + slack))
        return "a weaker shock (up " + to_text(weaker->particle_speed) + " m/s) runs ahead: the shock splits in two or spreads";
    }
    if (s.shock_speed < c_ * (1 - slack)) return "the shock is slower than sound ahead of it: it spreads into a compression fan";
    const double behind = std::sqrt(std::max(eos_.evaluate(s.density, s.energy).sound_speed_squared, 0.0));
    if (s.shock_speed - push > behind * (1 + slack)) return "the shock runs away from sound behind it: nothing holds it together";
    return {};
  }

  Eos eos_;
  double rho_, e_, p_ = 0, c_ = 0;
  std::vector<detail::isentrope_point> path_; // the expansion, step by step
};

/// Two materials in contact, after their waves have parted.
struct meeting {
  double velocity;  // m/s, of the contact; NaN where they have separated
  double pressure;  // Pa, at the contact; 0 where they have separated
  wave left, right; // in the frame of u_left and u_right
  wave_status status;
  std::string message; // a sentence unless status is ok
};

namespace detail {
/// Into the common frame: the left wave runs to the left.
inline wave in_frame(wave w, double sign, double u) {
  w.head = u + sign * w.head;
  w.tail = u + sign * w.tail;
  w.velocity = u + sign * w.velocity;
  return w;
}

template <class L, class R> meeting separated(const wave_curve<L>& left, double u_left, const wave_curve<R>& right, double u_right) {
  const double push_left = left.free_surface_push(), push_right = right.free_surface_push();
  const auto text = [](double from, double to) { return to < 1e-6 * from ? "fills it to density 0" : "has a free surface"; };
  meeting m{std::nan(""), 0, in_frame(left.wave_for(push_left), -1, u_left), in_frame(right.wave_for(push_right), 1, u_right),
            wave_status::vacuum, {}};
  m.message = std::string("the materials separate and leave a gap: the left one ") + text(left.density(), m.left.density) + ", the right one " +
              text(right.density(), m.right.density);
  if (u_left - push_left > u_right + push_right) {
    m.status = wave_status::no_solution;
    m.message = "no common pressure within what the equations of state hold in tension, and free surfaces would overlap";
  }
  return m;
}
} // namespace detail

/// The contact of two materials that stand side by side at speeds u_left and u_right (m/s).
template <class L, class R> meeting meet(const wave_curve<L>& left, double u_left, const wave_curve<R>& right, double u_right) {
  const auto excess = [&](double u) { return left.pressure_at(u_left - u) - right.pressure_at(u - u_right); }; // falls with u
  const double lowest = u_right - right.largest_gain(), highest = u_left + left.largest_gain();
  if (!(lowest < highest)) return detail::separated(left, u_left, right, u_right);
  // From the acoustic answer outwards until the excess changes sign, within what the rarefactions can give.
  const double acoustic = (left.impedance() * u_left + right.impedance() * u_right + left.pressure() - right.pressure()) /
                          (left.impedance() + right.impedance());
  double a = std::clamp(acoustic, lowest, highest), f = excess(a), b = a, step = 1e-3 * (left.sound_speed() + right.sound_speed());
  const bool up = f > 0;
  for (double g = f; f != 0 && (g > 0) == up; step *= 2) {
    a = b;
    b = up ? std::min(b + step, highest) : std::max(b - step, lowest);
    g = excess(b);
    if ((g > 0) == up && (b == lowest || b == highest)) return detail::separated(left, u_left, right, u_right);
  }
  const double u = f == 0 ? a : eos::bracketed_root(excess, a, b);
  const double push_left = u_left - u, push_right = u - u_right;
  meeting m{u, left.pressure_at(push_left), detail::in_frame(left.wave_for(push_left), -1, u_left),
            detail::in_frame(right.wave_for(push_right), 1, u_right), wave_status::ok, {}};
  const double soft = std::min(left.impedance() * left.sound_speed(), right.impedance() * right.sound_speed());
  if (!(m.pressure < wave_curve<L>::infinite && std::abs(excess(u)) <= 1e-7 * (std::abs(m.pressure) + soft))) {
    m.status = wave_status::no_solution;
    m.message = "no common pressure: at velocity " + to_text(u) + " m/s the pressure jumps, or an equation of state carries no such shock";
    return m;
  }
  std::string lost = left.loss_of_convexity(push_left);
  if (!lost.empty()) lost = "left wave: " + lost;
  const std::string right_lost = right.loss_of_convexity(push_right);
  if (!right_lost.empty()) lost += (lost.empty() ? "right wave: " : "; right wave: ") + right_lost;
  if (!lost.empty()) m.status = wave_status::not_convex, m.message = lost;
  return m;
}

} // namespace bolide::analysis
