// SPDX-License-Identifier: MIT
// Manufactured solutions for an elastic solid: a motion is chosen and the body force that makes it a solution is derived. Plane strain unless said.
//
// Material: hypoelastic, Jaumann rate with G, and p = K ln(rho/rho0). Where the principal axes of stretch do not turn against the material, the
// deviator is 2 G times that of the logarithmic strain, so sigma_i = (K - 2/3 G) ln J + 2 G ln lambda_i (lambda_i the principal stretches, J their
// product). In simple shear g the rate gives sigma_12 = G sin g, sigma_11 = -sigma_22 = G (1 - cos g), 1 the direction of the motion
// (strength/elastic.hpp).
//
// Vortex (after Kamojjala, Brannon et al. 2015): ring 0.75 < R < 1.25, every circle turns as a whole by
//   alpha(R, t) = A sin(c pi t) h(R),  h = (1 - 16 (R - 1)^2)^2,
// so F = Q(alpha) (I + g e_t e_r), g = R alpha', J = 1: simple shear g in a turning frame, which an objective rate does not feel. At the current
// point, r = R:
//   b_r = -r alpha_t^2 + G/rho (sin g g' + 2 (1 - cos g)/r),   b_t = r alpha_tt - G/rho (cos g g' + 2 sin g/r).
// Both rims stay where they are and carry no stress. Public suites take A = 1 and a neo-Hookean material: g is then 7, where the Jaumann rate has
// long turned soft (pi/2). Here A = 1/8, g up to 0.88.
//
// Expanding ring (after Wallstedt and Guilkey 2008): r = R + A sin(w t) f(R), f = 1 + (3 s^2 - 2 s^3)/4, s from 0 to 1 through the wall; f' = 0 at
// both rims and nu = 0 (K = 2/3 G), so that sigma_rr = 2 G ln lambda_r leaves them free. With lambda_r = 1 + A sin(w t) f', lambda_t = r/R:
//   b_r = r_tt - J/rho0 (sigma_rr,R / lambda_r + (sigma_rr - sigma_tt)/r). The same in plane strain and in a slab of r-z.
// In plane strain the rims are stairs on the lattice of particles, and the ring of the particles is not that of the drawing: its area and second
// moment are those of rims that lie some 0.05 of a spacing elsewhere, by no rule. A rim that is off by d bears sigma_rr = 2 G A f'' d there,
// f'' = -+1.5/(wall)^2, which is 37 d/m of the hoop stress: 0.4 mm at h = 1/80 m drives the ring by 9 % of its hoop force, and it breathes
// about 3 % of A beside the solution (measured 2.9 %), with 2.4 % at h = 1/40: order 0. So the rims of the solution are those of the particles.
//
// Axis-aligned (after Steffen et al. 2008): x_i = X_i + A sin(pi X_i) sin(c pi t + phase_i) in the unit square; the faces stay where they are
// (mirrors).
//   b_i = x_i,tt - J/(rho0 lambda_i) (K + 4/3 G) lambda_i,i / lambda_i.
// manufactured_test.cpp holds each force against finite differences of its stress, and each stress against the rate integrated along the motion.
#pragma once

#include "verify/elastic.hpp"

#include "bolide/space/plane_strain.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace bolide::verify {

using plane = vec<double, 2>;
using tensor = Eigen::Matrix2d;

/// p = K ln(rho/rho0).
struct logarithmic_solid {
  double bulk_modulus = 1, rho0 = 1; // Pa, kg/m3
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(bulk_modulus) * log(rho * T(1 / rho0)), T(bulk_modulus) / rho};
  }
  double reference_density() const { return rho0; }
};
static_assert(EquationOfState<logarithmic_solid>);
inline auto logarithmic(const moduli& m) {
  return material{logarithmic_solid{m.bulk(), m.rho}, strength::elastic_perfectly_plastic{m.shear(), std::numeric_limits<double>::infinity()},
                  failure::none{}, viscosity::none{}};
}

/// Components along and across the radius at x, in x and y.
inline tensor from_polar(const plane& x, double rr, double tt, double rt) {
  const plane er = x.normalized(), et{-er[1], er[0]};
  return rr * er * er.transpose() + tt * et * et.transpose() + rt * (er * et.transpose() + et * er.transpose());
}
/// X of x = X + a f(X), with the slope of f; f within the range where the map is monotonic.
template <class F, class Slope> double invert(double x, double a, F&& f, Slope&& slope) {
  double at = x;
  for (int i = 0; i < 50; ++i) {
    const double step = (at + a * f(at) - x) / (1 + a * slope(at));
    at -= step;
    if (std::abs(step) < 1e-9) break; // quadratic: the next one is round-off
  }
  return at;
}

struct vortex {
  static constexpr const char* name = "vortex";
  moduli m{1000, 0.3, 1000};
  double amplitude = 0.125, inner = 0.75, outer = 1.25, end = 1;
  static constexpr double scale = 0.125; // m, largest displacement

  double rate() const { return std::numbers::pi * std::sqrt(m.e / m.rho); }
  static double h(double r) { return std::abs(r - 1) < 0.25 ? square(1 - 16 * square(r - 1)) : 0; }
  static double slope(double r) { return std::abs(r - 1) < 0.25 ? -64 * (r - 1) * (1 - 16 * square(r - 1)) : 0; }
  static double curvature(double r) { return std::abs(r - 1) < 0.25 ? -64 * (1 - 48 * square(r - 1)) : 0; }
  plane turned(const plane& x, double angle) const {
    return {std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]};
  }

  plane position(const plane& x, double t) const { return turned(x, amplitude * std::sin(rate() * t) * h(x.norm())); }
  plane reference(const plane& x, double t) const { return turned(x, -amplitude * std::sin(rate() * t) * h(x.norm())); }
  plane force(const plane& x, double t) const {
    const double r = x.norm(), w = rate(), a = amplitude * std::sin(w * t), g = r * a * slope(r), dg = a * (slope(r) + r * curvature(r)),
                 modulus = m.shear() / m.rho;
    const double radial = -r * square(amplitude * w * std::cos(w * t) * h(r)) + modulus * (std::sin(g) * dg + 2 * (1 - std::cos(g)) / r);
    const double hoop = -r * a * w * w * h(r) - modulus * (std::cos(g) * dg + 2 * std::sin(g) / r);
    return (radial * x + hoop * plane{-x[1], x[0]}) / r;
  }
  tensor stress(const plane& x, double t) const {
    const double r = x.norm(), g = r * amplitude * std::sin(rate() * t) * slope(r), shear = m.shear();
    return from_polar(x, -shear * (1 - std::cos(g)), shear * (1 - std::cos(g)), shear * std::sin(g));
  }
};

struct expanding_ring {
  static constexpr const char* name = "expanding ring";
  moduli m{1e7, 0, 1000};
  double amplitude = 0.05, inner = 0.4, outer = 0.6, end = 0.02;
  static constexpr double scale = 0.05;

  double rate() const { return std::numbers::pi * std::sqrt(m.e / m.rho); }
  double s(double r) const { return (r - inner) / (outer - inner); }
  double f(double r) const { return 1 + square(s(r)) * (3 - 2 * s(r)) / 4; }
  double slope(double r) const { return 1.5 * s(r) * (1 - s(r)) / (outer - inner); }
  double curvature(double r) const { return 1.5 * (1 - 2 * s(r)) / square(outer - inner); }
  double swing(double t) const { return amplitude * std::sin(rate() * t); }
  double reference_radius(double r, double t) const {
    return invert(
        r, swing(t), [this](double x) { return f(x); }, [this](double x) { return slope(x); });
  }

  plane position(const plane& x, double t) const { return x * (1 + swing(t) * f(x.norm()) / x.norm()); }
  plane reference(const plane& x, double t) const { return x * (reference_radius(x.norm(), t) / x.norm()); }
  /// Along the radius, at the current radius r.
  double radial_force(double r, double t) const {
    const double big = reference_radius(r, t), a = swing(t), k = m.bulk() - 2.0 / 3 * m.shear(), g2 = 2 * m.shear();
    const double lr = 1 + a * slope(big), lt = r / big, lr_slope = a * curvature(big), lt_slope = a * (slope(big) - f(big) / big) / big;
    const double stress_slope = (k + g2) * lr_slope / lr + k * lt_slope / lt;
    return -square(rate()) * a * f(big) - lr * lt / m.rho * (stress_slope / lr + g2 * std::log(lr / lt) / r);
  }
  plane force(const plane& x, double t) const { return x * (radial_force(x.norm(), t) / x.norm()); }
  tensor stress(const plane& x, double t) const {
    const double r = x.norm(), big = reference_radius(r, t), lr = 1 + swing(t) * slope(big), lt = r / big, k = m.bulk() - 2.0 / 3 * m.shear();
    return from_polar(x, k * std::log(lr * lt) + 2 * m.shear() * std::log(lr), k * std::log(lr * lt) + 2 * m.shear() * std::log(lt), 0);
  }
};

/// The expanding ring with the rims of the lattice that stands for it: of the same area and second moment.
inline expanding_ring as_seeded(expanding_ring s, double spacing) {
  const shell ring{plane{0, 0}, s.inner, s.outer};
  double n = 0, squares = 0;
  for_each_lattice_point(ring, ring.anchor(), spacing, false, [&](const plane& x) { n += 1, squares += x.squaredNorm(); });
  const double middle = squares / n + square(spacing) / 6, half = 0.5 * n * square(spacing) / std::numbers::pi; // of the squares of both radii
  s.inner = std::sqrt(middle - half);
  s.outer = std::sqrt(middle + half);
  return s;
}

struct axis_aligned {
  static constexpr const char* name = "axis-aligned";
  moduli m{1e7, 0.3, 1000};
  double amplitude = 0.05, end = 0.02;
  static constexpr double scale = 0.05;
  std::array<double, 2> phase{0, std::numbers::pi};

  double rate() const { return std::numbers::pi * std::sqrt(m.e / m.rho); }
  double swing(int i, double t) const { return amplitude * std::sin(rate() * t + phase[static_cast<std::size_t>(i)]); }
  static double f(double x) { return std::sin(std::numbers::pi * x); }
  static double slope(double x) { return std::numbers::pi * std::cos(std::numbers::pi * x); }

  plane position(const plane& x, double t) const { return {x[0] + swing(0, t) * f(x[0]), x[1] + swing(1, t) * f(x[1])}; }
  plane reference(const plane& x, double t) const { return {invert(x[0], swing(0, t), f, slope), invert(x[1], swing(1, t), f, slope)}; }
  plane stretch(const plane& big, double t) const { return {1 + swing(0, t) * slope(big[0]), 1 + swing(1, t) * slope(big[1])}; }
  plane force(const plane& x, double t) const {
    const plane big = reference(x, t), l = stretch(big, t);
    const double j = l[0] * l[1], modulus = m.bulk() + 4.0 / 3 * m.shear();
    plane b;
    for (int i = 0; i < 2; ++i) {
      const double a = swing(i, t), l_slope = -square(std::numbers::pi) * a * f(big[i]);
      b[i] = -square(rate()) * a * f(big[i]) - j / (m.rho * l[i]) * modulus * l_slope / l[i];
    }
    return b;
  }
  tensor stress(const plane& x, double t) const {
    const plane l = stretch(reference(x, t), t);
    const double both = (m.bulk() - 2.0 / 3 * m.shear()) * std::log(l[0] * l[1]);
    return plane{both + 2 * m.shear() * std::log(l[0]), both + 2 * m.shear() * std::log(l[1])}.asDiagonal();
  }
};

/// Velocity and its gradient in space at the start, by differences of the motion (fourth order).
template <class Solution> plane velocity_at(const Solution& s, const plane& big, double t) {
  const double d = 1e-4 * s.end;
  return (8 * (s.position(big, t + d) - s.position(big, t - d)) - (s.position(big, t + 2 * d) - s.position(big, t - 2 * d))) / (12 * d);
}
template <class Solution> tensor velocity_gradient_at(const Solution& s, const plane& x, double t) {
  const double d = 1e-4;
  tensor l;
  for (int j = 0; j < 2; ++j) {
    const plane e = plane::Unit(j) * d;
    const auto v = [&](const plane& at) { return velocity_at(s, s.reference(at, t), t); };
    l.col(j) = (8 * (v(x + e) - v(x - e)) - (v(x + 2 * e) - v(x - 2 * e))) / (12 * d);
  }
  return l;
}

struct manufactured_error {
  double rms = 0, drift = 0, residual = 0, seconds = 0; // rms of the displacement over particles and time, over the largest displacement
};

/// Runs a scene of which `exact`(x at the start, t) is the position.
template <class Solver, class Exact> manufactured_error follow(Solver& sim, double end, double scale, Exact&& exact) {
  const auto x0 = positions(sim);
  double sum = 0;
  while (sim.time() < end * (1 - 1e-9)) {
    sim.step(end - sim.time());
    const auto x = positions(sim);
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) squares += (x[i] - exact(x0[i], sim.time())).squaredNorm();
    sum += sim.dt() * squares / static_cast<double>(x.size());
  }
  return {std::sqrt(sum / end) / scale, sim.energies().drift(), sim.energies().residual(), sim.solver_seconds()};
}

template <class Method> controls<typename Method::scalar> manufactured_controls(double courant) {
  auto c = one_thread<typename Method::scalar>();
  c.courant = courant;
  c.first_step = 1;
  c.energy_bound = 100; // the force does work
  return c;
}

/// Plane strain; `body` made of the geometry of the solution.
template <class Method, class Solution, class Geometry>
manufactured_error in_plane_strain(const Solution& s, const Geometry& g, double h, double courant, bool walls) {
  const body b{Solution::name, g, logarithmic(s.m), h / 2, initial_state{s.m.rho, 0}};
  solver sim{space::plane_strain{},
             grid::sparse{h},
             typename Method::shape_type{},
             typename Method::transfer_type{},
             typename Method::scheme_type{},
             manufactured_controls<Method>(courant),
             b};
  if (walls)
    for (int axis = 0; axis < 2; ++axis) sim.add(grid::mirror{axis, 0, true}).add(grid::mirror{axis, 1, false});
  sim.add(body_force{[s](const plane& x, double t) { return s.force(x, t); }});
  start_moving(
      sim, [&](const plane& x) { return velocity_at(s, x, 0); }, [&](const plane& x) { return velocity_gradient_at(s, x, 0); });
  return follow(sim, s.end, Solution::scale, [&](const plane& x, double t) { return s.position(x, t); });
}
template <class Method> manufactured_error run(const vortex& s, double h, double courant) {
  return in_plane_strain<Method>(s, shell{plane{0, 0}, s.inner, s.outer}, h, courant, false);
}
template <class Method> manufactured_error run(const expanding_ring& s, double h, double courant) {
  return in_plane_strain<Method>(as_seeded(s, h / 2), shell{plane{0, 0}, s.inner, s.outer}, h, courant, false);
}
template <class Method> manufactured_error run(const axis_aligned& s, double h, double courant) {
  return in_plane_strain<Method>(s, box{plane{0, 0}, plane{1, 1}}, h, courant, true);
}
/// The expanding ring as a slab of four cells in r-z.
template <class Method> manufactured_error run_in_rz(const expanding_ring& s, double h, double courant) {
  const body b{s.name, box{plane{s.inner, 0}, plane{s.outer, 4 * h}}, logarithmic(s.m), h / 2, initial_state{s.m.rho, 0}};
  solver sim{space::axisymmetric{},
             grid::sparse{h},
             typename Method::shape_type{},
             typename Method::transfer_type{},
             typename Method::scheme_type{},
             manufactured_controls<Method>(courant),
             b};
  sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 4 * h, false});
  sim.add(body_force{[s](const plane& x, double t) { return plane{s.radial_force(x[0], t), 0}; }});
  const auto moved = [&](const plane& x, double t) { return plane{s.position(plane{x[0], 0}, t)[0], x[1]}; };
  start_moving(
      sim,
      [&](const plane& x) {
        return plane{velocity_at(s, plane{x[0], 0}, 0)[0], 0};
      },
      [&](const plane& x) {
        return tensor(plane{velocity_gradient_at(s, plane{x[0], 0}, 0)(0, 0), 0}.asDiagonal());
      });
  return follow(sim, s.end, expanding_ring::scale, moved);
}

/// h, h/2, h/4 with dt as h^2 (see elastic_bar.hpp: the schemes are first order in time). `error`: what is asked at the finest.
template <class Method, class Run> void check_order(const char* problem, const char* space, double h, double error, double least_order, Run&& at) {
  manufactured_error e[3];
  for (int i = 0; i < 3; ++i) e[i] = at(h / (1 << i), 0.4 / (1 << i));
  char finest[80];
  std::snprintf(finest, sizeof finest, "RMS of the displacement over its largest, h = 1/%.0f m, dt ~ h^2", 4 / h);
  const double observed = order(e[1].rms, e[2].rms);
  constexpr bool smooth = Method::shape_type::smooth; // linear shapes: stress jumps where a particle changes cell, the more often the finer the grid
  record({.section = "smooth",
          .problem = std::string("manufactured: ") + problem,
          .composition = composition<Method>(space),
          .measure = finest,
          .value = e[2].rms,
          .bound = smooth ? error : none,
          .order = observed,
          .expected_order = smooth ? 2 : none,
          .seconds = e[2].seconds,
          .note = smooth ? "" : "reported: linear shapes do not converge where particles change cell"});
  if (smooth) {
    EXPECT_LT(e[2].rms, error);
    EXPECT_GT(observed, least_order);
  }
  EXPECT_LT(std::abs(e[2].drift), 1e-11);
  EXPECT_LT(std::abs(e[2].residual), 1e-11);
}
template <class Method> void check_vortex(double h, double error, double least_order) {
  check_order<Method>("vortex", "plane_strain", h, error, least_order,
                      [](double cell, double courant) { return run<Method>(vortex{}, cell, courant); });
}
template <class Method> void check_axis_aligned(double h, double error, double least_order) {
  check_order<Method>("axis-aligned", "plane_strain", h, error, least_order,
                      [](double cell, double courant) { return run<Method>(axis_aligned{}, cell, courant); });
}
template <class Method> void check_expanding_ring_in_plane_strain(double h, double error, double least_order) {
  check_order<Method>("expanding ring", "plane_strain", h, error, least_order,
                      [](double cell, double courant) { return run<Method>(expanding_ring{}, cell, courant); });
}
template <class Method> void check_expanding_ring(double h, double error, double least_order) {
  check_order<Method>("expanding ring", "axisymmetric", h, error, least_order,
                      [](double cell, double courant) { return run_in_rz<Method>(expanding_ring{}, cell, courant); });
}

} // namespace bolide::verify
