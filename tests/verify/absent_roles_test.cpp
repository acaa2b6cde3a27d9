// SPDX-License-Identifier: MIT
// optimise: -O2
// Roles that a composition does not have cost no instruction. The constitutive update of a stiffened gas in r-z, composed as
//   material{eos::stiffened_gas, strength::none, failure::none, viscosity::none}
// against a loop written by hand for just this physics (V, p*, floors, the bound on the step), both counted instruction by instruction. Strength, failure and
// viscosity are then added one by one: what they cost must be seen by the same count.
//
// The loops differ by some 17 instructions per register of particles: the constants of the material are made anew for every chunk of 64 (half of it), pointers to
// columns are read again after every store, masks of the floors are counted. None but one belongs to an absent role: p + q, which the compiler may not leave out for
// q = 0 (-0 + 0 is +0).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3") // as programs of the library are built, whatever the flags of the tests
#endif
#include "verify/count_instructions.hpp"
#include "verify/table.hpp"

#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/material/material.hpp"
#include "bolide/particles/columns.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/strength/elastic.hpp"
#include "bolide/strength/none.hpp"
#include "bolide/viscosity/none.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace bolide {
namespace {
using V = native_pack<double>;
constexpr int chunks = 4;
constexpr std::size_t particles = chunks * chunk_size;
const eos::stiffened_gas_parameters water{.gamma = 4.4, .p_inf = 6e8, .rho0 = 1000};

/// The same value, of which the compiler knows nothing: neither loop may be specialised for the numbers of this test.
template <class X> X unknown(X x) {
  asm volatile("" : "+m"(x));
  return x;
}

/// A velocity gradient that compresses and turns, the same for all particles but for a little.
struct gradients {
  alignas(64) double l[space::axisymmetric::gradient_size][chunk_size];
  gradients() {
    for (int c = 0; c < space::axisymmetric::gradient_size; ++c)
      for (int k = 0; k < chunk_size; ++k) l[c][k] = -1e4 * (1 + 0.1 * c) * (1 + 0.01 * k);
  }
};
/// A step whose bound no particle passes: the rare branches of the update are not taken.
step_context<double> step_without_limit() { return {unknown(1e-9), unknown(1e-4), unknown(0.4), unknown(1e12), unknown(true)}; }

template <class Columns> void fill(Columns& p) {
  for (std::size_t i = 0; i < particles; ++i) {
    p.append(static_cast<std::uint32_t>(i));
    p.template get<field::mass>()[i] = 1e-6 * (1 + 1e-4 * static_cast<double>(i));
    p.template get<field::velocity>(0)[i] = 10;
    p.template get<field::velocity>(1)[i] = 20;
  }
}

// ---- composed ---------------------------------------------------------------------------------------------------------------------------
template <class Material> struct composed {
  using columns = particles::columns<double, space::axisymmetric, field_union_t<fields<field::mass, field::position, field::velocity>, typename Material::particle_fields>>;
  Material material;
  columns p;
  gradients g;
  update_report report;

  explicit composed(const Material& m) : material(m) {
    fill(p);
    material.initialise(p, 0, particles, water.rho0, 100);
  }
  void update() {
    const auto step = step_without_limit();
    for (std::size_t begin = 0; begin < particles; begin += chunk_size) material.template update<space::axisymmetric>(p, begin, unknown(chunk_size), g.l, step, report);
  }
};
template <class Strength, class Failure, class Viscosity> composed<material<eos::stiffened_gas, Strength, Failure, Viscosity>> made_of(Strength s, Failure f, Viscosity v) {
  return composed<material<eos::stiffened_gas, Strength, Failure, Viscosity>>(material{eos::stiffened_gas{water}, s, f, v});
}

// ---- by hand ----------------------------------------------------------------------------------------------------------------------------
struct by_hand {
  std::vector<double> mass, vr, vz, volume, energy, pressure;
  gradients g;
  eos::stiffened_gas_parameters gas{unknown(water.gamma), unknown(water.p_inf), unknown(water.rho0)};
  double c2_floor, greatest;
  double rate = 0;
  long floors = 0, faster = 0;

  template <class Columns> explicit by_hand(const Columns& p) : c2_floor(0.05 * 0.05 * water.gamma * water.p_inf / water.rho0), greatest(1e6 / water.rho0) {
    const auto copy = [](const double* from) { return std::vector<double>(from, from + particles); };
    mass = copy(p.template get<field::mass>()), vr = copy(p.template get<field::velocity>(0)), vz = copy(p.template get<field::velocity>(1));
    volume = copy(p.template get<field::volume>()), energy = copy(p.template get<field::energy>()), pressure = copy(p.template get<field::pressure>());
  }
  __attribute__((noinline)) void take_the_fastest(std::size_t, const V& strain, const V& c2, const V& v2, double reach) {
    const V wanted = max(strain, (sqrt(c2) + sqrt(v2)) / V(reach));
    for (int i = 0; i < lane_width<V>; ++i) rate = std::max(rate, lane(wanted, i));
    ++faster;
  }
  __attribute__((noinline)) void chunk(std::size_t begin, int n, const double (*l)[chunk_size], const step_context<double>& step) {
    const eos::stiffened_gas_parameters q = gas;
    const V dt(step.dt), one(1.0), zero(0.0), floor(c2_floor);
    const double reach = step.courant * step.cell;
    const double per_density = 1 / q.rho0, most = greatest;
    for (int k = 0; k < n; k += lane_width<V>) {
      const std::size_t at = begin + static_cast<std::size_t>(k);
      const V rr = load<V>(l[0] + k), rz = load<V>(l[1] + k), zr = load<V>(l[2] + k), zz = load<V>(l[3] + k), tt = load<V>(l[4] + k);
      const auto active = first_lanes<V>(n - k);
      const V m = load<V>(&mass[at]), e = load<V>(&energy[at]), p_old = load<V>(&pressure[at]);
      const V divergence = rr + zz + tt;
      V v = load<V>(&volume[at]) * (one / (((one - dt * rr) * (one - dt * zz) - dt * dt * rz * zr) * (one - dt * tt)));
      const V largest = m * most;
      if (any(v > largest && active)) ++floors, v = min(v, largest);
      const V rho = m / v;
      const V predicted = e - 0.5 * dt * p_old * divergence * (one / rho);
      const V p = (q.gamma - 1) * rho * predicted + q.gamma * q.p_inf * (rho * per_density - one);
      const V c2_found = q.gamma * (p + V(q.p_inf)) / rho;
      if (any(!(c2_found >= floor) && active)) ++floors;
      if (any(p < V(-q.p_inf) && active)) ++floors; // outside of what the equation of state is valid for
      const V c2 = max(floor, c2_found);
      store_first(v, &volume[at], n - k);
      store_first(p, &pressure[at], n - k);
      const V strain = 4.0 * max(max(max(abs(rr), abs(zz)), abs(tt)), max(abs(rz), abs(zr)));
      const V v2 = square(load<V>(&vr[at])) + square(load<V>(&vz[at]));
      const double asked = std::max(rate, step.ignore_below), within = asked * reach; // the shortest step so far may have become shorter
      const V rest = V(within * within * (1 - 16 * std::numeric_limits<double>::epsilon())) - c2 - v2;
      if (any(!(rest >= zero && 4.0 * c2 * v2 <= rest * rest && strain <= V(asked)) && active)) take_the_fastest(begin, strain, c2, v2, reach);
    }
  }
  void update() {
    const auto step = step_without_limit();
    for (std::size_t begin = 0; begin < particles; begin += chunk_size) chunk(begin, unknown(chunk_size), g.l, step);
  }
};

template <class Work> double instructions_per_particle(Work work) {
  const long nothing = verify::instructions_of([] {}), all = verify::instructions_of([&] { work.update(); });
  return all < 0 || nothing < 0 ? -1 : static_cast<double>(all - nothing) / particles;
}

TEST(AbsentRoles, CostNoInstruction) {
#if defined(__clang__) || defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the bounds are those of g++ without sanitizers (clang 14 at -O2: 1.36 times the instructions of its loop by hand)";
#endif
  auto fluid = made_of(strength::none{}, failure::none{}, viscosity::none{});
  by_hand hand(fluid.p);
  const double composed_count = instructions_per_particle(fluid), hand_count = instructions_per_particle(hand);
  if (composed_count < 0) GTEST_SKIP() << "this machine does not let a process step its child";
  const double strong = instructions_per_particle(made_of(strength::elastic{1e9}, failure::none{}, viscosity::none{})),
               failing = instructions_per_particle(made_of(strength::none{}, failure::tension{1e8}, viscosity::none{})),
               viscous = instructions_per_particle(made_of(strength::none{}, failure::none{}, viscosity::bulk{}));
  const auto record = [](const char* what, double value, double bound) {
    verify::record({.section = "cost", .problem = "Roles that are absent", .composition = "r-z, stiffened gas, update of the material", .measure = what, .value = value, .bound = bound});
  };
  record("instructions, composed over by hand", composed_count / hand_count, 1.2);
  record("instructions per particle, composed", composed_count, verify::none);
  record("with elastic strength, over without", strong / composed_count, verify::none);
  record("with a tension limit, over without", failing / composed_count, verify::none);
  record("with bulk viscosity, over without", viscous / composed_count, verify::none);
  EXPECT_LE(composed_count / hand_count, 1.2) << "less than the cheapest of the roles costs, which is a quarter";
  EXPECT_GT(strong, 1.3 * composed_count) << "a role that is there costs, and the count sees it";
  EXPECT_GT(failing, 1.2 * composed_count);
  EXPECT_GT(viscous, 1.2 * composed_count);

  // the same physics
  fluid.update();
  hand.update();
  EXPECT_EQ(hand.floors, 0);
  EXPECT_EQ(hand.faster, 0);
  for (const auto n : fluid.report.floors.count) EXPECT_EQ(n, 0u);
  for (std::size_t i = 0; i < particles; ++i) {
    ASSERT_NEAR(fluid.p.get<field::volume>()[i], hand.volume[i], 1e-15 * hand.volume[i]);
    ASSERT_NEAR(fluid.p.get<field::pressure>()[i], hand.pressure[i], 1e-12 * water.p_inf);
  }
}

} // namespace
} // namespace bolide
