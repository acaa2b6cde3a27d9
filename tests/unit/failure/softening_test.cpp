// SPDX-License-Identifier: MIT
// Softening of a failed point: how tension and shear go to nothing over a time or over an opening, what the energy does, and that the void is
// that of the failure in one step in the end.
#include "bolide/failure/softening.hpp"
#include "bolide/concepts/failure.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/failure/tension_or_melt.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/none.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/core/lane_types.hpp"
#include "unit/material/material_point.hpp"

#include <cmath>
#include <cstdio>

namespace bolide {
namespace {

using soft_tension = failure::softening<failure::tension>;
using cohesive_tension = failure::cohesive<failure::tension>;

template <class V> class Softening : public testing::Test {};
TYPED_TEST_SUITE(Softening, lane_types);
TYPED_TEST(Softening, MeetsTheConceptOnEveryLane) {
  using V = TypeParam;
  using T = scalar_t<V>;
  EXPECT_TRUE((SofteningFailure<soft_tension, V> && SofteningFailure<cohesive_tension, V>));
  EXPECT_TRUE((AccumulatingFailure<failure::softening<failure::johnson_cook_damage>, V>));
  EXPECT_FALSE((SofteningFailure<failure::tension, V>));
  const soft_tension law{failure::tension{1e9}, 1e-7};
  EXPECT_NEAR(lane(law.capacity_lost(V(T(0.25)), V(T(1e9)), V(T(0)), T(5e-8), T(1e-4)), 0), 0.75, 1e-6);
  EXPECT_EQ(lane(law.capacity_lost(V(T(0.75)), V(T(1e9)), V(T(0)), T(5e-8), T(1e-4)), 0), 1);
  const cohesive_tension crack{failure::tension{1e9}, 1e3}; // w_c = 2 um
  EXPECT_NEAR(lane(crack.capacity_lost(V(T(0)), V(T(1e9)), V(T(0.005)), T(1), T(1e-4)), 0), 0.25, 1e-6);
  EXPECT_NEAR(lane(crack.capacity_lost(V(T(0.5)), V(T(1e9)), V(T(0.005)), T(1), T(1e-4)), 0), 0.5, 1e-6) << "never less than before";
  EXPECT_EQ(lane(crack.capacity_lost(V(T(0)), V(T(0)), V(T(0)), T(1), T(1e-4)), 0), 1) << "failed without tension";
}
TEST(SofteningParameters, AreCheckedWithASentence) {
  EXPECT_THROW((failure::softening{failure::tension{1e9}, 0}), bad_parameter);
  try {
    failure::cohesive{failure::tension{1e9}, -1};
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "fracture energy = -1 J/m2: must be positive (unit: J/m2)");
  }
}

// ---- in a material: p = K (rho/rho0 - 1), no heat in it -----------------------------------------------------------------------------------
struct spring {
  template <class V> eos_point<V> evaluate(V rho, V) const {
    using T = scalar_t<V>;
    return {T(1e7) * (rho - T(2000)), V(T(1e7))};
  }
  double reference_density() const { return 2000; }
};
constexpr double bulk = 2e10;
template <class Law, class Strength = strength::none> auto point(const Law& law, const Strength& s = {}) {
  using metal = material<spring, Strength, Law, viscosity::none>;
  return test::material_point<metal>(metal{spring{}, s, law, {}}, 2000, 0);
}
template <class Point> void until_failure(Point& m, double rate, double dt) {
  while (m.template get<field::failed>() == 0) m.advance({rate}, dt);
}

TEST(SofteningOverTime, TensionFallsLinearlyToNothing) {
  const double time = 1e-7, dt = 1e-9, rate = 1e5;
  auto m = point(soft_tension{failure::tension{0.2e9}, time});
  until_failure(m, rate, dt);
  const double held = -m.get<field::pressure>();
  EXPECT_GT(held, 0.2e9);
  EXPECT_LT(held, 0.2e9 + 1.01 * bulk * rate * dt) << "it still bears what it bore when it failed";
  EXPECT_EQ(m.get<field::held_tension>(), held);
  for (int i = 1; i <= 100; ++i) {
    m.advance({rate}, dt);
    ASSERT_NEAR(-m.get<field::pressure>(), held * (1 - i / 100.0), 1e-9 * held) << i;
    const auto state = m.material().eos.evaluate(m.own_density(), 0.0);
    ASSERT_NEAR(state.pressure, m.get<field::pressure>(), 1e-3 * held) << "the material itself is in that tension";
  }
  m.advance({rate}, dt);
  EXPECT_EQ(m.get<field::pressure>(), 0);
  EXPECT_EQ(m.get<field::lost_capacity>(), 1);
  for (int i = 0; i < 5; ++i) m.advance({rate}, dt);
  EXPECT_EQ(m.get<field::failed>(), 2) << "settled, as after a failure in one step";
  EXPECT_NEAR(m.own_density(), 2000, 1e-8 * 2000);
  EXPECT_GT(m.get<field::volume>(), 1.01 * m.get<field::material_volume>());
}

TEST(SofteningOverTime, DoesNotHangOnTheStep) {
  double last = 0, change[2] = {};
  for (int level = 0; level < 3; ++level) { // the work to pull it apart
    const double dt = 2e-9 / (1 << level), rate = 1e5;
    auto m = point(soft_tension{failure::tension{0.2e9}, 1e-7});
    for (double t = 0; t < 4e-7; t += dt) m.advance({rate}, dt);
    const double e = m.get<field::energy>();
    if (level > 0) change[level - 1] = std::abs(e / last - 1);
    last = e;
  }
  EXPECT_LT(change[0], 0.05);
  EXPECT_LT(change[1], 0.6 * change[0]) << "first order";
}

TEST(SofteningOverTime, ShearGoesAlongAndItsEnergyIsHeat) {
  using thermal = eos::isentrope_temperature<eos::mie_grueneisen>;
  using metal = material<thermal, strength::elastic_perfectly_plastic, failure::softening<failure::tension_or_melt>, viscosity::none>;
  const metal al{thermal{eos::mie_grueneisen{{.constant_gamma = true}}}, {27.6e9, 1e9}, {failure::tension_or_melt::melt_only(), 1e-7}, {}};
  test::material_point<metal, space::axisymmetric> m(al, 2785, 0.1e6);
  for (int i = 0; i < 300; ++i) m.advance({0, 1e5, 0, 0, 0}, 1e-9);
  const double shear = al.shear_energy(m.p, 0), s = m.get<field::deviator>(2);
  ASSERT_NEAR(s, 1e9 / std::sqrt(3.0), 0.02e9) << "at yield";
  m.get<field::energy>() += 0.6e6; // melts
  m.advance({1e-3, 0, 0, 0, 0}, 1e-9);
  ASSERT_GT(m.get<field::failed>(), 0);
  EXPECT_NEAR(m.get<field::deviator>(2), s, 1e-3 * s) << "nothing lost yet";
  const double temperature = m.thermodynamics().temperature;
  double released = 0;
  for (int i = 1; i <= 100; ++i) {
    released += m.advance({1e-3, 0, 0, 0, 0}, 1e-9).failure_release;
    ASSERT_NEAR(m.get<field::deviator>(2), s * (1 - i / 100.0), 1e-3 * s) << i;
  }
  EXPECT_NEAR(released, shear * 1e-6, 1e-3 * shear * 1e-6);
  EXPECT_NEAR(m.thermodynamics().temperature - temperature, shear / 875, 0.02 * shear / 875);
  EXPECT_EQ(al.shear_energy(m.p, 0), 0);
}

TEST(SofteningVoid, ClosesAtZeroPressureAndOpensAgainAtTheTensionThatIsLeft) {
  const double dt = 1e-9, rate = 1e5;
  auto m = point(cohesive_tension{failure::tension{0.2e9}, 2e3}); // w_c = 20 um in a cell of 100 um: a strain of 0.2
  until_failure(m, rate, dt);
  for (int i = 0; i < 500; ++i) m.advance({rate}, dt); // strain 0.05
  const double step = 2 * rate * dt * m.get<field::held_tension>() * 1e-4 / (2 * 2e3); // what one step may add to what is lost
  const double lost = m.get<field::lost_capacity>(), held = m.get<field::held_tension>(), tension = -m.get<field::pressure>();
  EXPECT_NEAR(tension, held * (1 - lost), 1e-9 * held);
  EXPECT_NEAR(lost, (m.own_density() / m.density() - 1) * held * 1e-4 / (2 * 2e3), step) << "the opening over w_c";
  const double opening = m.get<field::volume>() - m.get<field::material_volume>();
  // closing: the material lets its tension go elastically first
  int steps = 0;
  while (m.get<field::pressure>() < 0) {
    m.advance({-rate}, dt);
    ASSERT_LT(++steps, 1000);
  }
  EXPECT_NEAR(steps * rate * dt, tension / bulk, 0.1 * tension / bulk) << "with the stiffness of the material";
  EXPECT_NEAR(m.get<field::volume>() - m.get<field::material_volume>(), opening, 0.02 * opening) << "the void stayed";
  const double kept = m.get<field::lost_capacity>();
  EXPECT_NEAR(kept, lost, step + lost * tension / bulk) << "the opening is told in material volumes, and these shrink by the tension's strain";
  for (int i = 0; i < 200; ++i) m.advance({-rate}, dt);
  EXPECT_NEAR(m.get<field::pressure>(), 0, 1e-9 * tension) << "the void closes under nothing";
  EXPECT_LT(m.get<field::volume>() - m.get<field::material_volume>(), 0.7 * opening);
  // and opens again: elastically to the tension that is left
  for (int i = 0; i < 150; ++i) m.advance({rate}, dt);
  EXPECT_NEAR(-m.get<field::pressure>(), held * (1 - kept), 1e-6 * tension);
  EXPECT_EQ(m.get<field::lost_capacity>(), kept) << "no further than it was open before";
  for (int i = 0; i < 600; ++i) m.advance({-rate}, dt);
  EXPECT_GT(m.get<field::pressure>(), 0) << "closed: compression";
  EXPECT_NEAR(m.own_density(), m.density(), 1e-12 * m.density());
}

TEST(SofteningByEnergy, SpendsTheFractureEnergyPerAreaWhateverTheStep) {
  const double fracture = 2e3, cell = 1e-4; // J/m2, m
  for (const double dt : {4e-9, 1e-9}) {
    auto m = point(cohesive_tension{failure::tension{0.2e9}, fracture});
    const double rate = 1e5;
    double released = 0, work = 0;
    while (m.get<field::lost_capacity>() < 1) {
      const auto r = m.advance({rate}, dt);
      released += r.failure_release;
      work += r.work_energy;
    }
    // per area of the crack: the point's volume over the cell
    const double area = 1e-6 / 2000 / cell;
    std::printf("[ figures  ] fracture energy %g J/m2, steps of %g: released %.1f, work %.1f J/m2\n", fracture, rate * dt, released / area, work / area);
    EXPECT_NEAR(released / area, fracture, 0.01 * fracture + 2 * cell * 0.2e9 * rate * dt) << dt;
    EXPECT_NEAR(work / area, fracture, 0.01 * fracture + 2 * cell * 0.2e9 * rate * dt) << "what was put in, from rest to nothing held";
  }
}

} // namespace
} // namespace bolide
