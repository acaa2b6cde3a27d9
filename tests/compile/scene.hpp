// SPDX-License-Identifier: MIT
// What the compile cases share: a flyer in 1-D out of parts that a case replaces one by one.
#pragma once

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"

namespace scene {
using point = bolide::vec<double, 1>;
inline auto metal() { return bolide::material{bolide::eos::mie_grueneisen{}, bolide::strength::none{}, bolide::failure::none{}}; }
template <class Material> auto slab(const Material& m) {
  return bolide::body{"slab", bolide::box{point{0}, point{1e-3}}, m, 5e-5, bolide::initial_state{2785, 0}};
}
template <class Space, class Shape, class Transfer = bolide::transfer::flip> void run(Space space, Shape shape, Transfer transfer = {}) {
  bolide::solver sim{space, bolide::grid::sparse{1e-4}, shape, transfer, bolide::scheme::usf{}, bolide::controls<>{}, slab(metal())};
  sim.step();
}
} // namespace scene
