// SPDX-License-Identifier: MIT
// Fragments of a small real impact (r-z, aluminium sphere of 2 mm on a plate of 0.5 mm at 6.64 km/s, after 2 us): how much the answer depends on
// the mesh and on the linking length. docs/debris_cloud.md states the figures that this prints.
#include "bolide/observe/fragments.hpp"
#include "bolide/observe/take_snapshot.hpp"

#include "unit/solver/scenes.hpp"

#include <cstdio>

namespace bolide::observe {
namespace {
using unit::mm;
using unit::us;

snapshot debris(int per_diameter) {
  using point = vec<double, 2>;
  const double dx = 2 * mm / per_diameter;
  const auto al = bolide::test::aluminium();
  const body ball{"ball", sphere{point{0, -1 * mm}, 1 * mm}, al, dx, initial_state{2785, 0}, point{0, 6640}};
  const body plate{"plate", box{point{0, 0}, point{5 * mm, 0.5 * mm}}, al, dx, initial_state{2785, 0}};
  solver sim{space::axisymmetric{}, grid::sparse{2 * dx}, shape::quadratic_bspline{}, transfer::flip{}, scheme::musl{}, bolide::test::one_thread<double>(), ball, plate};
  sim.run(2 * us);
  return take_snapshot(sim, {"density", "failed"});
}

TEST(fragments_of_a_run, depend_on_mesh_and_linking_length_as_documented) {
  double loose[2][4]; // share of the mass that is not the plate's
  std::size_t resolved[2][4];
  for (const int mesh : {0, 1}) {
    const snapshot s = debris(mesh == 0 ? 40 : 80);
    double total = 0;
    for (const double m : s.at("mass").data) total += m;
    std::size_t before = s.size() + 1, k = 0;
    for (const double link : {1.5, 2.0, 3.0, 4.0}) {
      const fragments all(s, {.linking_length = link * s.spacing}), four(s, {.linking_length = link * s.spacing, .least_particles = 4});
      EXPECT_NEAR(all.mass(), total, 1e-12 * total) << "nothing is lost";
      EXPECT_NEAR(four.mass() + four.dust().mass, total, 1e-12 * total);
      EXPECT_LE(all.size(), before) << "longer links only join";
      EXPECT_GT(all.size(), 10u);
      before = all.size();
      loose[mesh][k] = 1 - all[0].mass / total, resolved[mesh][k] = four.size();
      EXPECT_EQ(all[0].kind, fragment_kind::ring) << "the plate with its hole";
      std::printf("[ figures  ] %d particles per diameter, linking length %.1f spacings: %zu fragments, %zu of at least 4 particles, dust %.4f, loose mass %.4f\n",
                  mesh == 0 ? 40 : 80, link, all.size(), four.size(), four.dust().mass / total, loose[mesh][k]);
      ++k;
    }
  }
  EXPECT_NEAR(loose[1][1], loose[0][1], 0.15 * loose[0][1]) << "how much is torn off depends little on the mesh";
  EXPECT_GT(static_cast<double>(resolved[1][1]), 1.2 * static_cast<double>(resolved[0][1])) << "into how many rings does: it is no measure";
}

} // namespace
} // namespace bolide::observe
