// SPDX-License-Identifier: MIT
// XPIC(m) (Hammerquist and Nairn 2017): the null space of the map to the grid is filtered out of the particle velocities, what the grid
// sees is kept the better the higher the order. With S+ the map to the nodes and S the one back:
//   v_p <- v_p - (1 - S S+)^m v_p + sum N dv_I
// XPIC(1) is PIC, large m approaches FLIP without its noise. A step costs m - 1 more maps there and back. Positions move as in FLIP,
// x_p += dt sum N (v_I + dv_I). The loss is m (v . r - |r|^2/2 + dv . r) with r = (1 - S S+)^m v_p; v . r is booked in the equal sum of
//   |(1 - S S+)^(m/2) v_p|^2 (m even),   sum N |u_p - u_I|^2 with u = (1 - S S+)^((m-1)/2) v_p (m odd),
// which is not negative particle by particle, and is returned as heat (`heat` = 1) or dropped (0).
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"

namespace bolide::transfer {
namespace detail {
inline constexpr const char* xpic_names[] = {"",       "xpic1",  "xpic2",  "xpic3",  "xpic4",  "xpic5",  "xpic6",  "xpic7",  "xpic8",  "xpic9", "xpic10",
                                             "xpic11", "xpic12", "xpic13", "xpic14", "xpic15", "xpic16", "xpic17", "xpic18", "xpic19", "xpic20"};
} // namespace detail

template <int Order> struct xpic {
  static_assert(Order >= 1 && Order <= 20, "bolide: transfer: xpic<m> wants an order m from 1 to 20");
  using particle_fields = std::conditional_t<(Order > 1), fields<field::velocity_residual, field::filter_loss>, fields<>>;
  static constexpr bool affine = false;
  static constexpr bool wants_smooth_shape = false;
  static constexpr int filter_order = Order;
  static constexpr const char* name = detail::xpic_names[Order];

  double heat = 1; // fraction of the transfer loss that is returned as heat

  static constexpr double filter() { return 1; }
  void validate() const { require(heat >= 0 && heat <= 1, "returned fraction of the transfer loss", heat, "in [0, 1]"); }
};
} // namespace bolide::transfer
