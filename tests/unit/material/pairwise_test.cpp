// SPDX-License-Identifier: MIT
// Every strength with every failure law, and each of them with every equation of state, in 47 small impacts (a covering array: the equation of
// state changes along both axes of the table of strengths and laws). Through any_material: one solver is compiled, and 47 materials.
//
// The state must stay finite and the ledger close; the last test asks that no pair was left out. What is not allowed (damage from plastic
// strain with a strength that never yields; a temperature that is not there) is refused by sentence: tests/compile.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/ideal_gas.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/jwl.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/eos/tillotson.hpp"
#include "bolide/failure/johnson_cook_damage.hpp"
#include "bolide/failure/softening.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/failure/thermal_tension.hpp"
#include "bolide/material/any_material.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"
#include "bolide/strength/linear_hardening.hpp"
#include "bolide/strength/steinberg_guinan.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace bolide {
namespace {
using namespace test;

// ---- the three lists --------------------------------------------------------------------------------------------------------------------
const std::tuple strengths{strength::none{}, strength::elastic{27.6e9}, strength::elastic_perfectly_plastic{27.6e9, 0.3e9}, strength::linear_hardening{27.6e9, 0.3e9, 1e9},
                           strength::johnson_cook{}, strength::steinberg_guinan::aluminium_6061_t6()};
const failure::johnson_cook_damage damage{.d1 = 0.05, .d2 = 0.1, .d3 = -1.5, .d4 = 0.01, .d5 = 0.5};
const std::tuple laws{failure::none{}, failure::tension{1e9}, failure::tension_or_melt{1e9}, failure::thermal_tension{1e9},
                      failure::softening{failure::tension{1e9}, 3e-8}, failure::cohesive{failure::tension_or_melt{1e9}, 100}, damage,
                      failure::softening{damage, 3e-8}};
const std::tuple models{eos::mie_grueneisen{{.constant_gamma = true}}, eos::tillotson{}, eos::grover{cold::tabulated{cold::cai_ye{}}, phase::mixed{}}, eos::stiffened_gas{},
                        eos::jwl{{.rho0 = 1630, .A = 373.77e9, .B = 3.7471e9, .R1 = 4.15, .R2 = 0.9, .omega = 0.35}}, eos::ideal_gas{{.rho0 = 100}}};
constexpr int gas = 5;                                            // composed with strength::none and failure::none alone: see its header
constexpr double start_energy[] = {0, 0, 0, 0, 4.29e6, 2e5};      // J/kg

template <class Strength, class Law> inline constexpr bool allowed = !AccumulatingFailure<Law> || strength_yields<Strength>;

/// The model, wrapped in a temperature where one is wanted and it has none.
template <bool Thermal, class Eos> auto with_temperature(const Eos& eos) {
  if constexpr (Thermal && !ThermalEquationOfState<Eos>) return eos::isentrope_temperature{eos};
  else return eos;
}

// ---- one combination ----------------------------------------------------------------------------------------------------------------------
using any = any_material<double, space::axisymmetric, fields<field::shear_modulus, field::damage, field::lost_capacity, field::held_tension>>;
std::set<std::pair<int, int>> strength_law, strength_model, law_model; // what was run
int yielded = 0, failed = 0, softened = 0, damaged = 0;

/// A sphere of 0.8 mm against a plate of 0.3 mm at 2 km/s, 120 steps.
void run(const any& m, const initial_state& at, const std::string& name) {
  using point = vec<double, 2>;
  const body ball{"ball", sphere{point{0, -0.4 * mm}, 0.4 * mm}, m, 0.05 * mm, at, point{0, 2000}};
  const body plate{"plate", box{point{0, 0}, point{1 * mm, 0.3 * mm}}, m, 0.05 * mm, at};
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), ball, plate};
  for (int i = 0; i < 120; ++i) sim.step();
  const auto& l = sim.energies();
  EXPECT_LT(std::abs(l.residual()), 1e-9) << name;
  EXPECT_LT(std::abs(l.drift()), 1e-9) << name;
  EXPECT_TRUE(std::isfinite(l.now.total())) << name;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    const auto each = [&]<class Tag>(Tag) {
      for (int c = 0; c < space::axisymmetric::components(Tag::order); ++c)
        for (std::size_t i = 0; i < p.size(); ++i) ASSERT_TRUE(std::isfinite(p.template get<Tag>(c)[i])) << name << " " << Tag::name;
    };
    const auto all = [&]<class... F>(fields<F...>) { (each(F{}), ...); };
    all(typename std::remove_cvref_t<decltype(p)>::field_list{});
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto thermal = s.material.thermodynamics(p, i);
      ASSERT_TRUE(std::isfinite(thermal.pressure) && std::isfinite(thermal.temperature)) << name;
      const double lost = p.template get<field::lost_capacity>()[i], harm = p.template get<field::damage>()[i];
      ASSERT_TRUE(lost >= 0 && lost <= 1 && harm >= 0 && harm <= 1) << name;
      yielded += p.template get<field::plastic_strain>()[i] > 0;
      failed += p.template get<field::failed>()[i] > 0;
      softened += lost > 0;
      damaged += harm > 0;
    }
  });
}

template <int S, int F, int E> void combine() {
  const auto& strength = std::get<S>(strengths);
  const auto& law = std::get<F>(laws);
  using strength_type = std::remove_cvref_t<decltype(strength)>;
  using law_type = std::remove_cvref_t<decltype(law)>;
  const auto model = with_temperature<strength_type::wants_temperature || law_type::wants_temperature>(std::get<E>(models));
  const any m{material{model, strength, law, viscosity::bulk{}, record::peak_pressure{}}};
  run(m, {model.reference_density(), start_energy[E]}, "strength " + std::to_string(S) + ", law " + std::to_string(F) + ", model " + std::to_string(E));
  strength_law.insert({S, F});
  strength_model.insert({S, E});
  law_model.insert({F, E});
}
constexpr int solids = 5; // models other than the gas
/// Strength S with every law it may have.
template <int S> void with_every_law() {
  [&]<int... F>(std::integer_sequence<int, F...>) {
    const auto one = [&]<int Law>(std::integral_constant<int, Law>) {
      if constexpr (allowed<std::tuple_element_t<S, decltype(strengths)>, std::tuple_element_t<Law, decltype(laws)>>) combine<S, Law, (S + Law) % solids>();
    };
    (one(std::integral_constant<int, F>{}), ...);
  }(std::make_integer_sequence<int, std::tuple_size_v<decltype(laws)>>{});
}

TEST(Pairwise, NoStrength) { with_every_law<0>(); }
TEST(Pairwise, Elastic) { with_every_law<1>(); }
TEST(Pairwise, PerfectlyPlastic) { with_every_law<2>(); }
TEST(Pairwise, LinearHardening) { with_every_law<3>(); }
TEST(Pairwise, JohnsonCook) { with_every_law<4>(); }
TEST(Pairwise, SteinbergGuinan) { with_every_law<5>(); }

TEST(Pairwise, TheTwoThatTheTableLeavesOutAndTheGas) {
  combine<2, 6, 2>(); // damage has four strengths only, so that the table misses a model for each of its two laws
  combine<4, 7, 3>();
  combine<0, 0, gas>();
}

TEST(Pairwise, WithoutTheWrapperAndInSinglePrecision) {
  const material m{with_temperature<true>(std::get<0>(models)), std::get<5>(strengths), std::get<7>(laws)};
  auto sim = small_impact<method<shape::linear, transfer::flip, scheme::usf, float>>(m);
  sim.run(0.2 * us);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-4);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-4);
  int some = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      ASSERT_TRUE(std::isfinite(s.columns.template get<field::energy>()[i]));
      some += s.columns.template get<field::lost_capacity>()[i] == 1;
    }
  });
  EXPECT_GT(some, 20);
}

TEST(Pairwise, NoPairIsLeftOut) {
  for (auto* pairs : {&strength_law, &strength_model, &law_model}) pairs->clear();
  yielded = failed = softened = damaged = 0;
  with_every_law<0>(); // all again: under ctest each test is a process of its own
  with_every_law<1>();
  with_every_law<2>();
  with_every_law<3>();
  with_every_law<4>();
  with_every_law<5>();
  combine<2, 6, 2>();
  combine<4, 7, 3>();
  int strength_law_pairs = 0;
  [&]<int... S>(std::integer_sequence<int, S...>) {
    const auto count = [&]<int I, int... F>(std::integral_constant<int, I>, std::integer_sequence<int, F...>) {
      strength_law_pairs += (allowed<std::tuple_element_t<I, decltype(strengths)>, std::tuple_element_t<F, decltype(laws)>> + ... + 0);
    };
    (count(std::integral_constant<int, S>{}, std::make_integer_sequence<int, 8>{}), ...);
  }(std::make_integer_sequence<int, 6>{});
  EXPECT_EQ(strength_law_pairs, 44);
  EXPECT_EQ(strength_law.size(), static_cast<std::size_t>(strength_law_pairs));
  EXPECT_EQ(strength_model.size(), 6u * solids);
  EXPECT_EQ(law_model.size(), 8u * solids);
  std::printf("[ figures  ] particles of all runs: %d have yielded, %d failed, %d softened, %d are damaged\n", yielded, failed, softened, damaged);
  EXPECT_GT(yielded, 1000);
  EXPECT_GT(failed, 1000);
  EXPECT_GT(softened, 300);
  EXPECT_GT(damaged, 300);
}

} // namespace
} // namespace bolide
