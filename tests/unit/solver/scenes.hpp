// SPDX-License-Identifier: MIT
// Small scenes for tests of the solver: a 1-D flyer and an r-z impact of a sphere on a plate, in any composition.
#pragma once

#include "bolide/core/unit.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/johnson_cook.hpp"
#include "bolide/strength/none.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>

namespace bolide::test {

using unit::mm;
using unit::us;

/// Shape, transfer, scheme and number type of a composition.
template <class Shape, class Transfer, class Scheme, class T = double> struct method {
  using shape_type = Shape;
  using transfer_type = Transfer;
  using scheme_type = Scheme;
  using scalar = T;
  static std::string name() {
    return std::string(Shape::name) + "_" + Transfer::name + "_" + Scheme::name + (sizeof(T) == 4 ? "_float" : "");
  }
};
using linear_flip_usf = method<shape::linear, transfer::flip, scheme::usf>;
using linear_flip_musl = method<shape::linear, transfer::flip, scheme::musl>;
using bspline_flip_usf = method<shape::quadratic_bspline, transfer::flip, scheme::usf>;
using bspline_flip_musl = method<shape::quadratic_bspline, transfer::flip, scheme::musl>;
using bspline_apic_usf = method<shape::quadratic_bspline, transfer::apic, scheme::usf>;
using bspline_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl>;
using every_method = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl>;
struct method_names {
  template <class M> static std::string GetName(int) { return M::name(); }
};

inline auto aluminium() {
  return material{eos::isentrope_temperature{eos::mie_grueneisen{{.constant_gamma = true}}}, strength::johnson_cook{}, failure::tension_or_melt{1.5e9}};
}
template <class T> controls<T> one_thread() {
  controls<T> c;
  c.threads = 1;
  return c;
}

/// A sphere of 0.8 mm on a plate of 0.3 mm at 6640 m/s: 88 and 240 particles, cells of 0.1 mm. Axis, free surfaces, failure, strength.
template <class Method, class Material = decltype(aluminium())>
auto small_impact(const Material& al = aluminium(), typename Method::transfer_type transfer = {}, controls<typename Method::scalar> c = one_thread<typename Method::scalar>(),
                  double shift = 0, double drift = 0) {
  using point = vec<double, 2>;
  const initial_state at{2785, 0};
  const body ball{"ball", sphere{point{0, -0.4 * mm + shift}, 0.4 * mm}, al, 0.05 * mm, at, point{0, 6640 + drift}};
  const body plate{"plate", box{point{0, shift}, point{2 * mm, 0.3 * mm + shift}}, al, 0.05 * mm, at, point{0, drift}};
  return solver{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename Method::shape_type{}, transfer, typename Method::scheme_type{}, c, ball, plate};
}

/// A flyer of 1 mm on a plate of 1 mm at 6640 m/s: 40 particles.
template <class Method, class Material = decltype(aluminium())>
auto small_flyer(const Material& al = aluminium(), typename Method::transfer_type transfer = {}, controls<typename Method::scalar> c = one_thread<typename Method::scalar>()) {
  using point = vec<double, 1>;
  const initial_state at{2785, 0};
  const body flyer{"flyer", box{point{-1 * mm}, point{0}}, al, 0.05 * mm, at, point{6640.}};
  const body plate{"plate", box{point{0}, point{1 * mm}}, al, 0.05 * mm, at};
  return solver{space::planar_1d{}, grid::sparse{0.1 * mm}, typename Method::shape_type{}, transfer, typename Method::scheme_type{}, c, flyer, plate};
}

/// FNV-1a over the bits of every column of every body, in the order of particle ids.
template <class Solver> std::uint64_t state_hash(const Solver& sim) {
  std::uint64_t hash = 1469598103934665603ull;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p.id()[a] < p.id()[b]; }); // particles may have left
    const auto add = [&]<class... F>(fields<F...>) {
      const auto one = [&]<class Tag>(Tag) {
        for (int c = 0; c < Solver::space::components(Tag::order); ++c)
          for (const auto i : order) {
            typename Solver::scalar x = p.template get<Tag>(c)[i];
            unsigned char bytes[sizeof x];
            std::memcpy(bytes, &x, sizeof x);
            for (const auto b : bytes) hash = (hash ^ b) * 1099511628211ull;
          }
      };
      (one(F{}), ...);
    };
    add(typename std::remove_cvref_t<decltype(p)>::field_list{});
  });
  return hash;
}

} // namespace bolide::test
