// SPDX-License-Identifier: MIT
// The stable range of every combination of shape, transfer and scheme, measured: the largest Courant number and the largest impact speed by
// bisection, and the stretch at which the grid loses a body. Section "stable range" of the table, each with the reason for its limit.
//
// Courant number: a free elastic bar in its first mode without viscosity over ten periods; stable while its kinetic energy never
// exceeds 1.05 of the start.
//   The step of the library is courant h / (c + |v|) and is at most 1.5 (controls::validate). An explicit step of the grid alone is stable
//   up to h_eff/c: linear shapes with lumped mass have omega_max = 2 c/h, dt = h/c; points off the middle of a cell make it less.
// Speed: the flyer at Courant 0.4, time scaled; stable while the run ends and the kinetic energy never exceeds the initial. Searched to
// 1000 km/s. Stretch: a failed bar, v = H x; the volumes of its points fall 20 % behind where they are a support apart.
#include "extreme/extreme.hpp"

#include "bolide/failure/tension.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/viscosity/none.hpp"

#include <algorithm>

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 1>;

using cubic_flip_musl = method<shape::cubic_bspline, transfer::flip, scheme::musl>;
using cubic_apic_musl = method<shape::cubic_bspline, transfer::apic, scheme::musl>;
template <class Method> class StableRange : public testing::Test {};
using methods = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl,
                               cubic_flip_musl>;
TYPED_TEST_SUITE(StableRange, methods, method_names);

/// Does the bar keep its energy at this Courant number? `per_cell` points per cell; the bar starts `off` cells from a face.
template <class Method> bool bar_is_stable(double courant, int per_cell, double off) {
  const double h = 0.1 * mm, length = 20 * h, c0 = 5328, v0 = 1;
  const material al{eos::mie_grueneisen{}, strength::none{}, failure::none{}, viscosity::none{}};
  auto c = one_thread<double>();
  c.courant = courant;
  c.energy_bound = 1e6;
  auto sim = make<Method, space::planar_1d>(
      h, c, body{"bar", box{point{off * h}, point{off * h + length}}, al, h / per_cell, initial_state{2785, 0}});
  sim.for_each_body([&](auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      s.columns.template get<field::velocity>()[i] = v0 * std::cos(std::numbers::pi * (value<field::position>(s, i) - off * h) / length);
  });
  const double start = sim.energies().now.kinetic, until = 10 * 2 * length / c0;
  try {
    for (int i = 0; sim.time() < until; ++i) {
      sim.step(until - sim.time());
      if (i % 8 == 0 && !(sim.energies().now.kinetic < 1.05 * start)) return false;
    }
  } catch (const run_stopped&) { return false; }
  return true;
}
template <class F> double largest(double low, double high, int halvings, F&& stable) {
  if (stable(high)) return high;
  if (!stable(low)) return 0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}
template <class Method>
void record(const std::string& problem, const char* measure, double got, const char* unit, const std::string& note) {
  verify::record({.section = "stable range",
                  .problem = problem,
                  .composition = composition<Method, space::planar_1d>(),
                  .measure = measure,
                  .value = got,
                  .unit = unit,
                  .note = note});
}

TYPED_TEST(StableRange, CourantNumber) {
  const double most = largest(0.05, 1.5, 6, [](double c) {
    for (const int per_cell : {2, 3})
      for (const double off : {0.0, 0.3})
        if (!bar_is_stable<TypeParam>(c, per_cell, off)) return false;
    return true;
  });
  record<TypeParam>("elastic bar, ten periods, 2 and 3 points per cell, on and off the grid", "largest Courant number", most, "",
                    most >= 1.5 ? "the most that controls allow"
                                : "beyond it the kinetic energy grows: the highest mode of the grid, or of particles near empty nodes");
  EXPECT_GT(most, 0.4) << "the default must be stable";
}

TYPED_TEST(StableRange, Speed) {
  std::string why = "none found up to it";
  const auto stable = [&](double kilometres) {
    const double v = kilometres * 1e3;
    const body flyer{"flyer", box{point{-1 * mm}, point{0.}}, aluminium(), 0.05 * mm, initial_state{2785, 0}, point{v}};
    const body plate{"plate", box{point{0.}, point{1 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 0}};
    auto sim = make<TypeParam, space::planar_1d>(0.1 * mm, one_thread<double>(), flyer, plate);
    const double start = sim.energies().now.kinetic, until = 0.5 * us * 6640 / v;
    try {
      while (sim.time() < until) {
        sim.step(until - sim.time());
        if (!(sim.energies().now.kinetic < 1.01 * start)) {
          why = "kinetic energy exceeds the initial";
          return false;
        }
      }
    } catch (const run_stopped& e) {
      why = std::string(e.what()).substr(0, 100);
      return false;
    }
    return true;
  };
  const double most = largest(1, 1000, 7, stable);
  record<TypeParam>("flyer on plate, Courant 0.4, Mie-Grueneisen", "largest speed", most, "km/s", why);
  EXPECT_GE(most, 70);
}

TYPED_TEST(StableRange, Stretch) {
  const double h = 0.1 * mm, rate = 1e6, length = 4 * mm;
  const material al{eos::mie_grueneisen{{.constant_gamma = true}}, strength::none{}, failure::tension{1.5e9}};
  for (const int per_cell : {2, 4}) {
    auto sim = make<TypeParam, space::planar_1d>(
        h, one_thread<double>(), body{"bar", box{point{-length / 2}, point{length / 2}}, al, h / per_cell, initial_state{2785, 0}});
    sim.for_each_body([&](auto& s) {
      auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        p.template get<field::velocity>()[i] = rate * value<field::position>(s, i);
        p.template get<field::failed>()[i] = 1;
        if constexpr (TypeParam::transfer_type::affine) p.template get<field::affine_velocity>()[i] = rate;
      }
    });
    double onset = 0;
    while (onset == 0 && rate * sim.time() < 99) {
      sim.step();
      double volume = 0;
      for_each_particle(sim, [&](const auto& s, std::size_t i) { volume += value<field::volume>(s, i); });
      if (std::abs(volume / (length * (1 + rate * sim.time())) - 1) > 0.2) onset = 1 + rate * sim.time();
    }
    record<TypeParam>("failed bar pulled apart, " + std::to_string(per_cell) + " points per cell", "stretch at which volumes are 20 % off",
                      onset, "", "points a support apart no longer see each other: numerical fracture");
    EXPECT_GT(onset, 1.2 * per_cell);
  }
}

} // namespace
} // namespace bolide
