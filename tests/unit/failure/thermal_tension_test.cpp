// SPDX-License-Identifier: MIT
// The tension limit that falls with temperature, lane by lane, and in a material.
#include "bolide/failure/thermal_tension.hpp"
#include "bolide/concepts/failure.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide {
namespace {

template <class V> class ThermalTension : public testing::Test {};
TYPED_TEST_SUITE(ThermalTension, lane_types);

TYPED_TEST(ThermalTension, FallsLinearlyToNothingAtMelting) {
  using V = TypeParam;
  EXPECT_TRUE((Failure<failure::thermal_tension, V>));
  const failure::thermal_tension law(2e9);
  const V melting(1000), fraction(0);
  const auto fails = [&](double p, double t) {
    return law.fails(V(static_cast<scalar_t<V>>(p)), V(static_cast<scalar_t<V>>(t)), melting, fraction);
  };
  for (const double t : {0.0, 250.0, 500.0, 900.0}) {
    const double limit = 2e9 * (1 - t / 1000);
    EXPECT_FALSE(any(fails(-0.999 * limit, t))) << t;
    EXPECT_TRUE(all(fails(-1.001 * limit, t))) << t;
  }
  for (const double t : {1000.0, 5000.0}) { // a melt: compressed it holds, the first tension fails it
    EXPECT_FALSE(any(fails(1e9, t)));
    EXPECT_TRUE(all(fails(-1, t)));
  }
}

TYPED_TEST(ThermalTension, TheExponentIsTheExponent) {
  using V = TypeParam;
  const V t(640), melting(1000);
  EXPECT_NEAR(static_cast<double>(lane(failure::thermal_tension(1, 0.5).carries(t, melting), 0)), 0.6, 1e-6);
  EXPECT_NEAR(static_cast<double>(lane(failure::thermal_tension(1, 2).carries(t, melting), 0)), 0.1296, 1e-6);
  EXPECT_EQ(lane(failure::thermal_tension(1, 0).carries(t, melting), 0), 1);
  EXPECT_EQ(lane(failure::thermal_tension(1, 0).carries(V(1001), melting), 0), 0);
  EXPECT_EQ(lane(failure::thermal_tension(1, 1).carries(t, V(0)), 0), 0) << "no solid, no tension";
}

TEST(ThermalTensionLaw, ChecksItsParameters) {
  EXPECT_THROW(failure::thermal_tension(0), bad_parameter);
  EXPECT_THROW(failure::thermal_tension(1e9, -1), bad_parameter);
  EXPECT_THROW(failure::thermal_tension(1e9, std::nan("")), bad_parameter);
}

/// In a solver: a weaker law fails more particles, and the books close.
TEST(ThermalTensionLaw, WorksInAnImpact) {
  const auto failed = [](double limit) {
    const eos::isentrope_temperature model{eos::mie_grueneisen{{.constant_gamma = true}}};
    const material al{model, strength::johnson_cook{}, failure::thermal_tension{limit}};
    auto sim = test::small_impact<test::bspline_apic_usf>(al);
    sim.run(0.25 * unit::us);
    EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
    int n = 0;
    sim.for_each_body([&](const auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i) n += s.columns.template get<field::failed>()[i] > 0;
    });
    return n;
  };
  const int weak = failed(0.2e9), strong = failed(20e9);
  EXPECT_GT(strong, 0);
  EXPECT_GT(weak, strong);
}

} // namespace
} // namespace bolide
