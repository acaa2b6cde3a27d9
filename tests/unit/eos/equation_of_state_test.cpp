// SPDX-License-Identifier: MIT
// What every equation of state must do, over all of them: the raw sound speed is the derivative of the pressure, every lane type gives
// the scalar's answer, nothing is NaN in or out of the range, the ambient state is one.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/tabulated.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/isentrope_temperature.hpp"
#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"
#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/sound_speed_floor.hpp"
#include "bolide/eos/state.hpp"
#include "bolide/eos/tillotson.hpp"
#include "unit/eos/lanes.hpp"

namespace {
using namespace bolide;
using bolide::test::expect_close;

const cold::tabulated& table() {
  static const cold::tabulated t{cold::cai_ye{}};
  return t;
}

/// make<E>() builds each model under test; borders(E, rho) are the energies at which its derivatives may jump.
template <class E> E make() { return E{}; }
using grover_exact = eos::grover<cold::cai_ye, phase::mixed>;
template <class P> using grover_table = eos::grover<cold::tabulated, P>;
using scaled_grover = eos::scaled_density<grover_table<phase::mixed>>;
using floored_grover = eos::sound_speed_floor<grover_table<phase::mixed>>;
template <> grover_exact make() { return grover_exact{cold::cai_ye{}}; }
template <> grover_table<phase::paper> make() { return grover_table<phase::paper>{table()}; }
template <> grover_table<phase::mixed> make() { return grover_table<phase::mixed>{table()}; }
template <> grover_table<phase::helm> make() { return grover_table<phase::helm>{table()}; }
template <> scaled_grover make() { return {make<grover_table<phase::mixed>>(), 1.05}; }
template <> eos::scaled_density<eos::mie_grueneisen> make() { return {eos::mie_grueneisen({.constant_gamma = true}), 1.0}; }
template <> floored_grover make() { return floored_grover{make<grover_table<phase::mixed>>(), 0.05}; }
template <> eos::isentrope_temperature<eos::mie_grueneisen> make() { return eos::isentrope_temperature{eos::mie_grueneisen{}}; }
template <> eos::isentrope_temperature<eos::tillotson> make() { return eos::isentrope_temperature{eos::tillotson{}}; }

template <class E> struct EveryEos : ::testing::Test {
  const E model = make<E>();
};
using models = ::testing::Types<grover_exact, grover_table<phase::paper>, grover_table<phase::mixed>, grover_table<phase::helm>,
                                eos::mie_grueneisen, eos::tillotson,
                                eos::isentrope_temperature<eos::mie_grueneisen>, eos::isentrope_temperature<eos::tillotson>,
                                scaled_grover, floored_grover,
                                eos::scaled_density<eos::mie_grueneisen>>; // the last: constant_gamma in expansion
TYPED_TEST_SUITE(EveryEos, models);

/// Whether all points of a stencil lie on one smooth piece of the surface.
template <class E> bool one_piece(const E& eos, double rho, double e, double dr, double de) {
  const auto piece = [&](double r, double energy) {
    const auto p = eos.evaluate(r, energy);
    int n = r < eos.reference_density() ? 1 : 0;
    if constexpr (ThermalEquationOfState<E>) n += 10 * static_cast<int>(p.region) + (p.temperature < 0 ? 1000 : 0);
    n += eos.outside_validity(r, energy) ? 10000 : 0;
    if (energy > 3.0e6) n += 100000; // Tillotson's vaporisation energies
    if (energy > 13.9e6) n += 100000;
    if constexpr (std::is_same_v<E, floored_grover>) n += p.sound_speed_squared == eos.least_sound_speed_squared() ? 1000000 : 0;
    return n;
  };
  const int here = piece(rho, e);
  for (const double k : {-2., 2.})
    if (piece(rho + k * dr, e) != here || piece(rho, e + k * de) != here) return false;
  return true;
}

TYPED_TEST(EveryEos, SoundSpeedAndItsPartsAreTheDerivatives) {
  const auto& eos = this->model;
  int tried = 0;
  for (double eta = 0.523; eta < 4.2; eta += 0.0371)
    for (double e = -1.01e5; e < 3e7; e += 1.7e5 + 0.05 * std::abs(e)) {
      const double rho = eta * eos.reference_density(), dr = 1e-4 * rho, de = 100;
      if (!one_piece(eos, rho, e, dr, de)) continue;
      if constexpr (requires { eos.least_sound_speed_squared(); })
        if (eos.evaluate(rho, e).sound_speed_squared == eos.least_sound_speed_squared()) continue; // the floor is not raw
      const auto slope = [&](auto f, double h) { return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h); };
      const double p_rho = slope([&](double d) { return eos.evaluate(rho + d, e).pressure; }, dr);
      const double p_e = slope([&](double d) { return eos.evaluate(rho, e + d).pressure; }, de);
      const auto p = eos.evaluate(rho, e);
      expect_close(p.sound_speed_squared, p_rho + p.pressure * p_e / (rho * rho), 1e-6, 1e6,
          "c^2 at eta = " + std::to_string(eta) + " e = " + std::to_string(e));
      expect_close(p.pressure_energy, p_e, 1e-6, 10, "dp/de at eta = " + std::to_string(eta) + " e = " + std::to_string(e));
      if constexpr (ThermalEquationOfState<TypeParam>)
        expect_close(p.temperature_energy, slope([&](double d) { return eos.evaluate(rho, e + d).temperature; }, de), 1e-6, 1e-3,
            "dT/de at eta = " + std::to_string(eta) + " e = " + std::to_string(e));
      ++tried;
    }
  EXPECT_GT(tried, 2000);
}

TYPED_TEST(EveryEos, NothingIsNaNAnywhere) {
  for (const double eta : {1e-6, 1e-3, 0.05, 0.3, 0.7423, 0.9, 1.0, 1.5, 3.0, 3.96, 4.0, 5.0, 7.0, 50.0})
    for (const double e : {-1e8, -1e6, -1e3, 0., 1e4, 1e6, 3e6, 13.9e6, 1e8, 1e10}) {
      const auto p = this->model.evaluate(eta * this->model.reference_density(), e);
      EXPECT_TRUE(std::isfinite(p.pressure) && std::isfinite(p.sound_speed_squared)) << "eta = " << eta << " e = " << e;
      if constexpr (ThermalEquationOfState<TypeParam>) {
        EXPECT_TRUE(std::isfinite(p.temperature) && std::isfinite(p.melting_temperature) && std::isfinite(p.melt_fraction)) << "eta = "
            << eta << " e = " << e;
      }
    }
}

TYPED_TEST(EveryEos, AmbientAndColdStates) {
  const auto& eos = this->model;
  const auto ambient = eos::ambient_state(eos, 293), cold = eos::cold_state(eos);
  EXPECT_LT(std::abs(ambient.pressure), 1e-3);
  EXPECT_GT(ambient.sound_speed, 5000);
  EXPECT_LT(ambient.sound_speed, 5500);
  EXPECT_EQ(cold.density, eos.reference_density());
  EXPECT_EQ(cold.energy, 0);
  if constexpr (ThermalEquationOfState<TypeParam>) {
    EXPECT_NEAR(ambient.temperature, 293, 1e-9);
  }
}

// Scalar and packed, double and float (cold_curve_test and phase_test go through every width); float's tolerance follows from the 6e-8
// of a density, which p and c^2 feel times about 100.
template <class V, class E> void lanes_agree(const E& eos) {
  using T = scalar_t<V>;
  const double eps = test::epsilon<V>(400);
  for (double eta = 0.55; eta < 3.4; eta += 0.0913)
    for (double e0 = -1e5; e0 < 2e7; e0 += 2e5 + 0.2 * std::abs(e0)) {
      const V rho = test::ramp<V>(eta, 0.0187) * T(eos.reference_density()), e = test::ramp<V>(e0, 1e3 + 0.13 * std::abs(e0));
      const auto many = eos.evaluate(rho, e);
      for (int i = 0; i < lane_width<V>; ++i) {
        const double r = static_cast<double>(lane(rho, i)), ei = static_cast<double>(lane(e, i));
        if (!one_piece(eos, r, ei, 2e-7 * r, 2e-7 * std::abs(ei) + 1)) continue;
        const auto one = eos.evaluate(r, ei);
        const std::string at = " at eta = " + std::to_string(r / eos.reference_density()) + ", e = " + std::to_string(ei);
        expect_close(lane(many.pressure, i), one.pressure, eps, 1e9, "p" + at);
        expect_close(lane(many.sound_speed_squared, i), one.sound_speed_squared, 4 * eps, 1e6, "c^2" + at);
        if constexpr (ThermalEquationOfState<E>) {
          expect_close(lane(many.temperature, i), one.temperature, eps, 100 + std::abs(one.cold_energy) / 900, "T" + at);
          expect_close(lane(many.melting_temperature, i), one.melting_temperature, eps, 0, "T_m" + at);
          expect_close(lane(many.cold_energy, i), one.cold_energy, eps, 1e5, "e_c" + at);
          EXPECT_EQ(static_cast<double>(lane(many.region, i)), one.region) << at;
        }
        bool outside = false;
        if constexpr (lane_width<V> == 1) outside = eos.outside_validity(rho, e);
        else outside = eos.outside_validity(rho, e)[i];
        EXPECT_EQ(outside, eos.outside_validity(r, ei)) << at;
      }
    }
}
TYPED_TEST(EveryEos, EveryLaneTypeGivesTheScalarAnswer) {
  lanes_agree<float>(this->model);
  lanes_agree<pack<double, 8>>(this->model);
  lanes_agree<pack<float, 4>>(this->model);
}
} // namespace
