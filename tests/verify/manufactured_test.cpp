// SPDX-License-Identifier: MIT
// Manufactured solutions: their forces against finite differences, and the order that the method reaches on them. All compositions:
// manufactured_slow_test.cpp.
#include "verify/manufactured.hpp"

namespace bolide {
namespace {
using namespace verify;

/// rho (x_tt - b) = div sigma with everything but b and sigma from finite differences; over the largest |div sigma| met.
template <class Solution> double force_error(const Solution& s, const std::vector<plane>& points) {
  double worst = 0, largest = 0;
  for (const auto& big : points)
    for (const double part : {0.13, 0.31, 0.57, 0.83}) {
      const double t = part * s.end, dt = 1e-3 * s.end, d = 1e-4;
      const plane x = s.position(big, t), acceleration = (s.position(big, t + dt) - 2 * x + s.position(big, t - dt)) / (dt * dt);
      plane divergence = plane::Zero();
      tensor inverse; // dX/dx
      for (int j = 0; j < 2; ++j) {
        const plane e = plane::Unit(j) * d;
        divergence += (s.stress(x + e, t) - s.stress(x - e, t)).col(j) / (2 * d);
        inverse.col(j) = (s.reference(x + e, t) - s.reference(x - e, t)) / (2 * d);
      }
      const double rho = s.m.rho * (inverse(0, 0) * inverse(1, 1) - inverse(0, 1) * inverse(1, 0));
      worst = std::max(worst, (rho * (acceleration - s.force(x, t)) - divergence).norm());
      largest = std::max(largest, divergence.norm());
    }
  return worst / largest;
}
/// The Jaumann rate integrated along the motion against the closed form; over the largest stress met.
template <class Solution> double stress_error(const Solution& s, const std::vector<plane>& points) {
  double worst = 0, largest = 0;
  for (const auto& big : points) {
    const int steps = 400;
    const double dt = s.end / steps;
    tensor sigma = tensor::Zero();
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) * dt;
      const tensor l = velocity_gradient_at(s, s.position(big, t), t), rate = 0.5 * (l + l.transpose()), spin = 0.5 * (l - l.transpose());
      const auto slope = [&](const tensor& at) {
        return tensor(spin * at - at * spin + 2 * s.m.shear() * rate + (s.m.bulk() - 2.0 / 3 * s.m.shear()) * rate.trace() * tensor::Identity());
      };
      const tensor half = sigma + 0.5 * dt * slope(sigma);
      sigma += dt * slope(half);
      const tensor exact = s.stress(s.position(big, t + 0.5 * dt), t + 0.5 * dt);
      worst = std::max(worst, (sigma - exact).norm());
      largest = std::max(largest, exact.norm());
    }
  }
  return worst / largest;
}

TEST(Manufactured, ForcesAndStressesBelongToTheMotions) {
  const std::vector<plane> through_vortex{{0.86, 0.1}, {-0.3, 0.9}, {0.7, -0.85}, {-0.8, -0.3}},
      through_ring{{0.41, 0.1}, {-0.3, 0.4}, {0.35, -0.45}}, in_square{{0.1, 0.2}, {0.4, 0.8}, {0.93, 0.55}};
  EXPECT_LT(force_error(vortex{}, through_vortex), 2e-5);
  EXPECT_LT(force_error(expanding_ring{}, through_ring), 2e-5);
  EXPECT_LT(force_error(axis_aligned{}, in_square), 2e-5);
  EXPECT_LT(stress_error(vortex{}, through_vortex), 2e-4);
  EXPECT_LT(stress_error(expanding_ring{}, through_ring), 2e-4);
  EXPECT_LT(stress_error(axis_aligned{}, in_square), 2e-4);
}

template <class Method> class Manufactured : public testing::Test {};
using methods = testing::Types<bspline_apic_usf>;
TYPED_TEST_SUITE(Manufactured, methods, method_names);

TYPED_TEST(Manufactured, AxisAligned) { check_axis_aligned<TypeParam>(1.0 / 6, 0.02, 1.8); }
TYPED_TEST(Manufactured, ExpandingRing) { check_expanding_ring<TypeParam>(1.0 / 40, 0.01, 1.8); }

} // namespace
} // namespace bolide
