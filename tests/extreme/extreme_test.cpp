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

} // namespace
} // namespace bolide
