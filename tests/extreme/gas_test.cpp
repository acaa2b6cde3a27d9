// SPDX-License-Identifier: MIT
// optimise: -O1
// Extremes 3 to 6, gas in one dimension: the 123 problem and ten times its speed (true vacuum), LeBlanc, the double blast wave, free
// expansion.
//
// Where gas thins by 18 (LeBlanc) or 46 (123), two points per cell end up 9 or 23 cells apart and no longer see each other: the driver gas
// is seeded finer by so much, as its user must. The viscosity of noh.hpp for APIC; FLIP has none of its own and takes more.
#include "extreme/noh.hpp"

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 1>;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
template <class Method> viscosity::bulk weak() {
  return Method::transfer_type::affine ? viscosity::bulk{0.1, 0.1} : viscosity::bulk{0.67, 0.3};
}
template <class Method> void report(const char* problem, const char* measure, double value, double bound, const std::string& note = "",
                                    const char* unit = "", double order = verify::none) {
  verify::record({.section = "extremes",
                  .problem = problem,
                  .composition = composition<Method, space::planar_1d>(),
                  .measure = measure,
                  .value = value,
                  .bound = bound,
                  .order = order,
                  .unit = unit,
                  .note = note});
}

template <class Method> class Gas : public testing::Test {};
using methods = testing::Types<bspline_apic_musl, bspline_flip_musl, float_apic_musl>;
TYPED_TEST_SUITE(Gas, methods, method_names);

/// Densities are volumes per mass and stay positive; the step must follow c and v, not collapse where nothing is.
TYPED_TEST(Gas, ReceivesAVacuum) {
  using T = typename TypeParam::scalar;
  for (const double u : {2.0, 20.0}) {
    const double h = 0.005, t = 0.15 * 2 / u, c0 = std::sqrt(1.4 * 0.4), front = u + 5 * c0;
    const auto matter = gas(1.4, 1, weak<TypeParam>());
    const initial_state at{1, 1};
    auto sim =
        make<TypeParam, space::planar_1d>(h, one_thread<T>(), body{"left", box{point{-0.5}, point{0.}}, matter, h / 40, at, point{-u}},
                                          body{"right", box{point{0.}, point{0.5}}, matter, h / 40, at, point{u}});
    sim.run(t);
    is_sound(sim);
    double mass = 0, volume = 0, thinnest = 1, fastest = 0;
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      const double m = value<field::mass>(s, i), v = value<field::volume>(s, i), x = value<field::position>(s, i);
      thinnest = std::min(thinnest, m / v);
      fastest = std::max(fastest, std::abs(value<field::velocity>(s, i)));
      if (std::abs(x) < 0.15 * t) mass += m, volume += v;
    });
    const double wanted_steps = t * (u + c0) / (0.4 * h);
    const std::string note = floors(sim) + ", least density " + to_text(thinnest);
    const std::string name = "123 problem, speed " + to_text(u) + ", 200 cells";
    report<TypeParam>(name.c_str(), "steps over t (c+v)/(Courant h)", static_cast<double>(sim.steps()) / wanted_steps, 3, note);
    report<TypeParam>(name.c_str(), "fastest particle over the exact front", fastest / front, 1, note);
    if (u == 2)
      report<TypeParam>(name.c_str(), "density at the middle, error", mass / volume / 0.0218521 - 1, verify::none,
                        "points drift a cell apart there");
    EXPECT_GT(thinnest, 0);
    EXPECT_LT(static_cast<double>(sim.steps()), 3 * wanted_steps);
    EXPECT_LT(fastest, front);
  }
}

/// LeBlanc's shock tube: pressure ratio 1e10, density ratio 1e3. Shock at 7.9747 at t = 6.
TYPED_TEST(Gas, LeBlancShockArrives) {
  using T = typename TypeParam::scalar;
  double errors[3];
  int k = 0;
  for (const int cells : {200, 500, 2000}) {
    const double h = 9.0 / cells, low = -(cells / 3) * h, high = (cells - cells / 3) * h;
    const auto matter = gas(5.0 / 3, 1, weak<TypeParam>());
    auto sim = make<TypeParam, space::planar_1d>(h, one_thread<T>(),
                                                 body{"driver", box{point{low}, point{0.}}, matter, h / 24, initial_state{1, 0.1}},
                                                 body{"driven", box{point{0.}, point{high}}, matter, h / 2, initial_state{0.001, 1e-7}});
    sim.add(grid::mirror{0, low, true}).add(grid::mirror{0, high, false});
    sim.run(6);
    is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-3, sizeof(T) == 8 ? 1e-9 : 1e-2, 2});
    double shock = 0; // the outermost driven gas that is compressed halfway, 0.001 to 0.004
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      if (s.name == "driven" && value<field::mass>(s, i) / value<field::volume>(s, i) > 0.0025)
        shock = std::max(shock, value<field::position>(s, i));
    });
    errors[k] = shock / (7.9747 - 3) - 1;
    const std::string name = "LeBlanc, " + std::to_string(cells) + " cells";
    report<TypeParam>(name.c_str(), "shock position from the diaphragm, error", errors[k], cells == 2000 ? 0.02 : verify::none,
                      floors(sim));
    ++k;
  }
  EXPECT_LT(std::abs(errors[2]), 0.02);
  EXPECT_LT(std::abs(errors[2]), std::abs(errors[0]));
}

} // namespace
} // namespace bolide
