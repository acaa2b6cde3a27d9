// SPDX-License-Identifier: MIT
// Radial vibration with known periods: sphere (breathing mode), long cylinder (plane strain), thin ring. E 70 GPa, nu 0.33, rho 2700.
//
// Sphere, radius R: u = j1(x r/R), free surface (lambda + 2 mu) u' + 2 lambda u/r = 0 at R:  tan x / x = 1/(1 - (c_L/2 c_T)^2 x^2), x = 2.73627.
// Cylinder: u = J1(x r/R), (lambda + 2 mu) u' + lambda u/r = 0 at R:  x J0(x)/J1(x) = 1 - lambda/(lambda + 2 mu) = (1 - 2 nu)/(1 - nu), x = 2.16176.
// Period 2 pi R/(x c_L).
// Thin ring: u uniform, period 2 pi R sqrt(rho/E). A square section of side a: with u_r = 1 - nu (r - R)/R, u_z = -nu z/R, hoop stress E u_r/r,
// Rayleigh's quotient gives the factor 1 - (1 + 4 nu - nu^2) a^2/(24 R^2), here 1 - 1.47e-4. Measured: the amplitude a(t) = sum m v.u / sum m u.u
// passes zero four times in two periods; T = (t4 - t1)/1.5. Amplitude 1 m/s (strain 2e-4): what is left of the second order of the strain is below
// 1e-4 of the period.
#pragma once

#include "verify/elastic.hpp"

#include <cmath>
#include <numbers>

namespace bolide::verify {

inline constexpr moduli radial{70e9, 0.33, 2700};

/// Root of f between a and b of different sign.
template <class F> double bisect(F&& f, double a, double b) {
  const bool rising = f(b) > 0;
  for (int i = 0; i < 100; ++i) {
    const double c = 0.5 * (a + b);
    ((f(c) > 0) == rising ? b : a) = c;
  }
  return 0.5 * (a + b);
}
inline double j1(double x) { return std::abs(x) < 1e-3 ? x / 3 * (1 - x * x / 10) : (std::sin(x) / x - std::cos(x)) / x; }
inline double bessel(int n, double x) { return std::cyl_bessel_j(n, x); }
/// (lambda + 2 mu) u' + shares lambda u/r for u = f(x r/R), at R = 1; shares 2 in a sphere, 1 in a cylinder.
template <class F> double traction(F&& u, double x, int shares) {
  const double lambda = radial.bulk() - 2.0 / 3 * radial.shear(), d = 1e-4;
  return (lambda + 2 * radial.shear()) * (u(x + d) - u(x - d)) / (2 * d) * x + shares * lambda * u(x);
}
inline double sphere_root() {
  return bisect([](double x) { return traction(j1, x, 2); }, 2, 3);
}
inline double cylinder_root() {
  return bisect([](double x) { return traction([](double y) { return bessel(1, y); }, x, 1); }, 1.5, 2.5);
}

struct vibration {
  double period = 0, amplitude = 0, rest = 0; // s; kept after two periods over the first, what is not in the mode over it
  double drift = 0, seconds = 0;
  double mass_ratio = 1; // of the particles over that of the geometry
};

/// Two periods of `mode`(x); `expected` period sets how long.
template <class Solver, class Mode, class Gradient> vibration vibrate(Solver& sim, double expected, Mode&& mode, Gradient&& gradient) {
  constexpr int dim = Solver::dim;
  start_moving(sim, mode, gradient);
  const auto x0 = positions(sim);
  const auto amplitude = [&](double& rest) {
    double av = 0, aa = 0, vv = 0;
    each_velocity(sim, [&](std::uint32_t id, double m, const vec<double, dim>& v) {
      const vec<double, dim> u = mode(x0[id]);
      av += m * v.dot(u), aa += m * u.squaredNorm(), vv += m * v.squaredNorm();
    });
    rest = std::sqrt(std::max(0.0, vv - av * av / aa) / aa);
    return av / aa;
  };
  vibration r;
  std::vector<double> zero;
  double before = 1;
  while (sim.time() < 2 * expected) {
    sim.step(2 * expected - sim.time());
    const double now = amplitude(r.rest);
    if ((now > 0) != (before > 0)) zero.push_back(sim.time() - sim.dt() * now / (now - before));
    before = now;
  }
  r.amplitude = before;
  r.period = zero.size() == 4 ? (zero[3] - zero[0]) / 1.5 : none;
  r.drift = sim.energies().drift();
  double mass = 0;
  each_velocity(sim, [&](std::uint32_t, double m, const vec<double, dim>&) { mass += m; });
  r.mass_ratio = mass / sim.geometric_mass();
  r.seconds = sim.solver_seconds();
  return r;
}

template <class Method, class... Bodies> auto radial_scene(double h, const Bodies&... bodies) {
  controls<typename Method::scalar> c = one_thread<typename Method::scalar>();
  c.first_step = 1;
  return solver{space::axisymmetric{},
                grid::sparse{h},
                typename Method::shape_type{},
                typename Method::transfer_type{},
                typename Method::scheme_type{},
                c,
                bodies...};
}

using plane = vec<double, 2>;
using gradient_2d = Eigen::Matrix2d;

/// `cells` per radius.
template <class Method> vibration sphere_mode(int cells) {
  const double radius = 4.765 * mm, h = radius / cells, x = sphere_root(), k = x / radius;
  auto sim = radial_scene<Method>(h, body{"sphere", sphere{plane{0, 0}, radius}, elastic(radial), h / 2, initial_state{radial.rho, 0}});
  const double surface = j1(x);
  const auto mode = [=](const plane& p) { return plane(p * (j1(k * p.norm()) / (surface * p.norm()))); };
  return vibrate(sim, 2 * std::numbers::pi / (k * radial.longitudinal_speed()), mode, [&](const plane& p) {
    const double r = p.norm(), u = j1(k * r) / surface, d = 1e-4 * radius, slope = (j1(k * (r + d)) - j1(k * (r - d))) / (2 * d * surface);
    return gradient_2d(gradient_2d::Identity() * (u / r) + p * p.transpose() / (r * r) * (slope - u / r));
  });
}

/// A slab of four cells between mirrors.
template <class Method> vibration cylinder_mode(int cells) {
  const double radius = 10 * mm, h = radius / cells, x = cylinder_root(), k = x / radius, surface = bessel(1, x);
  auto sim = radial_scene<Method>(h, body{"cylinder", box{plane{0, 0}, plane{radius, 4 * h}}, elastic(radial), h / 2, initial_state{radial.rho, 0}});
  sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 4 * h, false});
  const auto mode = [=](const plane& p) { return plane{bessel(1, k * p[0]) / surface, 0}; };
  return vibrate(sim, 2 * std::numbers::pi / (k * radial.longitudinal_speed()), mode, [&](const plane& p) {
    gradient_2d g = gradient_2d::Zero();
    g(0, 0) = (k * bessel(0, k * p[0]) - bessel(1, k * p[0]) / p[0]) / surface;
    return g;
  });
}

/// A ring of 2 mm by 2 mm at R = 50 mm.
inline double ring_period() {
  const double nu = radial.nu, side = 2, r = 50;
  return 2 * std::numbers::pi * 50 * mm * std::sqrt(radial.rho / radial.e) * (1 - (1 + 4 * nu - nu * nu) * square(side / r) / 24);
}
template <class Method> vibration ring_mode(int cells) {
  const double side = 2 * mm, h = side / cells;
  auto sim =
      radial_scene<Method>(h, body{"ring", box{plane{49 * mm, 0}, plane{51 * mm, side}}, elastic(radial), h / 2, initial_state{radial.rho, 0}});
  return vibrate(
      sim, ring_period(),
      [](const plane&) {
        return plane{1, 0};
      },
      [](const plane&) { return gradient_2d(gradient_2d::Zero()); });
}

/// Three resolutions `cells`, 2 `cells`, 4 `cells` per radius (the ring: 4 per side).
template <class Method> void check_radial_modes(int cells) {
  const std::string who = composition<Method>("axisymmetric"), finest = std::to_string(4 * cells) + " cells per radius";
  const double per_root = 2 * std::numbers::pi / radial.longitudinal_speed(), sphere = 4.765 * mm * per_root / sphere_root(),
               cylinder = 10 * mm * per_root / cylinder_root();
  vibration s[3], c[3];
  double s_error[3], s_own[3], c_error[3];
  for (int i = 0; i < 3; ++i) {
    s[i] = sphere_mode<Method>(cells << i);
    c[i] = cylinder_mode<Method>(cells << i);
    s_error[i] = s[i].period / sphere - 1;
    s_own[i] = s[i].period / (sphere * std::cbrt(s[i].mass_ratio)) - 1;
    c_error[i] = c[i].period / cylinder - 1;
  }
  const auto ring = ring_mode<Method>(4);
  const double ring_error = ring.period / ring_period() - 1;
  record({.section = "smooth",
          .problem = "sphere, breathing mode",
          .composition = who,
          .measure = "period, " + finest,
          .value = s_error[2],
          .bound = 0.01 * 32 / (4 * cells),
          .order = order(std::abs(s_error[1]), std::abs(s_error[2])),
          .expected_order = 1,
          .seconds = s[2].seconds,
          .note = "first order: a sphere of lattice points within R - dx/2 is smaller than R"});
  record({.section = "smooth",
          .problem = "sphere, breathing mode",
          .composition = who,
          .measure = "period over that of a sphere of the particles' mass, " + finest,
          .value = s_own[2],
          .bound = 0.004,
          .seconds = s[2].seconds});
  record({.section = "smooth",
          .problem = "cylinder, plane strain",
          .composition = who,
          .measure = "period, " + finest,
          .value = c_error[2],
          .bound = 4e-4 * square(32.0 / (4 * cells)),
          .order = order(std::abs(c_error[1]), std::abs(c_error[2])),
          .expected_order = 2,
          .seconds = c[2].seconds});
  record({.section = "smooth",
          .problem = "thin ring",
          .composition = who,
          .measure = "period, 4 cells per side",
          .value = ring_error,
          .bound = 5e-5,
          .seconds = ring.seconds});
  record({.section = "smooth",
          .problem = "cylinder, plane strain",
          .composition = who,
          .measure = "amplitude lost in two periods, " + finest,
          .value = 1 - c[2].amplitude,
          .bound = 5e-3,
          .seconds = c[2].seconds});
  EXPECT_LT(std::abs(s_error[2]), 0.01 * 32 / (4 * cells));
  EXPECT_NEAR(order(std::abs(s_error[0]), std::abs(s_error[2])) / 2, 1, 0.2);
  EXPECT_LT(std::abs(s_own[2]), 0.004);
  EXPECT_LT(std::abs(c_error[2]), 4e-4 * square(32.0 / (4 * cells)));
  EXPECT_GT(order(std::abs(c_error[1]), std::abs(c_error[2])), 1.5); // 2.0 in all but quadratic B-spline FLIP on 64 cells: 1.54
  EXPECT_LT(std::abs(1 - c[2].amplitude), 5e-3);
  EXPECT_LT(std::abs(ring_error), 5e-5);
  for (const auto& v : {s[2], c[2], ring}) EXPECT_LT(std::abs(v.drift), 1e-12);
}

} // namespace bolide::verify
