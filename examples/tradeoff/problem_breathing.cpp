// SPDX-License-Identifier: MIT
// Breathing mode of a free elastic sphere, half of it on a mirror; amplitude 1 m/s.
//
// u = j1(x r/R), free surface: tan x / x = 1/(1 - (c_L/2 c_T)^2 x^2); period 2 pi R/(x c_L). `length` is R. The amplitude a(t) = sum m v.u / sum m u.u passes zero
// four times in two periods; T = (t4 - t1)/1.5. Error: |T/T_exact - 1| + what the amplitude has lost (or gained) over one period.
// Lattice points belong to the sphere by their centres. No viscosity.
#include "problems.hpp"
#include "simulation.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/material.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace tradeoff {
namespace {
using namespace bolide;

struct elastic_sphere {
  double young, poisson, density, radius; // Pa, -, kg/m3, m
  double bulk() const { return young / (3 * (1 - 2 * poisson)); }
  double shear() const { return young / (2 * (1 + poisson)); }
  double longitudinal_speed() const { return std::sqrt((bulk() + 4.0 / 3 * shear()) / density); }
};
double j1(double x) { return std::abs(x) < 1e-3 ? x / 3 * (1 - x * x / 10) : (std::sin(x) / x - std::cos(x)) / x; }

/// The root of (lambda + 2 mu) u' + 2 lambda u/r = 0 at R between 2 and 3.
double root_of(const elastic_sphere& b) {
  const double lambda = b.bulk() - 2.0 / 3 * b.shear(), d = 1e-5;
  const auto traction = [&](double x) { return (lambda + 2 * b.shear()) * (j1(x + d) - j1(x - d)) / (2 * d) * x + 2 * lambda * j1(x); };
  double low = 2, high = 3.1;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((traction(middle) > 0) == (traction(low) > 0) ? low : high) = middle;
  }
  return low;
}

outcome measure_sphere(const elastic_sphere& b, const settings& s) {
  const double x = root_of(b), k = x / b.radius, surface = j1(x), period = 2 * std::numbers::pi / (k * b.longitudinal_speed());
  const auto mode = [&](const point& at) { return point(at * (j1(k * at.norm()) / (surface * at.norm()))); };
  const eos::mie_grueneisen eos{{.rho0 = b.density, .c0 = std::sqrt(b.bulk() / b.density), .s = 1.5, .gamma0 = 2}};
  const strength::elastic_perfectly_plastic never_yields{b.shear(), std::numeric_limits<double>::infinity()};
  scene of{{{half_ball(b.radius), choose(material{eos, never_yields, failure::none{}, viscosity::none{}}, b.density, 0)}}, {grid::mirror{1, 0, true}}, {}, b.radius / s.cells, 1};
  of.at_start = [&](const point& at, int) {
    const double r = at.norm(), u = j1(k * r) / surface, d = 1e-4 * b.radius, slope = (j1(k * (r + d)) - j1(k * (r - d))) / (2 * d * surface), twist = slope - u / r;
    start p{mode(at)};
    for (int i = 0; i < 4; ++i) p.gradient[i] = (i % 3 == 0 ? u / r : 0) + twist * at[i / 2] * at[i % 2] / (r * r);
    return p;
  };
  const auto sim = compose(s, of);
  std::vector<point> shape;
  sim->each([&](const particle& p) {
    if (p.id >= shape.size()) shape.resize(p.id + 1, point{0, 0});
    shape[p.id] = mode(p.x);
  });
  const auto amplitude = [&] {
    double av = 0, aa = 0;
    sim->each([&](const particle& p) { av += p.mass * p.v.dot(shape[p.id]), aa += p.mass * shape[p.id].squaredNorm(); });
    return av / aa;
  };
  std::vector<double> zero;
  double before = 1;
  sim->advance(2 * period, [&] {
    const double now = amplitude();
    if ((now > 0) != (before > 0)) zero.push_back(sim->time() - sim->dt() * now / (now - before));
    before = now;
  });
  if (zero.size() != 4) throw failed_run{"the sphere's amplitude passed zero " + std::to_string(zero.size()) + " times in two periods, not 4"};
  outcome o = sim->costs();
  o.error = std::abs((zero[3] - zero[0]) / 1.5 / period - 1) + std::abs(1 - before) / 2;
  return o;
}

problem sphere_problem(std::string name, const elastic_sphere& b) {
  const double period = 2 * std::numbers::pi / (root_of(b) / b.radius * b.longitudinal_speed());
  return {std::move(name), "wave", "relative error of the period, and what the amplitude changed in one period", b.radius, std::numbers::pi / 4,
          2 * period * b.longitudinal_speed() / b.radius, b.poisson, false, false, {8, 16, 32, 64}, [b](const settings& s) { return measure_sphere(b, s); }};
}
} // namespace

problem breathing_aluminium() { return sphere_problem("breathing sphere, aluminium", {70e9, 0.33, 2700, 4.765e-3}); }
problem breathing_lead() { return sphere_problem("breathing sphere, lead", {16e9, 0.44, 11340, 10e-3}); }
problem breathing_glass() { return sphere_problem("breathing sphere, glass", {72e9, 0.22, 2500, 5e-3}); }
problem breathing_tungsten() { return sphere_problem("breathing sphere, tungsten", {400e9, 0.26, 19300, 3e-3}); }
problem breathing_steel() { return sphere_problem("breathing sphere, steel", {205e9, 0.29, 7830, 7e-3}); }
problem breathing_copper() { return sphere_problem("breathing sphere, copper", {120e9, 0.34, 8960, 6e-3}); }

} // namespace tradeoff
