// SPDX-License-Identifier: MIT
// Runs that must end well: finite states, books closed, floors counted. verification.md section 4 gives the problems their numbers.
#include "verify/ideal_gas.hpp"

#include "bolide/analysis/hugoniot.hpp"
#include "bolide/eos/tillotson.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {
using namespace test;

template <class Solver> void is_sound(Solver& sim) {
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      ASSERT_TRUE(p.template get<field::volume>()[i] > 0);
      for (int d = 0; d < Solver::dim; ++d) {
        ASSERT_TRUE(std::isfinite(p.template get<field::position>(d)[i]));
        ASSERT_TRUE(std::isfinite(p.template get<field::velocity>(d)[i]));
      }
      ASSERT_TRUE(std::isfinite(p.template get<field::energy>()[i]));
      ASSERT_TRUE(std::isfinite(p.template get<field::pressure>()[i]));
    }
  });
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-9);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-9);
  EXPECT_LT(std::abs(sim.energies().momentum_error(Solver::dim - 1)), 1e-12);
}

template <class Method> class Extreme : public testing::Test {};
TYPED_TEST_SUITE(Extreme, every_method, method_names);

/// The small impact at 20, 40 and 70 km/s, time scaled.
TYPED_TEST(Extreme, ImpactAtTensOfKilometresPerSecond) {
  using point = vec<double, 2>;
  const initial_state at{2785, 0};
  for (const double v : {20e3, 40e3, 70e3}) {
    const body ball{"ball", sphere{point{0, -0.4 * mm}, 0.4 * mm}, aluminium(), 0.05 * mm, at, point{0, v}};
    const body plate{"plate", box{point{0, 0}, point{2 * mm, 0.3 * mm}}, aluminium(), 0.05 * mm, at};
    solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
               one_thread<double>(), ball, plate};
    sim.run(1 * us * 6640 / v);
    is_sound(sim);
    std::printf("[ figures  ] %-17s %2.0f km/s: %ld steps, floors", TypeParam::name().c_str(), v / 1000, sim.steps());
    for (std::size_t k = 0; k < floor_names.size(); ++k) std::printf(" %s %lu", floor_names[k], static_cast<unsigned long>(sim.energies().floors.count[k]));
    std::printf("\n");
  }
}

/// Tiny nodal mass: one particle carried across a cell face and a cell centre in small steps, at weights down to round-off. It must not notice.
TYPED_TEST(Extreme, AParticleAloneCrossesFacesUnharmed) {
  using point = vec<double, 2>;
  for (const double start : {1e-300, 1e-18, 1e-12, 1e-6}) {
    const body grain{"grain", box{point{0.3 * mm, 0}, point{0.35 * mm, 0.05 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 1e4}, point{0, 1e-6}};
    solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
               one_thread<double>(), grain};
    sim.for_each_body([&](auto& s) { s.columns.template get<field::position>(1)[0] = -start * 0.1 * mm; });
    for (int i = 0; i < 200; ++i) sim.step();
    EXPECT_LT(std::abs(sim.energies().residual()), 1e-9);
    sim.for_each_body([&](const auto& s) { EXPECT_NEAR(s.columns.template get<field::velocity>(1)[0], 1e-6, 1e-10) << "start " << start; });
  }
}

/// The outermost ring of a body on the centre of a cell, where the far node's weight vanishes and the hoop force must vanish with it
/// (it did not once: APIC ended in a vanishing time step within two steps).
TYPED_TEST(Extreme, TheOutermostRingOnACellCentre) {
  using point = vec<double, 2>;
  const double h = 0.1 * mm;
  for (const double off : {0.0, 1e-14, -1e-14, 1e-9, 1e-5}) {
    const body disc{"disc", box{point{off * h, 0}, point{(6 + off) * h, 6 * h}}, aluminium(), h, initial_state{2785, 0}, point{0, 1000.}};
    const body wall{"wall", box{point{off * h, 6 * h}, point{(10 + off) * h, 10 * h}}, aluminium(), h, initial_state{2785, 0}};
    solver sim{space::axisymmetric{}, grid::sparse{h}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
               one_thread<double>(), disc, wall};
    for (int i = 0; i < 100; ++i) sim.step();
    is_sound(sim);
    EXPECT_GT(sim.time(), 0.1 * us) << "the time step must not collapse";
  }
}

/// Noh's implosion in r (k = 2) and in r-z (k = 3), gamma 5/3, v = -1, e = 0 (1e-10): plateau 16 and 64, shock at t/3. Recorded: the plateau is
/// low by wall heating, and by half in the sphere at this resolution (docs/validation.md); the bars hold the line.
template <class Method> class Noh : public testing::Test {};
using noh_methods = testing::Types<bspline_apic_usf, linear_flip_usf>;
TYPED_TEST_SUITE(Noh, noh_methods, method_names);

TYPED_TEST(Noh, CylinderAndSphere) {
  using point = vec<double, 2>;
  const double h = 0.01, t = 0.6;
  for (const int axes : {2, 3}) {
    const material gas{verify::ideal_gas{5.0 / 3, 1.0}, strength::none{}, failure::none{}};
    auto c = one_thread<double>();
    c.dt_floor = 1e-9;
    const auto run = [&](const auto& b) {
      solver sim{space::axisymmetric{}, grid::sparse{h}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{}, c, b};
      sim.add(grid::mirror{1, 0, true});
      if (axes == 2) sim.add(grid::mirror{1, 3 * h, false});
      sim.for_each_body([&](auto& s) {
        auto& p = s.columns;
        for (std::size_t i = 0; i < p.size(); ++i) {
          const double x = p.template get<field::position>(0)[i], z = axes == 2 ? 0 : p.template get<field::position>(1)[i], r = std::hypot(x, z);
          p.template get<field::velocity>(0)[i] = -x / r;
          p.template get<field::velocity>(1)[i] = -z / r;
        }
      });
      sim.run(t);
      EXPECT_LT(std::abs(sim.energies().residual()), 1e-9);
      EXPECT_LT(std::abs(sim.energies().drift()), 1e-9);
      double plateau = 0, volume = 0, wall = 0, wall_volume = 0;
      sim.for_each_body([&](const auto& s) {
        const auto& p = s.columns;
        for (std::size_t i = 0; i < p.size(); ++i) {
          const double x = p.template get<field::position>(0)[i], z = axes == 2 ? 0 : p.template get<field::position>(1)[i], r = std::hypot(x, z);
          ASSERT_TRUE(std::isfinite(r));
          const double m = p.template get<field::mass>()[i], v = p.template get<field::volume>()[i];
          if (r > 0.05 && r < 0.15) plateau += m, volume += v;
          if (r < 0.03) wall += m, wall_volume += v;
        }
      });
      const double exact = axes == 2 ? 16 : 64;
      std::printf("[ figures  ] Noh %-17s %s: density at 0.05..0.15 %.2f of %.0f (%+.1f %%), at r < 0.03 %.2f, %ld steps\n", TypeParam::name().c_str(),
                  axes == 2 ? "cylinder" : "sphere  ", plateau / volume, exact, 100 * (plateau / volume / exact - 1), wall / wall_volume, sim.steps());
      EXPECT_LT(plateau / volume, 1.1 * exact);
      EXPECT_GT(plateau / volume, (axes == 2 ? 0.8 : 0.5) * exact);
    };
    if (axes == 2) run(body{"cylinder", box{point{0, 0}, point{1, 3 * h}}, gas, h / 2, initial_state{1, 1e-10}});
    else run(body{"sphere", sphere{point{0, 0}, 1.0}, gas, h / 2, initial_state{1, 1e-10}});
  }
}

} // namespace
} // namespace bolide
