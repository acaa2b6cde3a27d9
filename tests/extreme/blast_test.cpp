// SPDX-License-Identifier: MIT
// Extremes 5 and 6: the double blast wave (Woodward and Colella) and free expansion into vacuum. Sedov from one particle:
// sedov_slow_test.cpp.
#include "extreme/noh.hpp"

namespace bolide {
namespace {
using namespace extreme;

using float_apic_musl = method<shape::quadratic_bspline, transfer::apic, scheme::musl, float>;

/// The double blast wave by a Lagrangian Godunov scheme of first order in time with two-shock states at the faces (Dukowicz's linear form,
/// impedance rho c): an independent answer to hold the peak against. Zones keep their mass, so the contacts stay sharp. Returns the density
/// at t 0.038 in `bins` equal parts.
std::vector<double> blast_reference(int zones, int bins) {
  constexpr double gamma = 1.4;
  const auto n = static_cast<std::size_t>(zones);
  const double dx = 1.0 / zones;
  std::vector<double> x(n + 1), u(n, 0.0), e(n), rho(n, 1.0), p(n), z(n), pf(n + 1), uf(n + 1);
  for (std::size_t i = 0; i <= n; ++i) x[i] = static_cast<double>(i) * dx;
  for (std::size_t i = 0; i < n; ++i) {
    const double centre = (static_cast<double>(i) + 0.5) * dx;
    e[i] = (centre < 0.1 ? 1000 : centre < 0.9 ? 0.01 : 100) / (gamma - 1);
  }
  for (double t = 0; t < 0.038;) {
    double dt = 0.038 - t;
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = (gamma - 1) * rho[i] * e[i];
      z[i] = std::sqrt(gamma * p[i] * rho[i]);
      dt = std::min(dt, 0.4 * (x[i + 1] - x[i]) * rho[i] / z[i]);
    }
    uf[0] = uf[n] = 0;
    pf[0] = p[0] - z[0] * u[0];
    pf[n] = p[n - 1] + z[n - 1] * u[n - 1];
    for (std::size_t i = 1; i < n; ++i) {
      const std::size_t l = i - 1;
      // impedances stiffened by the jump: z + rho (gamma + 1)/2 |u* - u|, one pass
      const double guess = (z[l] * u[l] + z[i] * u[i] + p[l] - p[i]) / (z[l] + z[i]);
      const double a = z[l] + rho[l] * 0.5 * (gamma + 1) * std::max(0.0, u[l] - guess),
                   b = z[i] + rho[i] * 0.5 * (gamma + 1) * std::max(0.0, guess - u[i]);
      uf[i] = (a * u[l] + b * u[i] + p[l] - p[i]) / (a + b);
      pf[i] = (b * p[l] + a * p[i] + a * b * (u[l] - u[i])) / (a + b);
    }
    for (std::size_t i = 0; i <= n; ++i) x[i] += dt * uf[i];
    for (std::size_t i = 0; i < n; ++i) {
      const double before = u[i];
      u[i] += dt / dx * (pf[i] - pf[i + 1]);
      e[i] += dt / dx * (pf[i] * uf[i] - pf[i + 1] * uf[i + 1]) - 0.5 * (u[i] * u[i] - before * before);
      rho[i] = dx / (x[i + 1] - x[i]);
    }
    t += dt;
  }
  std::vector<double> density(static_cast<std::size_t>(bins), 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (auto k = static_cast<std::size_t>(x[i] * bins); k < density.size() && static_cast<double>(k) < x[i + 1] * bins; ++k) {
      const double low = static_cast<double>(k) / bins, high = static_cast<double>(k + 1) / bins;
      density[k] += rho[i] * bins * std::max(0.0, std::min(high, x[i + 1]) - std::max(low, x[i]));
    }
  return density;
}

template <class Method> class Blast : public testing::Test {};
using methods = testing::Types<bspline_apic_musl, bspline_flip_musl, float_apic_musl>;
TYPED_TEST_SUITE(Blast, methods, method_names);
template <class Method> viscosity::bulk weak() {
  return Method::transfer_type::affine ? viscosity::bulk{0.1, 0.1} : viscosity::bulk{0.67, 1};
}

TYPED_TEST(Blast, TwoBlastWavesMeet) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  double error[3], peak = 0, own = 0; // own: how far two resolutions of the reference are apart
  int k = 0;
  for (const int cells : {100, 200, 400}) {
    const auto reference = blast_reference(2400, cells), coarser = blast_reference(1200, cells);
    own = 0;
    for (std::size_t c = 0; c < reference.size(); ++c) own += std::abs(coarser[c] - reference[c]) / cells;
    const double h = 1.0 / cells;
    const auto matter = gas(1.4, 1, weak<TypeParam>());
    const auto part = [&](const char* name, double from, double to, double p, int per_cell) {
      return body{name, box{point{from}, point{to}}, matter, h / per_cell, initial_state{1, p / 0.4}};
    };
    auto sim = make<TypeParam, space::planar_1d>(h, one_thread<T>(), part("left", 0, 0.1, 1000, 24), part("middle", 0.1, 0.9, 0.01, 4),
                                                 part("right", 0.9, 1, 100, 24));
    sim.add(grid::mirror{0, 0, true}).add(grid::mirror{0, 1, false});
    sim.run(0.038);
    is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-3, sizeof(T) == 8 ? 1e-9 : 1e-2, 2});
    std::vector<double> mass(reference.size(), 0.0);
    for_each_particle(sim, [&](const auto& s, std::size_t i) {
      mass[std::min(static_cast<std::size_t>(value<field::position>(s, i) / h), mass.size() - 1)] += value<field::mass>(s, i);
    });
    error[k] = 0;
    for (std::size_t c = 0; c < mass.size(); ++c) error[k] += std::abs(mass[c] / h - reference[c]) / cells; // mean density is 1
    const auto density = profile(sim, 1, h, cells);
    peak = *std::max_element(density.begin(), density.end()) / *std::max_element(reference.begin(), reference.end()) - 1;
    std::printf("[ figures  ] %d cells: L1 error of the density %.4f, peak %+.3f\n", cells, error[k], peak);
    ++k;
  }
  const auto row = [&](const char* measure, double got, double order) {
    verify::record({.section = "extremes",
                    .problem = "double blast wave, t 0.038, 400 cells",
                    .composition = composition<TypeParam, space::planar_1d>(),
                    .measure = measure,
                    .value = got,
                    .order = order,
                    .note = "reference: Lagrangian Godunov scheme of 2400 zones, itself " + to_text(std::round(1000 * own) / 1000) +
                            " from 1200 zones"});
  };
  row("density, L1 error over its mean", error[2], std::log2(error[1] / error[2]));
  row("density peak, error", peak, verify::none);
  EXPECT_LT(error[2], 0.18);
  EXPECT_LT(error[2], error[0]);
}

/// Gas of e = 1, gamma 5/3 with a free surface: u = (2/(gamma+1)) (c + x/t) behind the front at 2c/(gamma-1) = 3.16228.
TYPED_TEST(Blast, TheFreeExpansionFrontIsNotOvertaken) {
  using point = vec<double, 1>;
  using T = typename TypeParam::scalar;
  const double h = 0.01, t = 0.5, gamma = 5.0 / 3, c = std::sqrt(gamma * (gamma - 1)), front = 2 * c / (gamma - 1);
  auto sim = make<TypeParam, space::planar_1d>(
      h, one_thread<T>(), body{"gas", box{point{-1.}, point{0.}}, gas(gamma, 1, weak<TypeParam>()), h / 8, initial_state{1, 1}});
  sim.add(grid::mirror{0, -1, true});
  sim.run(t);
  is_sound(sim, {sizeof(T) == 8 ? 1e-9 : 1e-3, sizeof(T) == 8 ? 1e-9 : 1e-2, 2});
  double error = 0, scale = 0, fastest = 0, furthest = 0;
  for_each_particle(sim, [&](const auto& s, std::size_t i) {
    const double x = value<field::position>(s, i), v = value<field::velocity>(s, i), m = value<field::mass>(s, i);
    fastest = std::max(fastest, v);
    furthest = std::max(furthest, x / t);
    if (x < -c * t) return;
    const double exact = 2 / (gamma + 1) * (c + x / t);
    error += m * std::abs(v - exact);
    scale += m * exact;
  });
  const auto row = [&](const char* measure, double got, double bound) {
    verify::record({.section = "extremes",
                    .problem = "free expansion, gamma 5/3, 100 cells",
                    .composition = composition<TypeParam, space::planar_1d>(),
                    .measure = measure,
                    .value = got,
                    .bound = bound,
                    .note = floors(sim)});
    EXPECT_LT(got, bound) << measure;
  };
  row("fastest particle over the exact front", fastest / front, 1);
  row("furthest particle over the exact front", furthest / front, 1);
  row("velocity, mass-weighted error", error / scale, 0.05);
}

} // namespace
} // namespace bolide
