// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a cold curve.
#include "bolide/concepts/cold_curve.hpp"

struct least_cold {
  template <class V> bolide::cold_point<V> evaluate(V x) const { return {x, x, x}; }
  double reference_density() const { return 1; }
};
static_assert(bolide::ColdCurve<least_cold>);
static_assert(bolide::ColdCurve<least_cold, bolide::native_pack<float>>);
