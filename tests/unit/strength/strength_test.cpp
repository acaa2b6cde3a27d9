// SPDX-License-Identifier: MIT
// Strength models: what every model must hold, and Johnson-Cook against its formula in long double.
#include "bolide/concepts/strength.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/johnson_cook.hpp"
#include "bolide/strength/linear_hardening.hpp"
#include "bolide/strength/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace bolide {
namespace {

template <class Model> Model make();
template <> strength::johnson_cook make() { return {}; }
template <> strength::elastic_perfectly_plastic make() { return {27.6e9, 0.3e9}; }
template <> strength::linear_hardening make() { return {27.6e9, 0.3e9, 1e9}; }

template <class Model> class Strengths : public testing::Test {};
using models = testing::Types<strength::none, strength::elastic, strength::elastic_perfectly_plastic, strength::linear_hardening, strength::johnson_cook>;
TYPED_TEST_SUITE(Strengths, models);

TYPED_TEST(Strengths, MeetTheConceptOnEveryLane) {
  EXPECT_TRUE((Strength<TypeParam, double> && Strength<TypeParam, float> && Strength<TypeParam, pack<double, 8>> && Strength<TypeParam, pack<float, 16>>));
}

TYPED_TEST(Strengths, YieldFloorIsALowerBoundAndYieldIsNotNegative) {
  if constexpr (strength_yields<TypeParam>) {
    const auto model = make<TypeParam>();
    for (double strain : {0.0, 1e-9, 0.01, 1.0, 10.0})
      for (double rate : {0.0, 1.0, 1e4, 1e8})
        for (double t : {0.0, 293.0, 600.0, 932.0, 933.0, 5000.0}) {
          const double y = model.yield_stress(strain, rate, t, 933.0);
          EXPECT_GE(y, model.yield_floor(t, 933.0)) << strain << " " << rate << " " << t;
          EXPECT_GE(y, 0);
          const auto v = model.yield_stress(pack<double, 8>(strain), pack<double, 8>(rate), pack<double, 8>(t), pack<double, 8>(933.0));
          EXPECT_NEAR(v[3], y, 1e-13 * 1e9);
        }
  }
}

long double reference(const strength::johnson_cook& m, long double strain, long double rate, long double t, long double melting) {
  const long double star = std::clamp((t - static_cast<long double>(m.room_temperature)) / (melting - static_cast<long double>(m.room_temperature)), 0.0L, 1.0L);
  return (static_cast<long double>(m.a) + static_cast<long double>(m.b) * std::pow(strain, static_cast<long double>(m.n))) *
         (1 + static_cast<long double>(m.c) * std::log(std::max(rate, 1.0L))) * (1 - std::pow(star, static_cast<long double>(m.q)));
}

template <class V> class JohnsonCook : public testing::Test {};
TYPED_TEST_SUITE(JohnsonCook, lane_types);

TYPED_TEST(JohnsonCook, IsItsFormula) {
  using V = TypeParam;
  for (double q : {1.0, 1.7}) {
    strength::johnson_cook m;
    m.q = q;
    for (double strain : {0.0, 1e-6, 1e-3, 0.1, 1.0, 3.0})
      for (double rate : {0.0, 0.5, 1.0, 10.0, 1e4, 1e7})
        for (double t : {100.0, 293.0, 400.0, 700.0, 932.0, 2000.0}) {
          const V y = m.yield_stress(V(static_cast<scalar_t<V>>(strain)), V(static_cast<scalar_t<V>>(rate)), V(static_cast<scalar_t<V>>(t)), V(static_cast<scalar_t<V>>(933)));
          const auto expected = static_cast<double>(reference(m, static_cast<long double>(strain), static_cast<long double>(rate), static_cast<long double>(t), 933.0L));
          test::expect_close(static_cast<double>(lane(y, 0)), expected, test::epsilon<V>(40), 0.5e9, "yield stress"); // 1 - T* cancels near melting
        }
  }
}

TEST(JohnsonCookLimits, AreTheTextbookOnes) {
  const strength::johnson_cook m;
  EXPECT_EQ(m.yield_stress(0.0, 0.0, 293.0, 933.0), 265e6) << "A at room temperature, no strain, slow";
  EXPECT_EQ(m.yield_stress(0.0, 1.0, 20.0, 933.0), 265e6) << "T* is not negative below room temperature";
  EXPECT_EQ(m.yield_stress(1.0, 1e6, 933.0, 933.0), 0) << "nothing at melting";
  EXPECT_NEAR(m.yield_stress(1.0, 1.0, 293.0, 933.0), 691e6, 1e-3) << "A + B at a strain of 1";
  EXPECT_GT(m.yield_stress(0.1, 1.0, 900.0, 4000.0), m.yield_stress(0.1, 1.0, 900.0, 1000.0)) << "homologous temperature";
}

TEST(JohnsonCookParameters, AreCheckedWithASentence) {
  strength::johnson_cook m;
  EXPECT_NO_THROW(m.validate());
  const auto refused = [&](double& x, double bad) {
    const double good = x;
    x = bad;
    EXPECT_THROW(m.validate(), bad_parameter);
    x = good;
  };
  for (double bad : {-1.0, std::nan("")}) {
    refused(m.shear_modulus, bad);
    refused(m.a, bad);
    refused(m.b, bad);
    refused(m.n, bad);
    refused(m.c, bad);
    refused(m.q, bad);
    refused(m.room_temperature, bad);
  }
  refused(m.n, 2.5);
  m.c = -1;
  try {
    m.validate();
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "Johnson-Cook C = -1: must be non-negative");
  }
}

TEST(PerfectlyPlastic, ChecksItsParameters) {
  EXPECT_THROW(strength::elastic_perfectly_plastic(0, 1), bad_parameter);
  EXPECT_THROW(strength::elastic_perfectly_plastic(1, -1), bad_parameter);
  try {
    strength::elastic_perfectly_plastic(27.6e9, -1);
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "yield stress = -1 Pa: must be positive (unit: Pa)");
  }
}

TEST(Elastic, NeverYieldsAndStoresNoPlasticStrain) {
  EXPECT_FALSE(strength_yields<strength::elastic>);
  EXPECT_FALSE(strength_yields<strength::none>);
  EXPECT_TRUE(strength_yields<strength::johnson_cook>);
  EXPECT_FALSE(strength::elastic::particle_fields::contains<field::plastic_strain>);
  EXPECT_THROW(strength::elastic(0), bad_parameter);
  EXPECT_THROW(strength::elastic(std::nan("")), bad_parameter);
}

TEST(LinearHardening, IsALineAndChecksItsParameters) {
  const strength::linear_hardening m(27.6e9, 0.3e9, 2e9);
  EXPECT_EQ(m.yield_stress(0.0, 1e6, 900.0, 933.0), 0.3e9);
  EXPECT_NEAR(m.yield_stress(0.25, 0.0, 0.0, 0.0), 0.8e9, 1);
  EXPECT_THROW(strength::linear_hardening(1, 1, -1), bad_parameter);
  EXPECT_THROW(strength::linear_hardening(1, 0, 1), bad_parameter);
  EXPECT_THROW(strength::linear_hardening(std::nan(""), 1, 1), bad_parameter);
}

} // namespace
} // namespace bolide
