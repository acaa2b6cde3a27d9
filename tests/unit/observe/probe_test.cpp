// SPDX-License-Identifier: MIT
// The probe: what it averages, with which weights, where it says that nothing is there, and when.
#include "bolide/observe/probe.hpp"
#include "bolide/concepts/observer.hpp"

#include "unit/observe/csv_rows.hpp"
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide::observe {
namespace {
using bolide::test::small_flyer;
using bolide::test::small_impact;
using test::read_rows;
using unit::mm;
using unit::us;
using method = bolide::test::linear_flip_usf;
using point1 = vec<double, 1>;
using point2 = vec<double, 2>;

TEST(Probe, IsAnObserver) {
  EXPECT_TRUE((Observer<probe<1>, decltype(small_flyer<method>())>));
  EXPECT_TRUE((Observer<probe<2>, decltype(small_impact<method>())>));
}

TEST(Probe, MeetsALinearFieldOnTheLattice) {
  const test::folder at("probe_linear");
  auto sim = small_flyer<method>();
  const chosen_field line{"line", "m", [](const particle& p) { return 3 * mm + 2 * p("position"); }};
  std::vector<point1> points;
  for (int k = 0; k < 30; ++k) points.push_back(point1{-0.8 * mm + 0.0531 * mm * k}); // at least a cell inside the surfaces
  probe pick(at.path / "p.csv", points, 1.0, {line, "density"});
  sim.run(0, pick);
  const auto rows = read_rows(at.path / "p.csv");
  ASSERT_EQ(rows.size(), 31u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time (s)", "step", "point", "x (m)", "particles", "line (m)", "density (kg/m3)"}));
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(rows[k + 1][2], std::to_string(k));
    EXPECT_NEAR(std::stod(rows[k + 1][5]), 3 * mm + 2 * points[k][0], 1e-15) << points[k][0];
    EXPECT_NEAR(std::stod(rows[k + 1][6]), 2785, 1e-9);
    EXPECT_EQ(rows[k + 1][4], "4") << "two particles to a cell on either side";
  }
}

TEST(Probe, WeighsByVolumeAndDistance) {
  const test::folder at("probe_weights");
  auto sim = small_impact<method>();
  const point2 where{0.43 * mm, 0.12 * mm};
  probe pick(at.path / "p.csv", std::vector{where}, 0.02 * us, {"pressure", "velocity", "region"});
  sim.run(0.06 * us, pick);
  double weights = 0, pressure = 0, axial = 0, largest = 0, kind = -1;
  long count = 0;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double dr = std::abs(p.template get<field::position>(0)[i] - where[0]) / sim.cell();
      const double dz = std::abs(p.template get<field::position>(1)[i] - where[1]) / sim.cell();
      if (!(dr < 1 && dz < 1)) continue;
      const double w = p.template get<field::volume>()[i] * (1 - dr) * (1 - dz);
      weights += w, pressure += w * p.template get<field::pressure>()[i], axial += w * p.template get<field::velocity>(1)[i], ++count;
      if (w > largest) largest = w, kind = s.material.thermodynamics(p, i).region;
    }
  });
  const auto rows = read_rows(at.path / "p.csv");
  const auto& last = rows.back();
  ASSERT_GT(count, 4);
  EXPECT_EQ(std::stol(last[5]), count);
  EXPECT_NEAR(std::stod(last[6]), pressure / weights, 1e-12 * std::abs(pressure / weights));
  EXPECT_NEAR(std::stod(last[8]), axial / weights, 1e-12 * std::abs(axial / weights));
  EXPECT_EQ(std::stod(last[9]), kind) << "kinds are not averaged";
  EXPECT_GT(std::abs(std::stod(last[6])), 1e8) << "the shock has come";
}

TEST(Probe, AtTheAxisSeesTheMirrorImages) {
  const test::folder at("probe_axis");
  auto sim = small_impact<method>();
  probe pick(at.path / "p.csv", std::vector{point2{0, 0.05 * mm}, point2{0.2 * mm, 0.05 * mm}}, 0.05 * us, {"velocity", "deviator", "pressure"});
  sim.run(0.05 * us, pick);
  const auto rows = read_rows(at.path / "p.csv");
  const auto &axis = rows[rows.size() - 2], &off = rows.back();
  EXPECT_EQ(rows[0][6], "v_r (m/s)");
  EXPECT_EQ(rows[0][10], "deviator_rz (Pa)");
  EXPECT_EQ(std::stod(axis[6]), 0) << "v_r";
  EXPECT_EQ(std::stod(axis[10]), 0) << "s_rz";
  EXPECT_GT(std::abs(std::stod(off[6])), 1);
  EXPECT_GT(std::stod(axis[7]), 1000) << "v_z is even";
}

TEST(Probe, SaysWhereThereIsNoMaterial) {
  const test::folder at("probe_empty");
  auto sim = small_flyer<method>();
  probe pick(at.path / "p.csv", std::vector{point1{5 * mm}, point1{0.5 * mm}}, 1.0);
  sim.run(0.02 * us, pick);
  const auto rows = read_rows(at.path / "p.csv");
  ASSERT_EQ(rows.size(), 5u) << "the beginning and the end";
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time (s)", "step", "point", "x (m)", "particles", "density (kg/m3)", "v_x (m/s)", "pressure (Pa)",
                                               "energy (J/kg)", "temperature (K)"}));
  for (const std::size_t k : {1u, 3u}) {
    EXPECT_EQ(rows[k][4], "0");
    for (std::size_t c = 5; c < 10; ++c) EXPECT_EQ(rows[k][c], "");
    EXPECT_NEAR(std::stod(rows[k + 1][9]), 293, 20);
  }
}

TEST(Probe, SamplesAtTheTimesAskedForAndChangesNothing) {
  const test::folder at("probe_times");
  auto watched = small_flyer<method>(), alone = small_flyer<method>();
  probe pick(at.path / "p.csv", std::vector{point1{0.5 * mm}}, std::vector{0.07 * us, 0.02 * us, 5 * us}, {"pressure"});
  watched.run(0.1 * us, pick);
  alone.run(0.1 * us);
  const auto rows = read_rows(at.path / "p.csv");
  ASSERT_EQ(rows.size(), 3u) << "neither at the start nor at the end, and the third time is not reached";
  EXPECT_EQ(pick.last_output(), (at.path / "p.csv").string());
  for (const std::size_t k : {1u, 2u}) {
    const double wanted = k == 1 ? 0.02 : 0.07, t = std::stod(rows[k][0]) / us;
    EXPECT_GE(t, wanted * (1 - 1e-9));
    EXPECT_LT(t, wanted + 0.02);
  }
  EXPECT_EQ(bolide::test::state_hash(watched), bolide::test::state_hash(alone));
}

TEST(Probe, RefusesWhatItCannotSample) {
  const test::folder at("probe_bad");
  EXPECT_THROW(probe(at.path / "p.csv", std::vector<point1>{}), bad_parameter);
  EXPECT_THROW(probe(at.path / "p.csv", std::vector{point1{std::nan("")}}), bad_parameter);
  EXPECT_THROW(probe(at.path / "p.csv", std::vector{point1{0.}}, -1.0), bad_parameter);
  EXPECT_THROW(probe(at.path / "p.csv", std::vector{point1{0.}}, std::vector<double>{}), bad_parameter);
  auto sim = small_impact<method>();
  probe left(at.path / "p.csv", std::vector{point2{-1 * mm, 0}});
  EXPECT_THROW(sim.run(0.01 * us, left), bad_parameter) << "a negative radius";
  EXPECT_FALSE(std::filesystem::exists(at.path / "p.csv"));
}

} // namespace
} // namespace bolide::observe
