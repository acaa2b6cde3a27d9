// SPDX-License-Identifier: MIT
// The adapters, and the library's own root finder and isentrope against GSL's: two independent roads to one number.
#include "bolide/analysis/hugoniot.hpp"
#include "bolide/analysis/release_isentrope.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/gsl/ode.hpp"
#include "bolide/gsl/root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace bolide;

TEST(GslRoot, FindsARootAndThrowsWithoutABracket) {
  EXPECT_NEAR(gsl::root([](double x) { return x * x - 2; }, 0, 2), std::sqrt(2.0), 1e-12);
  EXPECT_THROW(gsl::root([](double x) { return x * x + 2; }, 0, 2), gsl::failure);
}

TEST(GslOde, IntegratesACircle) {
  const auto y = gsl::integrate<2>([](double, const std::array<double, 2>& v) { return std::array<double, 2>{-v[1], v[0]}; }, {1, 0}, 0,
      2.5, 1e-12, 1e-12);
  EXPECT_NEAR(y[0], std::cos(2.5), 1e-10);
  EXPECT_NEAR(y[1], std::sin(2.5), 1e-10);
}

template <class Eos> void shock_and_release_agree(const Eos& eos, double up) {
  const auto ahead = eos::ambient_state(eos);
  const auto own = analysis::hugoniot(eos, ahead, up);
  // Shock: Brent in the shock speed, near the known root.
  const double us = gsl::root(
      [&](double s) {
        const double e = ahead.energy + ahead.pressure * up / (ahead.density * s) + 0.5 * up * up;
        return eos.evaluate(ahead.density * s / (s - up), e).pressure - ahead.pressure - ahead.density * s * up;
      },
      0.97 * own.shock_speed, 1.03 * own.shock_speed);
  EXPECT_NEAR(own.shock_speed / us, 1, 1e-10);
  // Release: e and u against ln V by GSL's Runge-Kutta 8(9), to the density where our release ended.
  const auto end = analysis::release_isentrope(eos, own.density, own.energy);
  const auto slope = [&](double y, const std::array<double, 2>& v) {
    const double rho = std::exp(-y);
    const auto p = eos.evaluate(rho, v[0]);
    return std::array<double, 2>{-p.pressure / rho, std::sqrt(p.sound_speed_squared)};
  };
  const auto y = gsl::integrate<2>(slope, {own.energy, 0}, -std::log(own.density), -std::log(end.density), 1e-11, 1e-6);
  EXPECT_NEAR(end.energy / y[0], 1, 1e-8);
  EXPECT_NEAR(end.speed_gain / y[1], 1, 1e-7); // the sound speed jumps at the phase borders
  EXPECT_LT(std::abs(end.pressure), 1e4);
}

TEST(GslCrossCheck, MieGrueneisen) { shock_and_release_agree(eos::mie_grueneisen{}, 3320); }
TEST(GslCrossCheck, Grover) {
  const eos::grover mixed{cold::tabulated{cold::cai_ye{}}, phase::mixed{}};
  shock_and_release_agree(mixed, 2000);
  shock_and_release_agree(mixed, 3320);
}
} // namespace
