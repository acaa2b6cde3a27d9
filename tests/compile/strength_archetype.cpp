// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a strength: one without shear, one with it, one that never yields, one whose modulus varies. If this stops compiling, the concept has grown unseen.
#include "bolide/concepts/strength.hpp"
#include "bolide/core/field.hpp"

struct least_fluid {
  using particle_fields = bolide::fields<>;
  static constexpr bool carries_shear = false, wants_temperature = false;
};
struct least_solid {
  using particle_fields = bolide::fields<bolide::field::deviator, bolide::field::plastic_strain>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  double shear_modulus = 1e9;
  template <class V> V yield_stress(V, V, V, V) const { return V(1); }
  template <class V> V yield_floor(V, V) const { return V(1); }
};
struct least_elastic {
  using particle_fields = bolide::fields<bolide::field::deviator>;
  static constexpr bool carries_shear = true, yields = false, wants_temperature = false;
  double shear_modulus = 1e9;
};
struct least_of_varying_modulus {
  using particle_fields = bolide::fields<bolide::field::deviator, bolide::field::plastic_strain, bolide::field::shear_modulus>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  double shear_modulus = 1e9;
  template <class V> V shear_modulus_at(V, V, V, V) const { return V(1); }
  template <class V> V yield_stress(V, V, V, V, V, V) const { return V(1); }
  template <class V> V yield_floor(V, V, V, V) const { return V(1); }
};
static_assert(bolide::Strength<least_fluid>);
static_assert(bolide::Strength<least_elastic> && !bolide::strength_yields<least_elastic>);
static_assert(bolide::Strength<least_of_varying_modulus, bolide::native_pack<float>> && bolide::VariableShearModulus<least_of_varying_modulus>);
static_assert(!bolide::VariableShearModulus<least_solid>);
static_assert(bolide::Strength<least_solid> && bolide::Strength<least_solid, bolide::native_pack<float>>);
