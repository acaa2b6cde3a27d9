// SPDX-License-Identifier: MIT
// The axis of r-z: a uniform state must feel no radial force, a converging flow must gain no error that grows towards r = 0.
#include "verify/ideal_gas.hpp"

#include "bolide/viscosity/none.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace bolide {
namespace {
using namespace test;

/// Largest |radial acceleration| over p/(rho h) within three cells of the axis and further out, after one step of a uniform pressure patch that
/// is held by walls on all sides.
struct patch_error {
  double near_axis = 0, beyond = 0;
};
template <class Shape> patch_error uniform_patch(double per_cell, double jittered) {
  using point = vec<double, 2>;
  const double h = 1e-3, radius = 12 * h, height = 12 * h, e = 2.5e5;
  const material gas{verify::ideal_gas{1.4, 1000}, strength::none{}, failure::none{}, viscosity::none{}};
  const body b{"gas", box{point{0, 0}, point{radius, height}}, gas, h / per_cell, initial_state{1000, e}, point{0, 0}, jitter{jittered, 3}};
  solver sim{space::axisymmetric{}, grid::sparse{h}, Shape{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), b};
  sim.add(grid::mirror{0, radius, false}).add(grid::mirror{1, 0, true}).add(grid::mirror{1, height, false});
  sim.step();
  patch_error worst;
  const double scale = 0.4 * e / h; // p/(rho h)
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double a = std::abs(p.template get<field::velocity>(0)[i]) / sim.dt() / scale;
      double& to = p.template get<field::position>(0)[i] < 3 * h ? worst.near_axis : worst.beyond;
      to = std::max(to, a);
    }
  });
  return worst;
}

template <class Shape> class AxisPatch : public testing::Test {};
using shapes = testing::Types<shape::linear, shape::quadratic_bspline>;
TYPED_TEST_SUITE(AxisPatch, shapes);

/// Linear shapes by the lattice alone; B-splines by the mended quadrature of the hoop terms (solver/stencil.hpp).
TYPED_TEST(AxisPatch, AUniformStateOnTheLatticeFeelsNoForce) {
  for (const double per_cell : {2.0, 4.0}) {
    const auto f = uniform_patch<TypeParam>(per_cell, 0);
    std::printf("[ figures  ] %-8s %g per cell: |a| rho h/p near the axis %.1e, beyond %.1e\n", TypeParam::name, per_cell, f.near_axis, f.beyond);
    EXPECT_LT(f.near_axis, 1e-11);
    EXPECT_LT(f.beyond, 1e-11);
  }
}
/// Recorded: what a jittered lattice does, near the axis and away from it.
TYPED_TEST(AxisPatch, JitteredPointsAreReported) {
  const auto f = uniform_patch<TypeParam>(2, 0.1);
  std::printf("[ figures  ] %-8s 10 %% jitter: |a| rho h/p near the axis %.3f, beyond %.3f\n", TypeParam::name, f.near_axis, f.beyond);
  EXPECT_LT(f.beyond, 0.5);
  EXPECT_LT(f.near_axis, 5 * f.beyond) << "the axis must not be much worse than the rest";
}

/// A particle exactly at, and next to, r = 0: finite, and it stays.
TEST(AxisParticle, AtTinyRadiusIsHarmless) {
  for (const double r : {1e-300, 1e-30, 1e-18, 1e-12, 1e-7}) {
    using point = vec<double, 2>;
    const body b{"slab", box{point{0, 0}, point{0.4 * mm, 0.4 * mm}}, aluminium(), 0.05 * mm, initial_state{2785, 1e5}};
    solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, one_thread<double>(), b};
    sim.for_each_body([&](auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i)
        if (s.columns.id()[i] == 3) s.columns.template get<field::position>(0)[i] = r;
    });
    for (int i = 0; i < 50; ++i) sim.step();
    sim.for_each_body([&](const auto& s) {
      for (std::size_t i = 0; i < s.columns.size(); ++i) {
        EXPECT_GE(s.columns.template get<field::position>(0)[i], 0);
        EXPECT_LT(std::abs(s.columns.template get<field::velocity>(0)[i]), 500) << "r = " << r << ", particle " << s.columns.id()[i];
      }
    });
    EXPECT_LT(std::abs(sim.energies().drift()), 1e-10);
  }
}

/// Homologous compression of a gas, v = -x/tau in `axes` directions (2: cylinder in r, between walls in z; 3: sphere): density is uniform,
/// rho = rho0/(1 - t/tau)^axes with a pressure too small to matter. Errors in bins of r.
template <class Method> std::vector<double> homologous(int axes, double until_fraction, double& exact_ratio) {
  using point = vec<double, 2>;
  const double h = 1e-3, radius = 20 * h, tau = 1e-3;
  const material dust{verify::ideal_gas{5.0 / 3, 1000, 1.0}, strength::none{}, failure::none{}, viscosity::none{}}; // c = 1 m/s against 20 m/s
  controls<double> c = one_thread<double>();
  c.energy_bound = 10;
  const auto run = [&](const auto& b, bool walls) {
    solver sim{space::axisymmetric{}, grid::sparse{h}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c, b};
    if (walls) sim.add(grid::mirror{1, 0, true}).add(grid::mirror{1, 6 * h, false});
    else sim.add(grid::mirror{1, 0, true});
    sim.for_each_body([&](auto& s) {
      auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i)
        for (int d = 0; d < (walls ? 1 : 2); ++d) {
          p.template get<field::velocity>(d)[i] = -p.template get<field::position>(d)[i] / tau;
          if constexpr (Method::transfer_type::affine) p.template get<field::affine_velocity>(d * 2 + d)[i] = -1 / tau;
        }
    });
    sim.run(until_fraction * tau);
    const double shrink = 1 - until_fraction;
    exact_ratio = std::pow(shrink, -axes);
    std::vector<double> sum(5, 0), n(5, 0);
    sim.for_each_body([&](const auto& s) {
      const auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = p.template get<field::position>(0)[i], z = walls ? 0 : p.template get<field::position>(1)[i];
        const double r = std::hypot(x, z) / (radius * shrink);
        if (r > 0.8) continue; // the free surface is not the question here
        // bins of the cylindrical radius: it is the axis that is looked at
        const auto bin = std::min<std::size_t>(4, static_cast<std::size_t>(x / (radius * shrink) * 6));
        const double rho = p.template get<field::mass>()[i] / p.template get<field::volume>()[i];
        sum[bin] += rho / (1000 * exact_ratio) - 1, n[bin] += 1;
      }
    });
    for (std::size_t k = 0; k < 5; ++k) sum[k] /= n[k];
    return sum;
  };
  if (axes == 2) return run(body{"cylinder", box{point{0, 0}, point{radius, 6 * h}}, dust, h / 2, initial_state{1000, 1e-3}}, true);
  return run(body{"sphere", sphere{point{0, 0}, radius}, dust, h / 2, initial_state{1000, 1e-3}}, false);
}

template <class Method> class Converging : public testing::Test {};
TYPED_TEST_SUITE(Converging, every_method, method_names);

TYPED_TEST(Converging, CompressionShowsNoErrorThatGrowsTowardsTheAxis) {
  for (const int axes : {2, 3}) {
    double ratio = 0;
    const auto e = homologous<TypeParam>(axes, 0.4, ratio);
    std::printf("[ figures  ] %-17s %s, rho/rho0 %.3f: error of the density in five bins of r (%%)", TypeParam::name().c_str(), axes == 2 ? "cylinder" : "sphere  ", ratio);
    for (const double x : e) std::printf(" %+.3f", 100 * x);
    std::printf("\n");
    for (const double x : e) EXPECT_LT(std::abs(x), 0.02);
    EXPECT_LT(std::abs(e[0]), 0.005 + 2 * std::abs(e[2])) << "the innermost bin against the middle one";
  }
}

} // namespace
} // namespace bolide
