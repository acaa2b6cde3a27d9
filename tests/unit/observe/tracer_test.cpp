// SPDX-License-Identifier: MIT
// The tracer in a run: right particles, right numbers, right times, whole rows, and a run that it does not change.
#include "bolide/observe/tracer.hpp"
#include "bolide/concepts/observer.hpp"

#include "unit/observe/csv_rows.hpp"
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide::observe {
namespace {
using bolide::test::small_flyer;
using bolide::test::small_impact;
using test::read_rows;
using unit::us;
using method = bolide::test::bspline_apic_usf;

TEST(Tracer, IsAnObserver) {
  EXPECT_TRUE((Observer<tracer, decltype(small_flyer<method>())>));
  EXPECT_TRUE((Observer<tracer, decltype(small_impact<method>())>));
}

TEST(Tracer, FollowsItsParticlesThroughEverySort) {
  const test::folder at("tracer");
  auto sim = small_impact<method>();
  tracer gauge(at.path / "gauge.csv", {100, 3}, 0.05 * us);
  sim.run(0.2 * us, gauge);
  const auto rows = read_rows(at.path / "gauge.csv");
  ASSERT_EQ(rows.size(), 1u + 2 * 5); // header; two particles at 0, 0.05, 0.1, 0.15 and 0.2 us
  EXPECT_EQ(gauge.rows(), 10u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time (s)", "step", "id", "body", "r (m)", "z (m)", "v_r (m/s)", "v_z (m/s)",
                                               "density (kg/m3)", "energy (J/kg)",
                                               "pressure (Pa)", "temperature (K)"}));
  for (int k = 0; k < 5; ++k) { // the first step on or after the time asked for
    const double t = std::stod(rows[static_cast<std::size_t>(1 + 2 * k)][0]) / us;
    EXPECT_GE(t, 0.05 * k * (1 - 1e-9));
    EXPECT_LT(t, 0.05 * k + 0.02);
  }
  EXPECT_EQ(rows[1][2], "3");
  EXPECT_EQ(rows[1][3], "ball");
  EXPECT_EQ(rows[2][2], "100");
  EXPECT_EQ(rows[2][3], "plate"); // 88 particles are the ball's
  EXPECT_EQ(std::stod(rows[1][7]), 6640);
  EXPECT_EQ(std::stod(rows[2][7]), 0);
  // the last rows are the state of the solver
  sim.for_each_body([&](const auto& s) {
    for (std::size_t i = 0; i < s.columns.size(); ++i)
      for (const auto& row : {rows[9], rows[10]})
        if (row[2] == std::to_string(s.columns.id()[i])) {
          EXPECT_EQ(std::stod(row[4]), s.columns.template get<field::position>(0)[i]);
          EXPECT_EQ(std::stod(row[10]), s.columns.template get<field::pressure>()[i]);
          EXPECT_EQ(std::stod(row[11]), s.material.thermodynamics(s.columns, i).temperature);
        }
  });
}

TEST(Tracer, SamplesEveryStepAndChangesNothing) {
  const test::folder at("tracer_steps");
  auto watched = small_flyer<method>(), alone = small_flyer<method>();
  tracer gauge(at.path / "gauge.csv", {7});
  watched.run(0.1 * us, gauge);
  alone.run(0.1 * us);
  EXPECT_EQ(gauge.rows(), static_cast<std::size_t>(watched.steps()) + 1);
  EXPECT_EQ(bolide::test::state_hash(watched), bolide::test::state_hash(alone));
}

TEST(Tracer, WritesAnEmptyTemperatureWhereThereIsNone) {
  const test::folder at("tracer_cold");
  const material cold{eos::mie_grueneisen{{.constant_gamma = true}}, strength::none{}, failure::none{}};
  auto sim = small_flyer<method>(cold);
  tracer gauge(at.path / "gauge.csv", {0}, 1);
  sim.run(0.02 * us, gauge);
  EXPECT_EQ(gauge.rows(), 2u) << "the beginning and the end";
  const auto text = test::bytes_of(at.path / "gauge.csv");
  EXPECT_EQ(text.substr(text.size() - 2), ",\n");
  EXPECT_NE(text.find("x (m),v_x (m/s)"), std::string::npos);
}

TEST(Tracer, WritesTheFieldsThatAreChosen) {
  const test::folder at("tracer_fields");
  auto sim = small_impact<method>();
  tracer gauge(at.path / "gauge.csv", {100, 3}, std::vector{0.05 * us}, {"plastic_strain", "position", field::deviator{}});
  EXPECT_EQ(gauge.last_output(), "") << "nothing is written yet";
  sim.run(0.1 * us, gauge);
  const auto rows = read_rows(at.path / "gauge.csv");
  ASSERT_EQ(rows.size(), 3u) << "one time, two particles, and no row at the end";
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time (s)", "step", "id", "body", "r (m)", "z (m)", "v_r (m/s)", "v_z (m/s)", "plastic_strain (1)",
                                               "deviator_rr (Pa)", "deviator_zz (Pa)", "deviator_rz (Pa)"}));
  EXPECT_EQ(gauge.last_output(), (at.path / "gauge.csv").string());
}

TEST(Tracer, RefusesWhatItCannotFollow) {
  const test::folder at("tracer_bad");
  EXPECT_THROW(tracer(at.path / "a.csv", {}), bad_parameter);
  EXPECT_THROW(tracer(at.path / "a.csv", {1, 2, 1}), bad_parameter);
  EXPECT_THROW(tracer(at.path / "a.csv", {1}, -1), bad_parameter);
  tracer gauge(at.path / "a.csv", {40}); // the flyer has particles 0 to 39
  auto sim = small_flyer<method>();
  EXPECT_THROW(sim.run(0.01 * us, gauge), bad_parameter);
  EXPECT_FALSE(std::filesystem::exists(at.path / "a.csv"));
}

} // namespace
} // namespace bolide::observe
