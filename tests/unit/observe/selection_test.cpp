// SPDX-License-Identifier: MIT
// Chosen fields in every output: by name, by tag, by a function of the user's; what is unknown is refused with what is known.
#include "bolide/observe/probe.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/observe/tracer.hpp"

#include "unit/observe/csv_rows.hpp"
#include "unit/observe/test_folder.hpp"
#include "unit/solver/scenes.hpp"

#include <cmath>

namespace bolide::observe {
namespace {
using bolide::test::small_flyer;
using bolide::test::small_impact;
using test::read_rows;
using unit::mm;
using unit::us;
using method = bolide::test::bspline_apic_usf;

const chosen_field impedance{"impedance", "kg/(m2 s)", [](const particle& p) { return p("density") * p("sound_speed"); }};

std::string refusal(const auto& f) {
  try {
    f();
  } catch (const bad_parameter& e) { return e.what(); }
  return "nothing refused";
}

TEST(selection, a_snapshot_has_what_is_asked_for_and_no_more) {
  auto sim = small_impact<method>();
  sim.run(0.1 * us);
  const snapshot s = take_snapshot(sim, {"pressure", field::plastic_strain{}, "von_mises", "deviator", impedance, "mass"});
  EXPECT_EQ(s.listing(), "position, velocity, mass, pressure, plastic_strain, von_mises, deviator, impedance");
  EXPECT_EQ(s.at("von_mises").unit, "Pa");
  EXPECT_EQ(s.at("impedance").unit, "kg/(m2 s)");
  ASSERT_EQ(s.at("deviator").components, 3);
  double most = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const column& d = s.at("deviator");
    const double rr = d(i, 0), zz = d(i, 1), rz = d(i, 2), tt = -(rr + zz);
    EXPECT_NEAR(s.at("von_mises")(i), std::sqrt(1.5 * (rr * rr + zz * zz + tt * tt + 2 * rz * rz)), 1e-12 * s.at("von_mises")(i));
    most = std::fmax(most, s.at("von_mises")(i));
  }
  EXPECT_GT(most, 1e8) << "the impact yields";
}

TEST(selection, derived_fields_are_those_of_the_material) {
  auto sim = small_impact<method>();
  sim.run(0.1 * us);
  const snapshot s = take_snapshot(sim, {"temperature", "cold_energy", "shear_energy", "speed", "failed", "void_fraction", impedance});
  sim.for_each_body([&](const auto& set) {
    const auto& p = set.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const std::size_t row = p.id()[i];
      const auto state = set.material.thermodynamics(p, i);
      EXPECT_EQ(s.at("temperature")(row), state.temperature);
      EXPECT_EQ(s.at("cold_energy")(row), state.cold_energy);
      EXPECT_EQ(s.at("shear_energy")(row), set.material.shear_energy(p, i));
      EXPECT_DOUBLE_EQ(s.at("speed")(row), std::hypot(p.template get<field::velocity>(0)[i], p.template get<field::velocity>(1)[i]));
      EXPECT_EQ(s.at("failed")(row), p.template get<field::failed>()[i] > 0 ? 1 : 0);
      EXPECT_EQ(s.at("impedance")(row), p.template get<field::mass>()[i] / set.material.material_volume(p, i) * p.template get<field::sound_speed>()[i]);
    }
  });
}

TEST(selection, unknown_names_are_refused_with_those_known) {
  const test::folder at("selection_bad");
  auto sim = small_flyer<method>();
  const std::string said = refusal([&] { take_snapshot(sim, {"presure"}); });
  EXPECT_NE(said.find("no material of this run knows a field \"presure\"; known are "), std::string::npos) << said;
  for (const char* name : {"pressure", "temperature", "von_mises", "region", "melt_fraction", "density", "plastic_strain"})
    EXPECT_NE(said.find(name), std::string::npos) << name << " in: " << said;
  tracer gauge(at.path / "a.csv", {1}, 0.0, {"presure"});
  EXPECT_NE(refusal([&] { sim.run(0.01 * us, gauge); }).find("\"presure\""), std::string::npos);
  probe pick(at.path / "b.csv", std::vector{vec<double, 1>{0.}}, 0.0, {"presure"});
  EXPECT_NE(refusal([&] { sim.run(0.01 * us, pick); }).find("\"presure\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(at.path)) << "no table without its fields";
  EXPECT_NE(refusal([&] { take_snapshot(sim, {"pressure", "pressure"}); }).find("times that field \"pressure\""), std::string::npos);
  EXPECT_NE(refusal([&] { take_snapshot(sim, {{"pressure", "Pa", [](const particle&) { return 1.0; }}}); }).find("have already"), std::string::npos);
  EXPECT_NE(refusal([&] { take_snapshot(sim, {{"own", "1", [](const particle& p) { return p("nothing"); }}}); }).find("have no field \"nothing\""), std::string::npos);
  EXPECT_NE(refusal([&] { take_snapshot(sim, {{"own", "1", [](const particle& p) { return p("velocity", 1); }}}); }).find("component of field"), std::string::npos);
  EXPECT_NE(refusal([&] { take_snapshot(sim, {{"own", "1", nullptr}}); }).find("function"), std::string::npos);
}

TEST(selection, a_body_without_the_field_leaves_its_cell_empty) {
  const test::folder at("selection_mixed");
  const material cold{eos::mie_grueneisen{{.constant_gamma = true}}, strength::none{}, failure::none{}};
  using point = vec<double, 1>;
  const body hot{"hot", box{point{-0.2 * mm}, point{0}}, bolide::test::aluminium(), 0.05 * mm, initial_state{2785, 0}};
  const body plain{"plain", box{point{0}, point{0.2 * mm}}, cold, 0.05 * mm, initial_state{2785, 0}};
  solver sim{space::planar_1d{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, bolide::test::one_thread<double>(), hot, plain};
  tracer gauge(at.path / "a.csv", {0, 5}, 1.0, {"melt_fraction", "von_mises", "pressure"});
  probe pick(at.path / "b.csv", std::vector{point{-0.15 * mm}, point{0.15 * mm}, point{1 * mm}}, 1.0, {"melt_fraction", "failed", "density"});
  sim.run(0, gauge, pick);
  const auto rows = read_rows(at.path / "a.csv"), points = read_rows(at.path / "b.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time (s)", "step", "id", "body", "x (m)", "v_x (m/s)", "melt_fraction (1)", "von_mises (Pa)", "pressure (Pa)"}));
  EXPECT_EQ(std::stod(rows[1][6]), 0);
  EXPECT_EQ(rows[2][3], "plain");
  EXPECT_EQ(rows[2][6], "") << "unknown, not 0";
  EXPECT_EQ(rows[2][7], "");
  EXPECT_EQ(std::stod(rows[2][8]), 0);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[1][5], "0");
  EXPECT_EQ(points[2][5], "");
  EXPECT_DOUBLE_EQ(std::stod(points[2][7]), 2785);
  EXPECT_EQ(points[3], (std::vector<std::string>{"0", "0", "2", "0.001", "0", "", "", ""})) << "no material there";
}

TEST(selection, components_are_named_after_the_axes_of_the_space) {
  EXPECT_EQ(component_axes<space::planar_1d>(rank::vector), (std::vector<std::string>{"x"}));
  EXPECT_EQ(component_axes<space::planar_1d>(rank::deviator), (std::vector<std::string>{"xx"}));
  EXPECT_EQ(component_axes<space::axisymmetric>(rank::deviator), (std::vector<std::string>{"rr", "zz", "rz"}));
  EXPECT_EQ(component_axes<space::axisymmetric>(rank::gradient), (std::vector<std::string>{"rr", "rz", "zr", "zz"}));
  EXPECT_EQ(component_axes<space::axisymmetric>(rank::scalar), (std::vector<std::string>{""}));
}

} // namespace
} // namespace bolide::observe
