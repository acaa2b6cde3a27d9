// SPDX-License-Identifier: MIT
// Imploding beryllium shells, every composition, at 2 mm and 1 mm.
#include "verify/verney.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Method> class Verney : public testing::Test {};
TYPED_TEST_SUITE(Verney, every_method, method_names);

TYPED_TEST(Verney, CylinderStops) {
  for (const double stop : {50.0, 45.0, 40.0}) check_verney<TypeParam>(2, stop, 1, 0.005);
}
TYPED_TEST(Verney, SphereStops) {
  for (const double stop : {50.0, 40.0, 30.0}) check_verney<TypeParam>(3, stop, 2, 0.05);
}

} // namespace
} // namespace bolide
