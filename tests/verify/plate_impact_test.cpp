// SPDX-License-Identifier: MIT
// Plate impact in the equations of state that flyer_1d_test.cpp does not run: reference, a table, stiffened gas, ideal gas, JWL products, and
// Mie-Grueneisen of every metal of the library.
#include "verify/flyer.hpp"

#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/reference.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tabulated.hpp"
#include "bolide/material/data/library.hpp"

namespace bolide {
namespace {
using namespace verify;

template <class Start> void check(const std::string& name, const Start& at) { verify_flyer_1d(name, at, 50); }
template <class Eos> auto ambient(const Eos& eos) {
  const auto at = eos::ambient_state(eos, 293);
  return start{eos, initial_state{at.density, at.energy}};
}
/// Time to run 0.88 of 8 mm: at the shock's speed, or, where a release follows from a free end, at the sum of its speed and the shock's.
double flight(double fastest) { return 0.88 * 8 * mm / fastest; }

TEST(PlateImpact, Reference) { check("reference", ambient(eos::reference{})); }
TEST(PlateImpact, TableOfMieGrueneisen) { check("tabulated mie-gruneisen", start{eos::tabulated{eos::mie_grueneisen{}}, initial_state{2785, 0}}); }
TEST(PlateImpact, StiffenedGas) { check("stiffened gas, water at 1 km/s", start{eos::stiffened_gas{}, initial_state{1000, 0}, 1000.0, flight(2600), false}); }
TEST(PlateImpact, IdealGas) {
  const eos::ideal_gas air;
  check("ideal gas, air at 1 km/s", start{air, initial_state{1.2, air.energy(293)}, 1000.0, flight(1100), true});
}
TEST(PlateImpact, JwlProducts) { // of TNT, expanded to half the explosive's density
  const eos::jwl products{{.rho0 = 1630, .A = 371.2e9, .B = 3.231e9, .R1 = 4.15, .R2 = 0.95, .omega = 0.30}};
  check("jwl, products of TNT at 815 kg/m3 and 4 km/s", start{products, initial_state{815, 2.5e6}, 4000.0, flight(8000), true});
}
TEST(PlateImpact, EveryMetalOfTheLibrary) {
  for (const auto& set : data::library) {
    const eos::mie_grueneisen eos{set.mie_grueneisen};
    check("mie-gruneisen of " + std::string(set.name) + " at 4 km/s",
          start{eos, initial_state{set.mie_grueneisen.rho0, 0}, 4000.0, flight(set.mie_grueneisen.c0 + 2000 * set.mie_grueneisen.s), false});
  }
}

} // namespace
} // namespace bolide
