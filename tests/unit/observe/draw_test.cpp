// SPDX-License-Identifier: MIT
// Image, font and strokes.
#include "bolide/observe/axes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace bolide::observe {
namespace {

double ink_sum(const image& on) {
  double sum = 0;
  for (int y = 0; y < on.height(); ++y)
    for (int x = 0; x < on.width(); ++x) sum += (255 - on(x, y).g) / 255.0;
  return sum;
}

TEST(image, blends_within_its_borders) {
  image on(4, 3);
  on.blend(1, 2, black, 0.5);
  on.blend(-1, 0, black, 1);
  on.blend(4, 0, black, 1);
  EXPECT_EQ(on(1, 2), (rgb{128, 128, 128}));
  EXPECT_NEAR(ink_sum(on), 0.5, 0.01);
  EXPECT_THROW(image(0, 5), bad_parameter);
}

TEST(draw, line_has_its_area) {
  image on(200, 100);
  draw_line(on, 20.3, 20.7, 170.1, 81.9, 4, black);
  const double length = std::hypot(170.1 - 20.3, 81.9 - 20.7);
  EXPECT_NEAR(ink_sum(on), 4 * length + 3.14159 * 4, 0.01 * 4 * length);
}

TEST(draw, crossing_strokes_are_not_blended_twice) {
  image on(40, 40);
  draw_strokes(on, {{5, 20, 35, 20}, {5, 20, 35, 20}}, 3.4, black);
  image once(40, 40);
  draw_line(once, 5, 20, 35, 20, 3.4, black);
  EXPECT_EQ(ink_sum(on), ink_sum(once));
}

TEST(draw, far_outside_is_harmless) {
  image on(40, 40);
  draw_line(on, -1e12, 5, -1e11, 7, 2, black);
  draw_text(on, 1e9, -1e9, "lost", 12);
  EXPECT_EQ(ink_sum(on), 0);
}

TEST(stroke_font, every_glyph_is_well_formed) {
  std::set<char32_t> seen;
  for (const detail::glyph& g : detail::glyphs) {
    EXPECT_TRUE(seen.insert(g.code).second) << static_cast<unsigned>(g.code);
    for (std::string_view rest = g.strokes; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const std::string_view stroke = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      EXPECT_NE(std::string_view("-~o.").find(stroke[0]), std::string_view::npos) << g.strokes;
      EXPECT_EQ(stroke.size() % 2, 1u) << g.strokes;
      EXPECT_GE(stroke.size(), stroke[0] == '.' ? 3u : stroke[0] == '-' ? 5u : 7u) << g.strokes;
      for (std::size_t i = 1; i < stroke.size(); ++i) {
        const double value = detail::base36(stroke[i]);
        EXPECT_TRUE(i % 2 == 1 ? value >= 0 && value <= g.width : value >= 0 && value <= 14) << g.strokes;
      }
    }
  }
  for (char32_t c = 32; c < 127; ++c) EXPECT_TRUE(seen.count(c)) << static_cast<unsigned>(c);
}

TEST(stroke_font, reads_utf8) {
  EXPECT_NEAR(text_width("\u00b5", 9), 5, 1e-12);
  EXPECT_NEAR(text_width("1", 9), 3, 1e-12);
  EXPECT_NEAR(text_width("1\u00b5", 9), 3 + 5 + letter_gap, 1e-12);
  EXPECT_NEAR(text_width("\u4e2d", 9), detail::unknown_glyph.width, 1e-12);
  EXPECT_EQ(text_width("", 9), 0);
}

TEST(stroke_font, text_is_as_wide_and_high_as_said) {
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
  for (const pen_segment& p : trace_text("HOME", 18)) {
    left = std::min({left, p.x0, p.x1}), right = std::max({right, p.x0, p.x1});
    low = std::min({low, p.y0, p.y1}), high = std::max({high, p.y0, p.y1});
  }
  EXPECT_NEAR(left, 0, 1e-12);
  EXPECT_NEAR(right, text_width("HOME", 18), 1e-12);
  EXPECT_NEAR(low, 0, 1e-12);
  EXPECT_NEAR(high, 18, 1e-12);
}

TEST(axes, ticks_are_round_and_inside) {
  EXPECT_NEAR(nice_step(70, 10), 5, 1e-12);
  EXPECT_NEAR(nice_step(0.007, 7), 0.001, 1e-15);
  EXPECT_NEAR(nice_step(9, 5), 2, 1e-12);
  EXPECT_EQ(ticks(-25, 45, 10), (std::vector<double>{-20, -10, 0, 10, 20, 30, 40}));
  EXPECT_EQ(ticks(-20, 0, 10), (std::vector<double>{-20, -10, 0}));
  EXPECT_EQ(tick_text(-5, 5), "\u22125");
  EXPECT_EQ(tick_text(0.25, 0.05), "0.25");
  EXPECT_EQ(tick_text(-1e-14, 5), "0");
}

} // namespace
} // namespace bolide::observe
