// SPDX-License-Identifier: MIT
// The phase-region solver that paper, mixed and helm share: finds the region of each lane and evaluates all of them in one pass.
//
// Regions at a volume, by the thermal energy e_k (borders included where the sign says so):
//   solid  e_k < E_ms  (without a mixed phase: e_k < E_m)      mixed  E_ms <= e_k <= E_m
//   liquid e_k <= E_G                                          hot liquid above       gas  everywhere for x >= xj, if there is one
// All lanes solid is a fast path; otherwise the coefficients of the branches are selected lane by lane and one root is taken.
// The answer equals the branch's own (tests/unit/eos/phase_test.cpp).
#pragma once

#include "bolide/eos/phase/branch/gas.hpp"
#include "bolide/eos/phase/branch/hot_liquid.hpp"
#include "bolide/eos/phase/branch/liquid.hpp"
#include "bolide/eos/phase/branch/mixed.hpp"
#include "bolide/eos/phase/branch/solid.hpp"

#include <vector>

namespace bolide::phase {

/// Law: published or helmholtz. HasMixed, HasGas: which regions exist.
template <class Law, bool HasMixed, bool HasGas> class regions {
public:
  explicit regions(const grover_parameters& parameters = {}) : q_(parameters) {
    q_.validate();
    hot_ = q_.hot();
    K_ = q_.K();
    inverse_latent_ = 1 / (q_.dS - q_.al);
  }

  const grover_parameters& parameters() const { return q_; }

  /// What the branches need to know of the volume x = V/V0; density = 1/V.
  template <class V> BOLIDE_INLINE isochore<V> at(V x, V density) const { return Law::at(q_, x, density); }

  template <class V> BOLIDE_INLINE phase_point<V> evaluate(V x, V e_k, V specific_volume) const {
    return evaluate_at_density(x, e_k, V(scalar_t<V>(1)) / specific_volume);
  }

  template <class V> BOLIDE_INLINE phase_point<V> evaluate_at_density(V x, V e_k, V density) const {
    using T = scalar_t<V>;
    const isochore<V> v = at(x, density);
    const V zero(T(0)), t_m = v.melting;
    const V E_ms = t_m * (T(3 * q_.R) + T(0.5) * v.electron * t_m), E_m = E_ms + t_m * T(q_.dS - q_.al);
    mask_t<V> is_solid = e_k < (HasMixed ? E_ms : E_m), is_gas = x < zero;
    if constexpr (HasGas) {
      is_gas = x >= V(T(q_.xj));
      is_solid = is_solid && !is_gas;
    }
    if (all(is_solid)) {
      const branch::coefficients<V> c{V(T(3 * q_.R)), zero, zero, v.electron, T(3 * q_.R) * v.gamma, T(3 * q_.R) * v.gamma_slope};
      return branch::evaluate(c, v, T(q_.ge), e_k, zero, zero);
    }
    return any_region(v, e_k, E_ms, E_m, is_solid, is_gas);
  }

  /// E_ms (if there is a mixed phase), E_m and E_G at the volume ratio x, J/kg, rising: where the regions meet.
  std::vector<double> energy_borders(double x, double density) const {
    const isochore<double> v = at(x, density);
    const double t_m = v.melting, solidus = t_m * (3 * q_.R + 0.5 * v.electron * t_m), liquidus = solidus + t_m * (q_.dS - q_.al);
    const double hot = t_m * (1.5 * q_.R * hot_ + K_ + 0.5 * hot_ * hot_ * v.electron * t_m);
    if constexpr (HasMixed) return {solidus, liquidus, hot};
    else return {liquidus, hot};
  }
  /// Volume ratios at which another region takes over at every energy: the gas's, if there is one.
  std::vector<double> border_volume_ratios() const {
    if constexpr (HasGas) return {q_.xj};
    else return {};
  }

private:
  template <class V>
  BOLIDE_INLINE phase_point<V> any_region(const isochore<V>& v, V e_k, V E_ms, V E_m, mask_t<V> is_solid, mask_t<V> is_gas) const {
    using T = scalar_t<V>;
    const V zero(T(0)), one(T(1)), t_m = v.melting, inverse_t_m = one / t_m;
    const V E_G = t_m * (T(1.5 * q_.R * hot_ + K_) + T(0.5 * hot_ * hot_) * v.electron * t_m);
    const mask_t<V> dense = !is_gas, above = dense && !is_solid;
    const mask_t<V> is_mixed = HasMixed ? above && e_k <= E_m : mask_t<V>(is_gas && dense);
    const mask_t<V> is_hot = above && e_k > E_G;
    const mask_t<V> is_liquid = above && !is_mixed && !is_hot, free = is_hot || is_gas;

    branch::coefficients<V> c;
    c.heat = select(free, V(T(1.5 * q_.R)), V(T(3 * q_.R)));
    c.curvature = select(is_liquid, T(q_.al) * inverse_t_m, zero);
    c.latent = select(is_liquid, V(T(q_.dS - 0.5 * q_.al)), select(is_hot, V(T(K_)), zero));
    c.electron = select(is_gas, zero, v.electron);
    c.lattice = select(free, V(T(q_.R)), T(3 * q_.R) * v.gamma);
    c.lattice_slope = select(free, zero, T(3 * q_.R) * v.gamma_slope);

    // As branch::evaluate, with the mixed phase's T, q and slopes selected in.
    const V lambda = v.lambda();
    branch::root<V> r = branch::solve(c, v, e_k);
    const V t = select(is_mixed, t_m, r.temperature), solid_capacity = c.heat + c.electron * t;
    const V bend = T(0.5) * c.curvature * t * t, melt = t_m * c.latent;
    const V q = select(is_mixed, e_k - E_ms, melt - bend), q_slope_t = -lambda * (melt + bend);
    const V electrons_slope = T(0.5) * v.electron_power * c.electron * t * t, inverse = r.inverse_capacity;
    const V t_slope = select(is_mixed, -lambda * t, -(electrons_slope + q_slope_t) * inverse);
    const V q_slope = select(is_mixed, -(electrons_slope + solid_capacity * t_slope), q_slope_t);
    const V p_t = branch::pressure_slope(c, v, T(q_.ge), t);
    const V nu = select(is_mixed, (e_k - E_ms) * inverse_t_m * T(inverse_latent_), select(is_solid, zero, one));
    const V where = select(is_gas, V(T(4)), select(is_hot, V(T(3)), select(is_liquid, V(T(2)), select(is_mixed, one, zero))));
    return branch::close(c, v, T(q_.ge), t, q, q_slope, t_slope, p_t, select(is_mixed, lambda, p_t * inverse),
                         select(is_mixed, zero, inverse), nu, where);
  }

  grover_parameters q_;
  double hot_ = 0, K_ = 0, inverse_latent_ = 0; // q_.hot(), q_.K(), 1/(dS - al)
};

} // namespace bolide::phase
