// SPDX-License-Identifier: MIT
// summary.json of a run: every floor, every channel of the ledger, the composition.
#include "bolide/observe/summary.hpp"
#include "bolide/concepts/observer.hpp"

#include "unit/observe/test_folder.hpp"
#include "unit/solver/scenes.hpp"

namespace bolide::observe {
namespace {
using bolide::test::small_impact;
using unit::us;
using method = bolide::test::bspline_apic_usf;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
std::string entry(const std::string& name, std::uint64_t n) { return "\"" + name + "\": " + std::to_string(n); }

TEST(summary, is_there_from_the_start_and_tells_everything_at_the_end) {
  const test::folder at("summary");
  auto al = bolide::test::aluminium();
  al.sound_speed_floor = 1.1; // acts wherever the material is not compressed
  auto sim = small_impact<method>(al);
  EXPECT_TRUE((Observer<summary, decltype(sim)>));
  summary report(at.path / "out" / "summary.json");
  EXPECT_EQ(report.last_output(), "");
  report.extra["mine"] = 7;
  std::string first;
  every look(1.0, [&](const auto&) { if (first.empty()) first = test::bytes_of(at.path / "out" / "summary.json"); });
  sim.run(0.1 * us, report, look);
  EXPECT_TRUE(contains(first, "\"status\": \"running\"")) << first;
  EXPECT_TRUE(contains(first, entry("steps", 0)));
  const std::string text = test::bytes_of(at.path / "out" / "summary.json");
  EXPECT_EQ(report.last_output(), (at.path / "out" / "summary.json").string());
  EXPECT_TRUE(contains(text, "\"status\": \"done\"")) << text;
  EXPECT_TRUE(contains(text, entry("steps", static_cast<std::uint64_t>(sim.steps()))));
  EXPECT_TRUE(contains(text, "\"mine\": 7"));
  const ledger l = sim.energies();
  std::uint64_t floors = 0;
  for (std::size_t k = 0; k < floor_names.size(); ++k) {
    EXPECT_TRUE(contains(text, entry(floor_names[k], l.floors.count[k]))) << floor_names[k];
    floors += l.floors.count[k];
  }
  EXPECT_GT(floors, 0u) << "a test of counts that are all zero shows little";
  const auto number = [](const char* name, double x) { return "\"" + std::string(name) + "\": " + to_text(x); };
  for (const std::string& member : {number("transfer", l.transfer), number("returned_heat", l.returned_heat), number("work_mismatch", l.work_mismatch),
                                    number("left", l.left), number("plastic_work", l.plastic_work), number("viscous_heating", l.viscous_heating),
                                    number("failure_release", l.failure_release), number("initial_kinetic", l.initial.kinetic), number("internal", l.now.internal),
                                    number("energy_drift", l.drift()), number("ledger_residual", l.residual())})
    EXPECT_TRUE(contains(text, member)) << member << "\n" << text;
}

TEST(summary, the_composition_names_its_roles_fields_and_bytes) {
  auto sim = small_impact<method>();
  const std::string text = composition_of(sim).text();
  for (const char* part : {"\"space\": \"axisymmetric\"", "\"shape\": \"bspline\"", "\"transfer\": \"apic\"", "\"scheme\": \"usf\"", "\"precision\": \"double\"",
                           "\"Courant number\": 0.4", "time step", "\"name\": \"ball\"", "eos::isentrope_temperature<eos::mie_grueneisen", "strength::johnson_cook", "\"deviator\": 3", "\"velocity\": 2", "valid density (kg/m3)"})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  EXPECT_TRUE(contains(text, "\"cell size (m)\": " + to_text(sim.cell()))) << text;
  sim.for_each_body([&](const auto& set) {
    EXPECT_TRUE(contains(text, entry("particles", set.columns.size()))) << text;
    const auto bytes = std::remove_cvref_t<decltype(set.columns)>::bytes_per_particle;
    EXPECT_TRUE(contains(text, entry("bytes per particle", bytes)));
  });
}

} // namespace
} // namespace bolide::observe
