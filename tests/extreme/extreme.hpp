// SPDX-License-Identifier: MIT
// What every extreme run must keep (verification.md section 4): finite states, positive volumes, books closed, momentum kept; and a line
// that says which floors acted. Rows of the table: section "extremes".
#pragma once

#include "verify/ideal_gas.hpp"
#include "verify/table.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace bolide::extreme {
using namespace test;

using float_apic_usf = method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>;
using float_flip_musl = method<shape::quadratic_bspline, transfer::flip, scheme::musl, float>;

/// A solver of a method in a space.
template <class Method, class Space, class... Bodies>
auto make(double h, const controls<typename Method::scalar>& c, const Bodies&... bodies) {
  return solver{Space{}, grid::sparse{h}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{},
                c,       bodies...};
}
template <class Method, class Space> std::string composition() { return std::string(Space::name) + ", " + Method::name(); }

/// A gas without strength and failure.
template <class Viscosity = viscosity::bulk> auto gas(double gamma, double rho0 = 1, Viscosity q = Viscosity()) {
  return material{verify::ideal_gas{gamma, rho0}, strength::none{}, failure::none{}, q};
}

/// f(set, i) for every particle.
template <class Solver, class F> void for_each_particle(Solver& sim, F&& f) {
  sim.for_each_body([&](auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) f(s, i);
  });
}
template <class Tag, class Set> double value(const Set& s, std::size_t i, int c = 0) {
  return static_cast<double>(s.columns.template get<Tag>(c)[i]);
}

/// No NaN, no infinity, no volume that is not positive in any column; the books close.
struct tolerances {
  double books, drift, momentum;
};
template <class T> constexpr tolerances tight{sizeof(T) == 8 ? 1e-9 : 1e-3, sizeof(T) == 8 ? 1e-9 : 1e-2, sizeof(T) == 8 ? 1e-12 : 1e-4};

template <class Solver> void is_sound(Solver& sim, tolerances to = tight<typename Solver::scalar>) {
  std::size_t bad = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    bool good = value<field::volume>(s, i) > 0 && std::isfinite(value<field::volume>(s, i)) && std::isfinite(value<field::energy>(s, i)) &&
                std::isfinite(value<field::pressure>(s, i));
    for (int d = 0; d < Solver::dim; ++d)
      good = good && std::isfinite(value<field::position>(s, i, d)) && std::isfinite(value<field::velocity>(s, i, d));
    if constexpr (std::remove_cvref_t<decltype(s.columns)>::template has<field::deviator>)
      for (int c = 0; c < Solver::space::deviator_size; ++c) good = good && std::isfinite(value<field::deviator>(s, i, c));
    bad += !good;
  });
  EXPECT_EQ(bad, 0u) << "particles without a finite state and a positive volume";
  const auto& books = sim.energies();
  EXPECT_LT(std::abs(books.residual()), to.books);
  EXPECT_LT(std::abs(books.drift()), to.drift);
  EXPECT_LT(std::abs(books.momentum_error(Solver::dim - 1)), to.momentum);
}

/// "floors: expansion 12, reflected 3" or "no floor".
template <class Solver> std::string floors(Solver& sim) {
  std::string text;
  for (std::size_t k = 0; k < floor_names.size(); ++k)
    if (const auto n = sim.energies().floors.count[k])
      text += std::string(text.empty() ? "floors: " : ", ") + floor_names[k] + " " + std::to_string(n);
  return text.empty() ? "no floor" : text;
}

} // namespace bolide::extreme
