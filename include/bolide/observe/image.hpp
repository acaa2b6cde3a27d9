// SPDX-License-Identifier: MIT
// A plain RGB image, 8 bits a channel, row 0 on top: what pictures are drawn on and what png/write_png.hpp writes.
#pragma once

#include "bolide/core/contract.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide::observe {

/// A colour in sRGB.
struct rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const rgb&, const rgb&) = default;
};
inline constexpr rgb white{255, 255, 255}, black{0, 0, 0};

/// a + t (b - a) per channel, t in [0, 1]: ink of colour b that covers the share t of a pixel of colour a.
inline rgb mix(rgb a, rgb b, double t) {
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(from + t * (to - from) + 0.5);
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

class image {
 public:
  image() = default;
  image(int width, int height, rgb background = white) : width_(width), height_(height) {
    require(width >= 1 && width <= 32768, "width of the image", width, "in 1..32768", "pixels");
    require(height >= 1 && height <= 32768, "height of the image", height, "in 1..32768", "pixels");
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  /// Column x from the left, row y from the top.
  rgb& operator()(int x, int y) { return pixels_[index(x, y)]; }
  rgb operator()(int x, int y) const { return pixels_[index(x, y)]; }
  /// The first byte of row y; rows lie one after another without padding.
  const std::uint8_t* row(int y) const { return &pixels_[index(0, y)].r; }

  /// Covers the share `coverage` of a pixel; a pixel outside the image is ignored.
  void blend(int x, int y, rgb ink, double coverage) {
    if (!contains(x, y) || !(coverage > 0)) return;
    rgb& p = (*this)(x, y);
    p = mix(p, ink, coverage < 1 ? coverage : 1);
  }

  /// Copies `other` with its upper left corner at (x, y); what does not fit is cut off.
  void paste(const image& other, int x, int y) {
    for (int j = 0; j < other.height(); ++j)
      for (int i = 0; i < other.width(); ++i)
        if (contains(x + i, y + j)) (*this)(x + i, y + j) = other(i, j);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_ = 0, height_ = 0;
  std::vector<rgb> pixels_;
};
static_assert(sizeof(rgb) == 3, "bolide: rgb must be three bytes without padding, so that rows can be handed to a writer");

} // namespace bolide::observe
