// SPDX-License-Identifier: MIT
// Failure laws: what makes a point fail, lane by lane.
#include "bolide/concepts/failure.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/failure/tension_or_melt.hpp"

#include "unit/core/lane_types.hpp"

#include <cmath>

namespace bolide {
namespace {

template <class Model> class Failures : public testing::Test {};
using models = testing::Types<failure::none, failure::tension, failure::tension_or_melt>;
TYPED_TEST_SUITE(Failures, models);

TYPED_TEST(Failures, MeetTheConceptOnEveryLane) {
  EXPECT_TRUE((Failure<TypeParam, double> && Failure<TypeParam, float> && Failure<TypeParam, pack<double, 8>> && Failure<TypeParam, pack<float, 16>>));
}
TYPED_TEST(Failures, DeclareTheFieldsOfAFailedPoint) {
  EXPECT_EQ(TypeParam::particle_fields::template contains<field::failed>, TypeParam::may_fail);
  EXPECT_EQ(TypeParam::particle_fields::template contains<field::material_volume>, TypeParam::may_fail);
}

template <class V> class FailureLanes : public testing::Test {};
TYPED_TEST_SUITE(FailureLanes, lane_types);

TYPED_TEST(FailureLanes, TensionFailsBeyondTheLimitOnly) {
  using V = TypeParam;
  const failure::tension law(1.5e9);
  const V zero(0);
  EXPECT_FALSE(any(law.fails(V(1e9), zero, zero, zero)));
  EXPECT_FALSE(any(law.fails(V(-1.499e9), zero, zero, zero)));
  EXPECT_TRUE(all(law.fails(V(-1.501e9), zero, zero, zero)));
}

TYPED_TEST(FailureLanes, MeltFailsByTemperatureOrFraction) {
  using V = TypeParam;
  const failure::tension_or_melt law(1.5e9), melt = failure::tension_or_melt::melt_only();
  const V p(1e9), cold(500), hot(1000), melting(933), none(0), some(scalar_t<V>(0.01));
  EXPECT_FALSE(any(law.fails(p, cold, melting, none)));
  EXPECT_TRUE(all(law.fails(p, hot, melting, none)));
  EXPECT_TRUE(all(law.fails(p, cold, melting, some)));
  EXPECT_TRUE(all(law.fails(V(-2e9), cold, melting, none)));
  EXPECT_FALSE(any(melt.fails(V(-1e15), cold, melting, none))) << "no tension limit";
  EXPECT_TRUE(all(melt.fails(V(-1e15), hot, melting, none)));
}

TEST(FailurePack, DecidesEachLaneForItself) {
  using V = pack<double, 4>;
  V p(0.0);
  p.set(2, -2e9);
  const auto m = failure::tension(1.5e9).fails(p, V(0), V(0), V(0));
  EXPECT_EQ(count(m), 1);
  EXPECT_TRUE(m[2]);
}

TEST(FailureParameters, AreCheckedWithASentence) {
  EXPECT_THROW(failure::tension(0), bad_parameter);
  EXPECT_THROW(failure::tension_or_melt(-1), bad_parameter);
  EXPECT_THROW(failure::tension_or_melt(std::nan("")), bad_parameter);
  try {
    failure::tension(-1e9);
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "tension limit = -1e+09 Pa: must be positive (unit: Pa)");
  }
}

} // namespace
} // namespace bolide
