// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a failure law.
#include "bolide/concepts/failure.hpp"
#include "bolide/core/field.hpp"

struct least_failure {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume>;
  static constexpr bool may_fail = true, wants_temperature = false;
  template <class V> bolide::mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(0); }
};
static_assert(bolide::Failure<least_failure> && bolide::Failure<least_failure, bolide::native_pack<double>>);
