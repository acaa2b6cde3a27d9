// SPDX-License-Identifier: MIT
// A run that stops: the message names the last good output, frames and summary are written all the same, and the cause is not lost.
#include "bolide/observe/every.hpp"
#include "bolide/observe/summary.hpp"
#include "bolide/observe/tracer.hpp"
#include "bolide/observe/vtk_frames.hpp"

#include "unit/observe/test_folder.hpp"
#include "unit/solver/scenes.hpp"

namespace bolide::observe {
namespace {
using bolide::test::small_flyer;
using unit::us;
using method = bolide::test::bspline_flip_usf;

auto that_stops() {
  auto c = bolide::test::one_thread<double>();
  c.step_cap = 30;
  return small_flyer<method>(bolide::test::aluminium(), {}, c);
}
template <class... Observers> std::string message_of(Observers&... observers) {
  auto sim = that_stops();
  try {
    sim.run(1 * us, observers...);
  } catch (const run_stopped& e) { return e.what(); }
  return "did not stop";
}
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(stop, the_message_names_the_last_good_output) {
  const test::folder at("stop");
  tracer gauge(at.path / "gauge.csv", {3}, 0.01 * us);
  vtk_frames movie(at.path / "vtk", 0.05 * us, {"pressure"});
  every silent(0.05 * us, [](const auto&) {});
  const std::string said = message_of(gauge, movie, silent);
  EXPECT_TRUE(contains(said, "the step cap of 30 is reached")) << said;
  EXPECT_TRUE(contains(said, "particle")) << said;
  EXPECT_TRUE(contains(said, ". Last good output: " + (at.path / "gauge.csv").string() + ", " + (at.path / "vtk/particles_0000.vtu").string())) << said;
  EXPECT_EQ(movie.frames(), 2u) << "the first, and the state in which it stopped";
}

TEST(stop, without_output_it_says_so_and_without_observers_nothing_is_added) {
  every silent(0.05 * us, [](const auto&) {});
  EXPECT_TRUE(contains(message_of(silent), ". Last good output: none"));
  EXPECT_FALSE(contains(message_of(), "output"));
}

TEST(stop, the_summary_is_written_with_the_message) {
  const test::folder at("stop_summary");
  summary report(at.path / "summary.json");
  const std::string said = message_of(report), text = test::bytes_of(at.path / "summary.json");
  EXPECT_TRUE(contains(text, "\"status\": \"stopped\"")) << text;
  EXPECT_TRUE(contains(text, "the step cap of 30 is reached")) << text;
  EXPECT_TRUE(contains(text, "\"steps\": 30")) << text;
}

struct broken {
  void watch(const auto&) {}
  void finish(const auto&) {}
  void stopped(const auto&, const std::string&) { throw output_error("the disk is full"); }
};

TEST(stop, an_observer_that_fails_then_does_not_hide_the_cause) {
  broken b;
  const std::string said = message_of(b);
  EXPECT_TRUE(contains(said, "the step cap of 30 is reached")) << said;
  EXPECT_TRUE(contains(said, "Besides: the disk is full")) << said;
}

} // namespace
} // namespace bolide::observe
