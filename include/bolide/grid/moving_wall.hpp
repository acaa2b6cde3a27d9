// SPDX-License-Identifier: MIT
// A rigid wall that moves at a constant velocity along an axis: a piston, an anvil. One-sided: it pushes and does not pull.
//
// Nodes behind the plane, and up to half a cell before it, that approach it get its velocity: the normal part, and all of it where the wall
// sticks (its tangential velocity is zero). Half a cell, so that the particle next to the wall always has such a node, wherever the plane lies
// between grid lines: material sees the wall to within that half cell. Momentum and work that it gives are
// booked (ledger: momentum_given, boundary_work). For a wall that rests on a grid line grid::mirror is more accurate (no node lacks mass).
#pragma once

#include "bolide/core/contract.hpp"

#include <cmath>
#include <string>

namespace bolide::grid {

struct moving_wall {
  int axis = 0;
  double position = 0;        // m, at time 0
  double velocity = 0;        // m/s, along the axis
  bool material_above = true; // is the material on the side of larger coordinates?
  bool stick = false;

  void validate(int dim) const {
    require(axis >= 0 && axis < dim, "axis of a moving wall", axis, "an axis of the space, 0 to " + std::to_string(dim - 1));
    require(std::abs(velocity) < 1e9, "velocity of a moving wall", velocity, "finite", "m/s");
  }
  double plane(double time) const { return position + velocity * time; }
  /// Does the wall hold a node at this coordinate (m)?
  bool holds(double coordinate, double time, double spacing) const {
    return material_above ? coordinate <= plane(time) + spacing / 2 : coordinate >= plane(time) - spacing / 2;
  }
  /// Does this normal velocity approach the wall?
  template <class T> bool approaches(T normal) const { return material_above ? normal < static_cast<T>(velocity) : normal > static_cast<T>(velocity); }
};

} // namespace bolide::grid
