// SPDX-License-Identifier: MIT
// r-z flyer impact between the axis and a slip wall against the exact Rankine-Hugoniot state.
#include "verify/flyer.hpp"

namespace bolide {
namespace {
using namespace verify;
using standard = bspline_apic_usf; // the default composition

template <class Start> void check(const char* name, const Start& at) {
  const auto x = exact_shock(at);
  const auto s = flyer_rz<standard>(at);
  report(name, "r-z", standard::name(), s, x);
  record_flyer<standard>(name, "axisymmetric", s, x);
  near_exact(s, x, 1000);
}

TEST(FlyerRZ, MieGrueneisen) { check("mie-gruneisen", mie_grueneisen()); }
TEST(FlyerRZ, Tillotson) { check("tillotson", tillotson()); }
TEST(FlyerRZ, Mixed) { check("mixed", mixed()); }
TEST(FlyerRZ, Helm) { check("helm", helm()); }
TEST(FlyerRZ, PaperFromTheColdState) { check("paper (cold)", paper()); }

template <class Method> class FlyerRZMethods : public testing::Test {};
TYPED_TEST_SUITE(FlyerRZMethods, every_method, method_names);

/// Recorded for every method.
TYPED_TEST(FlyerRZMethods, MieGrueneisen) {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_rz<TypeParam>(at);
  report("mie-gruneisen", "r-z", TypeParam::name(), s, x);
  EXPECT_NEAR(s.rho / x.density, 1, 0.02);
  EXPECT_NEAR(s.us / x.shock_speed, 1, 0.02);
  EXPECT_LT(std::abs(s.drift), 1e-12);
}

TEST(FlyerRZNoViscosity, FlipMissesTheTemperature) {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_rz<linear_flip_usf>(at, viscosity::none{});
  report("mie-gruneisen, no viscosity", "r-z", linear_flip_usf::name(), s, x);
  EXPECT_GT(std::max(std::abs(s.temperature / x.temperature - 1) / 0.025, std::abs(s.e / x.energy - 1) / 0.01), 2);
}

} // namespace
} // namespace bolide
