// SPDX-License-Identifier: MIT
// Artificial bulk viscosity (von Neumann and Richtmyer, with a linear term): without it a shock makes no entropy.
//   q = rho (c_q l^2 D^2 + c_l l c |D|)   for D = tr(L) < 0, else 0;   l the cell size, c the sound speed.
// Its work is part of the internal energy. It spreads a shock over some three cells.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"

namespace bolide::viscosity {

struct bulk {
  using particle_fields = fields<field::viscous_pressure, field::sound_speed>;
  static constexpr bool present = true;

  double quadratic;
  double linear;

  explicit bulk(double c_q = 1.5, double c_l = 0.06) : quadratic(c_q), linear(c_l) {
    require(c_q >= 0 && c_q < 100, "quadratic viscosity", c_q, "in [0, 100)");
    require(c_l >= 0 && c_l < 10, "linear viscosity", c_l, "in [0, 10)");
  }
  template <class V> BOLIDE_INLINE V pressure(V rho, V c, V divergence, scalar_t<V> cell) const {
    using T = scalar_t<V>;
    const V d = max(-divergence, V(T(0)));
    return rho * d * cell * (T(quadratic) * cell * d + T(linear) * c);
  }
  /// The speed Q that enters the time step as l / (Q + sqrt(Q^2 + c^2)).
  template <class V> BOLIDE_INLINE V signal_speed(V c, V divergence, scalar_t<V> cell) const {
    using T = scalar_t<V>;
    const V d = max(-divergence, V(T(0)));
    return select(d > V(T(0)), T(quadratic) * cell * d + T(linear) * c, V(T(0)));
  }
};

} // namespace bolide::viscosity
