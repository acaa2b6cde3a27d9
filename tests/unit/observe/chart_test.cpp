// SPDX-License-Identifier: MIT
// Charts: where a point lands, what is left out, what is refused.
#include "bolide/observe/chart.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

int count(const image& on, rgb color, int x0, int x1, int y0, int y1) {
  int n = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) n += on(x, y) == color;
  return n;
}
int count(const image& on, rgb color) { return count(on, color, 0, on.width(), 0, on.height()); }

constexpr chart_style small{400, 200, 10, 3};

TEST(chart, a_mark_lies_where_its_numbers_say) {
  chart c{"", "x", "y"};
  c.horizontal_range = {0, 4}, c.vertical_range = {-1, 1};
  c.marks("", {3}, {0.5});
  const image on = draw_chart(c, small);
  const int left = on.width() - 20 - 400, top = 36; // the field: 2 heights of text at the right, 3.6 above
  const int x = left + 300, y = top + 50;
  const rgb blue = line_palette[0];
  EXPECT_EQ(on(x, y), blue);
  EXPECT_EQ(count(on, blue), count(on, blue, x - 4, x + 4, y - 4, y + 4));
}

TEST(chart, a_line_has_a_gap_where_a_number_is_none) {
  chart c{"", "x", "y"};
  c.horizontal_range = {0, 4}, c.vertical_range = {0, 2};
  c.line("", {0, 1, 2, 3, 4}, {1.005, 1.005, std::nan(""), 1.005, 1.005}); // through the middle of a row of pixels
  const image on = draw_chart(c, small);
  const int left = on.width() - 20 - 400;
  EXPECT_GT(count(on, line_palette[0], left + 2, left + 98, 0, on.height()), 90);
  EXPECT_EQ(count(on, line_palette[0], left + 103, left + 297, 0, on.height()), 0);
  EXPECT_GT(count(on, line_palette[0], left + 302, left + 398, 0, on.height()), 90);
}

TEST(chart, what_lies_outside_the_ranges_is_cut_at_the_frame) {
  chart c{"", "x", "y"};
  c.horizontal_range = {0, 1}, c.vertical_range = {0, 1};
  c.line("", {-1, 2}, {0.5, 0.5}).marks("", {0.5, 0.5}, {5, -5});
  const image on = draw_chart(c, small);
  const int left = on.width() - 20 - 400;
  EXPECT_EQ(count(on, line_palette[0], 0, left, 0, on.height()) + count(on, line_palette[0], left + 400, on.width(), 0, on.height()), 0);
  EXPECT_EQ(count(on, line_palette[1]), 0);
}

TEST(chart, the_legend_takes_the_emptiest_corner) {
  chart c{"", "x", "y"};
  c.horizontal_range = {0, 1}, c.vertical_range = {0, 1};
  std::vector<double> x, y; // a band along the upper edge and one down the right
  for (int i = 0; i <= 100; ++i) x.push_back(i / 100.0), y.push_back(0.93), x.push_back(0.93), y.push_back(i / 100.0);
  c.marks("points", x, y);
  const image on = draw_chart(c, small);
  const int left = on.width() - 20 - 400, middle = 36 + 100;
  EXPECT_GT(count(on, line_palette[0], left, left + 100, middle, 36 + 200), 10); // its mark, lower left
}

TEST(chart, refuses_what_cannot_be_drawn) {
  chart c{"empty", "x", "y"};
  EXPECT_THROW(draw_chart(c), bad_parameter);
  EXPECT_THROW(c.line("a", {1, 2}, {1}), bad_parameter);
  c.line("one point", {1}, {1});
  EXPECT_THROW(draw_chart(c, {.width = 10}), bad_parameter);
  EXPECT_NO_THROW(draw_chart(c));
}

} // namespace
} // namespace bolide::observe
