// SPDX-License-Identifier: MIT
// expect: ok
// The least equation of state, strength, failure law and viscosity make a material and a solver together.
#include "scene.hpp"

namespace {
struct least_eos {
  template <class V> bolide::eos_point<V> evaluate(V rho, V) const { return {rho, V(1)}; }
  double reference_density() const { return 1; }
};
struct least_solid {
  using particle_fields = bolide::fields<bolide::field::deviator, bolide::field::plastic_strain>;
  static constexpr bool carries_shear = true, wants_temperature = false;
  double shear_modulus = 1;
  template <class V> V yield_stress(V, V, V, V) const { return V(1); }
  template <class V> V yield_floor(V, V) const { return V(1); }
};
struct least_failure {
  using particle_fields = bolide::fields<bolide::field::failed, bolide::field::material_volume>;
  static constexpr bool may_fail = true, wants_temperature = false;
  template <class V> bolide::mask_t<V> fails(V pressure, V, V, V) const { return pressure < V(0); }
};
struct least_viscosity {
  using particle_fields = bolide::fields<>;
  static constexpr bool present = false;
  template <class V> V pressure(V, V, V, bolide::scalar_t<V>) const { return V(0); }
  template <class V> V signal_speed(V, V, bolide::scalar_t<V>) const { return V(0); }
};
} // namespace

void compose() {
  const bolide::material m{least_eos{}, least_solid{}, least_failure{}, least_viscosity{}};
  bolide::solver sim{bolide::space::planar_1d{}, bolide::grid::sparse{1e-4}, bolide::shape::quadratic_bspline{}, bolide::transfer::apic{}, bolide::scheme::musl{},
                     bolide::controls<float>{}, scene::slab(m)};
  sim.step();
}
