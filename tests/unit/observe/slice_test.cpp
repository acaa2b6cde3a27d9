// SPDX-License-Identifier: MIT
// Sections and means about the axis of three-dimensional snapshots, and the measures of a three-dimensional cloud.
#include "bolide/observe/slice.hpp"
#include "bolide/observe/debris_cloud.hpp"
#include "bolide/observe/picture.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bolide::observe {
namespace {

constexpr double mm = 1e-3;

/// Particles (x, y, z) with velocity, mass 1 kg and volume 2 m3 each.
snapshot solid(std::vector<double> x, std::vector<double> v, std::vector<int> body = {}) {
  snapshot s;
  const std::size_t n = x.size() / 3;
  s.dimension = 3, s.spacing = 1, s.time = 2, s.step = 9, s.body = body.empty() ? std::vector<int>(n, 0) : body, s.body_names = {"sphere", "plate"};
  for (std::size_t i = 0; i < n; ++i) s.id.push_back(static_cast<std::uint32_t>(i));
  s.add("position", "m", 3, std::move(x)), s.add("velocity", "m/s", 3, std::move(v));
  s.add("mass", "kg", 1, std::vector<double>(n, 1.0)), s.add("volume", "m3", 1, std::vector<double>(n, 2.0));
  return s;
}

TEST(slice, keeps_what_lies_in_it_seen_along_its_axis) {
  const snapshot s = solid({0, 0, 5, 1, 0.5, 6, 2, 0.51, 7, 3, -0.5, 8}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const snapshot y = slice(s, 1, 0), x = slice(s, 0, 2, 2), z = slice(s, 2, 5.4);
  EXPECT_EQ(y.id, (std::vector<std::uint32_t>{0, 1, 3})) << "half a spacing to either side, borders included";
  EXPECT_EQ(y.dimension, 2);
  EXPECT_EQ(y.axis_letters(), "zx");
  EXPECT_EQ(y.at("position").data, (std::vector<double>{5, 0, 6, 1, 8, 3}));
  EXPECT_EQ(y.at("velocity").data, (std::vector<double>{3, 1, 6, 4, 12, 10}));
  EXPECT_EQ(y.at("volume").data, (std::vector<double>{2, 2, 2}));
  EXPECT_EQ(y.time, 2);
  EXPECT_EQ(x.axis_letters(), "yz");
  EXPECT_EQ(x.id, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(z.axis_letters(), "xy");
  EXPECT_EQ(z.at("position").data, (std::vector<double>{0, 0}));
  EXPECT_EQ(slice(s, 2, 100).size(), 0u);
  EXPECT_THROW(slice(s, 3, 0), bad_parameter);
  EXPECT_THROW(slice(y, 0, 0), bad_parameter) << "two dimensions already";
}

TEST(slice, around_the_axis_keeps_radius_speed_outwards_and_mass) {
  const snapshot s = solid({3, 4, 5, 0, 0, 1}, {6, 8, 7, 1, 0, 2});
  const snapshot r = around_axis(s, 4);
  EXPECT_TRUE(r.axisymmetric);
  EXPECT_EQ(r.axis_letters(), "rz");
  EXPECT_EQ(r.at("position").data, (std::vector<double>{5, 5, 0, 1}));
  EXPECT_EQ(r.at("velocity").data, (std::vector<double>{10, 7, 0, 2}));
  EXPECT_EQ(r.at("mass").data, (std::vector<double>{4, 4}));
  EXPECT_EQ(r.at("volume").data, (std::vector<double>{8, 8}));
  EXPECT_THROW(around_axis(s, 0.5), bad_parameter);
}

TEST(slice, pictures_take_a_slice_and_name_its_axes) {
  const snapshot s = solid({0, 0, 5 * mm}, {0, 0, 0});
  const window w{-10 * mm, 10 * mm, -10 * mm, 10 * mm};
  EXPECT_THROW(draw_panel({&s, paint::body(), ""}, w), bad_parameter);
  snapshot z = slice(s, 1, 0), named = z;
  named.axes = "qx";
  const picture_style small{.width = 200, .text = 10};
  const image a = draw_panel({&z, paint::body(), ""}, w, small), b = draw_panel({&named, paint::body(), ""}, w, small);
  long different = 0;
  for (int j = 0; j < a.height(); ++j)
    for (int i = 0; i < a.width(); ++i) different += !(a(i, j) == b(i, j));
  EXPECT_GT(different, 0) << "the label of the horizontal axis";
  EXPECT_LT(different, 400);
  EXPECT_EQ(a(66 + 150, 36 + 100), line_palette[0]) << "z = 5 mm to the right";
}

/// A square plate of side 2 x 20 mm and 2 mm thick at rest, with a hole of that radius, on a lattice: all of it, or the quarter x, y > 0.
snapshot plate_with_hole(double radius, double spacing, bool quarter) {
  std::vector<double> x;
  const int n = static_cast<int>(20 * mm / spacing + 0.5), layers = static_cast<int>(2 * mm / spacing + 0.5);
  for (int i = quarter ? 0 : -n; i < n; ++i)
    for (int j = quarter ? 0 : -n; j < n; ++j)
      for (int k = 0; k < layers; ++k)
        if (std::hypot(i + 0.5, j + 0.5) * spacing > radius) x.insert(x.end(), {(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing});
  const std::size_t count = x.size() / 3;
  snapshot s = solid(std::move(x), std::vector<double>(3 * count, 0.0), std::vector<int>(count, 1));
  s.spacing = spacing;
  return s;
}

TEST(debris_cloud_3d, hole_of_a_square_plate) {
  const impact_scene scene{.plate_front_z = 0, .plate_rear_z = 2 * mm, .impact_speed = 1000};
  for (const double radius : {4.0 * mm, 7.3 * mm})
    for (const bool quarter : {false, true}) {
      const double spacing = 0.25 * mm, found = hole_diameter_of(plate_with_hole(radius, spacing, quarter), scene);
      EXPECT_NEAR(found, 2 * radius, spacing) << radius << " " << quarter;
    }
}

TEST(debris_cloud_3d, radial_measures_are_about_the_axis) {
  // 1000 particles on a cone of directions: radius i / 1000 m at 37 degrees, v_r = 2 i, v_z = 1000 + i, a swirl of 50 m/s that is no expansion
  std::vector<double> x, v;
  const double c = std::cos(0.65), sn = std::sin(0.65);
  for (int i = 1; i <= 1000; ++i) {
    x.insert(x.end(), {i * mm * c, i * mm * sn, 1 + i * mm});
    v.insert(v.end(), {2 * i * c - 50 * sn, 2 * i * sn + 50 * c, 1000.0 + i});
  }
  const impact_scene scene{.plate_front_z = 0, .plate_rear_z = 2 * mm, .impact_speed = 1000};
  const debris_cloud cloud(solid(std::move(x), std::move(v)), scene);
  EXPECT_NEAR(cloud.width, 2 * 0.999, 1e-12);
  EXPECT_NEAR(cloud.expansion_speed, 2 * 995, 1e-9) << "median of the outermost 11";
  EXPECT_NEAR(cloud.front_speed, 1995, 1e-9);
  EXPECT_NEAR(cloud.mass_downstream, 1000, 1e-9);
}

} // namespace
} // namespace bolide::observe
