// SPDX-License-Identifier: MIT
// 1-D flyer impact against the exact Rankine-Hugoniot state, for every equation of state and two methods. The other methods: flyer_slow_test.cpp.
#include "verify/flyer.hpp"

namespace bolide {
namespace {
using namespace verify;

TEST(Flyer1D, MieGrueneisen) { verify_flyer_1d("mie-gruneisen", mie_grueneisen()); }
TEST(Flyer1D, Tillotson) { verify_flyer_1d("tillotson", tillotson()); }
TEST(Flyer1D, Mixed) { verify_flyer_1d("mixed", mixed()); }
TEST(Flyer1D, Helm) { verify_flyer_1d("helm", helm()); }
TEST(Flyer1D, PaperFromTheColdState) { verify_flyer_1d("paper (cold)", paper()); }

template <class Method> class Flyer1DMethods : public testing::Test {};
using methods = testing::Types<linear_flip_usf, standard>;
TYPED_TEST_SUITE(Flyer1DMethods, methods, method_names);

/// Recorded for every method.
TYPED_TEST(Flyer1DMethods, MieGrueneisen) { verify_method_1d<TypeParam>(); }
TYPED_TEST(Flyer1DMethods, WithoutViscosity) { misses_without_viscosity_1d<TypeParam>(); }

TEST(Flyer1DNoViscosity, ApicWithoutItsHeat) {
  const auto at = mie_grueneisen();
  const auto exact = exact_shock(at);
  const auto s = flyer_1d<standard>(at, viscosity::none{}, transfer::apic{0.0});
  report("mie-gruneisen, no viscosity, heat 0", "1-D", standard::name(), s, exact);
  EXPECT_GT(std::abs(s.temperature / exact.temperature - 1), 0.05);
}

} // namespace
} // namespace bolide
