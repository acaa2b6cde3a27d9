// SPDX-License-Identifier: MIT
// expect: bolide: solver: the fifth argument is no scheme: it must have particle_fields, stress_first, maps_velocity_back, wants_smooth_shape, name and step(phases)
// flags: -Wno-unknown-pragmas
// A scheme that calls a phase that does not exist is refused with a sentence.
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"
using namespace bolide;

struct forgot_its_step {
  using particle_fields = fields<>;
  static constexpr bool stress_first = true;
  static constexpr const char* name = "forgot";
};
const body b{"water", box{vec<double, 1>(0), vec<double, 1>(1)}, material{eos::stiffened_gas{}, strength::none{}, failure::none{}}, 0.1, {1000, 0}};
solver sim{space::planar_1d{}, grid::sparse{0.2}, shape::quadratic_bspline{}, transfer::flip{}, forgot_its_step{}, controls<>{}, b};
