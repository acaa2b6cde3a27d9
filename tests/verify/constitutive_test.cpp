// SPDX-License-Identifier: MIT
// Strength and damage of one material point against closed forms, for the table (every figure is tested in detail in tests/unit/strength and
// tests/unit/failure).
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/linear_hardening.hpp"
#include "bolide/strength/steinberg_guinan.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/material/material_point.hpp"
#include "verify/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bolide::verify {
namespace {

using rz = space::axisymmetric;
using thermal = eos::isentrope_temperature<eos::mie_grueneisen>;
const thermal aluminium{eos::mie_grueneisen{{.constant_gamma = true}}};
constexpr double rho0 = 2785, g = 27.6e9, y = 0.3e9;

template <class Space, class Strength, class Law = failure::none> auto point(const Strength& s, const Law& law = {}) {
  using metal = material<thermal, Strength, Law, viscosity::none>;
  return test::material_point<metal, Space>(metal{aluminium, s, law, {}}, rho0, 0);
}
void row(const char* section, const char* problem, const char* measure, double value, double bound, const char* note = "") {
  record({.section = section, .problem = problem, .composition = "one material point, double", .measure = measure, .value = value, .bound = bound, .note = note});
  EXPECT_LE(std::abs(value), bound) << problem;
}
template <class Point> double equivalent(Point& m) {
  const rz::deviator<double> s{m.template get<field::deviator>(0), m.template get<field::deviator>(1), m.template get<field::deviator>(2)};
  return std::sqrt(1.5 * rz::contract(s, s));
}

TEST(Constitutive, UniaxialStrain) {
  auto perfect = point<space::planar_1d>(strength::elastic_perfectly_plastic{g, y});
  auto hardens = point<space::planar_1d>(strength::linear_hardening{g, y, 2e9});
  for (int i = 0; i < 300; ++i) {
    perfect.advance({-1e5}, 1e-9);
    hardens.advance({-1e5}, 1e-9);
  }
  row("solids", "uniaxial strain 3 %, perfectly plastic", "s_xx against -2Y/3", perfect.get<field::deviator>() / (-2.0 / 3 * y) - 1, 1e-9);
  const double strain = 2 * g * (0.03 - y / (2 * g)) / (3 * g + 2e9);
  row("solids", "uniaxial strain 3 %, linear hardening", "s_xx against -2(Y0 + H eps)/3", hardens.get<field::deviator>() / (-2.0 / 3 * (y + 2e9 * strain)) - 1, 1e-9);
}

TEST(Constitutive, SimpleShearToAHundred) {
  auto elastic = point<rz>(strength::elastic{g});
  auto capped = point<rz>(strength::elastic_perfectly_plastic{g, y});
  const double step = 1e-3;
  double least = y, worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    elastic.advance({0, 1e6, 0, 0, 0}, step / 1e6, false);
    capped.advance({0, 1e6, 0, 0, 0}, step / 1e6, false);
    if (i > 1000) least = std::min(least, capped.get<field::deviator>(2));
    worst = std::max(worst, std::abs(elastic.get<field::deviator>(2) / g - std::sin((i + 1) * step)));
  }
  const double rr = y * y / (3 * g), steady = std::sqrt(y * y / 3 - rr * rr);
  row("extremes", "simple shear to gamma = 100, with a yield cap", "least s_rz after gamma = 1 below the steady value", 1 - least / steady, 1e-4);
  row("extremes", "simple shear to gamma = 100, elastic (Jaumann)", "largest |s_rz/G - sin(gamma)|", worst, 0.06,
      "oscillates as its exact solution; grows by exp(gamma dgamma/2), 5.1 % here, from the explicit rotation");
}

TEST(Constitutive, SteinbergGuinanShearedUnderPressure) {
  const auto law = strength::steinberg_guinan::aluminium_6061_t6();
  auto m = point<rz>(law);
  double work = 0;
  for (int i = 0; i < 1000; ++i) work += m.advance({-1e5, 0, 0, -1e5, -1e5}, 1e-9).work_energy;
  for (int i = 0; i < 1000; ++i) work += m.advance({0, 1e5, 0, 0, 0}, 1e-9).work_energy;
  EXPECT_GT(m.get<field::shear_modulus>(), 2 * g) << "the modulus must have changed";
  const auto at = m.thermodynamics();
  const double expected = law.yield_stress(m.get<field::plastic_strain>(), 0.0, at.temperature, at.melting_temperature, m.get<field::pressure>(), m.density());
  row("solids", "Steinberg-Guinan, compressed to 1.35 rho0 and sheared", "equivalent stress against the law at the state", equivalent(m) / expected - 1, 1e-3);
  row("solids", "Steinberg-Guinan, compressed to 1.35 rho0 and sheared", "energy gained against the work done", m.get<field::energy>() * 1e-6 / work - 1, 1e-12);
}

TEST(Constitutive, JohnsonCookDamageOfAnIsochoricExtension) {
  failure::johnson_cook_damage law;
  law.d1 = 0.05, law.d2 = 0.2, law.d3 = -2, law.d4 = law.d5 = 0; // fails at 0.25, before the heat of the work makes a pressure
  auto m = point<rz>(strength::elastic_perfectly_plastic{g, y}, law);
  const double rate = 1e5, dt = 1e-9, across = -rate / 2, along = (1 - 1 / square(1 - dt * across)) / dt; // no change of volume
  double plastic = 0, integral = 0;
  while (m.get<field::failed>() == 0 && plastic < 1) {
    const double before = m.get<field::plastic_strain>();
    integral += (before - plastic) / law.strain_to_failure(rate, m.get<field::pressure>(), y, 293.0, 933.0);
    plastic = before;
    m.advance({across, 0, 0, along, across}, dt);
  }
  row("solids", "Johnson-Cook damage in isochoric extension", "integral of d(eps)/eps_f at failure, less 1", integral - 1, 1e-3);
}

} // namespace
} // namespace bolide::verify
