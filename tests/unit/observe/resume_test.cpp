// SPDX-License-Identifier: MIT
// Outputs of a run that goes on from a checkpoint are those of a run that was never interrupted, bit by bit.
#include "bolide/observe/probe.hpp"
#include "bolide/observe/summary.hpp"
#include "bolide/observe/vtk_frames.hpp"

#include "unit/observe/test_folder.hpp"
#include "unit/solver/memory_archive.hpp"
#include "unit/solver/scenes.hpp"

namespace bolide::observe {
namespace {
using bolide::test::small_flyer;
using unit::mm;
using unit::us;
using method = bolide::test::bspline_flip_musl;

/// A run with its outputs in a folder.
struct watched {
  decltype(small_flyer<method>()) sim = small_flyer<method>();
  probe<1> pick;
  vtk_frames movie;
  summary report;
  explicit watched(const std::filesystem::path& at)
      : pick(at / "probe.csv", std::vector{vec<double, 1>{0.5 * mm}}, 0.01 * us, {"pressure", "velocity"}), movie(at / "vtk", 0.05 * us, {"pressure"}),
        report(at / "summary.json") {}
  void run(double until) { sim.run(until, pick, movie, report); }
  template <class A> void archive(A& a) {
    a.value("sim", sim);
    a.value("pick", pick);
    a.value("movie", movie);
    a.value("report", report);
  }
};

TEST(resume, tables_frames_and_summary_go_on) {
  const test::folder whole("resume_whole"), parts("resume_parts");
  watched one(whole.path);
  bolide::test::entries kept;
  int calls = 0;
  const auto save_at_step = [&](watched& w, long step) {
    return [&, step](const auto& sim) {
      ++calls;
      if (sim.steps() != step) return;
      bolide::test::memory_archive<false> a(kept);
      w.archive(a);
    };
  };
  watched first(parts.path);
  one.run(0.2 * us);
  every save(1e-12, save_at_step(first, 40));
  first.sim.run(0.15 * us, first.pick, first.movie, first.report, save); // goes on after the checkpoint: what it writes then is written again
  ASSERT_GT(calls, 40);
  ASSERT_FALSE(kept.empty());
  watched second(parts.path);
  bolide::test::memory_archive<true> a(kept);
  second.archive(a);
  EXPECT_EQ(second.sim.steps(), 40);
  second.run(0.2 * us);
  EXPECT_EQ(second.pick.rows(), one.pick.rows());
  EXPECT_EQ(second.movie.frames(), one.movie.frames());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(whole.path)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".json") continue;
    const auto name = std::filesystem::relative(entry.path(), whole.path);
    EXPECT_EQ(test::bytes_of(parts.path / name), test::bytes_of(entry.path())) << name;
  }
  const auto line = [](const std::filesystem::path& at, const std::string& from, const std::string& to) {
    const std::string text = test::bytes_of(at / "summary.json");
    return text.substr(text.find(from), text.find(to) - text.find(from));
  };
  EXPECT_EQ(line(parts.path, "\"steps_by_cause\"", "\"mass_kg\""), line(whole.path, "\"steps_by_cause\"", "\"mass_kg\""));
  EXPECT_EQ(line(parts.path, "\"ledger\"", "\"composition\""), line(whole.path, "\"ledger\"", "\"composition\""));
}

} // namespace
} // namespace bolide::observe
