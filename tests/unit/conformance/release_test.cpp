// SPDX-License-Identifier: MIT
// The release isentrope of every family against GSL's Runge-Kutta-Prince-Dormand 8(9) in another variable, and against the suite's own
// reference: three independent integrations of one curve.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/gsl/ode.hpp"
#include "unit/conformance/stated.hpp"

#include <gtest/gtest.h>

namespace {
using namespace bolide;

/// From the shock of `up` to the pressure ahead of it. GSL integrates de/dp = -p dV/dp = p/(rho c)^2, drho/dp = 1/c^2, du/dp = 1/(rho c).
template <class Eos> void release_agrees(const Eos& eos, const eos::material_state& ahead, double up, double relative) {
  const auto shock = analysis::hugoniot(eos, ahead, up);
  const auto end = analysis::release_isentrope(eos, shock.density, shock.energy, ahead.pressure);
  const double start = eos.evaluate(shock.density, shock.energy).pressure;
  const auto y = gsl::integrate<3>(
      [&](double, const std::array<double, 3>& at) {
        const double rho = at[0], c2 = eos.evaluate(rho, at[1]).sound_speed_squared, p = eos.evaluate(rho, at[1]).pressure;
        return std::array<double, 3>{1 / c2, p / (rho * rho * c2), 1 / (rho * std::sqrt(c2))};
      },
      {shock.density, shock.energy, 0}, start, end.pressure, 1e-12, 1e-9);
  EXPECT_NEAR(y[0] / end.density, 1, relative) << up;
  EXPECT_NEAR((y[1] - end.energy) / (shock.energy - end.energy), 0, relative) << up;
  EXPECT_NEAR(-y[2] / end.speed_gain, 1, relative) << up;
}

TEST(Release, AgreesWithGsl) {
  for (const double up : {500.0, 2000.0, 5000.0}) {
    const eos::grover helm{test::table(), phase::helm{}};
    const eos::grover mixed{test::table(), phase::mixed{}};
    release_agrees(helm, eos::ambient_state(helm), up, 1e-8);
    release_agrees(mixed, eos::ambient_state(mixed), up, 1e-8);
    release_agrees(eos::mie_grueneisen{}, eos::ambient_state(eos::mie_grueneisen{}), up, 1e-8);
    release_agrees(eos::tillotson{}, eos::ambient_state(eos::tillotson{}), up, 1e-8);
    release_agrees(eos::stiffened_gas{}, eos::ambient_state(eos::stiffened_gas{}), up, 1e-8);
    const eos::ideal_gas gas;
    release_agrees(gas, eos::state_at(gas, 1.2, gas.energy(293)), up, 1e-8);
  }
}
} // namespace
