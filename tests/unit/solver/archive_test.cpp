// SPDX-License-Identifier: MIT
// What the solver lists of its state is all there is: a fresh solver that is given the list of step k goes on to the same bits, for
// every k of a run: right after a sort and between two, with sleeping blocks and while material leaves.
#include "bolide/contact/frictional.hpp"
#include "bolide/grid/uniform.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/space/plane_strain.hpp"
#include "unit/solver/memory_archive.hpp"
#include "unit/solver/scenes.hpp"

#include <set>

namespace bolide {
namespace {
using namespace test;

template <class Method> auto scene(int threads = 1) {
  controls<typename Method::scalar> c;
  c.threads = threads;
  c.first_step = 1;
  auto sim = small_impact<Method>(aluminium(), {}, c);
  leaving_box<2> b;
  b.low << -2 * mm, -2 * mm;
  b.high << 2 * mm, 1 * mm;
  sim.add(b);
  return sim;
}

/// The list without what is measured by the clock, the energies that are only looked at, and the fingerprints (equal by construction).
entries comparable(entries e) {
  for (const char* name : {"solver_seconds", "phases/ledger/kinetic", "phases/ledger/internal", "phases/ledger/momentum_now"}) e.erase(name);
  return e;
}
std::string difference(const entries& a, const entries& b) {
  std::string names;
  if (a.size() != b.size()) names += "another number of entries;";
  for (const auto& [name, bytes] : a)
    if (!b.count(name) || b.at(name) != bytes) names += name + "; ";
  return names;
}
template <class X> X entry(const entries& e, const std::string& name) {
  X x;
  EXPECT_EQ(e.at(name).size(), sizeof x);
  std::memcpy(&x, e.at(name).data(), sizeof x);
  return x;
}

template <class X> std::size_t entry_size(const entries& e, const std::string& name) { return e.at(name).size() / sizeof(X); }

template <class Method> class Archive : public testing::Test {};
using methods = testing::Types<linear_flip_usf, linear_flip_musl, bspline_flip_usf, bspline_flip_musl, bspline_apic_usf, bspline_apic_musl,
                               method<shape::quadratic_bspline, transfer::apic, scheme::usf, float>>;
TYPED_TEST_SUITE(Archive, methods, method_names);

TYPED_TEST(Archive, ARunGoesOnToTheSameBitsFromEveryStep) {
  constexpr int steps = 300;
  auto sim = scene<TypeParam>();
  std::vector<entries> at;
  std::size_t slept = 0, left = 0;
  for (int k = 0; k <= steps; ++k) {
    at.push_back(listed(sim));
    slept += sim.sleeping_particles() > 0;
    left += entry<std::uint64_t>(at.back(), "phases/ledger/particles_left") > 0;
    if (k < steps) sim.step();
  }
  int sorts = 0, unsorted = 0, sorted = 0; // what the run went through
  std::set<int> from;
  for (int k = 1; k <= steps; ++k) {
    const auto ids = [&](int i) { return at[static_cast<std::size_t>(i)].at("phases/body_0/columns/id"); };
    sorts += ids(k) != ids(k - 1);
    const bool is_sorted = entry<bool>(at[static_cast<std::size_t>(k)], "phases/sorted");
    (is_sorted ? sorted : unsorted) += 1;
    if (k <= 4 || k % 97 == 0 || !is_sorted || ids(k) != ids(k - 1)) from.insert(k - 1), from.insert(k);
  }
  EXPECT_GT(sorts, 3);
  EXPECT_GE(unsorted, 1);
  EXPECT_GT(sorted, 30);
  EXPECT_GE(slept, 3u);
  EXPECT_GT(left, 3u);
  for (const int k : from) {
    auto again = scene<TypeParam>();
    put_back(again, at[static_cast<std::size_t>(k)]);
    EXPECT_EQ(difference(at[static_cast<std::size_t>(k)], listed(again)), "") << "what was put back, step " << k;
    for (int i = k; i < steps; ++i) again.step();
    EXPECT_EQ(difference(comparable(at.back()), comparable(listed(again))), "") << "from step " << k;
    again.for_each_body([&](const auto& a) {
      EXPECT_EQ(a.columns.size(), entry_size<std::uint32_t>(at.back(), "phases/body_" + std::to_string(a.first_id > 0) + "/columns/id"));
    });
    EXPECT_EQ(again.time(), sim.time());
  }
}

TEST(Archive, ASolverInTheMiddleOfAnotherRunIsOverwritten) {
  auto sim = scene<bspline_apic_usf>(), other = scene<bspline_apic_usf>();
  for (int i = 0; i < 60; ++i) sim.step();
  for (int i = 0; i < 175; ++i) other.step();
  put_back(other, listed(sim));
  for (int i = 0; i < 100; ++i) sim.step(), other.step();
  EXPECT_EQ(difference(comparable(listed(sim)), comparable(listed(other))), "");
}

/// What the other compositions leave out: a dense grid, GIMP, contact with friction, a period, a moving wall, a body force.
auto other_models() {
  using point = vec<double, 2>;
  controls<double> c;
  c.first_step = 1;
  const initial_state at{2785, 0};
  const body upper{"upper", box{point{0, 0}, point{0.8 * mm, 0.4 * mm}}, aluminium(), 0.05 * mm, at, point{300., -500.}};
  const body lower{"lower", box{point{0, -0.4 * mm}, point{0.8 * mm, 0}}, aluminium(), 0.05 * mm, at, point{0, 500.}};
  solver sim{space::plane_strain{}, grid::uniform{0.1 * mm}, shape::gimp{}, transfer::flip{}, scheme::usf{}, contact::frictional{0.3}, c, upper,
             lower};
  sim.add(grid::periodic{0, 0.0, 0.8 * mm});
  sim.add(grid::moving_wall{.axis = 1, .position = -0.6 * mm, .velocity = 400, .material_above = true});
  sim.add(body_force{[](const point& x, double t) { return point{1e9 * std::sin(1e4 * x[1] + 1e7 * t), 0}; }});
  return sim;
}
TEST(Archive, OtherModelsGoOnToTheSameBits) {
  constexpr int steps = 200;
  auto sim = other_models();
  std::vector<entries> at;
  for (int k = 0; k <= steps; ++k) {
    at.push_back(listed(sim));
    if (k < steps) sim.step();
  }
  for (int k = 0; k < steps; k += 13) {
    auto again = other_models();
    put_back(again, at[static_cast<std::size_t>(k)]);
    for (int i = k; i < steps; ++i) again.step();
    EXPECT_EQ(difference(comparable(at.back()), comparable(listed(again))), "") << "from step " << k;
  }
  EXPECT_NE(sim.energies().contact, 0);
  EXPECT_NE(sim.energies().boundary_work, 0);
  EXPECT_NE(sim.energies().body_work, 0);
}

TEST(Archive, ListingTheStateChangesNothing) {
  auto sim = scene<bspline_flip_usf>(), watched = scene<bspline_flip_usf>();
  for (int i = 0; i < 80; ++i) sim.step(), watched.step(), listed(watched);
  EXPECT_EQ(difference(comparable(listed(sim)), comparable(listed(watched))), "");
}

} // namespace
} // namespace bolide
