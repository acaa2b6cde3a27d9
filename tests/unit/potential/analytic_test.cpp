// SPDX-License-Identifier: MIT
// Cai-Ye's and Zhou's functions: derivatives against differences, the published fits, the joins of F, refusals.
#include "bolide/potential/cai_ye.hpp"
#include "bolide/potential/zhou04.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {
using namespace bolide;

/// first and second against fourth-order differences, relative to value/s and value/s^2.
template <class F> void expect_derivatives(const F& f, double s, const std::string& what) {
  const double h = 2e-4 * s;
  const potential_value at = f(s), a = f(s - 2 * h), b = f(s - h), c = f(s + h), d = f(s + 2 * h);
  const double first = (8 * (c.value - b.value) - (d.value - a.value)) / (12 * h),
               second = (8 * (c.first - b.first) - (d.first - a.first)) / (12 * h);
  const double size = std::abs(at.value) + std::abs(s * at.first) + std::abs(s * s * at.second);
  EXPECT_NEAR(at.first * s, first * s, 1e-8 * size) << what << " at " << s;
  EXPECT_NEAR(at.second * s * s, second * s * s, 1e-8 * size) << what << " at " << s;
}
template <class P>
void expect_all_derivatives(const P& p, double rho_low, double rho_high, double gap_low, double gap_high, const std::string& name) {
  for (double r = 1.1; r < 12; r *= 1.07) {
    expect_derivatives([&](double s) { return p.pair(s); }, r, name + " phi");
    expect_derivatives([&](double s) { return p.density(s); }, r, name + " f");
  }
  for (double rho = rho_low; rho < rho_high; rho *= 1.13)
    if (std::abs(rho / gap_low - 1) > 0.005 && std::abs(rho / gap_high - 1) > 0.005)
      expect_derivatives([&](double s) { return p.embedding(s); }, rho, name + " F");
}
TEST(Potential, DerivativesMatchDifferences) {
  expect_all_derivatives(potential::cai_ye{}, 1e-9, 1e4, -1, -1, "Cai-Ye");
  const potential::zhou04 zhou;
  const double rho_e = zhou.parameters().rho_e;
  expect_all_derivatives(zhou, 1e-3, 1e4, 0.85 * rho_e, 1.15 * rho_e, "Zhou");
}

TEST(Potential, CaiYeAtEquilibrium) {
  const potential::cai_ye sharp(potential::cutoff::sharp), none;
  EXPECT_NEAR(0.3833721 * sharp.equilibrium_density(), 4.7726129, 1e-6); // with the published f_e
  EXPECT_EQ(sharp.reach(), 1.65 * 4.05);
  EXPECT_EQ(none.reach(), uncut_reach);
  const auto F = none.embedding(none.equilibrium_density()); // y = 1: F = -F0 + F1, F' rho_e = F1
  EXPECT_NEAR(F.value, -2.61 - 0.1392, 1e-14);
  EXPECT_NEAR(F.first * none.equilibrium_density(), -0.1392, 1e-14);
  const auto phi = none.pair(3.0169); // u = 0: the minimum
  EXPECT_NEAR(phi.value, -0.0834, 1e-16);
  EXPECT_EQ(phi.first, 0);
  EXPECT_EQ(none.density(4.05 / std::sqrt(2.0)).value, 1);
  for (const double rho : {0.0, 1e-300, 1e-201}) {
    EXPECT_EQ(none.embedding(rho).value, 0);
    EXPECT_EQ(none.embedding(rho).first, 0);
  }
  EXPECT_TRUE(std::isfinite(none.embedding(1e-198).second));
}

TEST(Potential, ZhouStepsWhereItsPiecesJoin) {
  const potential::zhou04 zhou;
  const double rho_e = zhou.parameters().rho_e;
  const auto step = [&](double at) {
    const auto a = zhou.embedding(at * rho_e * (1 - 1e-13)), b = zhou.embedding(at * rho_e * (1 + 1e-13));
    return potential_value{b.value - a.value, (b.first - a.first) * rho_e, (b.second - a.second) * rho_e * rho_e};
  };
  const auto low = step(0.85), high = step(1.15);
  EXPECT_NEAR(low.value, 3.4e-7, 2e-8); // as the header says
  EXPECT_NEAR(low.first, -5.6e-7, 2e-8);
  EXPECT_NEAR(low.second, 0, 1e-6);
  EXPECT_NEAR(high.value, 4.1e-7, 2e-8);
  EXPECT_NEAR(high.first, -1.15e-7, 2e-8);
  EXPECT_NEAR(high.second, 2.32, 0.005);
  EXPECT_NEAR(zhou.embedding(0).value, -1e-6, 1e-12);
  EXPECT_NEAR(zhou.embedding(rho_e).value, -2.83, 1e-15);
  EXPECT_NEAR(zhou.lattice_constant(), 4.0502, 5e-5);
}

TEST(Potential, BadParametersAreRefusedWithASentence) {
  try {
    potential::zhou_parameters q;
    q.r_e = 0;
    potential::zhou04 bad{q};
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "potential::zhou04 r_e = 0 angstrom: must be > 0 (unit: angstrom)");
  }
  potential::cai_ye_parameters q;
  q.n = 1;
  try {
    potential::cai_ye bad(potential::cutoff::none, q);
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "potential::cai_ye n = 1: must be between 0 and 1");
  }
}
} // namespace
