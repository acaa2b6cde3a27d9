// SPDX-License-Identifier: MIT
// Colours that tell the truth: maps whose lightness rises evenly with the value, and palettes for categories.
//
// A map is a path in Oklab (B. Ottosson 2020, "A perceptual color space for image processing"): lightness L rises linearly, the
// hue turns linearly, the chroma follows a parabola and is cut to what sRGB can show. So equal steps of the value look like equal
// steps, in grey print too, and no hue makes an edge where the data have none. The maps end at L = 0.82: a lone particle of the
// highest value must still show on white paper.
//   ember   dark blue - violet - red - amber     (temperature, pressure)
//   ocean   dark violet - blue - green - lime    (speed)
//   grey    black - white
// Categories differ in lightness as well as in hue, so that they stay apart for the colour-blind.
// Cost: a map is a table of 256 colours, made once.
#pragma once

#include "bolide/observe/image.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bolide::observe {

namespace detail {
struct linear_rgb {
  double r, g, b;
  bool shown() const { return std::min({r, g, b}) >= -1e-6 && std::max({r, g, b}) <= 1 + 1e-6; }
};

/// Oklab in polar form (L, chroma, hue in radians) to linear sRGB.
inline linear_rgb from_oklab(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The sRGB transfer curve (IEC 61966-2-1) of one channel, to 8 bits.
inline std::uint8_t to_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(255 * y + 0.5);
}

/// The colour of that lightness and hue with the chroma asked for, or the largest below it that sRGB shows.
inline rgb from_polar(double lightness, double chroma, double hue) {
  while (chroma > 0 && !from_oklab(lightness, chroma, hue).shown()) chroma -= 0.002;
  const linear_rgb c = from_oklab(lightness, std::max(chroma, 0.0), hue);
  return {to_srgb(c.r), to_srgb(c.g), to_srgb(c.b)};
}
} // namespace detail

class color_map {
 public:
  /// One end of a map: lightness 0..1, chroma (0 is grey, 0.2 vivid), hue in degrees (30 red, 110 yellow, 145 green, 265 blue).
  struct stop {
    double lightness, chroma, hue;
  };

  /// From `low` to `high`, the chroma raised by `swell` half-way.
  color_map(stop low, stop high, double swell) {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(table_.size() - 1);
      const auto between = [t](double from, double to) { return from + t * (to - from); };
      const double chroma = between(low.chroma, high.chroma) + 4 * swell * t * (1 - t);
      table_[i] = detail::from_polar(between(low.lightness, high.lightness), chroma, between(low.hue, high.hue) * 3.14159265358979 / 180);
    }
  }

  static color_map ember() { return {{0.24, 0.11, -88}, {0.81, 0.17, 78}, 0.07}; }
  static color_map ocean() { return {{0.24, 0.10, 300}, {0.82, 0.17, 118}, -0.02}; }
  /// Grey with the level 255 t: the same grey that a film of transmission t has in a radiograph.
  static color_map grey() {
    color_map map({0, 0, 0}, {1, 0, 0}, 0);
    for (std::size_t i = 0; i < map.table_.size(); ++i) map.table_[i].r = map.table_[i].g = map.table_[i].b = static_cast<std::uint8_t>(i);
    return map;
  }

  /// The colour of t in [0, 1]; outside it the end's colour, for NaN a mid grey.
  rgb operator()(double t) const {
    if (!(t == t)) return {128, 128, 128};
    const double last = static_cast<double>(table_.size() - 1);
    return table_[static_cast<std::size_t>(std::clamp(t, 0.0, 1.0) * last + 0.5)];
  }

 private:
  std::array<rgb, 256> table_;
};

/// A category of a picture: what the legend says and its colour.
struct category {
  const char* label;
  rgb color;
};

/// State of the material: the regions of concepts/equation_of_state.hpp, the solid one split by whether it has failed.
inline constexpr std::array<category, 6> phase_palette{{{"solid", {52, 62, 82}},
                                                        {"solid, failed", {104, 152, 198}},
                                                        {"melting", {240, 176, 50}},
                                                        {"liquid", {212, 62, 40}},
                                                        {"hot liquid", {132, 28, 92}},
                                                        {"gas", {40, 150, 110}}}};

/// Colours for bodies and for curves of one picture; they repeat after six.
inline constexpr std::array<rgb, 6> line_palette{
    {{24, 84, 160}, {212, 84, 30}, {34, 136, 92}, {128, 60, 148}, {178, 140, 20}, {90, 90, 90}}};

} // namespace bolide::observe
