// SPDX-License-Identifier: MIT
// The dense grid gives the bits of the sparse one; uniform GIMP in the solver: books, patch in r-z, where it lies between linear and B-spline.
#include "bolide/grid/uniform.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/space/plane_strain.hpp"

#include "unit/solver/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace bolide {
namespace {
using namespace test;
using point = vec<double, 2>;

template <class Method, class Grid> auto impact_on() {
  const initial_state at{2785, 0};
  const body ball{"ball", sphere{point{0, -0.4 * mm}, 0.4 * mm}, aluminium(), 0.05 * mm, at, point{0, 6640}};
  const body plate{"plate", box{point{0, 0}, point{2 * mm, 0.3 * mm}}, aluminium(), 0.05 * mm, at};
  return solver{space::axisymmetric{}, Grid{0.1 * mm}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, one_thread<double>(), ball, plate};
}

template <class Method> class UniformGrid : public testing::Test {};
TYPED_TEST_SUITE(UniformGrid, testing::Types<linear_flip_usf>, method_names);
TYPED_TEST(UniformGrid, GivesTheBitsOfTheSparseOne) {
  auto dense = impact_on<TypeParam, grid::uniform>();
  auto sparse = impact_on<TypeParam, grid::sparse>();
  dense.run(0.4 * us);
  sparse.run(0.4 * us);
  EXPECT_EQ(state_hash(dense), state_hash(sparse));
  EXPECT_GE(dense.node_count(), sparse.node_count());
  EXPECT_LT(std::abs(dense.energies().residual()), 1e-13);
}
TEST(UniformGrid, HasTheNodesOfTheSparseOneAndItsNeighbours) {
  using index = grid::cell_index<2>;
  grid::block_map<2> sparse;
  grid::dense_map<2> dense;
  const std::vector<index> occupied{{-3, 5}, {0, 0}, {2, 7}};
  sparse.rebuild(occupied);
  dense.rebuild(occupied);
  EXPECT_EQ(dense.size(), 8u * 10u);
  for (std::size_t b = 0; b < dense.size(); ++b) {
    EXPECT_EQ(dense.find(dense.coordinate(b)), static_cast<std::int32_t>(b));
    if (b > 0) {
      EXPECT_LT(dense.coordinate(b - 1), dense.coordinate(b));
    }
  }
  for (std::size_t b = 0; b < sparse.size(); ++b) {
    EXPECT_GE(dense.find(sparse.coordinate(b)), 0);
    const index at = sparse.node_at(b, 37);
    EXPECT_EQ(dense.node_at(static_cast<std::size_t>(dense.find(sparse.coordinate(b))), 37), at);
    EXPECT_EQ(dense.node(at), dense.find(sparse.coordinate(b)) * grid::block_map<2>::nodes_per_block + 37);
  }
  EXPECT_EQ(dense.find({-5, 0}), -1);
  dense.rebuild({});
  EXPECT_EQ(dense.size(), 0u);
  EXPECT_EQ(dense.find({0, 0}), -1);
}
TEST(UniformGrid, RefusesAnEmptySpaceThatIsTooLarge) {
  grid::dense_map<2> map(1e6);
  try {
    map.rebuild({{0, 0}, {1000, 1000}});
    FAIL();
  } catch (const bad_parameter& e) {
    EXPECT_NE(std::string(e.what()).find("take grid::sparse"), std::string::npos) << e.what();
  }
}

template <class Method> class GimpSolver : public testing::Test {};
using gimp_methods = testing::Types<method<shape::gimp, transfer::flip, scheme::usf>, method<shape::gimp, transfer::xpic<2>, scheme::usl>>;
TYPED_TEST_SUITE(GimpSolver, gimp_methods, method_names);
TYPED_TEST(GimpSolver, ClosesItsBooks) {
  auto sim = impact_on<TypeParam, grid::sparse>();
  sim.run(0.4 * us);
  EXPECT_LT(std::abs(sim.energies().residual()), 1e-13);
  EXPECT_LT(std::abs(sim.energies().drift()), 1e-13);
  EXPECT_LT(std::abs(sim.energies().momentum_error(1)), 1e-12);
}

/// A uniform pressure over the seeding lattice of r-z makes no force: particles near the axis, away from the free surface, stay at rest.
TYPED_TEST(GimpSolver, UniformPressurePatchAtTheAxisMakesNoForce) {
  const material gas{eos::mie_grueneisen{{}}, strength::none{}, failure::none{}};
  const body block{"block", box{point{0, 0}, point{2 * mm, 2 * mm}}, gas, 0.05 * mm, initial_state{2900, 1e5}};
  auto c = one_thread<double>();
  solver sim{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::gimp{}, typename TypeParam::transfer_type{}, typename TypeParam::scheme_type{}, c, block};
  sim.step();
  const double scale = 1e10 / (2900 * 0.1 * mm); // p / (rho h)
  double worst = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double r = s.columns.template get<field::position>(0)[i], z = s.columns.template get<field::position>(1)[i];
      if (r < 1 * mm && std::abs(z - 1 * mm) < 0.5 * mm) worst = std::max(worst, std::abs(s.columns.template get<field::velocity>(0)[i]) / (sim.dt() * scale));
    }
  });
  EXPECT_LT(worst, 1e-12);
}

/// Rigid flight through cells: GIMP carries a compressed bar without the noise of linear shapes.
template <class Shape> double noise() {
  using p1 = vec<double, 1>;
  const material fluid{eos::mie_grueneisen{{}}, strength::none{}, failure::none{}, viscosity::bulk{0, 0}};
  const body bar{"bar", box{p1{0}, p1{64 * mm}}, fluid, 0.5 * mm, initial_state{2785, 0}, p1{300.}};
  solver sim{space::planar_1d{}, grid::sparse{1 * mm}, Shape{}, transfer::flip{}, scheme::musl{}, one_thread<double>(), bar};
  sim.add(grid::periodic{0, 0, 64 * mm});
  sim.initialise([](initial_point<1>& p) { p.velocity[0] += 20 * std::sin(2 * 3.14159265358979 * p.position[0] / (64 * mm)); });
  sim.run(64e-3 / 5328 / 4); // a quarter of a period: the wave stands still in its velocity, p = rho c u
  std::vector<std::pair<double, double>> p;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) p.emplace_back(s.columns.template get<field::position>()[i], s.columns.template get<field::pressure>()[i]);
  });
  std::sort(p.begin(), p.end());
  double rough = 0; // second differences of the pressure
  for (std::size_t i = 1; i + 1 < p.size(); ++i) rough = std::max(rough, std::abs(p[i + 1].second - 2 * p[i].second + p[i - 1].second));
  return rough / (2785 * 5328 * 20);
}
TEST(GimpSolver, CrossesCellsWithoutTheNoiseOfLinearShapes) {
  const double linear = noise<shape::linear>(), gimp = noise<shape::gimp>(), bspline = noise<shape::quadratic_bspline>();
  std::printf("[ figures  ] roughness of the pressure over rho c u: linear %.3f, GIMP %.3f, B-spline %.3f\n", linear, gimp, bspline);
  EXPECT_LT(gimp, 0.3 * linear);
}

} // namespace
} // namespace bolide
