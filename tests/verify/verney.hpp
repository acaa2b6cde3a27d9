// SPDX-License-Identifier: MIT
// Imploding beryllium shells (Verney; Howell and Ball 2002): started inwards, they stop where all kinetic energy has become plastic work.
//
// Incompressible, rigid-plastic, yield stress Y, inner and outer radius Ri, Ro:
//   cylinder  u = V0 Ri/r,      pi rho V0^2 Ri^2 ln(Ro/Ri)       = int Y (2/sqrt 3) ln(R/r) 2 pi R dR,   r^2 = R^2 - Ri^2 + ri^2
//   sphere    u = V0 (Ri/r)^2,  2 pi rho V0^2 Ri^4 (1/Ri - 1/Ro) = int Y 2 ln(R/r) 4 pi R^2 dR,         r^3 = R^3 - Ri^3 + ri^3
// which ties V0 to the radius ri at which the inner surface stops. rho 1845, Y 330 MPa, G 151 GPa, 80 to 100 mm. The material here is elastic and
// compressible (Mie-Grueneisen, c0 7998 m/s, s 1.124, Gamma 1.11, from memory: they enter by Y/K, 0.3 %).
// Measured: the least over time of the inner radius that the formulas above infer from each particle's own radius, mean over the particles.
#pragma once

#include "verify/elastic.hpp"

#include "bolide/eos/mie_grueneisen.hpp"

#include <cmath>
#include <numbers>

namespace bolide::verify {

using plane = vec<double, 2>;

struct verney {
  static constexpr double rho = 1845, yield = 330e6, shear = 151e9, inner = 80 * mm, outer = 100 * mm;
  int power; // 2 cylinder, 3 sphere

  double radius(double big, double ri) const { return std::pow(std::pow(big, power) - std::pow(inner, power) + std::pow(ri, power), 1.0 / power); }
  double inferred(double big, double r) const {
    return std::pow(std::max(0.0, std::pow(r, power) - std::pow(big, power) + std::pow(inner, power)), 1.0 / power);
  }
  /// V0 that stops at ri: Simpson's rule.
  double speed(double ri) const {
    const int n = 2000;
    double work = 0;
    for (int i = 0; i <= n; ++i) {
      const double big = inner + (outer - inner) * i / n, strain = (power == 2 ? 2 / std::sqrt(3.0) : 2) * std::log(big / radius(big, ri));
      work += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * strain * 2 * (power - 1) * std::numbers::pi * std::pow(big, power - 1);
    }
    work *= yield * (outer - inner) / (3 * n);
    const double inertia = power == 2 ? std::numbers::pi * rho * square(inner) * std::log(outer / inner)
                                      : 2 * std::numbers::pi * rho * std::pow(inner, 4) * (1 / inner - 1 / outer);
    return std::sqrt(work / inertia);
  }
};

/// The half of a hollow sphere above z = 0.
struct upper_half : shell<2> {
  using shell<2>::shell;
  plane low() const { return {-outer, 0}; }
  bool contains(const plane& x, double spacing) const { return x[1] > 0 && shell<2>::contains(x, spacing); }
  double volume(bool radial) const { return shell<2>::volume(radial) / 2; }
};

struct stopped {
  double radius = 0, plastic = 0, kinetic = 0, drift = 0, seconds = 0; // m; plastic work and kinetic energy left, over the initial kinetic energy
};

template <class Method> stopped implode(int power, double stop, double h) {
  const verney problem{power};
  const double v0 = problem.speed(stop);
  const material be{eos::mie_grueneisen{{.rho0 = problem.rho, .c0 = 7998, .s = 1.124, .gamma0 = 1.11}},
                    strength::elastic_perfectly_plastic{problem.shear, problem.yield}, failure::none{}, viscosity::none{}};
  const auto run = [&](const auto& b) {
    solver sim{space::axisymmetric{},
               grid::sparse{h},
               typename Method::shape_type{},
               typename Method::transfer_type{},
               typename Method::scheme_type{},
               one_thread<typename Method::scalar>(),
               b};
    sim.add(grid::mirror{1, 0, true});
    if (power == 2) sim.add(grid::mirror{1, 4 * h, false});
    const auto part = [power](const plane& x) { return power == 2 ? plane{x[0], 0} : x; };
    const double strength = v0 * std::pow(problem.inner, power - 1);
    start_moving(
        sim, [&](const plane& x) { return plane(-strength * part(x) / std::pow(part(x).norm(), power)); },
        [&](const plane& x) {
          const plane p = part(x);
          const double r = p.norm();
          Eigen::Matrix2d g = -strength / std::pow(r, power) * (Eigen::Matrix2d::Identity() - power * p * p.transpose() / (r * r));
          if (power == 2) g(1, 1) = 0;
          return g;
        });
    const auto x0 = positions(sim);
    double before = 1e9;
    for (;;) {
      for (int i = 0; i < 10; ++i) sim.step();
      const auto x = positions(sim);
      double mean = 0;
      for (std::size_t i = 0; i < x.size(); ++i) mean += problem.inferred(part(x0[i]).norm(), part(x[i]).norm());
      mean /= static_cast<double>(x.size());
      if (mean > before) break;
      before = mean;
    }
    const auto& e = sim.energies();
    return stopped{before, e.plastic_work / e.initial.kinetic, e.now.kinetic / e.initial.kinetic, e.drift(), sim.solver_seconds()};
  };
  const initial_state at{problem.rho, 0};
  if (power == 2) return run(body{"shell", box{plane{problem.inner, 0}, plane{problem.outer, 4 * h}}, be, h / 2, at});
  return run(body{"shell", upper_half{plane{0, 0}, problem.inner, problem.outer}, be, h / 2, at});
}

/// Stops at `stop` mm with cells of `cell` mm.
template <class Method> void check_verney(int power, double stop, double cell, double bound) {
  const auto r = implode<Method>(power, stop * mm, cell * mm);
  const double error = r.radius / (stop * mm) - 1;
  char problem[80], measure[80];
  std::snprintf(problem, sizeof problem, "Verney shell, %s, %.2f m/s", power == 2 ? "cylindrical (r-z slab)" : "spherical (r-z)",
                verney{power}.speed(stop * mm));
  std::snprintf(measure, sizeof measure, "inner radius at rest over %g mm, cells of %g mm", stop, cell);
  record({.section = "solids",
          .problem = problem,
          .composition = composition<Method>("axisymmetric"),
          .measure = measure,
          .value = error,
          .bound = bound,
          .seconds = r.seconds});
  record({.section = "solids",
          .problem = problem,
          .composition = composition<Method>("axisymmetric"),
          .measure = "plastic work over kinetic energy at the start, less 1",
          .value = r.plastic - 1,
          .bound = 0.005,
          .seconds = r.seconds});
  EXPECT_LT(std::abs(error), bound) << problem;
  EXPECT_LT(std::abs(r.plastic - 1), 0.005) << problem;
  EXPECT_LT(r.kinetic, 0.002) << problem;
  EXPECT_LT(std::abs(r.drift), 1e-12) << problem;
}

} // namespace bolide::verify
