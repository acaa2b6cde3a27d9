// SPDX-License-Identifier: MIT
// r-z flyer impact between the axis and a slip wall against the exact Rankine-Hugoniot state. The other equations of state and methods:
// flyer_slow_test.cpp.
#include "verify/flyer.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(FlyerRZ, MieGrueneisen) { verify_flyer_rz("mie-gruneisen", mie_grueneisen()); }
TEST(FlyerRZ, Mixed) { verify_flyer_rz("mixed", mixed()); }

template <class Method> class FlyerRZMethods : public testing::Test {};
using methods = testing::Types<linear_flip_usf, standard>;
TYPED_TEST_SUITE(FlyerRZMethods, methods, method_names);

/// Recorded for every method.
TYPED_TEST(FlyerRZMethods, MieGrueneisen) { verify_method_rz<TypeParam>(); }

TEST(FlyerRZNoViscosity, FlipMissesTheTemperature) {
  const auto at = mie_grueneisen();
  const auto x = exact_shock(at);
  const auto s = flyer_rz<linear_flip_usf>(at, viscosity::none{});
  report("mie-gruneisen, no viscosity", "r-z", linear_flip_usf::name(), s, x);
  EXPECT_GT(std::max(std::abs(s.temperature / x.temperature - 1) / 0.025, std::abs(s.e / x.energy - 1) / 0.01), 2);
}

} // namespace
} // namespace bolide
