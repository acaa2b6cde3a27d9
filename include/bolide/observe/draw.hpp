// SPDX-License-Identifier: MIT
// Ink on an image: lines, discs, rectangles and text with smooth edges.
//
// A stroke of width w covers a pixel at distance d from its middle line by clip(w/2 + 1/2 - d, 0, 1). The pieces of one shape are
// joined by the largest coverage before they are blended once, so that crossings and joints do not get darker.
// Coordinates are pixels, x right, y down; the middle of pixel (i, j) lies at (i + 1/2, j + 1/2).
#pragma once

#include "bolide/observe/image.hpp"
#include "bolide/observe/stroke_font.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace bolide::observe {

enum class anchor { start, middle, end };

/// Draws all pieces with a round pen of that width as one shape.
inline void draw_strokes(image& on, const std::vector<pen_segment>& pieces, double width, rgb ink) {
  if (pieces.empty()) return;
  double x_low = 1e30, x_high = -1e30, y_low = 1e30, y_high = -1e30;
  for (const pen_segment& p : pieces) {
    x_low = std::min({x_low, p.x0, p.x1}), x_high = std::max({x_high, p.x0, p.x1});
    y_low = std::min({y_low, p.y0, p.y1}), y_high = std::max({y_high, p.y0, p.y1});
  }
  const double reach = width / 2 + 1;
  const auto column = [&](double x) { return static_cast<int>(std::clamp(std::floor(x), 0.0, double(on.width()))); };
  const auto line = [&](double y) { return static_cast<int>(std::clamp(std::floor(y), 0.0, double(on.height()))); };
  const int left = column(x_low - reach), right = column(x_high + reach + 1), top = line(y_low - reach), bottom = line(y_high + reach + 1);
  if (right <= left || bottom <= top) return;
  const std::size_t columns = static_cast<std::size_t>(right - left);
  std::vector<float> coverage(columns * static_cast<std::size_t>(bottom - top), 0.0f);
  for (const pen_segment& p : pieces) {
    const double ex = p.x1 - p.x0, ey = p.y1 - p.y0, length2 = ex * ex + ey * ey;
    // only the pixels that this piece can reach
    const int first_row = std::max(top, line(std::min(p.y0, p.y1) - reach));
    const int row_end = std::min(bottom, line(std::max(p.y0, p.y1) + reach + 1));
    const int first = std::max(left, column(std::min(p.x0, p.x1) - reach)), end = std::min(right, column(std::max(p.x0, p.x1) + reach + 1));
    for (int j = first_row; j < row_end; ++j)
      for (int i = first; i < end; ++i) {
        const double px = i + 0.5 - p.x0, py = j + 0.5 - p.y0;
        const double t = length2 > 0 ? std::clamp((px * ex + py * ey) / length2, 0.0, 1.0) : 0.0;
        const double distance = std::hypot(px - t * ex, py - t * ey);
        float& c = coverage[static_cast<std::size_t>(j - top) * columns + static_cast<std::size_t>(i - left)];
        c = std::max(c, static_cast<float>(std::clamp(width / 2 + 0.5 - distance, 0.0, 1.0)));
      }
  }
  for (int j = top; j < bottom; ++j)
    for (int i = left; i < right; ++i)
      on.blend(i, j, ink, coverage[static_cast<std::size_t>(j - top) * columns + static_cast<std::size_t>(i - left)]);
}

inline void draw_line(image& on, double x0, double y0, double x1, double y1, double width, rgb ink) {
  draw_strokes(on, {{x0, y0, x1, y1}}, width, ink);
}

/// Fills the pixels of columns [x, x + width) and rows [y, y + height).
inline void fill_rectangle(image& on, int x, int y, int width, int height, rgb ink) {
  for (int j = std::max(y, 0); j < std::min(y + height, on.height()); ++j)
    for (int i = std::max(x, 0); i < std::min(x + width, on.width()); ++i) on(i, j) = ink;
}

/// The outline of a rectangle, `width` pixels thick, just outside of it.
inline void draw_frame(image& on, int x, int y, int columns, int rows, int width, rgb ink) {
  fill_rectangle(on, x - width, y - width, columns + 2 * width, width, ink);
  fill_rectangle(on, x - width, y + rows, columns + 2 * width, width, ink);
  fill_rectangle(on, x - width, y, width, rows, ink);
  fill_rectangle(on, x + columns, y, width, rows, ink);
}

/// One line of text with its baseline at y (or, when it runs upwards, at x); `height` is that of the capitals, in pixels.
inline void draw_text(image& on, double x, double y, std::string_view text, double height, rgb ink = black, anchor at = anchor::start,
                      bool upwards = false) {
  const double width = text_width(text, height);
  const double shift = at == anchor::start ? 0 : at == anchor::middle ? -width / 2 : -width;
  std::vector<pen_segment> way = trace_text(text, height);
  for (pen_segment& p : way)
    p = upwards ? pen_segment{x - p.y0, y - p.x0 - shift, x - p.y1, y - p.x1 - shift}
                : pen_segment{x + p.x0 + shift, y - p.y0, x + p.x1 + shift, y - p.y1};
  draw_strokes(on, way, std::max(1.0, 0.125 * height), ink);
}

} // namespace bolide::observe
