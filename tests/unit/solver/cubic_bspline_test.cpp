// SPDX-License-Identifier: MIT
// The cubic B-spline in the solver, with every scheme and transfer: the books close on an impact with axis, free surfaces and failure,
// and the axis quadrature has the error that the header states.
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/viscosity/none.hpp"

#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide {
namespace {
using namespace test;
using shape::cubic_bspline;

template <class Method> class CubicBspline : public testing::Test {};
using methods = testing::Types<method<cubic_bspline, transfer::flip, scheme::usf>, method<cubic_bspline, transfer::flip, scheme::musl>,
                               method<cubic_bspline, transfer::apic, scheme::usf>, method<cubic_bspline, transfer::apic, scheme::musl>>;
TYPED_TEST_SUITE(CubicBspline, methods, method_names);

TYPED_TEST(CubicBspline, BooksCloseOnTheImpact) {
  auto sim = small_impact<TypeParam>();
  sim.run(0.25 * us);
  const auto& l = sim.energies();
  EXPECT_LT(std::abs(l.residual()), 1e-12);
  EXPECT_LT(std::abs(l.drift()), 1e-12);
  EXPECT_LT(std::abs(l.momentum_error(1)), 1e-13);
  EXPECT_GT(l.viscous_heating, 0.001 * l.scale()) << "the scene must have a shock";
}

/// Radial acceleration over p/(rho h) of a uniform state between walls: 1/96 of p times the cell's area on the node at r = h (mass of the
/// node: about 2 pi h of the same area), so below 1/96 = 0.0104 on every particle, and
/// round-off between; the wall at r = 12 h has the like of it, a tenth as large.
TEST(CubicBsplineAxis, QuadratureHasTheErrorThatTheHeaderStates) {
  using point = vec<double, 2>;
  const double h = 1e-3, e = 1e5;
  const eos::stiffened_gas water{};
  const material m{water, strength::none{}, failure::none{}, viscosity::none{}};
  const body b{"water", box{point{0, 0}, point{12 * h, 12 * h}}, m, h / 2, initial_state{1000, e}};
  solver sim{space::axisymmetric{}, grid::sparse{h}, cubic_bspline{}, transfer::flip{}, scheme::usf{}, one_thread<double>(), b};
  sim.add(grid::mirror{0, 12 * h, false}).add(grid::mirror{1, 0, true}).add(grid::mirror{1, 12 * h, false});
  sim.step();
  double near = 0, between = 0, wall = 0;
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i) {
      const double a = std::abs(s.columns.template get<field::velocity>(0)[i]) / sim.dt() / (water.evaluate(1000., e).pressure / 1000 / h);
      const double r = s.columns.template get<field::position>(0)[i] / h;
      double& to = r < 4 ? near : r < 8 ? between : wall;
      to = std::max(to, a);
    }
  });
  std::printf("[ figures  ] cubic_bspline |a| rho h/p near the axis %.1e, between %.1e, at the wall %.1e\n", near, between, wall);
  EXPECT_LT(near, 1.0 / 96);
  EXPECT_GT(near, 1e-4) << "the error is gone: mend the header";
  EXPECT_LT(between, 1e-11);
  EXPECT_LT(wall, 1e-3);
}

} // namespace
} // namespace bolide
