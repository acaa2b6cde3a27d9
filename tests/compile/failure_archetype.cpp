// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a failure law, one that accumulates damage, and one that softens.
#include "bolide/concepts/failure.hpp"
#include "bolide/core/field.hpp"

struct least_failure {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume>;
  static constexpr bool may_fail = true, wants_temperature = false;
  template <class V> bolide::mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(0); }
};
struct least_damage : least_failure {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume, bolide::field::damage>;
  template <class V> V damage_increment(V plastic, V, V, V, V, V) const { return plastic; }
};
struct least_softening : least_failure {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume, bolide::field::lost_capacity, bolide::field::held_tension>;
  template <class V> V capacity_lost(V, V, V, bolide::scalar_t<V>, bolide::scalar_t<V>) const { return V(1); }
};
static_assert(bolide::Failure<least_failure> && bolide::Failure<least_failure, bolide::native_pack<double>>);
static_assert(bolide::AccumulatingFailure<least_damage> && !bolide::AccumulatingFailure<least_failure>);
static_assert(bolide::SofteningFailure<least_softening, bolide::native_pack<float>> && !bolide::SofteningFailure<least_failure>);
