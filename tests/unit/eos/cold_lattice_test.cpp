// SPDX-License-Identifier: MIT
// The lattice sum of any embedded-atom potential: against an independent sum over all sites, against the reference tables of
// docs/eos.md to every printed digit, and its derivatives and elastic constants against differences of energies.
#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/potential/zhou04.hpp"
#include "unit/eos/brute_lattice.hpp"
#include "unit/eos/lanes.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace {
using namespace bolide;
using bolide::test::expect_close;
using bolide::test::real;

potential::zhou_parameters zhou_2001() {
  potential::zhou_parameters q;
  q.r_e = 2.886166, q.f_e = 1.392302, q.rho_e = q.rho_s = 20.226537;
  q.alpha = 6.942419, q.beta = 3.702623, q.A = 0.251519, q.B = 0.313394, q.kappa = 0.395132, q.lambda = 0.790264;
  q.Fn = {-2.806783, -0.276173, 0.893409, -1.637201};
  q.F = {-2.83, 0, 0.929508, -0.682320};
  q.eta = 0.779208, q.F_e = -2.829437;
  return q;
}

/// The made-up bcc metal with analytic derivatives, as a library potential.
struct bcc_potential {
  potential_value pair(double r) const {
    const double e = 900 * std::exp(-3.4 * r), t = 14 / (r * r * r);
    return {e - t, -3.4 * e + 3 * t / r, 3.4 * 3.4 * e - 12 * t / (r * r)};
  }
  potential_value density(double r) const {
    const double e = std::exp(-2.1 * r);
    return {r * r * e, (2 * r - 2.1 * r * r) * e, (2 - 4.2 * 2 * r + 2.1 * 2.1 * r * r) * e};
  }
  potential_value embedding(double rho) const {
    const double root = std::sqrt(rho);
    return {-2.3 * root + 0.11 * rho * rho, -1.15 / root + 0.22 * rho, 0.575 / (root * rho) + 0.22};
  }
  double reach() const { return 6.335; }
  double lattice_constant() const { return 2.87; }
  lattice structure() const { return lattice::bcc; }
  double mass() const { return 55.845; }
};
static_assert(EmbeddedAtomPotential<bcc_potential>);

/// Does a site cross the cut-off between x (1 - width) and x (1 + width)?
template <class P> bool crosses_cut(const P& p, double x, double width) {
  if (p.reach() >= 20) return false;
  for (const auto& s : potential::shells(P::bcc ? lattice::bcc : lattice::fcc, 6)) {
    const double at = std::pow(double(p.reach() / p.a0()) / s.distance, 3);
    if (std::abs(at - x) < width * x) return true;
  }
  return false;
}

template <class Cold, class Brute>
void expect_same_as_brute_sum(const Cold& cold, const Brute& brute, const std::vector<double>& places, const std::string& what) {
  int compared = 0;
  for (const double x : places) {
    if (crosses_cut(brute, x, 0.007)) continue;
    const auto a = cold.evaluate(x);
    const auto b = test::brute_cold(brute, real(x));
    const std::string at = what + " at x = " + std::to_string(x);
    expect_close(cold.energy_per_atom(x), double(test::brute_energy(brute, real(x))), 1e-10 / 10, 1, "E, " + at);
    expect_close(a.energy, b.energy, 1e-10, 4e5, "e_c, " + at);
    expect_close(a.pressure, b.pressure, 1e-10, 1e9, "p_c, " + at);
    expect_close(a.slope, b.slope, 1e-9, 1e9, "dp_c/dx, " + at); // the second difference of the independent sum has no more
    ++compared;
  }
  EXPECT_GE(compared, int(places.size()) - 4);
}
const std::vector<double> places{0.3,  0.37, 0.44, 0.5,    0.58, 0.66, 0.75, 0.83, 0.9, 0.97, 1.0,
                                 1.05, 1.12, 1.2,  1.3471, 1.45, 1.8,  2.1,  2.8,  4.1, 5.2};

TEST(ColdLattice, EqualsTheSumOverAllSites) {
  expect_same_as_brute_sum(cold::cai_ye{}, test::brute_cai_ye{false}, places, "Cai-Ye");
  expect_same_as_brute_sum(cold::cai_ye{cold::cutoff::sharp}, test::brute_cai_ye{true}, places, "Cai-Ye sharp");
}
TEST(ColdLattice, EqualsTheSumOverAllSitesZhou) {
  expect_same_as_brute_sum(cold::lattice{potential::zhou04{}}, test::brute_zhou04{}, places, "Zhou 2004");
}
TEST(ColdLattice, EqualsTheSumOverAllSitesOfABccCrystal) {
  expect_same_as_brute_sum(cold::lattice{bcc_potential{}}, test::made_up_bcc{}, places, "bcc");
  EXPECT_NEAR(cold::lattice{bcc_potential{}}.reference_density(), 2 * 55.845 * unit::u / std::pow(2.87e-10, 3), 1e-9);
}

// ---- the reference tables of docs/eos.md ----------------------------------------------------------------------------------------
TEST(ColdLattice, ReferenceTableZhou04) {
  const cold::lattice zhou{potential::zhou04{}};
  const double rows[][3] = {{0.3, 834.7, .05}, {0.4, 384.3, .05}, {0.5, 191.6, .05},  {0.6, 97.7, .05},      {0.7, 51.1, .05},
                            {0.8, 27.2, .05},  {0.9, 9.20, .005}, {1.1, -5.28, .005}, {1.3471, -9.55, .005}, {1.6, -12.88, .005},
                            {2, -12.67, .005}, {3, -7.01, .005},  {5, -4.81, .005}};
  for (const auto& r : rows) EXPECT_NEAR(zhou.evaluate(r[0]).pressure / 1e9, r[1], 1.05 * r[2]) << r[0];
  EXPECT_NEAR(zhou.cohesive_energy() / 1e6, 12.802, .0005);
}

struct summary {
  double density, density_digit, cohesion, pressure, pressure_digit, B, derivative, C11, C12, C44, elastic_digit, vacancy;
};
template <class Cold> void expect_summary(const Cold& c, const summary& s, const std::string& what) {
  EXPECT_NEAR(c.reference_density(), s.density, s.density_digit) << what;
  EXPECT_NEAR(c.cohesive_energy_per_atom(), s.cohesion, .00005) << what;
  EXPECT_NEAR(c.evaluate(1.0).pressure, s.pressure, s.pressure_digit) << what;
  EXPECT_NEAR(c.bulk_modulus() / 1e9, s.B, .005) << what;
  EXPECT_NEAR(c.bulk_modulus_derivative(), s.derivative, .005) << what;
  const auto e = c.elastic_constants();
  EXPECT_NEAR(e.C11 / 1e9, s.C11, s.elastic_digit) << what;
  EXPECT_NEAR(e.C12 / 1e9, s.C12, s.elastic_digit) << what;
  EXPECT_NEAR(e.C44 / 1e9, s.C44, s.elastic_digit) << what;
  EXPECT_NEAR(c.vacancy_energy(), s.vacancy, .0005) << what;
}
TEST(ColdLattice, ReferenceTableOfConstants) {
  expect_summary(cold::cai_ye{cold::cutoff::sharp}, {2697.85, .005, 3.3183, 4.50e6, .005e6, 76.77, 4.71, 89.7, 70.3, 33.1, .05, 0.735},
                 "Cai-Ye sharp");
  expect_summary(cold::cai_ye{}, {2697.85, .005, 3.3188, -20.6e6, .05e6, 76.61, 4.705, 89.5, 70.2, 33.0, .05, 0.736}, "Cai-Ye");
  expect_summary(cold::lattice{potential::zhou04{zhou_2001()}}, {2635.5, .05, 3.5800, -14e3, .5e3, 96.60, 4.38, 127, 81, 36, .5, 0.807}, "Zhou 2001");
  expect_summary(cold::lattice{potential::zhou04{}}, {2697.4, .05, 3.5800, -45e3, .5e3, 75.91, 3.97, 107, 60, 28, .5, 0.796}, "Zhou 2004");
}
TEST(ColdLattice, MinimumOfTheColdPressure) {
  const auto lowest = [](const auto& cold, double x, double pressure, double digit_x, double digit_p) {
    double best = 0, at = 0;
    for (double s = 1.3; s < 2; s += 1e-4)
      if (const double p = cold.evaluate(s).pressure / 1e9; p < best) best = p, at = s;
    EXPECT_NEAR(best, pressure, digit_p);
    EXPECT_NEAR(at, x, digit_x);
  };
  lowest(cold::cai_ye{cold::cutoff::sharp}, 1.511, -11.79, .0005, .005);
  lowest(cold::lattice{potential::zhou04{}}, 1.80, -14.0, .005, .05);
}

// ---- derivatives ------------------------------------------------------------------------------------------------------------------
template <class Cold> void expect_derivatives(const Cold& cold, const std::string& what) {
  for (double x = 0.3; x < 6; x *= 1.0731) {
    const double h = 1e-4 * x;
    const auto d = [&](auto get) {
      return (8 * (get(cold.evaluate(x + h)) - get(cold.evaluate(x - h))) -
              (get(cold.evaluate(x + 2 * h)) - get(cold.evaluate(x - 2 * h)))) /
             (12 * h);
    };
    const auto c = cold.evaluate(x);
    expect_close(-cold.reference_density() * d([](auto p) { return p.energy; }), c.pressure, 3e-9, 1e9,
                 what + ": p = -de/dV at x = " + std::to_string(x));
    expect_close(d([](auto p) { return p.pressure; }), c.slope, 3e-9, 1e9, what + ": dp/dx at x = " + std::to_string(x));
  }
}
TEST(ColdLattice, PressureIsMinusTheEnergySlope) {
  expect_derivatives(cold::lattice{potential::zhou04{}}, "Zhou 2004");
  expect_derivatives(cold::lattice{potential::zhou04{zhou_2001()}}, "Zhou 2001");
}

// Deformations that keep the volume: E/V = (C11 - C12) d^2 for diag(1 + d, 1/(1 + d), 1), 2 C44 d^2 for the shear, at any pressure.
template <class Cold, class Brute> void expect_elastic(const Cold& cold, const Brute& brute, real x, const std::string& what) {
  const real E0 = test::brute_energy(brute, x), pascal = test::brute_eV / test::brute_atom_volume(brute, x);
  const auto second = [&](auto energy) { // d^2E/dd^2 at d = 0, sixth order
    const real d = 3e-3L;
    return (-490 * E0 + 270 * (energy(d) + energy(-d)) - 27 * (energy(2 * d) + energy(-2 * d)) + 2 * (energy(3 * d) + energy(-3 * d))) /
           (180 * d * d) * pascal;
  };
  const real tetragonal = second([&](real d) { return test::brute_energy(brute, x, test::stretch(1 + d, 1 / (1 + d), 1)); }) / 2;
  const real shear = second([&](real d) { return test::brute_energy(brute, x, {{{1, d, 0}, {d, 1, 0}, {0, 0, 1 / (1 - d * d)}}}); }) / 4;
  const auto c = cold.elastic_constants(double(x));
  const std::string at = what + " at x = " + std::to_string(double(x));
  expect_close(c.C11 - c.C12, double(tetragonal), 1e-8, 1e9, "C11 - C12, " + at);
  expect_close(c.C44, double(shear), 1e-8, 1e9, "C44, " + at);
  expect_close((c.C11 + 2 * c.C12) / 3, cold.bulk_modulus(double(x)), 1e-12, 0, "B, " + at);
}
TEST(ColdLattice, ElasticConstantsAreThoseOfDeformedCrystals) {
  for (const real x : {0.6L, 1.0L, 1.2L}) {
    expect_elastic(cold::cai_ye{}, test::brute_cai_ye{false}, x, "Cai-Ye");
    expect_elastic(cold::lattice{potential::zhou04{}}, test::brute_zhou04{}, x, "Zhou 2004");
  }
  for (const real x : {0.8L, 1.0L}) expect_elastic(cold::lattice{bcc_potential{}}, test::made_up_bcc{}, x, "bcc");
}

TEST(ColdLattice, BulkModulusDerivative) {
  const cold::cai_ye cold;
  for (const real x : {0.7L, 1.0L}) { // B' from three independent points of the curve
    const real h = 1e-3L * x;
    const auto B = [&](real s) { return -double(s) * test::brute_cold(test::brute_cai_ye{}, s).slope; };
    const double dB = (B(x + h) - B(x - h)) / double(2 * h);
    EXPECT_NEAR(cold.bulk_modulus_derivative(double(x)), dB / test::brute_cold(test::brute_cai_ye{}, x).slope, 2e-4);
  }
}

// A periodic block of 4 x 4 x 4 cells, whole and with one atom taken out; every pair by its nearest image.
TEST(ColdLattice, VacancyEnergyOfAPeriodicBlock) {
  const test::brute_cai_ye brute{true};
  for (const double x : {0.9, 1.0}) {
    const real a = brute.a0() * std::cbrt(real(x));
    const int cells = 4;
    std::vector<std::array<real, 3>> atoms;
    for (int i = 0; i < 2 * cells; ++i)
      for (int j = 0; j < 2 * cells; ++j)
        for (int k = 0; k < 2 * cells; ++k)
          if ((i + j + k) % 2 == 0) atoms.push_back({i * a / 2, j * a / 2, k * a / 2});
    const auto energy = [&] {
      real total = 0;
      for (const auto& p : atoms) {
        real rho = 0, pair = 0;
        for (const auto& q : atoms) {
          real r2 = 0;
          for (std::size_t c = 0; c < 3; ++c) {
            const real d = p[c] - q[c], near = d - cells * a * std::round(d / (cells * a));
            r2 += near * near;
          }
          const real r = std::sqrt(r2);
          if (r < 0.1L || r > brute.reach()) continue;
          rho += brute.f(r), pair += brute.phi(r) / 2;
        }
        total += brute.F(rho) + pair;
      }
      return total;
    };
    const real whole = energy(), n = real(atoms.size());
    atoms.pop_back();
    const real formed = energy() - whole * (n - 1) / n;
    EXPECT_NEAR(cold::cai_ye(cold::cutoff::sharp).vacancy_energy(x), double(formed), 1e-11) << x;
  }
}

TEST(ColdLattice, GoesToFreeAtoms) {
  const cold::lattice zhou{potential::zhou04{}};
  expect_close(zhou.evaluate(1e6).energy, zhou.cohesive_energy(), 1e-12, 0, "cohesive energy");
  const cold::lattice bcc{bcc_potential{}};
  EXPECT_EQ(bcc.cohesive_energy_per_atom(), -bcc.energy_per_atom(1));
}

TEST(ColdLattice, BadPotentialsAreRefusedWithASentence) {
  struct reach_of_nothing : bcc_potential {
    double reach() const { return 0; }
  };
  try {
    cold::lattice bad{reach_of_nothing{}};
    FAIL() << "accepted";
  } catch (const bad_parameter& e) {
    EXPECT_STREQ(e.what(), "cold::lattice reach = 0 angstrom: must be > 0 and below 20 lattice constants (unit: angstrom)");
  }
}
} // namespace
