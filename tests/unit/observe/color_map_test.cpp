// SPDX-License-Identifier: MIT
#include "bolide/observe/color_map.hpp"

#include <gtest/gtest.h>

namespace bolide::observe {
namespace {

/// CIE 1976 lightness L* (0..100) of an sRGB colour: an independent judge of the maps, which are made in Oklab.
double lightness(rgb c) {
  const auto linear = [](std::uint8_t v) {
    const double x = v / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

TEST(color_map, lightness_rises_evenly) {
  for (const color_map& map : {color_map::ember(), color_map::ocean(), color_map::grey()}) {
    const double first = lightness(map(0)), last = lightness(map(1));
    ASSERT_GT(last, first + 40);
    for (int i = 1; i <= 8; ++i) {
      const double step = lightness(map(i / 8.0)) - lightness(map((i - 1) / 8.0));
      EXPECT_NEAR(step, (last - first) / 8, 0.45 * (last - first) / 8) << i;
    }
  }
}

TEST(color_map, the_bright_end_still_shows_on_white) {
  for (const color_map& map : {color_map::ember(), color_map::ocean()}) EXPECT_LT(lightness(map(1)), 82);
}

TEST(color_map, ends_outside_and_not_a_number) {
  const color_map map = color_map::ember();
  EXPECT_EQ(map(-3), map(0));
  EXPECT_EQ(map(7), map(1));
  EXPECT_EQ(map(std::nan("")), (rgb{128, 128, 128}));
  EXPECT_EQ(color_map::grey()(0.5), (rgb{128, 128, 128}));
  EXPECT_EQ(color_map::grey()(0), black);
  EXPECT_EQ(color_map::grey()(1), white);
}

TEST(color_map, phases_differ_in_lightness_from_their_neighbours) {
  for (std::size_t i = 1; i < phase_palette.size(); ++i)
    EXPECT_GT(std::fabs(lightness(phase_palette[i].color) - lightness(phase_palette[i - 1].color)), 8) << phase_palette[i].label;
}

} // namespace
} // namespace bolide::observe
