// SPDX-License-Identifier: MIT
// expect: bolide: solver: run: an observer must have watch(solver) and finish(solver)
// flags: -Wno-unknown-pragmas
// An observer that forgets finish is refused with a sentence.
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"
using namespace bolide;

struct never_finishes {
  template <class Sim> void watch(const Sim&) {}
};
int main() {
  const body b{"water", box{vec<double, 1>(0), vec<double, 1>(1)}, material{eos::stiffened_gas{}, strength::none{}, failure::none{}}, 0.1, {1000, 0}};
  solver sim{space::planar_1d{}, grid::sparse{0.2}, shape::quadratic_bspline{}, transfer::flip{}, scheme::usf{}, controls<>{}, b};
  sim.run(1, never_finishes{});
}
