// SPDX-License-Identifier: MIT
// Extremes 16 and 17: rigid flight over 1e4 cells at 7 and 70 km/s, and contact of very unequal materials: tungsten on foam, densities 1e3
// and 1e4 apart. (The Galilean shift of an impact: tests/verify/flight_test.cpp.)
#include "extreme/extreme.hpp"

namespace bolide {
namespace {
using namespace extreme;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
template <class Method> class Flight : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_musl, float_apic_musl>;
TYPED_TEST_SUITE(Flight, methods, method_names);

TYPED_TEST(Flight, TenThousandCellsMakeNoStress) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm, bulk = 2785 * 5328. * 5328.;
  for (const double v : {7e3, 70e3}) {
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<T>(), body{"bar", box{point{0.}, point{8 * h}}, aluminium(), h / 2, initial_state{2785, 0}, point{v}});
    sim.run(1e4 * h / v);
    double stress = 0, change = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      stress = std::max({stress, std::abs(value<field::pressure>(s, i)), std::abs(value<field::deviator>(s, i))});
      change = std::max(change, std::abs(value<field::velocity>(s, i) / v - 1));
    });
    constexpr bool is_float = sizeof(T) == 4, smooth = TypeParam::shape_type::smooth;
    // in float a tenth of an epsilon per step: how the sums happen to round
    const double velocity_bound = is_float ? std::max(1e-5, 0.1 * static_cast<double>(std::numeric_limits<T>::epsilon()) * static_cast<double>(sim.steps())) : 1e-12;
    auto to = tight<T>;
    if (is_float) to.momentum = velocity_bound;
    is_sound(sim, to);
    const auto row = [&](const char* measure, double got, double bound, double held) {
      verify::record(
          {.section = "extremes",
           .problem = "rigid flight over 1e4 cells at " + to_text(v / 1000) + " km/s",
           .composition = composition<TypeParam, space::planar_1d>(),
           .measure = measure,
           .value = got,
           .bound = bound,
           .note = is_float  ? "positions of 1 m are known to 6e-4 of a cell"
                   : !smooth ? "FLIP with linear shapes amplifies round-off by its cell crossings, slowly; over 2000 cells it keeps 1e-9"
                             : ""});
      EXPECT_LT(got, held) << measure;
    };
    row("largest stress over the bulk modulus", stress / bulk, is_float ? 1e-3 : 1e-9, is_float ? 1e-3 : smooth ? 1e-9 : 0.05);
    row("velocity, largest relative change", change, velocity_bound, is_float || smooth ? velocity_bound : 0.05);
  }
}

/// A tungsten plate of 1 mm at 1 km/s pushes a foam of 1/1000 and 1/10000 of its density: no tungsten point may pass a foam point, and the
/// step is that of the tungsten.
TYPED_TEST(Flight, TungstenDoesNotEnterFoam) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  const double h = 0.1 * mm, v = 1000, c_tungsten = 4030;
  const material tungsten{eos::mie_grueneisen{{.rho0 = 19300, .c0 = c_tungsten, .s = 1.237, .gamma0 = 1.54, .constant_gamma = true}},
                          strength::none{}, failure::none{}};
  for (const double ratio : {1e3, 1e4}) {
    const double rho = 19300 / ratio;
    const material foam{eos::mie_grueneisen{{.rho0 = rho, .c0 = 400, .s = 1.4, .gamma0 = 1, .constant_gamma = true}}, strength::none{},
                        failure::none{}};
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<T>(), body{"tungsten", box{point{-1 * mm}, point{0.}}, tungsten, h / 2, initial_state{19300, 0}, point{v}},
        body{"foam", box{point{0.}, point{4 * mm}}, foam, h / 4, initial_state{rho, 0}});
    double overlap = -1, longest = 0;
    while (sim.time() < 1 * us) {
      sim.step(1 * us - sim.time());
      double front = -1, back = 1;
      for_each_particle(sim, [&](const auto& s, std::size_t i) {
        const double x = value<field::position>(s, i);
        if (s.name == "foam") back = std::min(back, x);
        else front = std::max(front, x);
      });
      overlap = std::max(overlap, (front - back) / h);
      longest = std::max(longest, sim.dt());
    }
    is_sound(sim);
    const auto row = [&](const char* measure, double got, double bound, const char* unit) {
      verify::record({.section = "extremes",
                      .problem = "tungsten at 1 km/s on foam of 1/" + to_text(ratio) + " of its density",
                      .composition = composition<TypeParam, space::planar_1d>(),
                      .measure = measure,
                      .value = got,
                      .bound = bound,
                      .unit = unit,
                      .note = floors(sim)});
      EXPECT_LT(got, bound) << measure;
    };
    row("deepest overlap of their points + 1 (below 1: none)", overlap + 1, 1, "cells");
    row("longest step over 0.4 h/(c + v) of the tungsten", longest / (0.4 * h / (c_tungsten + v)), 1.001, "");
  }
}

} // namespace
} // namespace bolide
