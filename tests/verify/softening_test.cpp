// SPDX-License-Identifier: MIT
// How much does a break hang on the time step? A bar of 4 mm, free at both ends, starts with the velocity 200 m/s sin(pi x/L): it is stretched
// most in the middle, breaks there, and the velocity of its end tells how it broke. Each law runs at four Courant numbers, each halved three
// times; what is compared is the mean change of that velocity per halving over 1.2 us.
//
// Without failure the change is that of the scheme alone. With failure in one step the step decides which of the evenly stretched points goes
// first, and the change does not fall with the step. A point that softens goes on bearing tension while its neighbours are asked.
// What is left with softening is no error of the scheme either: an evenly stretched bar breaks in several places, and which ones
// remains sensitive.
#include "bolide/failure/softening.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

#include "unit/solver/scenes.hpp"
#include "verify/table.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bolide::verify {
namespace {
using namespace test;

constexpr double length = 4 * mm, until = 1.2 * us;
constexpr std::size_t samples = 600;

/// Velocity of an end of the bar at even times, m/s.
template <class Law> std::vector<double> pull_apart(const Law& law, double courant) {
  using point = vec<double, 1>;
  const material al{eos::mie_grueneisen{{.constant_gamma = true}}, strength::elastic_perfectly_plastic{27.6e9, 0.3e9}, law};
  const body bar{"bar", box{point{-length / 2}, point{length / 2}}, al, 0.02 * mm, initial_state{2785, 0}};
  auto c = one_thread<double>();
  c.courant = courant;
  solver sim{space::planar_1d{}, grid::sparse{0.04 * mm}, shape::quadratic_bspline{}, transfer::flip{}, scheme::usf{}, c, bar};
  sim.initialise([](auto& p) { p.velocity[0] = 200 * std::sin(std::numbers::pi * p.position[0] / length); });
  std::vector<double> end;
  double before = 0, time_before = 0;
  while (end.size() < samples) {
    sim.step();
    double v = 0;
    sim.for_each_body([&](const auto& s) {
      const auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i)
        if (p.id()[i] == p.size() - 1) v = p.template get<field::velocity>()[i];
    });
    for (double next; end.size() < samples && (next = until * static_cast<double>(end.size() + 1) / samples) <= sim.time();)
      end.push_back(before + (v - before) * (next - time_before) / (sim.time() - time_before));
    before = v;
    time_before = sim.time();
  }
  const auto& l = sim.energies();
  EXPECT_LT(std::abs(l.residual()), 1e-12);
  EXPECT_LT(std::abs(l.drift()), 1e-12);
  if constexpr (Law::may_fail) {
    EXPECT_GT(l.failure_release, 0) << "it must break";
    EXPECT_LT(l.failure_release, l.now.internal);
  }
  return end;
}

/// Mean over the Courant numbers and their halvings of the mean change of the end's velocity, m/s.
template <class Law> double change_per_halving(const Law& law) {
  double sum = 0;
  int n = 0;
  for (const double courant : {0.8, 0.7, 0.6, 0.5}) {
    auto before = pull_apart(law, courant);
    for (int halving = 1; halving <= 3; ++halving) {
      const auto now = pull_apart(law, courant / (1 << halving));
      for (std::size_t i = 0; i < samples; ++i, ++n) sum += std::abs(now[i] - before[i]);
      before = now;
    }
  }
  return sum / n;
}

void report(const std::string& law, double change, double bound) {
  record({.section = "solids", .problem = "bar pulled apart at 200 m/s, " + law, .composition = "1-D, quadratic B-spline, FLIP, USF, double",
          .measure = "change of the end's velocity per halving of the step", .value = change, .bound = bound, .unit = "m/s",
          .note = "mean over 12 halvings; bound: a part of the failure in one step"});
}

TEST(PulledApartBar, WithSofteningHangsLessOnTheStep) {
  const double whole = change_per_halving(failure::none{}), one_step = change_per_halving(failure::tension{1.5e9});
  const double over_time = change_per_halving(failure::softening{failure::tension{1.5e9}, 20e-9}), by_energy = change_per_halving(failure::cohesive{failure::tension{1.5e9}, 300});
  report("no failure", whole, none);
  report("failure in one step", one_step, none);
  report("softening over 20 ns (three cells' passage)", over_time, 0.5 * one_step);
  report("fracture energy 300 J/m2", by_energy, 0.7 * one_step);
  EXPECT_GT(one_step, 5 * whole) << "it is the failure that hangs on the step";
  EXPECT_LT(over_time, 0.5 * one_step);
  EXPECT_LT(by_energy, 0.7 * one_step);
}

} // namespace
} // namespace bolide::verify
