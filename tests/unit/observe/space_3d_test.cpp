// SPDX-License-Identifier: MIT
// Every output of a run in three dimensions and in plane strain: chosen fields, probes, frames, fragments, sections.
#include "bolide/observe/fragments.hpp"
#include "bolide/observe/probe.hpp"
#include "bolide/observe/slice.hpp"
#include "bolide/observe/tracer.hpp"
#include "bolide/observe/vtk_frames.hpp"

#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

#include "unit/observe/csv_rows.hpp"
#include "unit/solver/scenes.hpp"

namespace bolide::observe {
namespace {
using test::read_rows;
using unit::mm;
using unit::us;

auto plain_metal() { return material{eos::mie_grueneisen{{.constant_gamma = true}}, strength::elastic_perfectly_plastic{27e9, 0.3e9}, failure::none{}}; }

/// Two cubes (squares) of 0.4 mm that meet at 1 km/s along x.
template <class Space> auto collision() {
  using point = vec<double, Space::dim>;
  const double a = 0.4 * mm;
  point low = point::Zero(), high = point::Constant(a), along = point::Zero(), shift = point::Zero();
  along[0] = 1000, shift[0] = a;
  const auto metal = plain_metal();
  const body left{"left", box{low, high}, metal, 0.05 * mm, initial_state{2785, 0}, along};
  const body right{"right", box{point(low + shift), point(high + shift)}, metal, 0.05 * mm, initial_state{2785, 0}};
  return solver{Space{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, bolide::test::one_thread<double>(), left, right};
}

/// sqrt(3/2 s:s) of a full symmetric tensor.
double equivalent(double xx, double yy, double zz, double xy, double xz, double yz) {
  return std::sqrt(1.5 * (xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)));
}

TEST(outputs_3d, fields_probes_frames_and_tables) {
  const test::folder at("outputs_3d");
  auto sim = collision<space::cartesian_3d>();
  using point = vec<double, 3>;
  tracer gauge(at.path / "gauge.csv", {0}, 1.0, {"deviator", "pressure"});
  probe pick(at.path / "probe.csv", std::vector{point{0.415 * mm, 0.2 * mm, 0.2 * mm}, point{-1 * mm, 0, 0}}, 1.0, {"pressure", "velocity"});
  vtk_frames movie(at.path / "vtk", 1.0, {"von_mises"});
  sim.run(0.03 * us, gauge, pick, movie);
  EXPECT_EQ(read_rows(at.path / "gauge.csv")[0],
            (std::vector<std::string>{"time (s)", "step", "id", "body", "x (m)", "y (m)", "z (m)", "v_x (m/s)", "v_y (m/s)", "v_z (m/s)", "deviator_xx (Pa)",
                                      "deviator_yy (Pa)", "deviator_xy (Pa)", "deviator_xz (Pa)", "deviator_yz (Pa)", "pressure (Pa)"}));
  const auto rows = read_rows(at.path / "probe.csv");
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_GT(std::stol(rows[3][6]), 8);
  EXPECT_GT(std::stod(rows[3][7]), 1e9) << "the shock";
  EXPECT_NEAR(std::stod(rows[3][8]), 500, 5) << "the contact, where it is by now, moves with half the speed";
  EXPECT_EQ(rows[4][6], "0");
  EXPECT_EQ(movie.frames(), 2u);

  const snapshot s = take_snapshot(sim, {"von_mises", "deviator", "density", "pressure"});
  double most = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const column& d = s.at("deviator");
    const double expected = equivalent(d(i, 0), d(i, 1), -d(i, 0) - d(i, 1), d(i, 2), d(i, 3), d(i, 4));
    ASSERT_NEAR(s.at("von_mises")(i), expected, 1e-9 * expected + 1e-3);
    most = std::fmax(most, expected);
  }
  EXPECT_GT(most, 1e8);
  const fragments pieces(s), bodies(s, {.across_bodies = false});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(bodies.size(), 2u);
  double mass = 0, momentum = 0;
  for (std::size_t i = 0; i < s.size(); ++i) mass += s.at("mass")(i), momentum += s.at("mass")(i) * s.at("velocity")(i, 0);
  EXPECT_NEAR(pieces[0].mass, mass, 1e-15 * mass);
  EXPECT_NEAR(pieces[0].velocity[0], momentum / mass, 1e-9);
  const snapshot cut = slice(s, 1, 0.225 * mm);
  EXPECT_NEAR(static_cast<double>(cut.size()), static_cast<double>(s.size()) / 8, static_cast<double>(s.size()) / 32) << "one layer of eight";
}

TEST(outputs_plane_strain, von_mises_counts_the_third_axis) {
  auto sim = collision<space::plane_strain>();
  sim.run(0.03 * us);
  const snapshot s = take_snapshot(sim, {"von_mises", "deviator", "density"});
  double most = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const column& d = s.at("deviator");
    const double expected = equivalent(d(i, 0), d(i, 1), -d(i, 0) - d(i, 1), d(i, 2), 0, 0);
    ASSERT_NEAR(s.at("von_mises")(i), expected, 1e-9 * expected + 1e-3);
    most = std::fmax(most, expected);
  }
  EXPECT_GT(most, 1e8);
  const fragments pieces(s);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].kind, fragment_kind::piece);
  EXPECT_NEAR(pieces[0].diameter, std::sqrt(4 * 2 * 0.4 * mm * 0.4 * mm / 3.14159265358979), 0.03 * mm) << "the circle of both squares' area";
}

} // namespace
} // namespace bolide::observe
