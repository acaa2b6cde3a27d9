// SPDX-License-Identifier: MIT
// The energy ledger and momentum for every scheme, shape and transfer, on a 1-D flyer and an r-z impact: the books close, the channels are
// real, and nothing is a remainder.
#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {
using namespace test;

/// Energies from the particles alone, the ledger's own sums unused.
template <class Method, class Solver> double particle_energy(const Solver& sim) {
  double e = 0;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      double v2 = 0;
      for (int d = 0; d < Solver::dim; ++d) v2 += square(static_cast<double>(p.template get<field::velocity>(d)[i]));
      if constexpr (Method::transfer_type::affine)
        for (int c = 0; c < Solver::dim * Solver::dim; ++c) v2 += 0.25 * square(sim.cell() * static_cast<double>(p.template get<field::affine_velocity>(c)[i]));
      e += static_cast<double>(p.template get<field::mass>()[i]) * (0.5 * v2 + static_cast<double>(p.template get<field::energy>()[i]));
    }
  });
  return e;
}

template <class Method> class Ledger : public testing::Test {};
TYPED_TEST_SUITE(Ledger, every_method, method_names);

template <class Method, class Solver> void books_close(Solver& sim, double until, const char* scene) {
  const double before = particle_energy<Method>(sim);
  sim.run(until);
  const auto& l = sim.energies();
  std::printf("[ figures  ] %-6s %-18s residual %9.2e  drift %9.2e  momentum %9.2e  transfer %9.2e  heat %9.2e  mismatch %9.2e\n", scene, Method::name().c_str(), l.residual(),
              l.drift(), l.momentum_error(Solver::dim - 1), l.transfer / l.scale(), l.returned_heat / l.scale(), l.work_mismatch / l.scale());
  EXPECT_NEAR(l.initial.total(), before, 1e-12 * before);
  EXPECT_NEAR(l.now.total(), particle_energy<Method>(sim), 1e-12 * before);
  EXPECT_LT(std::abs(l.residual()), 1e-12);
  EXPECT_LT(std::abs(l.momentum_error(Solver::dim - 1)), 1e-13);
  EXPECT_GT(l.viscous_heating, 0.001 * before) << "the scene must have a shock";
  // total energy holds: FLIP's identity sum f.dv~ = sum m|dv|^2; APIC returns what it loses as heat
  EXPECT_LT(std::abs(l.drift()), 1e-12);
  EXPECT_LT(std::abs(l.work_mismatch / l.scale()), 1e-12) << "particles gain what the nodes lose";
  if constexpr (Method::transfer_type::affine) {
    EXPECT_LT(l.transfer, -1e-4 * before) << "APIC loses kinetic energy";
    EXPECT_NEAR(l.returned_heat, -l.transfer, 1e-12 * before);
  } else {
    EXPECT_EQ(l.returned_heat, 0);
    EXPECT_LT(std::abs(l.transfer / l.scale()), 1e-12);
  }
}

TYPED_TEST(Ledger, ClosesOnTheFlyer) {
  auto sim = small_flyer<TypeParam>();
  books_close<TypeParam>(sim, 0.15 * us, "1-D");
}
TYPED_TEST(Ledger, ClosesOnTheAxisymmetricImpact) {
  auto sim = small_impact<TypeParam>();
  books_close<TypeParam>(sim, 0.25 * us, "r-z");
  std::uint64_t failed = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) failed += s.columns.template get<field::failed>()[i] > 0;
  });
  EXPECT_GT(failed, 50u) << "the scene must have failure";
  EXPECT_GT(sim.energies().plastic_work, 0);
}

template <class Method> class ApicLedger : public testing::Test {};
using apic_methods = testing::Types<bspline_apic_usf, bspline_apic_musl>;
TYPED_TEST_SUITE(ApicLedger, apic_methods, method_names);

TYPED_TEST(ApicLedger, WithoutHeatTheDriftIsTheTransferChannel) {
  for (double heat : {0.0, 0.5}) {
    auto sim = small_impact<TypeParam>(aluminium(), transfer::apic{heat});
    sim.run(0.15 * us);
    const auto& l = sim.energies();
    EXPECT_LT(l.drift(), -1e-4);
    EXPECT_NEAR(l.drift(), (1 - heat) * l.transfer / l.scale(), 1e-12);
    EXPECT_NEAR(l.returned_heat, -heat * l.transfer, 1e-12 * l.scale());
    EXPECT_LT(std::abs(l.residual()), 1e-12);
  }
}

/// Each channel muted: the residual must rise by exactly its size, and be seen.
TEST(LedgerChannels, EachMutedChannelShows) {
  auto sim = small_impact<bspline_apic_usf>(aluminium(), transfer::apic{0.7});
  sim.add(leaving_box<2>{{0, -0.5 * mm}, {1.5 * mm, 0.6 * mm}});
  sim.run(0.3 * us);
  const ledger full = sim.energies();
  ASSERT_LT(std::abs(full.residual()), 1e-12);
  ASSERT_GT(full.particles_left, 0u);
  const auto muted = [&](double ledger::* channel, double sign) {
    ledger l = full;
    l.*channel = 0;
    const double rise = l.residual() - full.residual();
    EXPECT_NEAR(rise, sign * full.*channel / full.scale(), 1e-15);
    return std::abs(rise);
  };
  EXPECT_GT(muted(&ledger::transfer, 1), 1e-4);
  EXPECT_GT(muted(&ledger::returned_heat, 1), 1e-4);
  EXPECT_GT(muted(&ledger::left, -1), 1e-4);
}

/// The two parts of the work are opposite and large: leaving out either one shows (they are one channel only in their sum).
TEST(LedgerChannels, WorkIsSummedFromItsOwnFormula) {
  auto sim = small_flyer<linear_flip_usf>();
  sim.run(0.1 * us);
  const auto& l = sim.energies();
  EXPECT_GT(std::abs(l.now.internal - l.initial.internal) / l.scale(), 0.2) << "what the particles' work must have given";
  EXPECT_LT(std::abs(l.work_mismatch / l.scale()), 1e-12);
}

// ---- momentum ---------------------------------------------------------------------------------------------------------------------------
template <class Method> class FaceParticle : public testing::Test {};
TYPED_TEST_SUITE(FaceParticle, every_method, method_names);

/// A bug once: a particle exactly on a cell face put a force on a node without mass, and that force was lost.
TYPED_TEST(FaceParticle, OnACellFaceMomentumHolds) {
  using point = vec<double, 1>;
  const double h = 0.0625 * mm; // a particle per face: i h is exact in binary
  auto c = one_thread<double>();
  c.accept_one_particle_per_cell = true;
  const material al = aluminium();
  const body flyer{"flyer", box{point{-10.5 * h}, point{-0.5 * h}}, al, h, initial_state{2785, 0}, point{1000.}};
  const body plate{"plate", box{point{-0.5 * h}, point{10.5 * h}}, al, h, initial_state{2785, 0}};
  solver sim{space::planar_1d{}, grid::sparse{h}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{}, c,
             flyer, plate};
  int on_face = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double cells = s.columns.template get<field::position>()[i] / h;
      on_face += std::abs(cells - std::round(cells)) < 1e-12;
    }
  });
  EXPECT_EQ(on_face, 21) << "the test must put its particles on faces";
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    sim.step();
    worst = std::max(worst, std::abs(sim.energies().momentum_error(0)));
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
}

/// The same in r-z along the axis, where the plate's lattice is shifted onto the faces.
TYPED_TEST(FaceParticle, OnACellFaceAxialMomentumHoldsInRZ) {
  using point = vec<double, 2>;
  const double h = 0.0625 * mm;
  auto c = one_thread<double>();
  c.accept_one_particle_per_cell = true;
  const material al = aluminium();
  const body flyer{"flyer", box{point{0, -6.5 * h}, point{6 * h, -0.5 * h}}, al, h, initial_state{2785, 0}, point{0, 2000.}};
  const body plate{"plate", box{point{0, -0.5 * h}, point{12 * h, 6.5 * h}}, al, h, initial_state{2785, 0}};
  solver sim{space::axisymmetric{}, grid::sparse{h}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{}, c,
             flyer, plate};
  for (int i = 0; i < 60; ++i) sim.step();
  EXPECT_LT(std::abs(sim.energies().momentum_error(1)), 1e-13);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
}

// ---- float: figures, with bars of float's own size --------------------------------------------------------------------------------------
template <class Method> class FloatLedger : public testing::Test {};
using float_methods = testing::Types<method<shape::linear, transfer::flip, scheme::usf, float>, method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(FloatLedger, float_methods, method_names);

TYPED_TEST(FloatLedger, FiguresAreReported) {
  auto sim = small_impact<TypeParam>();
  sim.run(0.25 * us);
  const auto& l = sim.energies();
  std::printf("[ figures  ] r-z    %-18s residual %9.2e  drift %9.2e  momentum %9.2e\n", TypeParam::name().c_str(), l.residual(), l.drift(), l.momentum_error(1));
  EXPECT_LT(std::abs(l.residual()), 2e-5);
  EXPECT_LT(std::abs(l.drift()), 2e-5);
  EXPECT_LT(std::abs(l.momentum_error(1)), 2e-5);
}

} // namespace
} // namespace bolide
