// SPDX-License-Identifier: MIT
// The forward Abel transform against bodies whose projection is known in closed form.
#include "bolide/observe/radiograph.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bolide::observe {
namespace {

constexpr double mm = 1e-3, density = 2785;

/// Rings on a half-offset lattice whose middles fulfil `inside(r, z)`.
template <class Inside> snapshot rings(double spacing, double extent, Inside&& inside) {
  snapshot s;
  std::vector<double> x, m;
  for (double r = spacing / 2; r < extent; r += spacing)
    for (double z = -extent + spacing / 2; z < extent; z += spacing)
      if (inside(r, z)) x.insert(x.end(), {r, z}), m.push_back(2 * std::numbers::pi * r * spacing * spacing * density);
  s.axisymmetric = true, s.spacing = spacing;
  const std::size_t n = m.size();
  s.add("position", "m", 2, std::move(x)), s.add("velocity", "m/s", 2, std::vector<double>(2 * n, 0.0));
  s.add("mass", "kg", 1, std::move(m));
  return s;
}
double total_mass(const snapshot& s) {
  double sum = 0;
  for (const double m : s.at("mass").data) sum += m;
  return sum;
}
const window around{-6 * mm, 6 * mm, -6 * mm, 6 * mm};

TEST(radiograph, mass_is_kept_to_round_off) {
  const snapshot s = rings(0.1 * mm, 5 * mm, [](double r, double z) { return std::hypot(r, z) < 4.75 * mm; });
  for (const int pixels : {1, 7, 120, 333})
    for (const double spread : {0.0, 0.37 * mm}) {
      const areal_density picture = project(s, around, pixels, pixels + 3, spread);
      EXPECT_NEAR(picture.mass(), total_mass(s), 1e-12 * total_mass(s)) << pixels << " " << spread;
    }
}

TEST(radiograph, one_ring_at_or_on_the_axis_keeps_its_mass) {
  for (const double r : {0.0, 1e-12, 0.01 * mm, 3.3 * mm}) {
    snapshot s = rings(0.1 * mm, 0.1 * mm, [](double, double z) { return z > 0; });
    s.columns[0].data = {r, 0.5 * mm};
    EXPECT_NEAR(project(s, around, 100, 100).mass(), total_mass(s), 1e-12 * total_mass(s)) << r;
  }
}

TEST(radiograph, sphere_gives_the_chord) {
  const double R = 4.75 * mm;
  double error[2];
  int k = 0;
  for (const double spacing : {0.1 * mm, 0.05 * mm}) {
    const snapshot s = rings(spacing, 5 * mm, [R](double r, double z) { return std::hypot(r, z) < R; });
    const areal_density picture = project(s, around, 120, 120);
    double sum = 0;
    int count = 0;
    for (int j = 0; j < 120; ++j)
      for (int i = 0; i < 120; ++i) {
        const double z = -6 * mm + (i + 0.5) * 0.1 * mm, x = 6 * mm - (j + 0.5) * 0.1 * mm, d = std::hypot(x, z);
        if (d > 0.9 * R) continue;
        const double exact = density * 2 * std::sqrt(R * R - d * d);
        EXPECT_NEAR(picture(i, j), exact, 0.8 * spacing / mm * exact);
        sum += std::fabs(picture(i, j) / exact - 1), ++count;
      }
    error[k++] = sum / count;
  }
  EXPECT_LT(error[0], 0.012);
  EXPECT_LT(error[1], 0.7 * error[0]) << "the staircase of the lattice, not the projection, is the error";
}

TEST(radiograph, cylinder_is_exact) {
  // a tube between two radii on the lattice has no staircase: pixels must hold the exact mean of the chord
  const snapshot s = rings(0.1 * mm, 5 * mm, [](double r, double z) { return r > 2 * mm && r < 4 * mm && std::fabs(z) < 3 * mm; });
  const areal_density picture = project(s, around, 120, 60);
  const auto area = [](double x, double R) { // integral of the chord from 0 to x by hand
    x = std::clamp(x, -R, R);
    return x * std::sqrt(R * R - x * x) + R * R * std::asin(x / R);
  };
  for (int j = 0; j < 60; ++j) {
    const double top = 6 * mm - j * 0.2 * mm, bottom = top - 0.2 * mm;
    const double exact = density * (area(top, 4 * mm) - area(bottom, 4 * mm) - area(top, 2 * mm) + area(bottom, 2 * mm)) / (0.2 * mm);
    EXPECT_NEAR(picture(60, j), exact, 5e-9 * density * 8 * mm) << j; // asin above loses half its digits at the limb
    EXPECT_NEAR(picture(10, j), 0, 1e-12);
  }
}

TEST(radiograph, thin_shell_brightens_towards_its_limb) {
  const double R = 4.5 * mm, w = 0.2 * mm;
  const snapshot s = rings(0.025 * mm, 5 * mm, [&](double r, double z) { return std::hypot(r, z) < R && std::hypot(r, z) > R - w; });
  const areal_density picture = project(s, around, 60, 60);
  const auto exact = [&](double d) {
    const double a = R - w;
    return density * 2 * (std::sqrt(R * R - d * d) - (d < a ? std::sqrt(a * a - d * d) : 0));
  };
  for (const int j : {5, 15, 25, 29}) { // x from 4.9 - ... to the middle at z = 0.1 mm
    const double x = 6 * mm - (j + 0.5) * 0.2 * mm, d = std::hypot(x, 0.1 * mm);
    if (d < 0.9 * R) {
      EXPECT_NEAR(picture(30, j), exact(d), 0.08 * exact(d)) << j;
    }
  }
  EXPECT_GT(picture(30, 8), 2.5 * picture(30, 29));
}

TEST(radiograph, part_outside_the_window_is_not_squeezed_in) {
  const snapshot s = rings(0.1 * mm, 5 * mm, [](double r, double z) { return std::hypot(r, z) < 4.75 * mm; });
  const window half{0, 6 * mm, 0, 6 * mm};
  EXPECT_NEAR(project(s, half, 40, 40).mass(), total_mass(s) / 4, 1e-9 * total_mass(s));
}

TEST(radiograph, blur_keeps_the_mean) {
  std::vector<double> value(31 * 21, 0.0);
  value[10 * 31 + 15] = 1;
  detail::blur(value, 31, 21, 1.7);
  double sum = 0, second = 0;
  for (int j = 0; j < 21; ++j)
    for (int i = 0; i < 31; ++i) sum += value[std::size_t(j * 31 + i)], second += value[std::size_t(j * 31 + i)] * (i - 15) * (i - 15);
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(second, 1.7 * 1.7, 0.02);
}

TEST(radiograph, picture_follows_the_law_of_absorption) {
  const snapshot s = rings(0.1 * mm, 5 * mm, [](double r, double z) { return r < 4 * mm && std::fabs(z) < 3 * mm; });
  const picture_style small{.width = 120, .text = 8};
  const radiograph_options options{.mu = 0.05, .spread = 0, .unsharpness = 0, .scale_bar = false};
  const image picture = draw_radiograph(s, around, "", options, small);
  const int left = static_cast<int>(6.6 * 8), top = static_cast<int>(3.6 * 8);
  const rgb middle = picture(left + 60, top + 60), empty = picture(left + 5, top + 5);
  EXPECT_NEAR(middle.r, 255 * std::exp(-0.05 * density * 8 * mm), 1.5);
  EXPECT_EQ(empty, white);
}

TEST(radiograph, refuses_with_a_sentence) {
  snapshot s = rings(0.1 * mm, 1 * mm, [](double, double) { return true; });
  EXPECT_THROW(draw_radiograph(s, around, "", {.mu = 0}), bad_parameter);
  EXPECT_THROW(project(s, around, 0, 5), bad_parameter);
  s.axisymmetric = false;
  EXPECT_THROW(project(s, around, 5, 5), bad_parameter);
}

} // namespace
} // namespace bolide::observe
