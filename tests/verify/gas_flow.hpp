// SPDX-License-Identifier: MIT
// What the tests of gas flow share: starts given by place, volume-weighted L1 errors against an exact solution, and their rows in the table.
//
// Errors are relative: sum V |q - q_exact| / sum V |q_exact| over the particles of a window, V the particle's volume.
#pragma once

#include "verify/exact/flow.hpp"
#include "verify/ideal_gas.hpp"
#include "verify/table.hpp"

#include "bolide/failure/none.hpp"
#include "bolide/strength/none.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace bolide::verify {
using namespace test;

/// "planar_1d, bspline, apic, usf, double"
template <class Method> std::string composed(const char* space) {
  return std::string(space) + ", " + Method::shape_type::name + ", " + Method::transfer_type::name + ", " + Method::scheme_type::name + ", " +
         (sizeof(typename Method::scalar) == 4 ? "float" : "double");
}
/// A solver of a method's parts; its transfer with default settings.
template <class Method, class Space, class... Bodies> auto solve(const Space& space, double h, const controls<typename Method::scalar>& c, const Bodies&... bodies) {
  return solver{space, grid::sparse{h}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c, bodies...};
}

/// What lies between two spheres about the origin where no coordinate is negative: the half of a sphere in r-z, a quarter of a disc, an octant.
/// (A body that reaches beyond a mirror is folded onto the other half: two bodies in one place.)
template <int Dim> struct positive_part {
  static constexpr int dim = Dim;
  double inner, outer;
  vec<double, Dim> anchor() const { return vec<double, Dim>::Zero(); }
  vec<double, Dim> low() const { return vec<double, Dim>::Zero(); }
  vec<double, Dim> high() const { return vec<double, Dim>::Constant(outer); }
  bool contains(const vec<double, Dim>& x, double) const { return (x.array() > 0).all() && x.norm() > inner && x.norm() < outer; }
  double volume(bool radial) const { return shell<Dim>(anchor(), inner, outer).volume(radial) / (radial ? 2 : 1 << Dim); }
};

/// velocity(x) for every particle before the first step, with its gradient where the transfer carries one.
template <class Solver, class Velocity> void set_in_motion(Solver& sim, Velocity&& velocity) {
  constexpr int dim = Solver::dim;
  using scalar = typename Solver::scalar;
  sim.initialise([&](auto& point) { point.velocity = velocity(point.position); });
  sim.for_each_body([&](auto& s) {
    auto& p = s.columns;
    if constexpr (std::remove_cvref_t<decltype(p)>::template has<field::affine_velocity>)
      for (std::size_t i = 0; i < p.size(); ++i)
        for (int d = 0; d < dim; ++d) {
          vec<double, dim> x, step = vec<double, dim>::Zero();
          for (int c = 0; c < dim; ++c) x[c] = static_cast<double>(p.template get<field::position>(c)[i]);
          step[d] = 1e-4 * sim.cell();
          const vec<double, dim> slope = (velocity(vec<double, dim>(x + step)) - velocity(vec<double, dim>(x - step))) / (2 * step[d]);
          for (int c = 0; c < dim; ++c) p.template get<field::affine_velocity>(c * dim + d)[i] = static_cast<scalar>(slope[c]);
        }
  });
}

/// One particle as the measures see it: its distance along the only coordinate of the exact solution (x, or |x| over the first `axes` axes).
struct sample {
  double r, volume, mass, u, p, e;
};
template <class Solver, class F> void each_sample(const Solver& sim, int axes, F&& f) {
  sim.for_each_body([&](const auto& s) {
    const auto& c = s.columns;
    for (std::size_t i = 0; i < c.size(); ++i) {
      double r = static_cast<double>(c.template get<field::position>(0)[i]), u = static_cast<double>(c.template get<field::velocity>(0)[i]);
      if (axes > 1) {
        double r2 = 0, product = 0;
        for (int d = 0; d < axes; ++d) {
          const double x = static_cast<double>(c.template get<field::position>(d)[i]);
          r2 += x * x, product += x * static_cast<double>(c.template get<field::velocity>(d)[i]);
        }
        r = std::sqrt(r2), u = product / r;
      }
      f(sample{r, static_cast<double>(c.template get<field::volume>()[i]), static_cast<double>(c.template get<field::mass>()[i]), u,
               static_cast<double>(c.template get<field::pressure>()[i]), static_cast<double>(c.template get<field::energy>()[i])});
    }
  });
}

struct l1 {
  double rho = 0, u = 0, p = 0;
  double seconds = 0;
};
/// exact(r) -> flow, inside(r) -> bool.
template <class Solver, class Exact, class Inside> l1 l1_errors(const Solver& sim, int axes, Exact&& exact, Inside&& inside) {
  flow error, scale;
  each_sample(sim, axes, [&](const sample& s) {
    if (!inside(s.r)) return;
    const flow x = exact(s.r);
    error.rho += s.volume * std::abs(s.mass / s.volume - x.rho), scale.rho += s.volume * x.rho;
    error.u += s.volume * std::abs(s.u - x.u), scale.u += s.volume * std::abs(x.u);
    error.p += s.volume * std::abs(s.p - x.p), scale.p += s.volume * x.p;
  });
  return {error.rho / scale.rho, error.u / scale.u, error.p / scale.p, sim.solver_seconds()};
}

/// The same of means over shells one cell thick from r = `from` to `to`: density and pressure as the grid sees them (mass over volume, V p over V),
/// velocity of the momentum. What a particle differs from the mean of its cell is no part of it: see scatter_of_pressure.
template <class Solver, class Exact> l1 l1_errors_of_shells(const Solver& sim, int axes, double from, double to, Exact&& exact) {
  const double h = sim.cell();
  struct sums {
    double volume = 0, mass = 0, momentum = 0, work = 0;
  };
  std::vector<sums> shells(static_cast<std::size_t>(std::lround((to - from) / h)));
  each_sample(sim, axes, [&](const sample& s) {
    const double at = (s.r - from) / h;
    if (at < 0 || at >= static_cast<double>(shells.size())) return;
    auto& c = shells[static_cast<std::size_t>(at)];
    c.volume += s.volume, c.mass += s.mass, c.momentum += s.mass * s.u, c.work += s.volume * s.p;
  });
  flow error, scale;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const auto& c = shells[i];
    if (!(c.volume > 0)) continue;
    const flow x = exact(from + (static_cast<double>(i) + 0.5) * h);
    error.rho += c.volume * std::abs(c.mass / c.volume - x.rho), scale.rho += c.volume * x.rho;
    error.u += c.volume * std::abs(c.momentum / c.mass - x.u), scale.u += c.volume * std::abs(x.u);
    error.p += c.volume * std::abs(c.work / c.volume - x.p), scale.p += c.volume * x.p;
  }
  return {error.rho / scale.rho, error.u / scale.u, error.p / scale.p, sim.solver_seconds()};
}
/// Standard deviation of the particles' pressure over its mean where it should be uniform, r = `from` to `to`.
template <class Solver> double scatter_of_pressure(const Solver& sim, int axes, double from, double to) {
  double n = 0, sum = 0, squares = 0;
  each_sample(sim, axes, [&](const sample& s) {
    if (s.r > from && s.r < to) n += 1, sum += s.p, squares += s.p * s.p;
  });
  return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n))) / (sum / n);
}

inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// A row, and a failure of the test where it is not met.
inline void record_and_check(const row& r) {
  record(r);
  EXPECT_TRUE(r.met()) << r.problem << ", " << r.composition << ": " << r.measure << " = " << r.value;
}

/// What a problem asks of its errors at the finest resolution; `note` goes with every row.
struct asked {
  double rho = none, u = none, p = none, order = none;
  std::string note{};
};
/// Rows of the three errors at the finest of resolutions that double. A row that is not met fails the test, too.
inline void record_errors(const std::string& problem, const std::string& composition, const std::string& resolution, const std::vector<l1>& errors, const asked& bounds) {
  const auto one = [&](const char* what, double l1::* part, double bound) {
    const double fine = errors.back().*part;
    const row r{.section = "shocks", .problem = problem, .composition = composition, .measure = std::string("L1 error of ") + what + ", " + resolution, .value = fine,
                .bound = bound, .order = errors.size() > 1 ? order(errors[errors.size() - 2].*part, fine) : none, .expected_order = bounds.order,
                .seconds = errors.back().seconds, .note = bounds.note};
    record_and_check(r);
  };
  one("density", &l1::rho, bounds.rho);
  one("velocity", &l1::u, bounds.u);
  one("pressure", &l1::p, bounds.p);
}

} // namespace bolide::verify
