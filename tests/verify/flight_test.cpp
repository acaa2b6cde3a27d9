// SPDX-License-Identifier: MIT
// Rigid flight over many cells, and Galilean shift: the grid must not be felt by what merely moves through it.
#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {
using namespace test;

template <class Method> class Flight : public testing::Test {};
TYPED_TEST_SUITE(Flight, every_method, method_names);

/// A ball at rest in itself flies 2000 cells at 7 km/s along z: no stress, the velocity kept.
TYPED_TEST(Flight, OfARigidBallMakesNoStress) {
  using point = vec<double, 2>;
  const body ball{"ball", sphere{point{0, 0}, 0.4 * mm}, aluminium(), 0.05 * mm, initial_state{2785, 0}, point{0, 7000.}};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<double>(), ball};
  sim.run(0.2 / 7000);
  double worst = 0, dv = 0;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      worst = std::max(worst, std::abs(p.template get<field::pressure>()[i]));
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(p.template get<field::deviator>(c)[i]));
      dv = std::max(dv, std::abs(p.template get<field::velocity>(1)[i] - 7000));
    }
  });
  const double bulk = 2785 * 5328.0 * 5328.0;
  std::printf("[ figures  ] %-17s 2000 cells, %ld steps: stress over bulk modulus %.1e, velocity change %.1e m/s\n", TypeParam::name().c_str(), sim.steps(), worst / bulk, dv);
  EXPECT_LT(worst / bulk, 1e-9);
  EXPECT_LT(dv, 1e-6);
  EXPECT_LT(std::abs(sim.energies().momentum_error(1)), 1e-12);
}

struct summary {
  double kinetic, internal, volume, plastic;
  std::uint64_t failed;
};
template <class Solver> summary summarise(Solver& sim, double drift) {
  summary r{};
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      r.kinetic += 0.5 * p.template get<field::mass>()[i] * (square(p.template get<field::velocity>(0)[i]) + square(p.template get<field::velocity>(1)[i] - drift));
      r.volume += p.template get<field::volume>()[i];
      r.failed += p.template get<field::failed>()[i] > 0;
    }
  });
  r.internal = sim.energies().now.internal;
  r.plastic = sim.energies().plastic_work;
  return r;
}

template <class Method> class Galilei : public testing::Test {};
TYPED_TEST_SUITE(Galilei, every_method, method_names);

/// The whole scene moved by a whole number of cells: the same to round-off.
TYPED_TEST(Galilei, ShiftByWholeCellsChangesNothing) {
  auto a = small_impact<TypeParam>(), b = small_impact<TypeParam>(aluminium(), {}, one_thread<double>(), 64 * 0.1 * mm);
  a.run(0.08 * us);
  b.run(0.08 * us);
  const auto x = summarise(a, 0), y = summarise(b, 0);
  EXPECT_NEAR(y.kinetic / x.kinetic, 1, 1e-6);
  EXPECT_NEAR(y.internal / x.internal, 1, 1e-6);
  EXPECT_EQ(a.steps(), b.steps());
}

/// The whole scene in a frame that moves at 3 km/s: another part of the grid under every particle and shorter steps. The difference is reported;
/// its bar is a few times that of a shift of the lattice against the grid.
TYPED_TEST(Galilei, BoostIsReported) {
  auto a = small_impact<TypeParam>(), shifted = small_impact<TypeParam>(aluminium(), {}, one_thread<double>(), 0.0437 * mm),
       boosted = small_impact<TypeParam>(aluminium(), {}, one_thread<double>(), 0, 3000);
  a.run(0.15 * us);
  shifted.run(0.15 * us);
  boosted.run(0.15 * us);
  const auto x = summarise(a, 0), s = summarise(shifted, 0), y = summarise(boosted, 3000);
  std::printf("[ figures  ] %-17s kinetic energy in the frame of the plate: sub-cell shift %+.2f %%, boost %+.2f %%; failed particles %lu, %lu, %lu\n", TypeParam::name().c_str(),
              100 * (s.kinetic / x.kinetic - 1), 100 * (y.kinetic / x.kinetic - 1), static_cast<unsigned long>(x.failed), static_cast<unsigned long>(s.failed),
              static_cast<unsigned long>(y.failed));
  EXPECT_NEAR(y.kinetic / x.kinetic, 1, 0.05);
}

} // namespace
} // namespace bolide
