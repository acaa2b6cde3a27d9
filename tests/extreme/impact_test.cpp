// SPDX-License-Identifier: MIT
// optimise: -O1
// Extreme 10: the paper's impact (sphere of 9.5 mm on a plate of 2.2 mm) on cells of 0.4 mm at 0.5, 6.64, 20, 40 and 70 km/s, time scaled
// by 6640 m/s over the speed: it ends, the energy holds, and its r-z mirror image along z gives the mirrored answer.
#include "extreme/extreme.hpp"

#include "bolide/eos/tillotson.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

namespace bolide {
namespace {
using namespace extreme;
using point = vec<double, 2>;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;
template <class Method> class Impact : public testing::Test {};
using methods = testing::Types<linear_flip_usf, bspline_flip_musl, bspline_apic_musl, float_apic_musl>;
TYPED_TEST_SUITE(Impact, methods, method_names);

inline auto tillotson() { return material{eos::tillotson{}, strength::elastic_perfectly_plastic{27.6e9, 0.3e9}, failure::tension{1.5e9}}; }

/// `up` 1: the sphere flies to larger z; -1: the mirror image.
template <class Method, class Material> auto impact(const Material& al, double rho0, double speed, double up) {
  using T = typename Method::scalar;
  const double h = 0.4 * mm, dx = h / 2, radius = 4.75 * mm, t = 2.2 * mm;
  const initial_state at{rho0, 0};
  const double from = up > 0 ? 0 : -t;
  const body ball{"ball", sphere{point{0, -up * radius}, radius}, al, dx, at, point{0, up * speed}};
  const body plate{"plate", box{point{0, from}, point{20 * mm, from + t}}, al, dx, at};
  auto c = one_thread<T>();
  return make<Method, space::axisymmetric>(h, c, ball, plate);
}
struct outcome {
  double front, width, energy; // m, m (rms radius), relative change
};
template <class Solver> outcome measure(Solver& sim, double up) {
  outcome r{0, 0, sim.energies().drift()};
  double mass = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    const double m = value<field::mass>(s, i);
    r.front = std::max(r.front, up * value<field::position>(s, i, 1));
    if (s.name != "ball") return;
    mass += m;
    r.width += m * square(value<field::position>(s, i, 0));
  });
  r.width = std::sqrt(r.width / mass);
  return r;
}

TYPED_TEST(Impact, EndsAndKeepsItsBooks) {
  const auto run = [&](const char* name, const auto& al, double rho0) {
    for (const double v : {500., 6640., 20e3, 40e3, 70e3}) {
      auto sim = impact<TypeParam>(al, rho0, v, 1);
      const double until = 2 * us * 6640 / v;
      sim.run(until);
      is_sound(sim);
      const auto r = measure(sim, 1);
      verify::record({.section = "extremes",
                      .problem = std::string("the paper's impact, ") + name + ", cells of 0.4 mm, " + to_text(v / 1000) + " km/s",
                      .composition = composition<TypeParam, space::axisymmetric>(),
                      .measure = "total energy, change",
                      .value = r.energy,
                      .bound = 0.02,
                      .seconds = sim.solver_seconds(),
                      .note = std::to_string(sim.steps()) + " steps, front at " + to_text(r.front / (v * until)) + " V t, " + floors(sim)});
      EXPECT_LT(std::abs(r.energy), 0.02);
      EXPECT_GT(r.front / (v * until), 0.4);
    }
  };
  run("Mie-Grueneisen", aluminium(), 2785);
  run("Tillotson", tillotson(), 2700);
}

/// The mirror image of the scene gives the mirror image of the answer, but for the order of sums: the cloud is chaotic, so it is asked at
/// first contact.
TYPED_TEST(Impact, IsSymmetric) {
  using T = typename TypeParam::scalar;
  for (const double v : {500., 70e3}) {
    auto a = impact<TypeParam>(aluminium(), 2785, v, 1), b = impact<TypeParam>(aluminium(), 2785, v, -1);
    a.run(0.3 * us * 6640 / v);
    b.run(0.3 * us * 6640 / v);
    const auto x = measure(a, 1), y = measure(b, -1);
    const double worst = std::max(std::abs(x.front / y.front - 1), std::abs(x.width / y.width - 1)), bar = sizeof(T) == 8 ? 1e-6 : 1e-2;
    verify::record({.section = "extremes",
                    .problem = "the paper's impact and its mirror image, " + to_text(v / 1000) + " km/s",
                    .composition = composition<TypeParam, space::axisymmetric>(),
                    .measure = "front and width, largest difference",
                    .value = worst,
                    .bound = bar});
    EXPECT_LT(worst, bar);
  }
}

} // namespace
} // namespace bolide
