// SPDX-License-Identifier: MIT
// What the tests of smooth and solid problems share: linear elastic materials, initial velocity fields, an order from errors, names of compositions.
//
// Elastic material: p = K (rho/rho0 - 1), Jaumann rate with shear modulus G, no heat, no artificial viscosity. Linear for small strain, which the
// exact answers are; energy is not asked for by the pressure but advanced all the same, so that the ledger can be read.
#pragma once

#include "verify/table.hpp"

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace bolide::verify {
using namespace test;

/// p = K (rho/rho0 - 1).
struct linear_solid {
  double bulk_modulus = 1, rho0 = 1; // Pa, kg/m3
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(bulk_modulus) * (rho * T(1 / rho0) - T(1)), V(T(bulk_modulus / rho0))};
  }
  double reference_density() const { return rho0; }
};
static_assert(EquationOfState<linear_solid>);

struct moduli {
  double e, nu, rho; // Young's modulus (Pa), Poisson's ratio, density (kg/m3)
  double bulk() const { return e / (3 * (1 - 2 * nu)); }
  double shear() const { return e / (2 * (1 + nu)); }
  double longitudinal_speed() const { return std::sqrt((bulk() + 4.0 / 3 * shear()) / rho); }
  double shear_speed() const { return std::sqrt(shear() / rho); }
};
inline auto elastic(const moduli& m) {
  return material{linear_solid{m.bulk(), m.rho}, strength::elastic_perfectly_plastic{m.shear(), std::numeric_limits<double>::infinity()},
                  failure::none{}, viscosity::none{}};
}

/// "axisymmetric, quadratic_bspline, apic, usf, double"
template <class Method> std::string composition(const char* space) {
  return std::string(space) + ", " + Method::shape_type::name + ", " + Method::transfer_type::name + ", " + Method::scheme_type::name + ", " +
         (sizeof(typename Method::scalar) == 4 ? "float" : "double");
}

/// velocity(x) and its in-plane gradient(x)(i, j) = dv_i/dx_j, which APIC carries; before the first step.
template <class Solver, class Velocity, class Gradient> void start_moving(Solver& sim, Velocity&& velocity, Gradient&& gradient) {
  constexpr int dim = Solver::dim;
  using scalar = typename Solver::scalar;
  sim.for_each_body([&](auto& s) {
    auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      vec<double, dim> x;
      for (int d = 0; d < dim; ++d) x[d] = static_cast<double>(p.template get<field::position>(d)[i]);
      const vec<double, dim> v = velocity(x);
      for (int d = 0; d < dim; ++d) p.template get<field::velocity>(d)[i] = static_cast<scalar>(v[d]);
      if constexpr (std::remove_cvref_t<decltype(p)>::template has<field::affine_velocity>) {
        const auto g = gradient(x);
        for (int c = 0; c < dim * dim; ++c) p.template get<field::affine_velocity>(c)[i] = static_cast<scalar>(g(c / dim, c % dim));
      }
    }
  });
}

/// Positions by particle id.
template <class Solver> std::vector<vec<double, Solver::dim>> positions(const Solver& sim) {
  std::vector<vec<double, Solver::dim>> x(sim.particle_count());
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      for (int d = 0; d < Solver::dim; ++d) x[s.columns.id()[i]][d] = static_cast<double>(s.columns.template get<field::position>(d)[i]);
  });
  return x;
}

/// f(id, mass, velocity) for every particle.
template <class Solver, class F> void each_velocity(const Solver& sim, F&& f) {
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      vec<double, Solver::dim> v;
      for (int d = 0; d < Solver::dim; ++d) v[d] = static_cast<double>(p.template get<field::velocity>(d)[i]);
      f(p.id()[i], static_cast<double>(p.template get<field::mass>()[i]), v);
    }
  });
}

/// Order between two errors of resolutions that differ by 2.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

} // namespace bolide::verify
