// SPDX-License-Identifier: MIT
// The limited viscosity: its factors on every lane, and what they make of shear flow, a planar shock and converging flow in a material.
#include "bolide/viscosity/limited.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/strength/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/eos/lanes.hpp"
#include "unit/material/material_point.hpp"

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {

template <class V> class Limited : public testing::Test {};
TYPED_TEST_SUITE(Limited, lane_types);

TYPED_TEST(Limited, FactorsAreTheirFormulas) {
  using V = TypeParam;
  using T = scalar_t<V>;
  const viscosity::limited by_shear{viscosity::bulk{}}, by_isotropy{viscosity::bulk{}, false, true}, by_both{viscosity::bulk{}, true, true}, by_none{viscosity::bulk{}, false, false};
  const auto factor = [](const auto& m, double divergence, double vorticity, double deviatoric2) {
    return static_cast<double>(lane(m.factor(V(T(divergence)), V(T(vorticity * vorticity)), V(T(deviatoric2))), 0));
  };
  for (const double d : {-1e3, -1e7})
    for (const double ratio : {0.0, 0.01, 1.0, 100.0}) {
      test::expect_close(factor(by_shear, d, -ratio * d, 0), 1 / (1 + ratio), test::epsilon<V>(8), 0, "shear");
      test::expect_close(factor(by_isotropy, d, -ratio * d, 0.01 * d * d), std::sqrt(0.015), test::epsilon<V>(8), 0, "isotropy");
      test::expect_close(factor(by_both, d, -ratio * d, 0.01 * d * d), std::sqrt(0.015) / (1 + ratio), test::epsilon<V>(16), 0, "both");
      EXPECT_EQ(factor(by_none, d, -ratio * d, 0), 1);
    }
  EXPECT_EQ(factor(by_both, 0, 0, 0), 0) << "at rest: a number";
  EXPECT_EQ(factor(by_isotropy, -1e6, 0, 1e18), 1) << "never more than all of it";
}

// ---- in a material ------------------------------------------------------------------------------------------------------------------------
const double rho0 = 2785;
template <class Space, class Viscosity> double q_of(const Viscosity& v, const typename Space::template gradient<double>& l) {
  using fluid = material<eos::mie_grueneisen, strength::none, failure::none, Viscosity>;
  test::material_point<fluid, Space> m(fluid{eos::mie_grueneisen{{.constant_gamma = true}}, {}, {}, v}, rho0, 0);
  m.advance(l, 1e-12, false);
  return m.template get<field::viscous_pressure>();
}
using rz = space::axisymmetric;
const viscosity::bulk bulk;
const viscosity::limited by_shear{viscosity::bulk{}};
const viscosity::limited by_isotropy{viscosity::bulk{}, false, true};

TEST(LimitedFlow, ShearWithALittleCompressionMakesNearlyNone) {
  const double shear = 1e7;
  for (const double compression : {1e-2, 1e-3}) {
    const rz::gradient<double> l{-compression * shear, shear, 0, 0, 0};
    EXPECT_NEAR(q_of<rz>(by_shear, l) / q_of<rz>(bulk, l), compression / (1 + compression), 1e-9);
  }
  EXPECT_EQ(q_of<rz>(bulk, {0, shear, 0, 0, 0}), 0) << "pure shear makes none at all";
  // rotation without compression: none; a rotating shock keeps its part
  EXPECT_NEAR(q_of<rz>(by_shear, {-shear, shear, -shear, 0, 0}) / q_of<rz>(bulk, {-shear, shear, -shear, 0, 0}), 1.0 / 3, 1e-9);
}

TEST(LimitedFlow, APlanarShockIsUnchanged) {
  for (const double d : {-1e4, -1e6, -3e7}) {
    EXPECT_EQ(q_of<space::planar_1d>(by_shear, {d}), q_of<space::planar_1d>(bulk, {d}));
    EXPECT_NEAR(q_of<space::planar_1d>(by_isotropy, {d}) / q_of<space::planar_1d>(bulk, {d}), 1, 1e-14);
    for (int axis = 0; axis < 2; ++axis) { // along r and along z
      rz::gradient<double> l{};
      l[axis == 0 ? 0 : 3] = d;
      EXPECT_EQ(q_of<rz>(by_shear, l), q_of<rz>(bulk, l));
      EXPECT_NEAR(q_of<rz>(by_isotropy, l) / q_of<rz>(bulk, l), 1, 1e-14);
    }
    const double c = 0.5 * d; // at 45 degrees: no vorticity either
    EXPECT_EQ(q_of<rz>(by_shear, {c, c, c, c, 0}), q_of<rz>(bulk, {c, c, c, c, 0}));
    EXPECT_NEAR(q_of<rz>(by_isotropy, {c, c, c, c, 0}) / q_of<rz>(bulk, {c, c, c, c, 0}), 1, 1e-12);
  }
}

TEST(LimitedFlow, UniformConvergenceFromAllSidesMakesNone) {
  for (const double d : {-1e5, -1e7}) {
    const rz::gradient<double> sphere{d, 0, 0, d, d}, cylinder{d, 0, 0, 0, d};
    EXPECT_LT(q_of<rz>(by_isotropy, sphere), 1e-7 * q_of<rz>(bulk, sphere));
    EXPECT_NEAR(q_of<rz>(by_isotropy, cylinder) / q_of<rz>(bulk, cylinder), 0.5, 1e-9);
    EXPECT_EQ(q_of<rz>(by_shear, sphere), q_of<rz>(bulk, sphere)) << "the shear limiter says nothing of it";
    EXPECT_EQ(q_of<rz>(by_isotropy, {-d, 0, 0, -d, -d}), 0) << "expansion";
  }
}

TEST(LimitedFlow, AHomologousImplosionFollowsTheIsentrope) {
  // uniform compression to 1.5 rho0 in 2 us: the energy beyond that of the isentrope is what the viscosity added
  const auto heated = [](const auto& v) {
    using fluid = material<eos::mie_grueneisen, strength::none, failure::none, std::remove_cvref_t<decltype(v)>>;
    test::material_point<fluid, rz> m(fluid{eos::mie_grueneisen{{.constant_gamma = true}}, {}, {}, v}, rho0, 0);
    const double dt = 1e-10, rate = -std::log(1.5) / 3 / 2e-6;
    double heating = 0;
    for (int i = 0; i < 20000; ++i) heating += m.advance({rate, 0, 0, rate, rate}, dt).viscous_heating;
    EXPECT_NEAR(m.density(), 1.5 * rho0, 1e-3 * rho0);
    return heating / 1e-6; // J/kg
  };
  const double full = heated(bulk), limited = heated(by_isotropy);
  std::printf("[ figures  ] homologous compression to 1.5 rho0 in 2 us: viscous heating %.4g J/kg, limited by isotropy %.4g J/kg\n", full, limited);
  EXPECT_GT(full, 1000);
  EXPECT_LT(limited, 1e-6 * full);
}

TEST(LimitedFlow, TheTimeStepGoesOnCountingAllOfIt) {
  using full = material<eos::mie_grueneisen, strength::none, failure::none, viscosity::bulk>;
  using part = material<eos::mie_grueneisen, strength::none, failure::none, viscosity::limited<viscosity::bulk>>;
  const eos::mie_grueneisen eos{{.constant_gamma = true}};
  test::material_point<full, rz> a(full{eos, {}, {}}, rho0, 0);
  test::material_point<part, rz> b(part{eos, {}, {}, by_shear}, rho0, 0);
  const rz::gradient<double> l{-3e7, 1e7, 0, 0, 0};
  const double rate = a.advance(l, 1e-12, false).limit.rate;
  EXPECT_NEAR(b.advance(l, 1e-12, false).limit.rate, rate, 1e-4 * rate); // the sound speed has seen less heat
  EXPECT_LT(b.get<field::viscous_pressure>(), 0.8 * a.get<field::viscous_pressure>());
  EXPECT_EQ(b.material().viscosity.quadratic, 1.5);
}

} // namespace
} // namespace bolide
