// SPDX-License-Identifier: MIT
// Every cold curve of the library passes the suite, and broken ones fail it where they are broken.
#include "bolide/conformance/cold_curve.hpp"
#include "bolide/eos/cold/birch_murnaghan.hpp"
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/eos/cold/rose.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/cold/user_table.hpp"
#include "bolide/eos/cold/vinet.hpp"
#include "bolide/potential/zhou04.hpp"
#include "unit/conformance/expect.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_fails;
using bolide::test::expect_passed;

TEST(ColdCurves, Conform) {
  expect_passed(conformance::check(cold::cai_ye{}, {.name = "cai_ye"}));
  expect_passed(conformance::check(cold::rose{}, {.name = "rose"}));
  expect_passed(conformance::check(cold::vinet{}, {.name = "vinet"}));
  expect_passed(conformance::check(cold::birch_murnaghan{}, {.name = "birch_murnaghan"}));
  expect_passed(conformance::check(cold::lattice{potential::zhou04{}}, {.name = "zhou04"}));
  expect_passed(conformance::check(cold::tabulated{cold::cai_ye{}}, {.name = "tabulated cai_ye"}));
  expect_passed(conformance::check(cold::tabulated{cold::rose{}}, {.name = "tabulated rose"}));
}

// A user's two columns: pressures of Rose's curve at 41 volumes. Beyond them the curve goes on with e_c to a limit that is the table's own.
TEST(ColdCurves, AUsersTableConforms) {
  const cold::rose source;
  std::vector<double> x, p;
  for (int i = 0; i <= 40; ++i) {
    x.push_back(0.4 + 0.04 * i);
    p.push_back(source.evaluate(x.back()).pressure);
  }
  expect_passed(conformance::check(cold::user_table{x, p, {.reference_density = source.reference_density()}}, {.name = "user_table"}));
}

TEST(ColdCurves, TheSharpCutoffJumpsAndIsStated) {
  const cold::cai_ye sharp{cold::cutoff::sharp};
  expect_fails(conformance::check(sharp), {"pressure_jump", "energy_jump"});
  const std::vector<conformance::stated_violation> stated = {
      {"pressure_jump", 0.002, "shells cross the cut-off", 0, 4.6}, {"pressure_jump", 0.3, "the nearest shells cross it", 4.6},
      {"energy_jump", 0.001, "shells cross the cut-off", 0, 4.6},   {"energy_jump", 0.03, "the nearest shells cross it", 4.6}};
  const auto report = conformance::check(sharp, {.name = "cai_ye, sharp", .stated = stated});
  expect_passed(report);
  EXPECT_EQ(report.at("pressure_jump").result, conformance::outcome::stated);
}

/// A right curve (Rose's) with one thing broken at a time.
enum class fault { none, pressure, slope, zero, jump, lanes, thin };
template <fault F> struct broken_curve {
  cold::rose right{};
  template <class V> cold_point<V> evaluate(V x) const {
    using T = scalar_t<V>;
    auto c = right.evaluate(x);
    if constexpr (F == fault::pressure) c.pressure = T(1.0001) * c.pressure, c.slope = T(1.0001) * c.slope;
    if constexpr (F == fault::slope) c.slope = c.slope * x;
    if constexpr (F == fault::zero) c.energy = c.energy + T(1e3);
    if constexpr (F == fault::jump) c.pressure = c.pressure + select(x < V(T(0.777)), V(T(1e7)), V(T(0))); // 10 MPa
    if constexpr (F == fault::lanes && lane_width<V> > 1) c.pressure = select(x > V(T(1.9)), T(1.01) * c.pressure, c.pressure);
    if constexpr (F == fault::thin) c.energy = c.energy + sqrt(V(T(2e5)) - x) - sqrt(V(T(2e5)) - x); // NaN beyond
    return c;
  }
  double reference_density() const { return right.reference_density(); }
};

TEST(BrokenColdCurves, FailWhereTheyAreBroken) {
  expect_passed(conformance::check(broken_curve<fault::none>{}));
  expect_fails(conformance::check(broken_curve<fault::pressure>{}), {"pressure"});
  expect_fails(conformance::check(broken_curve<fault::slope>{}), {"slope"});
  expect_fails(conformance::check(broken_curve<fault::zero>{}), {"zero_energy"});
  expect_fails(conformance::check(broken_curve<fault::jump>{}), {"pressure", "pressure_jump"});
  expect_fails(conformance::check(broken_curve<fault::lanes>{}), {"lane pack<double, 2>", "lane pack<double, 4>", "lane pack<double, 8>",
                                                                  "lane pack<float, 4>", "lane pack<float, 8>", "lane pack<float, 16>"});
  EXPECT_EQ(conformance::check(broken_curve<fault::thin>{}).at("finite").result, conformance::outcome::failed);
}

TEST(ColdCurveSuite, RefusesOptionsThatMakeNoSense) {
  EXPECT_THROW(conformance::check(cold::rose{}, {.smallest = 2}), bad_parameter);
  EXPECT_THROW(conformance::check(cold::rose{}, {.volumes = 1}), bad_parameter);
  EXPECT_THROW(conformance::check(cold::rose{}, {.stated = {{"presure", 1, "misspelt"}}}), bad_parameter);
}
} // namespace
