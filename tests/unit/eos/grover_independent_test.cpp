// SPDX-License-Identifier: MIT
// Every branch of the paper's equation of state against an independent calculation: the formulas written out branch by branch in long
// double as docs/eos.md has them, the temperature by bisection of e_k(T), the sound speed from
//   c^2 = V^2 [(p_th + de_th/dV) p_T/C - dp_c/dV - dp_th/dV]                     (derivatives of e_th and p_th at constant T)
// on the exact lattice sum. p, T and c^2 must agree to 1e-9 (of what they are made of) in all regions of paper, mixed and helm.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/grover.hpp"
#include "bolide/eos/phase/helm.hpp"
#include "bolide/eos/phase/mixed.hpp"
#include "bolide/eos/phase/paper.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace {
using namespace bolide;
using real = long double;

struct answer {
  real p, T, c2, scale; // Pa, K, m2/s2; Pa: the largest term of p
  int region;
};

/// What a branch is at a volume and a temperature: e_th, p_th and their derivatives by V (constant T) and T.
struct thermal {
  real e, e_V, C, p, p_V, p_T;
};

struct by_hand {
  phase::grover_parameters q;
  bool helm, has_mixed;
  real x, V, gamma, gamma_x, Tm, G, lam, G_power;

  by_hand(bool is_helm, bool mixed_phase, real ratio, real rho0) : helm(is_helm), has_mixed(mixed_phase), x(ratio), V(ratio / rho0) {
    gamma = real(q.g0) - real(q.a) * (1 - x);
    gamma_x = real(q.a);
    Tm = real(q.Tm0) * std::exp(2 * real(q.a) * (1 - x)) * std::pow(x, -2 * (real(q.g0) - real(q.a) - real(1) / 3));
    if (helm && x > 1) {
      const real B = -(real(q.a) + 2 * (real(q.g0) - real(2) / 3)) / 2, A = real(q.g0) - real(2) / 3 - B;
      gamma = real(2) / 3 + A / (x * x) + B / (x * x * x * x);
      gamma_x = -2 * A / (x * x * x) - 4 * B / (x * x * x * x * x);
      Tm = real(q.Tm0) * std::pow(x, -real(2) / 3) * std::exp(-A * (1 - 1 / (x * x)) - B / 2 * (1 - 1 / (x * x * x * x)));
    }
    G_power = helm ? real(q.ge) : 0;
    G = real(q.G) * std::pow(x, G_power);
    lam = 2 * gamma - real(2) / 3;
  }

  real Tm_V() const { return -lam * Tm / V; }
  real lam_V() const { return 2 * gamma_x * x / V; }
  thermal electrons(real T) const {
    const real e = G * T * T / 2, ge = real(q.ge);
    return {e, G_power * e / V, G * T, ge * e / V, ge * (G_power - 1) * e / (V * V), ge * G * T / V};
  }
  thermal lattice(real T, real heat, real grueneisen, real grueneisen_V) const { // heat T per mass, pressure grueneisen heat T/V
    return {heat * T, 0, heat, grueneisen * heat * T / V, (grueneisen_V - grueneisen / V) * heat * T / V, grueneisen * heat / V};
  }
  /// A term T_m w(tau) of the energy, whose pressure is lam/V times it; w and dw/dtau given.
  thermal melting(real T, real w, real w_tau) const {
    const real tau = T / Tm, e = Tm * w, e_T = w_tau, e_V = Tm_V() * (w - tau * w_tau);
    return {e, e_V, e_T, lam / V * e, (lam_V() - lam / V) / V * e + lam / V * e_V, lam / V * e_T};
  }
  static thermal sum(std::initializer_list<thermal> parts) {
    thermal s{};
    for (const auto& t : parts) s = {s.e + t.e, s.e_V + t.e_V, s.C + t.C, s.p + t.p, s.p_V + t.p_V, s.p_T + t.p_T};
    return s;
  }
  thermal solid(real T) const { return sum({lattice(T, 3 * real(q.R), gamma, gamma_x * x / V), electrons(T)}); }
  thermal liquid(real T) const {
    const real tau = T / Tm, al = real(q.al);
    return sum({solid(T), melting(T, real(q.dS) - al / 2 * (1 + tau * tau), -al * tau)});
  }
  thermal hot_liquid(real T) const {
    const real hot = 3 * real(q.R) / (2 * real(q.al)), K = real(q.dS) + real(q.al) / 2 * (hot * hot - 1);
    return sum({lattice(T, real(1.5) * real(q.R), 2 * gamma - lam, 0), electrons(T), melting(T, K, 0)});
  }
  thermal gas(real T) const { return lattice(T, real(1.5) * real(q.R), real(2) / 3, 0); }

  template <class Branch> static real temperature(const Branch& branch, real e) {
    real low = 0, high = 1;
    while (branch(high).e < e) high *= 2;
    for (int i = 0; i < 200; ++i) (branch((low + high) / 2).e < e ? low : high) = (low + high) / 2;
    return (low + high) / 2;
  }
  template <class Branch> answer of(const Branch& branch, real e, const cold_point<double>& c, real rho0, int where) const {
    const real T = temperature(branch, e), p_c_V = real(c.slope) * rho0;
    const thermal t = branch(T);
    return {real(c.pressure) + t.p, T, V * V * ((t.p + t.e_V) * t.p_T / t.C - p_c_V - t.p_V), std::abs(real(c.pressure)) + std::abs(t.p), where};
  }
  answer mixture(real e, const cold_point<double>& c, real rho0) const {
    const thermal s = solid(Tm);
    const real excess = e - s.e, p_c = real(c.pressure), p = p_c + s.p + lam / V * excess;
    const real E_ms_V = s.e_V + s.C * Tm_V();
    const real p_V = real(c.slope) * rho0 + s.p_V + s.p_T * Tm_V() + (lam_V() - lam / V) / V * excess + lam / V * (p_c - E_ms_V); // at constant total e
    return {p, Tm, V * V * (p * lam / V - p_V), std::abs(p_c) + std::abs(s.p), 1};
  }
  answer at(real e, const cold_point<double>& c, real rho0) const {
    const auto in = [&](auto member) { return [this, member](real T) { return (this->*member)(T); }; };
    const real E_ms = solid(Tm).e, E_m = liquid(Tm).e, E_G = hot_liquid(3 * real(q.R) / (2 * real(q.al)) * Tm).e;
    if (!helm && x >= real(q.xj)) return of(in(&by_hand::gas), e, c, rho0, 4);
    if (e < (has_mixed ? E_ms : E_m)) return of(in(&by_hand::solid), e, c, rho0, 0);
    if (has_mixed && e <= E_m) return mixture(e, c, rho0);
    return e <= E_G ? of(in(&by_hand::liquid), e, c, rho0, 2) : of(in(&by_hand::hot_liquid), e, c, rho0, 3);
  }
};

template <class Phase> class GroverByHand : public ::testing::Test {};
using variants = ::testing::Types<phase::paper, phase::mixed, phase::helm>;
TYPED_TEST_SUITE(GroverByHand, variants);

TYPED_TEST(GroverByHand, EveryBranchAgreesTo1e_9) {
  const eos::grover eos{cold::cai_ye{}, TypeParam{}};
  const bool helm = std::is_same_v<TypeParam, phase::helm>, has_mixed = !std::is_same_v<TypeParam, phase::paper>;
  const double rho0 = eos.reference_density();
  std::array<int, 5> seen{};
  double worst_p = 0, worst_T = 0, worst_c = 0;
  for (double x = 0.3; x < 5; x *= 1.043) {
    const auto cold = eos.cold.evaluate(x);
    const by_hand hand(helm, has_mixed, real(x), real(rho0));
    for (double e_k = 1e4; e_k < 2e8; e_k *= 1.19) {
      const auto r = eos.evaluate(rho0 / x, cold.energy + e_k);
      const real own_e_k = real(cold.energy + e_k) - real(cold.energy); // what is left of e_k in a double e
      const answer a = hand.at(own_e_k, cold, real(rho0));
      SCOPED_TRACE("x = " + std::to_string(x) + ", e_k = " + std::to_string(e_k));
      ASSERT_EQ(static_cast<int>(r.region), a.region);
      ++seen[static_cast<std::size_t>(a.region)];
      const real wave = std::abs(a.c2) + a.scale * hand.V;
      worst_p = std::max(worst_p, static_cast<double>(std::abs(real(r.pressure) - a.p) / a.scale));
      worst_T = std::max(worst_T, static_cast<double>(std::abs(real(r.temperature) - a.T) / a.T));
      worst_c = std::max(worst_c, static_cast<double>(std::abs(real(r.sound_speed_squared) - a.c2) / wave));
      ASSERT_LE(std::abs(real(r.pressure) - a.p), 1e-9L * a.scale);
      ASSERT_LE(std::abs(real(r.temperature) - a.T), 1e-9L * a.T);
      ASSERT_LE(std::abs(real(r.sound_speed_squared) - a.c2), 1e-9L * wave);
    }
  }
  std::printf("[ figures  ] worst relative difference: p %.1e, T %.1e, c^2 %.1e\n", worst_p, worst_T, worst_c);
  for (const int region : {0, 2, 3}) EXPECT_GT(seen[static_cast<std::size_t>(region)], 50) << "region " << region;
  EXPECT_EQ(seen[1] > 20, has_mixed);
  EXPECT_EQ(seen[4] > 100, !helm);
}
} // namespace
