// SPDX-License-Identifier: MIT
// Frames of chosen fields while a run goes on, and a snapshot as a table.
#include "bolide/observe/vtk_frames.hpp"
#include "bolide/concepts/observer.hpp"
#include "bolide/observe/snapshot_csv.hpp"

#include "unit/observe/csv_rows.hpp"
#include "unit/solver/scenes.hpp"

namespace bolide::observe {
namespace {
using bolide::test::small_impact;
using unit::us;
using method = bolide::test::bspline_apic_usf;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(vtk_frames, writes_the_chosen_fields_when_they_are_due_and_changes_nothing) {
  const test::folder at("frames");
  auto watched = small_impact<method>(), alone = small_impact<method>();
  vtk_frames movie(at.path, 0.05 * us, {"pressure", "von_mises"});
  EXPECT_EQ(movie.last_output(), "");
  watched.run(0.12 * us, movie);
  alone.run(0.12 * us);
  EXPECT_EQ(movie.frames(), 4u) << "0, 0.05, 0.1 us and the end";
  EXPECT_EQ(movie.last_output(), (at.path / "particles_0003.vtu").string());
  const std::string frame = test::bytes_of(at.path / "particles_0003.vtu");
  EXPECT_TRUE(contains(frame, "Name=\"von_mises\""));
  EXPECT_FALSE(contains(frame, "Name=\"temperature\"")) << "only what is asked for";
  EXPECT_EQ(bolide::test::state_hash(watched), bolide::test::state_hash(alone));
}

TEST(snapshot_csv, one_row_per_particle) {
  const test::folder at("snapshot_csv");
  auto sim = small_impact<method>();
  sim.run(0.02 * us);
  const snapshot s = take_snapshot(sim, {"pressure", "deviator"});
  write_csv(at.path / "p.csv", s);
  const auto rows = test::read_rows(at.path / "p.csv");
  ASSERT_EQ(rows.size(), s.size() + 1);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"id", "body", "r (m)", "z (m)", "v_r (m/s)", "v_z (m/s)", "mass (kg)", "pressure (Pa)", "deviator_0 (Pa)",
                                               "deviator_1 (Pa)", "deviator_2 (Pa)"}));
  EXPECT_EQ(rows[101][0], "100");
  EXPECT_EQ(rows[101][1], "plate");
  EXPECT_EQ(std::stod(rows[101][7]), s.at("pressure")(100));
}

} // namespace
} // namespace bolide::observe
