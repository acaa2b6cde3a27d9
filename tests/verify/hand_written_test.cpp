// SPDX-License-Identifier: MIT
// The hand-written kernel of the benchmarks (tests/benchmark/hand_written.hpp) takes the same step as the composed solver of the same policies: what
// a policy costs could not be told from a kernel that computed something else. Every column of every particle, the ledger and the step that
// is asked for next, to round-off.
//
// Three runs of a block in r-z that is strained at 1e6 /s and yields: on its lattice; with its points shifted at random, so that tiles are partly
// filled, in oblique flight at 3 km/s, so that particles change cells and blocks all the time; and sheared at 3e6 /s, so that blocks spread and are
// made anew. Differences are maxima over the particles, over the largest value of the column (in positions over a cell). They come from sums in
// another order and from inverses that are shared; particles that cross the faces of cells amplify them.
#include "benchmark/block_scene.hpp"
#include "benchmark/hand_written.hpp"
#include "verify/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace bolide {
namespace {

struct comparison {
  std::map<std::string, double> difference; // over the scale of the column
  std::map<std::string, double> ledger, reference;
  double wanted_step, composed_step, plastic_strain, displacement; // s, s, largest, cells
};

template <class Composed> comparison compare(const scenes::block<2>& scene, Composed& composed, hand_written::rz& by_hand, int steps) {
  comparison r{};
  const double start = by_hand.of[hand_written::rz::z][0];
  for (int i = 0; i < steps; ++i) {
    composed.step(scene.dt());
    by_hand.step(composed.dt()); // what it took: no more than it allows itself
  }
  composed.for_each_body([&](const auto& set) {
    const auto& p = set.columns;
    EXPECT_EQ(p.size(), by_hand.size());
    std::vector<std::size_t> at(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) at[p.id()[i]] = i;
    const auto measure = [&](const char* name, const double* column, hand_written::rz::quantity k, double scale = 0) {
      double most = 0, largest = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = column[at[by_hand.id[i]]];
        most = std::max(most, std::abs(by_hand.of[k][i] - x));
        largest = std::max(largest, std::abs(x));
      }
      r.difference[name] = most / (scale > 0 ? scale : largest);
    };
    using h = hand_written::rz;
    measure("r", p.template get<field::position>(0), h::r, scene.h);
    measure("z", p.template get<field::position>(1), h::z, scene.h);
    measure("v_r", p.template get<field::velocity>(0), h::vr);
    measure("v_z", p.template get<field::velocity>(1), h::vz);
    measure("volume", p.template get<field::volume>(), h::volume);
    measure("s_rr", p.template get<field::deviator>(0), h::srr);
    measure("s_zz", p.template get<field::deviator>(1), h::szz);
    measure("s_rz", p.template get<field::deviator>(2), h::srz);
    measure("plastic strain", p.template get<field::plastic_strain>(), h::strain);
    measure("energy", p.template get<field::energy>(), h::e);
    measure("pressure", p.template get<field::pressure>(), h::p);
    measure("viscous pressure", p.template get<field::viscous_pressure>(), h::q);
    measure("sound speed", p.template get<field::sound_speed>(), h::c);
    r.plastic_strain = *std::max_element(p.template get<field::plastic_strain>(), p.template get<field::plastic_strain>() + p.size());
    r.displacement = (p.template get<field::position>(1)[at[0]] - start) / scene.h;
  });
  const ledger& l = composed.energies();
  r.reference = {{"kinetic", l.now.kinetic},
                 {"work_mismatch", l.work_mismatch},
                 {"transfer", l.transfer},
                 {"plastic_work", l.plastic_work},
                 {"viscous_heating", l.viscous_heating}};
  r.ledger = {{"work_mismatch", by_hand.energy.work_mismatch}, {"transfer", by_hand.energy.transfer}, {"plastic_work", by_hand.energy.plastic_work},
              {"viscous_heating", by_hand.energy.viscous_heating}};
  r.wanted_step = 1 / by_hand.rate;
  composed.step();
  r.composed_step = composed.dt();
  return r;
}
void expect_equal(const comparison& r, const std::string& run, double bound) {
  double worst = 0;
  for (const auto& [name, difference] : r.difference) {
    EXPECT_LT(difference, bound) << run << ": " << name;
    worst = std::max(worst, difference);
  }
  for (const auto& [name, value] : r.ledger) EXPECT_NEAR(value, r.reference.at(name), bound * r.reference.at("kinetic")) << run << ": " << name;
  EXPECT_GT(r.ledger.at("plastic_work"), 1e-3 * r.reference.at("kinetic"));
  EXPECT_GT(r.ledger.at("viscous_heating"), 1e-6 * r.reference.at("kinetic"));
  EXPECT_NEAR(r.wanted_step / r.composed_step, 1, bound);
  char motion[80];
  std::snprintf(motion, sizeof motion, "plastic strain up to %.2f, displacement of the first particle %.1f cells", r.plastic_strain, r.displacement);
  verify::record({.section = "smooth", .problem = "hand-written kernel of the benchmarks, " + run, .composition = "r-z linear, FLIP, USF, double",
                  .measure = "against the composed solver, worst column, largest", .value = worst, .bound = bound, .note = motion});
}

scenes::block<2> strained_block() {
  scenes::block<2> scene{40};
  scene.strain_rate = 1e6;
  return scene;
}

TEST(HandWritten, TakesTheStepOfTheComposedSolverOnALattice) {
  const auto scene = strained_block();
  auto composed = scenes::composed<double, shape::linear>(scene);
  const auto by_hand = hand_written::by_hand(scene);
  expect_equal(compare(scene, composed, *by_hand, 60), "lattice", 1e-10);
}

/// Runs both solvers from the block with every particle changed by f(x, v).
template <class F> comparison compare_changed(const scenes::block<2>& scene, int margin, int steps, const F& f) {
  auto composed = scenes::composed<double, shape::linear>(scene);
  auto first = f, second = f;
  composed.initialise([&](auto& point) { first(point.position, point.velocity); });
  const auto by_hand = hand_written::by_hand(scene, margin, second);
  return compare(scene, composed, *by_hand, steps);
}

TEST(HandWritten, TakesTheStepOfTheComposedSolverInDisorderAndFlight) {
  const auto scene = strained_block();
  const auto disturb = [random = std::mt19937_64(1), &scene](vec<double, 2>& x, vec<double, 2>& v) mutable {
    std::uniform_real_distribution<double> shift(-0.25, 0.25);
    for (int d = 0; d < 2; ++d) x[d] += shift(random) * scene.h;
    v += vec<double, 2>(-1000, 3000);
  };
  expect_equal(compare_changed(scene, 16, 100, disturb), "disorder and flight", 1e-10);
}

TEST(HandWritten, TakesTheStepOfTheComposedSolverInLargeShear) {
  auto scene = strained_block();
  scene.cells = 24;
  const double centre = scene.corner() + scene.edge() / 2;
  const auto shear = [centre](vec<double, 2>& x, vec<double, 2>& v) { v[1] += 3e6 * (x[0] - centre); };
  expect_equal(compare_changed(scene, 24, 100, shear), "shear", 1e-10);
}

} // namespace
} // namespace bolide
