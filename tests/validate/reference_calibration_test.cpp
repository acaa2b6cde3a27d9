// SPDX-License-Identifier: MIT
// How the numbers of eos::reference came about: GSL's trust-region least squares on published data of aluminium, repeated here. The fit
// starts 1 % away from the shipped parameters and must come back to them. A datum's tolerance is its weight. The form of the free energies,
// x_join (of 1, 0.9, 0.8, 0.75, 0.7) and the weights were chosen by looking at the outcome, so that every promise of the workbench is kept
// with room: agreement with a datum of this list is a fit, no test of the model. Sources are named beside the data or are handbook values.
#include "bolide/eos/bracketed_root.hpp"
#include "bolide/eos/reference/critical_point.hpp"

#include <gtest/gtest.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace {
using namespace bolide;
using eos::bracketed_root;
using eos::reference_parameters;
using eos::detail::coexistence_point;
using eos::detail::phase_state;

// ---- what a set of parameters says about each datum ------------------------------------------------------------------------------------
struct surface {
  eos::detail::reference_phases phases;
  explicit surface(const reference_parameters& q) : phases(q) {}

  phase_state at(bool liquid, double log_x, double t) const { return eos::detail::state_of(phases, liquid, log_x, t); }
  phase_state at_pressure(bool liquid, double log_x, double t, double p) const {
    phase_state s = at(liquid, log_x, t);
    for (int i = 0; i < 60; ++i) {
      const double d = (s.pressure - p) * s.volume / s.stiffness;
      s = at(liquid, s.log_x + std::fmax(-0.05, std::fmin(0.05, d)), t);
      if (std::abs(d) < 1e-13) break;
    }
    require(std::abs(s.pressure - p) < 1e3, "calibration: pressure", s.pressure, "reached");
    return s;
  }
  /// The shock of particle speed up from `a` that ends in one phase, by Newton's method in (L, T).
  phase_state shocked(bool liquid, const phase_state& a, double up) const {
    const double us = 5350 + 1.34 * up;
    phase_state s = at(liquid, a.log_x + std::log(1 - up / us), 300 + 2e-4 * up * up);
    for (int i = 0; i < 100; ++i) {
      const double gap = a.volume - s.volume, dp = s.pressure - up * up / gap, de = s.energy - a.energy - 0.5 * up * up;
      const double p_l = -s.stiffness / s.volume - up * up / (gap * gap) * s.volume, p_t = -s.cross / s.volume;
      const double e_l = -s.pressure * s.volume - s.temperature * s.cross, e_t = s.heat, det = p_l * e_t - p_t * e_l;
      const double dl = (p_t * de - dp * e_t) / det, dt = (dp * e_l - p_l * de) / det;
      const double part = std::fmin(1, std::fmin(0.05 / std::abs(dl), 0.5 * s.temperature / std::abs(dt)));
      s = at(liquid, s.log_x + part * dl, s.temperature + part * dt);
      if (std::abs(dl) < 1e-12) return s;
    }
    require(false, "calibration: particle speed", up, "reached by a shock");
    return s;
  }
};
double shock_speed(const phase_state& a, const phase_state& s, double up) { return up / (1 - s.volume / a.volume); }
double hugoniot_gap(const phase_state& a, const phase_state& s) { return s.energy - a.energy - 0.5 * s.pressure * (a.volume - s.volume); }

/// Melting from p = 0 up: seeds every 100 K, and roots between them.
class melting_line {
public:
  explicit melting_line(const surface& s) : s_(s) {
    const auto gap = [&](double t) { return s_.at_pressure(false, 0.06, t, 0).gibbs - s_.at_pressure(true, 0.12, t, 0).gibbs; };
    const double t0 = bracketed_root(gap, 600, 1500);
    require(std::isfinite(t0), "calibration: melting point", t0, "between 600 and 1500 K");
    nodes_.push_back(eos::detail::equilibrium(s_.phases, t0, s_.at_pressure(false, 0.06, t0, 0).log_x, s_.at_pressure(true, 0.12, t0, 0).log_x));
    while (nodes_.back().temperature < 10000) nodes_.push_back(near(nodes_.back(), nodes_.back().temperature + 100));
  }
  const coexistence_point& at_zero_pressure() const { return nodes_.front(); }
  /// The point where f(point), which is positive at p = 0 or at the first node after it and falls, is zero.
  template <class F> coexistence_point where(const F& f) const {
    for (std::size_t i = 1; i + 1 < nodes_.size(); ++i)
      if (f(nodes_[i]) > 0 && f(nodes_[i + 1]) <= 0)
        return near(nodes_[i], bracketed_root([&](double t) { return f(near(nodes_[i], t)); }, nodes_[i].temperature, nodes_[i + 1].temperature));
    require(false, "calibration: melting line", 0, "long enough");
    return nodes_.front();
  }

private:
  const surface& s_;
  std::vector<coexistence_point> nodes_;
  coexistence_point near(const coexistence_point& c, double t) const { return eos::detail::equilibrium(s_.phases, t, c.solid.log_x, c.liquid.log_x); }
};

/// us (m/s) behind `up`, in whatever phase the shock ends.
double shock_speed_at(const surface& s, const melting_line& line, const phase_state& a, const coexistence_point& onset, const coexistence_point& end,
                      double up) {
  const auto speed = [&](const phase_state& p) { return std::sqrt(p.pressure * (a.volume - p.volume)); };
  if (up <= speed(onset.solid)) return shock_speed(a, s.shocked(false, a, up), up);
  if (up >= speed(end.liquid)) return shock_speed(a, s.shocked(true, a, up), up);
  const auto excess = [&](const coexistence_point& c) { // of the energy on the tie line over that behind the shock
    const double p = c.solid.pressure, volume = a.volume - up * up / p;
    return c.solid.energy + (volume - c.solid.volume) * (c.temperature * c.pressure_slope - p) - a.energy - 0.5 * up * up;
  };
  const auto c = line.where([&](const coexistence_point& q) { return q.temperature < onset.temperature - 100 ? 1.0 : -excess(q); });
  return c.solid.pressure * a.volume / up;
}

/// Boiling at one atmosphere: the liquid at p = 0 and the vapour at 101 325 Pa have one Gibbs energy.
double boiling_point(const surface& s) {
  const double R = s.phases.parameters().R(), p = 101325;
  const auto gap = [&](double t) {
    return s.at_pressure(true, 0.3 + t / 1e4, t, 0).gibbs - s.at_pressure(true, std::log(R * t * s.phases.parameters().rho0 / p), t, p).gibbs;
  };
  return bracketed_root(gap, 1500, 4500);
}

/// Enthalpy of the liquid at its cold spinodal less the solid's at that pressure, J/kg: below 0 the melting line reaches 0 K.
double cold_margin(const surface& s) {
  const double t = 0.01;
  const auto stiff = [&](double l) { return s.at(true, l, t).stiffness; };
  const auto end = s.at(true, bracketed_root(stiff, 0.1, 0.9), t);
  return end.gibbs - s.at_pressure(false, 0.1, t, end.pressure).gibbs;
}

struct datum {
  const char* name;
  double published, tolerance, found;
};

std::vector<datum> data(const reference_parameters& q) {
  const surface s(q);
  const melting_line line(s);
  const auto a = s.at_pressure(false, 0.02, 300, 0), hot = s.at_pressure(true, 0.25, 2000, 0);
  const auto& m = line.at_zero_pressure();
  const auto onset = line.where([&](const coexistence_point& c) { return c.temperature < 2000 ? 1 : hugoniot_gap(a, c.solid); });
  const auto end = line.where([&](const coexistence_point& c) { return c.temperature < 2000 ? 1 : hugoniot_gap(a, c.liquid); });
  const auto simon = [&](double gpa) { return line.where([&](const coexistence_point& c) { return gpa * 1e9 - c.solid.pressure; }).temperature; };
  const auto published_simon = [](double gpa) { return 933.45 * std::pow(1 + gpa / 6.049, 0.531); };
  const auto isentropic = [&](double entropy) {
    const double up = bracketed_root([&](double u) { return s.shocked(false, a, u).entropy - entropy; }, 1500, 5000);
    return s.shocked(false, a, up).pressure / 1e9;
  };
  const auto critical = eos::detail::find_critical_point(s.phases);
  std::vector<datum> d = {
      {"density at 300 K, kg/m3", 2699, 1.5, 1 / a.volume},
      {"expansion, 1e-6/K", 69, 1, -1e6 * a.cross / a.stiffness},
      {"c_p, J/(kg K)", 897, 6, a.heat + 300 * a.cross * a.cross / a.stiffness},
      {"K_T, GPa", 72.5, 1, a.stiffness / a.volume / 1e9},
      {"K_S, GPa", 76, 1, (a.stiffness + 300 * a.cross * a.cross / a.heat) / a.volume / 1e9},
      {"p at V/V0 = 0.5, 300 K, GPa (Greene 1994)", 220, 2, s.at(false, a.log_x + std::log(0.5), 300).pressure / 1e9},
      {"melting point at p = 0, K", 933.45, 3, m.temperature},
      {"latent heat, kJ/kg", 397, 4, (m.liquid.energy - m.solid.energy) / 1e3},
      {"volume of melting, %", 6.5, 0.15, 100 * (m.liquid.volume / m.solid.volume - 1)},
      {"liquid density, kg/m3", 2375, 20, 1 / m.liquid.volume},
      {"liquid sound speed, m/s", 4700, 200, std::sqrt(m.liquid.stiffness + m.temperature * m.liquid.cross * m.liquid.cross / m.liquid.heat)},
      {"liquid expansion, 1e-6/K", 115, 10, -1e6 * m.liquid.cross / m.liquid.stiffness},
      {"liquid c_p, J/(kg K)", 1177, 60, m.liquid.heat + m.temperature * m.liquid.cross * m.liquid.cross / m.liquid.stiffness},
      {"liquid density at 2000 K, kg/m3", 2080, 30, 1 / hot.volume},
  };
  for (const double gpa : {10., 25., 50., 80., 100.}) // Haenstroem and Lazor 2000
    d.push_back({"melting curve, K", published_simon(gpa), 0.05 * published_simon(gpa), simon(gpa)});
  d.push_back({"shock melting begins, GPa", 125, 1.5, onset.solid.pressure / 1e9});
  d.push_back({"shock melting begins, K", 4600, 100, onset.temperature});
  for (const double up : {1e3, 2e3, 3e3, 4e3, 5e3, 6e3}) { // LASL
    const double us = 5350 + 1.34 * up;
    d.push_back({"us, m/s", us, us * (up < 4500 ? 0.0015 : 0.005), shock_speed_at(s, line, a, onset, end, up)});
  }
  d.push_back({"melt on release begins, GPa", 67.5, 1, isentropic(m.solid.entropy)});
  d.push_back({"melt on release complete, GPa", 95, 5, isentropic(m.liquid.entropy)});
  d.push_back({"critical temperature, K", 6600, 400, critical.temperature});
  d.push_back({"critical density, kg/m3", 637, 80, critical.density});
  d.push_back({"critical pressure, GPa", 0.25, 0.04, critical.pressure / 1e9});
  d.push_back({"boiling point, K", 2792, 300, boiling_point(s)});
  d.push_back({"attraction b0, MJ/kg (prior)", -20, 8, q.b0 / 1e6});
  d.push_back({"cold margin, kJ/kg (the melting line reaches 0 K)", -4, 2, cold_margin(s) / 1e3});
  return d;
}

// ---- the fit -----------------------------------------------------------------------------------------------------------------------------
struct fitted {
  const char* name;
  double reference_parameters::* value;
  double scale, within;
};
// within: relative, how well the fit repeats. The minimum lies in a flat valley, along which delta and eta, the two gammas, and b1 to b3 among
// themselves make up for one another: how far a compiler's round-off lets the fit creep changes chi^2 by 0.4 % and no datum by more than
// a fifth of its tolerance (asserted below).
const fitted parameters[] = {
    {"rho0", &reference_parameters::rho0, 2700, 1e-5},  {"K0", &reference_parameters::K0, 80e9, 1e-3},
    {"eta", &reference_parameters::eta, 5, 1e-2},       {"delta", &reference_parameters::delta, 0.1, 5e-2},
    {"theta", &reference_parameters::theta, 300, 2e-3}, {"b", &reference_parameters::b, 1.5, 1e-2},
    {"b_liquid", &reference_parameters::b_liquid, 1.5, 1e-2}, {"x_gamma", &reference_parameters::x_gamma, 1, 1e-2},
    {"n", &reference_parameters::n, 3, 1e-2},           {"dS", &reference_parameters::dS, 400, 2e-3},
    {"c", &reference_parameters::c, 0.01, 1e-2},        {"b0", &reference_parameters::b0, 1e7, 1e-2},
    {"b1", &reference_parameters::b1, 1e9, 5e-2},       {"b2", &reference_parameters::b2, 1e9, 5e-2},
    {"b3", &reference_parameters::b3, 1e9, 5e-2}};
constexpr std::size_t count = std::size(parameters);

reference_parameters unpack(const gsl_vector* x) {
  reference_parameters q;
  for (std::size_t i = 0; i < count; ++i) q.*(parameters[i].value) = gsl_vector_get(x, i) * parameters[i].scale;
  return q;
}
int residuals(const gsl_vector* x, void*, gsl_vector* f) {
  try {
    const auto d = data(unpack(x));
    for (std::size_t i = 0; i < d.size(); ++i) {
      const double r = (d[i].found - d[i].published) / d[i].tolerance;
      gsl_vector_set(f, i, std::isfinite(r) ? r : 1e3);
    }
  } catch (const bad_parameter&) { // no such surface: the step is refused
    gsl_vector_set_all(f, 1e3);
  }
  return GSL_SUCCESS;
}
double chi_square(const std::vector<datum>& d) {
  double sum = 0;
  for (const auto& i : d) sum += std::pow((i.found - i.published) / i.tolerance, 2);
  return sum;
}

TEST(ReferenceCalibration, TheFitLandsOnTheShippedParameters) {
  const reference_parameters shipped;
  const auto now = data(shipped);
  gsl_set_error_handler_off();
  auto settings = gsl_multifit_nlinear_default_parameters();
  settings.h_df = 1e-6;
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  settings.solver = gsl_multifit_nlinear_solver_svd;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, now.size(), count), gsl_multifit_nlinear_free);
  const std::unique_ptr<gsl_vector, void (*)(gsl_vector*)> start(gsl_vector_alloc(count), gsl_vector_free);
  for (std::size_t i = 0; i < count; ++i)
    gsl_vector_set(start.get(), i, shipped.*(parameters[i].value) / parameters[i].scale * (i % 2 ? 1.01 : 0.99));
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residuals;
  problem.n = now.size();
  problem.p = count;
  ASSERT_EQ(gsl_multifit_nlinear_init(start.get(), &problem, work.get()), GSL_SUCCESS);
  double before = 0;
  gsl_blas_ddot(work->f, work->f, &before);
  int why = 0;
  gsl_multifit_nlinear_driver(60, 1e-9, 1e-9, 0, nullptr, nullptr, &why, work.get()); // stops on its way down the valley or at its end
  const auto best = unpack(gsl_multifit_nlinear_position(work.get()));
  const auto then = data(best);
  const std::size_t steps = gsl_multifit_nlinear_niter(work.get());
  std::printf("chi^2: start %.1f, fit %.4f (%zu steps), shipped %.4f\n", before, chi_square(then), steps, chi_square(now));
  EXPECT_GT(before, 10 * chi_square(now)); // the start is somewhere else
  EXPECT_NEAR(chi_square(then), chi_square(now), 1e-2 * chi_square(now));
  std::printf("%-10s %16s %16s\n", "", "fit", "shipped");
  for (const auto& p : parameters) {
    std::printf("%-10s %16.9g %16.9g\n", p.name, best.*(p.value), shipped.*(p.value));
    EXPECT_NEAR(best.*(p.value), shipped.*(p.value), p.within * std::abs(shipped.*(p.value))) << p.name;
  }
  std::printf("%-52s %10s %10s %8s\n", "", "published", "found", "%");
  for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(then[i].found, now[i].found, 0.2 * now[i].tolerance) << now[i].name;
  for (const auto& d : then) std::printf("%-52s %10.5g %10.5g %+8.2f\n", d.name, d.published, d.found, 100 * (d.found / d.published - 1));
}
} // namespace
