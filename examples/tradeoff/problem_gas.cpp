// SPDX-License-Identifier: MIT
// Ideal gases: Noh's implosion onto a point and onto a line, and shock tubes.
//
// Noh (gamma 5/3, rho 1, e 0, radial speed -1, t 0.6). Exact: a shock at r = 0.2, behind it rho = 4^k, p = rho/3, u = 0; ahead rho = (1 + t/r)^(k-1),
// u = -1; k = 3 into a point (half a ball on a mirror), 2 onto a line (a slab of four cells between mirrors). `length` is 0.2, the shock's radius.
// Viscosity 0.1 and 0.1: the default heats the gas while it converges (tests/verify/noh_problem.hpp).
// Error: mean of the relative L1 errors sum V |q - q_exact| / sum V |q_exact| of density, pressure and radial speed over particles with r in 0.05 to 0.35
// (the centre, which every method of this kind heats, is left out, as others do).
//
// Shock tubes to t = 0.2 in a tube of four cells' radius between walls: Sod's and one with a pressure ratio of 30 (gamma 1.4), and one of 100 (gamma 5/3). `length`: from the head
// of the fan to the shock. Error: mean of the relative L1 errors of density, pressure and speed over all particles, against analysis::riemann. Viscosity 1.5 and 0.06.
#include "problems.hpp"
#include "simulation.hpp"

#include "bolide/analysis/riemann.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/material/material.hpp"
#include "bolide/strength/none.hpp"

#include <cmath>

namespace tradeoff {
namespace {
using namespace bolide;

/// Sums of |q - exact| and |exact| by volume.
struct deviations {
  double off[3] = {0, 0, 0}, size[3] = {0, 0, 0};
  void add(double volume, const double (&found)[3], const double (&exact)[3]) {
    for (int k = 0; k < 3; ++k) off[k] += volume * std::abs(found[k] - exact[k]), size[k] += volume * std::abs(exact[k]);
  }
  double mean() const { return (off[0] / size[0] + off[1] / size[1] + off[2] / size[2]) / 3; }
};

chosen_material gas(double gamma, const viscosity::bulk& q) {
  return choose(material{eos::ideal_gas{{.gamma = gamma, .c_v = 1, .rho0 = 1}}, strength::none{}, failure::none{}, q}, 1, 0);
}

constexpr double noh_end = 0.6, noh_shock = 0.2, tube_end = 0.2;

outcome measure_noh(const settings& s, int k) {
  const double h = noh_shock / s.cells;
  const auto cold = gas(5.0 / 3, viscosity::bulk{0.1, 0.1});
  scene of{{}, {grid::mirror{1, 0, true}}, {}, h, 0.1, 1e-9};
  if (k == 3) of.parts.push_back({half_ball(1), cold});
  else of.parts.push_back({block({0, 0}, {1, 4 * h}), cold}), of.mirrors.push_back(grid::mirror{1, 4 * h, false});
  of.at_start = [k](const point& x, int) {
    const double r = k == 3 ? x.norm() : x[0];
    const point n = k == 3 ? point(x / r) : point{1, 0};
    start at{-n};
    if (k == 3) at.gradient[0] = -(1 - n[0] * n[0]) / r, at.gradient[1] = at.gradient[2] = n[0] * n[1] / r, at.gradient[3] = -(1 - n[1] * n[1]) / r;
    return at;
  };
  const auto sim = compose(s, of);
  sim->advance(noh_end);
  deviations d;
  sim->each([&](const particle& p) {
    const double r = k == 3 ? p.x.norm() : p.x[0], u = k == 3 ? p.v.dot(p.x) / r : p.v[0];
    if (r < 0.05 || r > 0.35) return;
    const bool inside = r < noh_shock;
    const double rho = inside ? std::pow(4, k) : std::pow(1 + noh_end / r, k - 1);
    d.add(p.volume, {p.mass / p.volume, p.pressure, u}, {rho, inside ? rho / 3 : 0, inside ? 0.0 : -1.0});
  });
  outcome o = sim->costs();
  o.error = d.mean();
  return o;
}

struct tube {
  double gamma;
  analysis::flow_state left, right; // density, velocity, pressure, both at rest, about z = 0
  double fan, shock;                // their speeds
  double fastest;                   // sound + material
  double compression;               // density behind the shock over that ahead
  double length() const { return tube_end * (fan + shock); }
};

outcome measure_tube(const settings& s, const tube& t) {
  const double h = t.length() / s.cells, half = std::ceil(0.5 / h) * h, radius = 4 * h;
  scene of{{{block({0, -half}, {radius, half}), gas(t.gamma, viscosity::bulk{})}},
           {grid::mirror{0, radius, false}, grid::mirror{1, -half, true}, grid::mirror{1, half, false}},
           {},
           h};
  of.at_start = [&](const point& x, int) {
    const auto& side = x[1] < 0 ? t.left : t.right;
    start at;
    at.density = side.density;
    at.energy = side.pressure / ((t.gamma - 1) * side.density);
    return at;
  };
  const auto sim = compose(s, of);
  sim->advance(tube_end);
  const eos::ideal_gas eos{{.gamma = t.gamma, .c_v = 1, .rho0 = 1}};
  const auto exact = analysis::riemann(eos, t.left, eos, t.right);
  deviations d;
  sim->each([&](const particle& p) {
    const auto at = exact.sample(p.x[1] / tube_end);
    d.add(p.volume, {p.mass / p.volume, p.pressure, p.v[1]}, {at.density, at.pressure, at.velocity});
  });
  outcome o = sim->costs();
  o.error = d.mean();
  return o;
}

const char* const noh_measure = "mean relative L1 error of rho, p and u over the particles at r 0.05 to 0.35";

problem tube_problem(std::string name, const tube& t) {
  return {std::move(name), "gas", "mean relative L1 error of rho, p and v over the particles", t.length(), 1 / t.length(), tube_end * t.fastest / t.length(), 1 - 1 / t.compression, true, false,
          {25, 50, 100, 200, 400}, [t](const settings& s) { return measure_tube(s, t); }};
}
} // namespace

problem noh_sphere() {
  return {"Noh, spherical", "convergence", noh_measure, noh_shock, std::acos(-1) / 4 / square(noh_shock), noh_end * 1.75 / noh_shock, 3, false, false, {5, 10, 20},
          [](const settings& s) { return measure_noh(s, 3); }};
}
problem noh_cylinder() {
  return {"Noh, cylindrical", "convergence", noh_measure, noh_shock, 1 / noh_shock, noh_end * 1.75 / noh_shock, 2, true, false, {5, 10, 20},
          [](const settings& s) { return measure_noh(s, 2); }};
}
problem sod_tube() { return tube_problem("Sod's tube", {1.4, {1, 0, 1}, {0.125, 0, 0.1}, std::sqrt(1.4), 1.752156, 2.2, 0.265574 / 0.125}); }
problem light_tube() {
  return tube_problem("shock tube, pressure ratio 30", {1.4, {1, 0, 1}, {0.2, 0, 1.0 / 30}, std::sqrt(1.4), 1.329301, 1.952396, 0.722788 / 0.2});
}
problem strong_tube() {
  return tube_problem("shock tube, pressure ratio 100", {5.0 / 3, {1, 0, 1}, {0.1, 0, 0.01}, std::sqrt(5.0 / 3), 1.582833, 2.0708, 0.333452 / 0.1});
}

} // namespace tradeoff
