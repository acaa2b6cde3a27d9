// SPDX-License-Identifier: MIT
// The solver in plane strain and in three dimensions, initial fields and body forces. A slab of a 3-D scene between two mirrors that does
// not vary along z is the plane-strain scene.
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/plane_strain.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>
#include <vector>

namespace bolide {
namespace {
using namespace test;

/// A disc of 0.8 mm against a block at 1 km/s, in plane strain or three cells deep in 3-D.
template <class Method, class Space> auto disc_on_block() {
  constexpr int dim = Space::dim;
  using point = vec<double, dim>;
  const auto at = [](double x, double y, double z) {
    point p;
    const double all[] = {x, y, z};
    for (int d = 0; d < dim; ++d) p[d] = all[d];
    return p;
  };
  const double dx = 0.1 * mm;
  const initial_state start{2785, 0};
  // a "disc" as rows of a box keeps the lattice of both spaces the same
  const body disc{"disc", box{at(-0.3 * mm, -0.4 * mm, 0), at(0.3 * mm, 0, 0.6 * mm)}, aluminium(), dx, start, at(100, 1000, 0)};
  const body block{"block", box{at(-0.8 * mm, 0, 0), at(0.8 * mm, 0.4 * mm, 0.6 * mm)}, aluminium(), dx, start};
  solver sim{Space{}, grid::sparse{0.2 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, one_thread<double>(), disc, block};
  if constexpr (dim == 3) sim.add(grid::mirror{2, 0, true}).add(grid::mirror{2, 0.6 * mm, false});
  return sim;
}

template <class Method> class ThreeDimensions : public testing::Test {};
TYPED_TEST_SUITE(ThreeDimensions, testing::Types<linear_flip_usf>, method_names);

TYPED_TEST(ThreeDimensions, ASlabBetweenMirrorsIsPlaneStrain) {
  auto flat = disc_on_block<TypeParam, space::plane_strain>();
  auto deep = disc_on_block<TypeParam, space::cartesian_3d>();
  for (int i = 0; i < 60; ++i) {
    flat.step();
    deep.step();
    ASSERT_NEAR(flat.dt() / deep.dt(), 1, 1e-9);
  }
  EXPECT_EQ(deep.particle_count(), 6 * flat.particle_count());
  std::vector<double> of(flat.particle_count());
  flat.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) of[s.columns.id()[i]] = s.columns.template get<field::pressure>()[i];
  });
  double most = 0, worst = 0;
  deep.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double p = s.columns.template get<field::pressure>()[i], q = of[s.columns.id()[i] / 6];
      most = std::max(most, std::abs(q));
      worst = std::max(worst, std::abs(p - q));
      EXPECT_LT(std::abs(s.columns.template get<field::velocity>(2)[i]), 1e-6);
    }
  });
  EXPECT_GT(most, 1e9);
  EXPECT_LT(worst, 1e-6 * most);
  EXPECT_NEAR(deep.energies().now.kinetic / (flat.energies().now.kinetic * 0.6 * mm), 1, 1e-9) << "one metre of depth against 0.6 mm";
}

TYPED_TEST(ThreeDimensions, MomentumAndEnergyAreKept) {
  using point = vec<double, 3>;
  const initial_state start{2785, 0};
  const body ball{"ball", sphere{point{0, 0, -0.4 * mm}, 0.4 * mm}, aluminium(), 0.1 * mm, start, point{300, 100, 5000}};
  const body plate{"plate", box{point{-0.8 * mm, -0.8 * mm, 0}, point{0.8 * mm, 0.8 * mm, 0.2 * mm}}, aluminium(), 0.1 * mm, start};
  solver sim{space::cartesian_3d{}, grid::sparse{0.2 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<double>(), ball, plate};
  sim.run(0.3 * us);
  for (std::size_t d = 0; d < 3; ++d) EXPECT_LT(std::abs(sim.energies().momentum_error(d)), 1e-13);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-12);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-12);
  EXPECT_NEAR(sim.energies().now.total(), sim.energies().initial.total(), 1e-12 * sim.energies().initial.total());
}

TYPED_TEST(ThreeDimensions, ASphereFallsFreelyInAUniformField) {
  using point = vec<double, 3>;
  const body ball{"ball", sphere{point{0, 0, 0}, 0.4 * mm}, aluminium(), 0.1 * mm, initial_state{2785, 0}};
  solver sim{space::cartesian_3d{}, grid::sparse{0.2 * mm}, typename TypeParam::shape_type{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{},
             one_thread<double>(), ball};
  const point g{1e6, 0, -9e6};
  sim.add(body_force{[g](const point&, double) { return g; }});
  const double t = 1 * us;
  sim.run(t);
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(s.columns.template get<field::velocity>(d)[i], g[d] * t, 1e-9 * 9e6 * t);
        EXPECT_LT(std::abs(s.columns.template get<field::pressure>()[i]), 1) << "a rigid fall makes no stress, Pa";
      }
  });
  const auto& e = sim.energies();
  EXPECT_NEAR(e.body_work / e.now.kinetic, 1, 1e-12);
  EXPECT_LT(std::abs(e.residual()), 1e-12 * e.now.kinetic);
  EXPECT_NEAR(e.momentum_given[2] / e.momentum_now[2], 1, 1e-12);
}

/// A rigid rotation given with its gradient: APIC keeps its angular momentum from the first step on.
TEST(InitialFields, ApicStartsFromTheGradientThatIsGiven) {
  using point = vec<double, 2>;
  const auto after_a_step = [](bool with_gradient) {
    const body disc{"disc", sphere{point{0.1 * mm, 0.2 * mm}, 1 * mm}, aluminium(), 0.1 * mm, initial_state{2785, 0}};
    solver sim{space::plane_strain{}, grid::sparse{0.2 * mm}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, one_thread<double>(), disc};
    const double w = 1e5;
    sim.initialise([&](initial_point<2>& p) {
      p.velocity = point{-w * (p.position[1] - 0.2 * mm), w * (p.position[0] - 0.1 * mm)};
      if (with_gradient) p.velocity_gradient = {0, -w, w, 0};
    });
    sim.step();
    return sim.energies().now.kinetic / sim.energies().initial.kinetic;
  };
  EXPECT_NEAR(after_a_step(true), 1, 1e-6) << "a rigid rotation is a linear field";
  EXPECT_LT(after_a_step(false), 0.99) << "without its gradient a part of it is lost in the first map";
}

TEST(InitialFields, AreWhatWasSaid) {
  using point = vec<double, 2>;
  const body disc{"disc", sphere{point{0, 0}, 1 * mm}, aluminium(), 0.1 * mm, initial_state{2785, 0}};
  solver sim{space::plane_strain{}, grid::sparse{0.2 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), disc};
  sim.initialise([](initial_point<2>& p) {
    EXPECT_EQ(p.body, "disc");
    p.velocity = point{-1e5 * p.position[1], 1e5 * p.position[0]};
    p.density = p.position[0] > 0 ? 2800 : 2900;
    p.energy = 1e3;
  });
  double mass = 0, momentum = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double x = s.columns.template get<field::position>(0)[i], m = s.columns.template get<field::mass>()[i];
      EXPECT_EQ(s.columns.template get<field::velocity>(1)[i], 1e5 * x);
      EXPECT_NEAR(m / s.columns.template get<field::volume>()[i], x > 0 ? 2800 : 2900, 1e-9);
      EXPECT_EQ(s.columns.template get<field::energy>()[i], 1e3);
      mass += m;
      momentum += m * s.columns.template get<field::velocity>(1)[i];
    }
  });
  EXPECT_NEAR(sim.energies().now.internal, mass * 1e3, 1e-9 * mass * 1e3);
  sim.step();
  EXPECT_NEAR(sim.energies().momentum_initial[1], momentum, 1e-12 * mass * 100);
  EXPECT_THROW(sim.initialise([](initial_point<2>&) {}), bad_parameter);
}

} // namespace
} // namespace bolide
