// SPDX-License-Identifier: MIT
#include "bolide/observe/picture.hpp"

#include "synthetic_cloud.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

constexpr double mm = 1e-3;
const window square{-10 * mm, 10 * mm, -10 * mm, 10 * mm};

snapshot few(std::vector<double> position, std::vector<double> velocity, double spacing) {
  snapshot s;
  s.axisymmetric = true, s.spacing = spacing;
  const std::size_t n = position.size() / 2;
  s.body.assign(n, 0), s.body_names = {"one", "two"};
  s.add("position", "m", 2, std::move(position)), s.add("velocity", "m/s", 2, std::move(velocity));
  s.add("mass", "kg", 1, std::vector<double>(n, 1.0));
  return s;
}

/// Colours of the field alone: column i of 200 from the left, row j from the top.
rgb at(const image& picture, int i, int j, const picture_style& style) {
  return picture(static_cast<int>(6.6 * style.text) + i, static_cast<int>(3.6 * style.text) + j);
}
const picture_style small{.width = 200, .text = 10};

TEST(picture, a_particle_is_drawn_and_mirrored) {
  snapshot s = few({5 * mm, -3 * mm}, {0, 0}, 2 * mm); // r, z
  s.body = {1};
  const image picture = draw_panel({&s, paint::body(), ""}, square, small);
  const rgb color = line_palette[1];
  // z = -3 mm is column 70; r = 5 mm is row 50, mirrored 150
  EXPECT_EQ(at(picture, 70, 50, small), color);
  EXPECT_EQ(at(picture, 70, 150, small), color);
  EXPECT_EQ(at(picture, 70, 70, small), white);
  EXPECT_EQ(at(picture, 130, 50, small), white);
}

TEST(picture, a_lone_fine_particle_still_shows) {
  snapshot s = few({5 * mm, -3 * mm}, {0, 0}, 1e-6);
  const image picture = draw_panel({&s, paint::body(), ""}, square, small);
  double ink_there = 0;
  for (int j = 40; j < 60; ++j)
    for (int i = 60; i < 80; ++i) ink_there += (255 - at(picture, i, j, small).r) / double(255 - line_palette[0].r);
  EXPECT_NEAR(ink_there, 3.14159 * small.least_radius * small.least_radius, 0.5);
}

TEST(picture, dense_material_is_solid) {
  std::vector<double> position, velocity;
  for (double r = 0.1; r < 8; r += 0.2)
    for (double z = -4.9; z < 5; z += 0.2) position.insert(position.end(), {r * mm, z * mm}), velocity.insert(velocity.end(), {0, 0});
  const snapshot s = few(position, velocity, 0.2 * mm);
  const image picture = draw_panel({&s, paint::body(), ""}, square, small);
  for (int j = 22; j < 178; ++j)
    for (int i = 52; i < 148; ++i) ASSERT_EQ(at(picture, i, j, small), line_palette[0]) << i << " " << j;
}

TEST(picture, the_order_of_the_particles_does_not_matter) {
  const snapshot a = few({5 * mm, 0, 5 * mm, 0.51 * mm}, {0, 1000, 0, 4000}, 1 * mm);
  const snapshot b = few({5 * mm, 0.51 * mm, 5 * mm, 0}, {0, 4000, 0, 1000}, 1 * mm);
  const paint how = paint::speed().between(0, 5);
  const image one = draw_panel({&a, how, ""}, square, small), other = draw_panel({&b, how, ""}, square, small);
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) ASSERT_EQ(one(x, y), other(x, y));
  EXPECT_EQ(at(one, 97, 50, small), how.map(0.2)) << "nearest to the slow one";
  EXPECT_EQ(at(one, 108, 50, small), how.map(0.8));
}

TEST(picture, phases_and_failure_choose_the_colour) {
  snapshot s = few({5 * mm, -6 * mm, 5 * mm, 0, 5 * mm, 6 * mm}, {0, 0, 0, 0, 0, 0}, 2 * mm);
  s.add("region", "1", 1, {0, 0, 2}), s.add("failed", "1", 1, {0, 1, 1});
  const image picture = draw_panel({&s, paint::phase(), ""}, square, small);
  EXPECT_EQ(at(picture, 40, 50, small), phase_palette[0].color);
  EXPECT_EQ(at(picture, 100, 50, small), phase_palette[1].color);
  EXPECT_EQ(at(picture, 160, 50, small), phase_palette[3].color);
}

TEST(picture, window_ignores_runaways_and_the_plate_at_rest) {
  snapshot s = test::synthetic_cloud(0.1e-3);
  const window before = cloud_window(s);
  EXPECT_GT(before.right, 39 * mm);
  EXPECT_LT(before.right, 48 * mm);
  EXPECT_NEAR(before.left, -25 * mm, 1e-9);
  EXPECT_NEAR(before.top, 25 * mm, 1e-9);
  EXPECT_EQ(before.bottom, -before.top);
  s.columns[0].data[1] = 5.0, s.columns[1].data[1] = 7000, s.columns[2].data[0] *= 0.01; // one plate particle flies 5 m away
  EXPECT_NEAR(cloud_window(s).right, before.right, 1 * mm);
}

TEST(picture, value_range_is_round_and_robust) {
  snapshot s = test::synthetic_cloud(0.1e-3);
  for (column& c : s.columns)
    if (c.name == "temperature") c.data[0] = 1e7;
  const auto c = detail::color_particles(s, paint::temperature(), cloud_window(s));
  EXPECT_GE(c.low, 200);
  EXPECT_LE(c.high, 1500);
}

TEST(picture, panels_stand_side_by_side) {
  const snapshot s = test::synthetic_cloud(0.2e-3);
  curve c;
  c.points = {{0, 0.01}, {0.03, 0.02}}, c.label = "edge";
  const panel p{&s, paint::speed(), "a", {c}};
  const image one = draw_panel(p, square, small), sheet = draw_panels({p, p, p}, square, 2, "heading", small);
  EXPECT_EQ(sheet.width(), 2 * one.width());
  EXPECT_GT(sheet.height(), 2 * one.height());
}

TEST(picture, planar_section_is_not_mirrored) {
  snapshot s = few({-3 * mm, 5 * mm}, {0, 0}, 2 * mm); // x, y
  s.axisymmetric = false;
  const image picture = draw_panel({&s, paint::body(), ""}, square, small);
  EXPECT_EQ(at(picture, 70, 50, small), line_palette[0]);
  EXPECT_EQ(at(picture, 70, 150, small), white);
}

TEST(picture, refuses_with_a_sentence) {
  snapshot s = few({5 * mm, 0}, {0, 0}, 1 * mm);
  EXPECT_THROW(draw_panel({&s, paint::temperature(), ""}, square, small), bad_parameter);
  EXPECT_THROW(draw_panel({nullptr, paint::speed(), ""}, square, small), bad_parameter);
  EXPECT_THROW(draw_panel({&s, paint::speed(), ""}, {0, 0, 0, 1}, small), bad_parameter);
  EXPECT_THROW(paint::speed().between(5, 5), bad_parameter);
  s.dimension = 1;
  EXPECT_THROW(draw_panel({&s, paint::speed(), ""}, square, small), bad_parameter);
}

} // namespace
} // namespace bolide::observe
