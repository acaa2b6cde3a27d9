// SPDX-License-Identifier: MIT
// Equations of state that are broken on purpose, one fault each, fail the check that the fault belongs to; the same construction without the
// fault passes. And a user's own equation of state goes through the suite in three lines.
#include "bolide/conformance/equation_of_state.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/conformance/expect.hpp"
#include "unit/conformance/stated.hpp"

#include <sstream>

namespace {
using namespace bolide;
using namespace bolide::test;
using conformance::check;

// ---- Tillotson, branch II put together from I and III by hand ------------------------------------------------------------------------
template <bool Swapped> struct tillotson_by_hand {
  eos::tillotson I{{.E_iv = 1e30, .E_cv = 2e30}}, III{{.E_iv = 1e-30, .E_cv = 2e-30}};
  double E_iv = 3e6, E_cv = 13.9e6;
  template <class V> caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const auto a = I.evaluate(rho, e), b = III.evaluate(rho, e);
    const V raw = (e - T(E_iv)) / V(T(E_cv - E_iv)), w = clip(raw, V(T(0)), V(T(1)));
    const V slope = select(raw > V(T(0)) && raw < V(T(1)), V(T(1 / (E_cv - E_iv))), V(T(0)));
    const auto inside = slope > V(T(0)) && rho < V(T(2700));
    const V u = Swapped ? select(inside, V(T(1)) - w, w) : w, u_e = Swapped ? -slope : slope, rest = V(T(1)) - u, inverse = V(T(1)) / (rho * rho);
    const auto density_part = [&](const caloric_point<V>& p) { return p.sound_speed_squared - p.pressure * p.pressure_energy * inverse; };
    const V p = rest * a.pressure + u * b.pressure, p_e = rest * a.pressure_energy + u * b.pressure_energy + u_e * (b.pressure - a.pressure);
    const V c2 = rest * density_part(a) + u * density_part(b) + p * p_e * inverse;
    const auto expanded = rho < V(T(2700));
    return {select(expanded, p, a.pressure), select(expanded, c2, a.sound_speed_squared), select(expanded, p_e, a.pressure_energy)};
  }
  double reference_density() const { return 2700; }
};
TEST(BrokenEos, TillotsonWithSwappedWeightsInBranchII) {
  expect_passed(check(tillotson_by_hand<false>{}, {.name = "tillotson by hand", .stated = of_tillotson()}));
  const auto report = check(tillotson_by_hand<true>{}, {.stated = of_tillotson()});
  expect_fails(report, {"pressure_jump"});
  EXPECT_GT(report.at("pressure_jump").worst, 0.1);
}

// ---- Mie-Grueneisen with one thing broken ------------------------------------------------------------------------------------------------
enum class fault { none, sound_speed, sound_speed_by_little, pressure_energy, jump, nan, lanes, float_only };
template <fault F> struct broken_mie_grueneisen {
  eos::mie_grueneisen right{{.fading_expansion = true}};
  template <class V> caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = right.evaluate(rho, e);
    if constexpr (F == fault::sound_speed) r.sound_speed_squared = r.sound_speed_squared - r.pressure * r.pressure_energy / (rho * rho);
    if constexpr (F == fault::sound_speed_by_little)
      r.sound_speed_squared = select(e > V(T(9e6)), T(1.0001) * r.sound_speed_squared, r.sound_speed_squared);
    if constexpr (F == fault::pressure_energy) r.pressure_energy = select(rho > V(T(2785)), T(0.999) * r.pressure_energy, r.pressure_energy);
    if constexpr (F == fault::jump) r.pressure = r.pressure + select(rho > V(T(4000)) && e > V(T(7e6)), V(T(1e7)), V(T(0))); // 10 MPa of 100 GPa
    if constexpr (F == fault::nan) r.pressure = r.pressure + V(T(0)) * sqrt(rho - V(T(1)));                                  // below 1 kg/m3
    if constexpr (F == fault::lanes && lane_width<V> == 8) r.pressure = select(rho < V(T(2000)), T(1.01) * r.pressure, r.pressure);
    if constexpr (F == fault::float_only && sizeof(T) == 4) r.sound_speed_squared = r.sound_speed_squared + T(1e-7) * e * e;
    return r;
  }
  double reference_density() const { return right.reference_density(); }
  eos::validity_box validity() const { return right.validity(); }
};
TEST(BrokenEos, ControlPasses) { expect_passed(check(broken_mie_grueneisen<fault::none>{})); }
TEST(BrokenEos, SoundSpeedFromTheDensitySlopeAlone) {
  expect_fails(check(broken_mie_grueneisen<fault::sound_speed>{}), {"sound_speed", "continuation"});
}
TEST(BrokenEos, SoundSpeedOffByOneInTenThousandInHotMaterial) {
  expect_fails(check(broken_mie_grueneisen<fault::sound_speed_by_little>{}), {"sound_speed", "continuation"});
}
TEST(BrokenEos, PressureEnergyOffByOneInAThousand) {
  expect_fails(check(broken_mie_grueneisen<fault::pressure_energy>{}), {"pressure_energy", "continuation"});
}
TEST(BrokenEos, AnUnstatedJumpOf10MPa) {
  const auto report = check(broken_mie_grueneisen<fault::jump>{});
  expect_fails(report, {"pressure_jump", "sound_speed"}); // c^2 = p_rho + p p_e/rho^2 feels the wrong p
  EXPECT_NE(report.at("pressure_jump").note.find("at most 0.01 GPa"), std::string::npos) << report;
}
TEST(BrokenEos, NaNAtSmallDensity) {
  const auto report = check(broken_mie_grueneisen<fault::nan>{});
  EXPECT_EQ(report.at("finite").result, conformance::outcome::failed);
  EXPECT_EQ(report.at("lane pack<float, 8>").result, conformance::outcome::failed);
}
TEST(BrokenEos, ALaneBranchThatDiffers) {
  expect_fails(check(broken_mie_grueneisen<fault::lanes>{}), {"lane pack<double, 8>", "lane pack<float, 8>", "lane continuation"});
}
TEST(BrokenEos, FloatsThatDiffer) {
  expect_fails(check(broken_mie_grueneisen<fault::float_only>{}),
               {"lane float", "lane pack<float, 4>", "lane pack<float, 8>", "lane pack<float, 16>", "lane continuation"});
}

// ---- helm with one thing broken ------------------------------------------------------------------------------------------------------------
enum class thermal_fault { none, latent, temperature_energy, temperature, cold_energy };
template <thermal_fault F> struct broken_helm {
  eos::grover<cold::tabulated, phase::helm> right{table(), phase::helm{}};
  template <class V> thermal_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    auto r = right.evaluate(rho, e);
    const V latent = r.melting_temperature * T(1.01 * 308) * r.melt_fraction; // e_k - E_ms in the mixed phase
    const auto mixed = r.region == V(region_value<V>(region::mixed));
    if constexpr (F == thermal_fault::latent) r.pressure = select(mixed, r.pressure - T(0.1) * r.pressure_energy * latent, r.pressure);
    if constexpr (F == thermal_fault::temperature_energy) r.temperature_energy = T(1.01) * r.temperature_energy;
    const V factor = V(T(0.999)) + rho * T(0.001 / 2700); // 1 at 2700 kg/m3
    if constexpr (F == thermal_fault::temperature) r.temperature = factor * r.temperature, r.temperature_energy = factor * r.temperature_energy;
    if constexpr (F == thermal_fault::cold_energy) r.cold_energy = r.cold_energy + T(1e3);
    return r;
  }
  double reference_density() const { return right.reference_density(); }
  eos::validity_box validity() const { return right.validity(); }
};
TEST(BrokenEos, HelmControlPasses) { expect_passed(check(broken_helm<thermal_fault::none>{})); }
TEST(BrokenEos, WrongLatentTermInTheMixedPhase) {
  expect_fails(check(broken_helm<thermal_fault::latent>{}), {"sound_speed", "pressure_energy", "pressure_jump", "monotone_pressure"});
}
TEST(BrokenEos, WrongHeatCapacity) { expect_fails(check(broken_helm<thermal_fault::temperature_energy>{}), {"temperature_energy", "continuation"}); }
TEST(BrokenEos, ATemperatureThatBelongsToNoFreeEnergy) { expect_fails(check(broken_helm<thermal_fault::temperature>{}), {"maxwell"}); }
TEST(BrokenEos, AColdEnergyThatIsNotThatOfZeroKelvin) { expect_fails(check(broken_helm<thermal_fault::cold_energy>{}), {"cold_limit"}); }

// ---- the pole of the linear us-up line, left open --------------------------------------------------------------------------------------------
struct unguarded {
  template <class V> caloric_point<V> evaluate(V rho, V e) const {
    using T = scalar_t<V>;
    const V one(T(1)), eta = one - T(2785) / rho, d = one / (one - T(1.338) * eta), bulk(T(2785 * 5328. * 5328.)), g(T(2 * 2785));
    const V p_h = bulk * eta * d * d, slope = bulk * (one + T(1.338) * eta) * d * d * d * (one - eta) - p_h;
    const V p = p_h * (one - eta) + g * e, inverse = one / (rho * rho);
    return {p, slope * T(2785) * inverse + p * g * inverse, g};
  }
  double reference_density() const { return 2785; }
};
TEST(BrokenEos, APoleWithoutGuard) {
  const auto failed = failed_checks(check(unguarded{}, {.lowest_density_ratio = 0.9}));
  EXPECT_TRUE(failed.count("monotone_pressure") == 1 && failed.count("stability") == 1) << check(unguarded{}, {.lowest_density_ratio = 0.9});
  expect_passed(check(unguarded{}, {.lowest_density_ratio = 0.9, .highest_density_ratio = 3.4}));
}

// ---- a user's own ----------------------------------------------------------------------------------------------------------------------------
struct water { // a stiffened gas, as in examples/own_eos
  double g = 4.4, p_inf = 6e8, rho0 = 1000;
  template <class V> eos_point<V> evaluate(V rho, V e) const {
    const V p = scalar_t<V>(g - 1) * rho * e + scalar_t<V>(g * p_inf) * (rho * scalar_t<V>(1 / rho0) - scalar_t<V>(1));
    return {p, scalar_t<V>(g) * (p + scalar_t<V>(p_inf)) / rho};
  }
  double reference_density() const { return rho0; }
};
struct bounded_water : water {
  eos::validity_box validity() const { return {0.9 * rho0, 5 * rho0, 0, 1e10}; }
};
struct scalar_water {
  eos_point<double> evaluate(double rho, double e) const { return water{}.evaluate(rho, e); }
  double reference_density() const { return 1000; }
};

TEST(UsersEos, InThreeLines) {
  std::ostringstream out;
  const auto report = conformance::check(bounded_water{});
  out << report;
  EXPECT_EQ(report.passed() ? 0 : 1, 0) << out.str();
  EXPECT_NE(out.str().find("passed: 23 checks, 0 failed"), std::string::npos) << out.str();
  EXPECT_EQ(report.at("maxwell").note, "the model gives no temperature");
}
TEST(UsersEos, WithoutABoxIsAskedForAThinGasToo) { expect_fails(check(water{}), {"thin_limit"}); }
TEST(UsersEos, ForScalarsOnly) {
  const auto report = check(scalar_water{}, {.lowest_density_ratio = 0.9});
  expect_passed(report);
  EXPECT_EQ(report.at("lane pack<double, 4>").result, conformance::outcome::not_applicable);
}
TEST(UsersEos, OptionsThatMakeNoSenseAreRefused) {
  EXPECT_THROW(check(water{}, {.lowest_density_ratio = -1}), bad_parameter);
  EXPECT_THROW(check(water{}, {.lowest_energy = 1, .highest_energy = 0}), bad_parameter);
  EXPECT_THROW(check(water{}, {.stated = {{"sound speed", 1, "misspelt"}}}), bad_parameter);
}
} // namespace
