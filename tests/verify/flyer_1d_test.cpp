// SPDX-License-Identifier: MIT
// 1-D flyer impact against the exact Rankine-Hugoniot state, for every equation of state and every method.
#include "verify/flyer.hpp"

namespace bolide {
namespace {
using namespace verify;
using standard = bspline_apic_usf; // the default composition

template <class Start> void check(const char* name, const Start& at) {
  const auto exact = exact_shock(at);
  const auto s = flyer_1d<standard>(at);
  report(name, "1-D", standard::name(), s, exact);
  record_flyer<standard>(name, "planar_1d", s, exact);
  near_exact(s, exact, 100);
}

TEST(Flyer1D, MieGrueneisen) { check("mie-gruneisen", mie_grueneisen()); }
TEST(Flyer1D, Tillotson) { check("tillotson", tillotson()); }
TEST(Flyer1D, Mixed) { check("mixed", mixed()); }
TEST(Flyer1D, Helm) { check("helm", helm()); }
TEST(Flyer1D, PaperFromTheColdState) { check("paper (cold)", paper()); }

template <class Method> class Flyer1DMethods : public testing::Test {};
TYPED_TEST_SUITE(Flyer1DMethods, every_method, method_names);

/// Recorded for every method; bars for what all of them hold.
TYPED_TEST(Flyer1DMethods, MieGrueneisen) {
  const auto at = mie_grueneisen();
  const auto exact = exact_shock(at);
  const auto s = flyer_1d<TypeParam>(at);
  report("mie-gruneisen", "1-D", TypeParam::name(), s, exact);
  if (TypeParam::name() != standard::name()) record_flyer<TypeParam>("mie-gruneisen", "planar_1d", s, exact, 0.02, TypeParam::transfer_type::affine ? "" : velocity_noise);
  EXPECT_NEAR(s.rho / exact.density, 1, 0.02);
  EXPECT_NEAR(s.us / exact.shock_speed, 1, 0.02);
  EXPECT_LT(std::abs(s.drift), 1e-12);
}

/// Without artificial viscosity FLIP makes no entropy: the test must be able to fail.
TYPED_TEST(Flyer1DMethods, WithoutViscosity) {
  const auto at = mie_grueneisen();
  const auto exact = exact_shock(at);
  const auto s = flyer_1d<TypeParam>(at, viscosity::none{});
  report("mie-gruneisen, no viscosity", "1-D", TypeParam::name(), s, exact);
  const double off_T = std::abs(s.temperature / exact.temperature - 1), off_e = std::abs(s.e / exact.energy - 1);
  if constexpr (!TypeParam::transfer_type::affine) {
    EXPECT_GT(std::max(off_T / 0.025, off_e / 0.01), 2);
  }
}
TEST(Flyer1DNoViscosity, ApicWithoutItsHeat) {
  const auto at = mie_grueneisen();
  const auto exact = exact_shock(at);
  const auto s = flyer_1d<standard>(at, viscosity::none{}, transfer::apic{0.0});
  report("mie-gruneisen, no viscosity, heat 0", "1-D", standard::name(), s, exact);
  EXPECT_GT(std::abs(s.temperature / exact.temperature - 1), 0.05);
}

} // namespace
} // namespace bolide
