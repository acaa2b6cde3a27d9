// SPDX-License-Identifier: MIT
// expect: bolide: solver: APIC with linear shape functions is unsound
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/strength/none.hpp"

using namespace bolide;
int main() {
  const material gas{eos::ideal_gas{}, strength::none{}, failure::none{}};
  const body tube{"tube", box{vec<double, 1>(0), vec<double, 1>(1)}, gas, 0.01, {1, 1}};
  solver sim{space::planar_1d{}, grid::sparse{0.02}, shape::linear{}, transfer::apic{}, scheme::usf{}, controls<>{}, tube};
}
