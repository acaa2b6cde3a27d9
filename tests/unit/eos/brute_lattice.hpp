// SPDX-License-Identifier: MIT
// An independent lattice sum: every site of a block of cells by a triple loop, no shells, no analytic derivative, long double, the
// potentials written out again from the published formulas. What is asked of it are energies; derivatives are differences of them.
#pragma once

#include <array>
#include <cmath>

namespace bolide::test {

using real = long double;

/// Cai and Ye's aluminium, with the sharp cut-off or without one (then 20 angstrom).
struct brute_cai_ye {
  bool sharp = false;
  static constexpr bool bcc = false;
  real a0() const { return 4.05L; }
  real mass() const { return 26.982L; }
  real reach() const { return sharp ? 1.65L * a0() : 20.0L; }
  real f(real r) const { return std::exp(-2.5L * (r - a0() / std::sqrt(2.0L))); }
  real phi(real r) const {
    const real s = 7.5995L * (r / 3.0169L - 1);
    return -0.0834L * (1 + s) * std::exp(-s);
  }
  real F(real rho) const;
};

/// Zhou, Johnson and Wadley's aluminium of 2004.
struct brute_zhou04 {
  static constexpr bool bcc = false;
  real a0() const { return std::sqrt(2.0L) * 2.863924L; }
  real mass() const { return 26.981539L; }
  real reach() const { return 20.0L; }
  static real twentieth(real w) { return std::pow(w * w, 10.0L); }
  real f(real r) const { return 1.403115L * std::exp(-3.527021L * (r / 2.863924L - 1)) / (1 + twentieth(r / 2.863924L - 0.759692L)); }
  real phi(real r) const {
    const real u = r / 2.863924L;
    return 0.314873L * std::exp(-6.613165L * (u - 1)) / (1 + twentieth(u - 0.379846L)) -
           0.365551L * std::exp(-3.527021L * (u - 1)) / (1 + twentieth(u - 0.759692L));
  }
  real F(real rho) const {
    const real e = 20.418205L, low = rho / (0.85L * e) - 1, mid = rho / e - 1, y = rho / 23.195740L;
    if (rho < 0.85L * e) return -2.807602L - 0.301435L * low + 1.258562L * low * low - 1.247604L * low * low * low;
    if (rho < 1.15L * e) return -2.83L + 0.622245L * mid * mid - 2.488244L * mid * mid * mid;
    return -2.824528L * (1 - 0.785902L * std::log(y)) * std::pow(y, 0.785902L);
  }
};

/// A made-up body-centred metal with a cut-off that has a jump, for the sums of a bcc crystal. Also a library potential (double).
struct made_up_bcc {
  static constexpr bool bcc = true;
  real a0() const { return 2.87L; }
  real mass() const { return 55.845L; }
  real reach() const { return 6.335L; }
  real f(real r) const { return r * r * std::exp(-2.1L * r); }
  real phi(real r) const { return 900.0L * std::exp(-3.4L * r) - 14.0L / (r * r * r); }
  real F(real rho) const { return -2.3L * std::sqrt(rho) + 0.11L * rho * rho; }
};

using deformation = std::array<std::array<real, 3>, 3>; // rows: r = D X
inline deformation stretch(real x, real y, real z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }

/// {rho, 1/2 sum phi} of the crystal with cell edge a, deformed by D: for every cell and every atom in it.
template <class P> std::array<real, 2> brute_sums(const P& p, real a, const deformation& D) {
  const real half = 0.5L;
  const std::array<std::array<real, 3>, 4> fcc{{{0, 0, 0}, {0, half, half}, {half, 0, half}, {half, half, 0}}};
  const std::array<std::array<real, 3>, 2> bcc{{{0, 0, 0}, {half, half, half}}};
  const int cells = static_cast<int>(p.reach() / a) + 3;
  real rho = 0, pair = 0;
  const auto site = [&](const std::array<real, 3>& s) {
    real r2 = 0;
    for (const auto& row : D) {
      const real c = a * (row[0] * s[0] + row[1] * s[1] + row[2] * s[2]);
      r2 += c * c;
    }
    const real r = std::sqrt(r2);
    if (r > p.reach() || r < 0.1L) return;
    rho += p.f(r);
    pair += p.phi(r) / 2;
  };
  for (int i = -cells; i <= cells; ++i)
    for (int j = -cells; j <= cells; ++j)
      for (int k = -cells; k <= cells; ++k) {
        if constexpr (P::bcc) for (const auto& b : bcc) site({i + b[0], j + b[1], k + b[2]});
        else for (const auto& b : fcc) site({i + b[0], j + b[1], k + b[2]});
      }
  return {rho, pair};
}

inline real brute_cai_ye::F(real rho) const {
  static const real scale[2] = {brute_sums(brute_cai_ye{false}, 4.05L, stretch(1, 1, 1))[0],
                                brute_sums(brute_cai_ye{true}, 4.05L, stretch(1, 1, 1))[0]};
  const real y = rho / scale[sharp ? 1 : 0];
  return -2.61L * (1 - 0.5L * std::log(y)) * std::sqrt(y) - 0.1392L * y;
}

/// eV per atom at x = V/V0, deformed by D on top.
template <class P> real brute_energy(const P& p, real x, const deformation& D = stretch(1, 1, 1)) {
  const auto s = brute_sums(p, p.a0() * std::cbrt(x), D);
  return p.F(s[0]) + s[1];
}

/// m3
template <class P> real brute_atom_volume(const P& p, real x) {
  const real a = p.a0() * 1e-10L;
  return a * a * a * x / (P::bcc ? 2 : 4);
}
inline constexpr real brute_eV = 1.602176634e-19L, brute_u = 1.66053906660e-27L;

struct brute_point {
  double energy, pressure, slope; // J/kg from x = 1, Pa, Pa
};
/// From energies at x, x (1 +- h), x (1 +- 2 h), x (1 +- 3 h): sixth order. Not for an x with a shell on the cut-off inside.
template <class P> brute_point brute_cold(const P& p, real x, real h = 2e-3L) {
  real E[7];
  for (int i = 0; i < 7; ++i) E[i] = brute_energy(p, x * (1 + h * (i - 3)));
  const real first = (45 * (E[4] - E[2]) - 9 * (E[5] - E[1]) + (E[6] - E[0])) / (60 * h * x);
  const real second = (-490 * E[3] + 270 * (E[4] + E[2]) - 27 * (E[5] + E[1]) + 2 * (E[6] + E[0])) / (180 * h * h * x * x);
  const real pascal = brute_eV / brute_atom_volume(p, 1);
  return {double((E[3] - brute_energy(p, 1)) * brute_eV / (p.mass() * brute_u)), double(-first * pascal), double(-second * pascal)};
}

} // namespace bolide::test
