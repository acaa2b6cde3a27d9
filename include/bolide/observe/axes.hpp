// SPDX-License-Identifier: MIT
// The frame of a picture: a window of space on a field of pixels, ticks with numbers, labels, colour bar, legend, scale bar.
//
// Equal aspect: a millimetre is as many pixels to the right as it is up. Ticks stand at multiples of 1, 2 or 5 times a power of ten.
// All sizes follow one number, the height of the capitals.
#pragma once

#include "bolide/observe/color_map.hpp"
#include "bolide/observe/draw.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

/// A rectangle of space, in metres: left to right and bottom to top.
struct window {
  double left = 0, right = 0, bottom = 0, top = 0;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  void validate() const {
    require(width() > 0 && std::isfinite(width()), "width of the window", width(), "more than 0", "m");
    require(height() > 0 && std::isfinite(height()), "height of the window", height(), "more than 0", "m");
  }
};

/// A window on a field of pixels.
struct plot_field {
  window space;
  int x = 0, y = 0, width = 0, height = 0; // pixels, upper left corner and size
  double pixels_per_metre() const { return width / space.width(); }
  double column(double horizontal) const { return x + (horizontal - space.left) * pixels_per_metre(); }
  double row(double vertical) const { return y + (space.top - vertical) * pixels_per_metre(); }
};

/// 1, 2 or 5 times a power of ten, so that `range` holds about `count` steps.
inline double nice_step(double range, double count) {
  const double raw = range / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

/// The multiples of `step` in [low, high].
inline std::vector<double> ticks(double low, double high, double step) {
  std::vector<double> at;
  const double slack = 1e-9 * step;
  for (double n = std::ceil((low - slack) / step); n * step <= high + slack; ++n) at.push_back(n * step);
  return at;
}

/// A tick's number with as many decimals as its step needs, and a true minus sign.
inline std::string tick_text(double value, double step) {
  const int decimals = static_cast<int>(std::fmax(0.0, std::ceil(-std::log10(step) - 1e-9)));
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, std::fabs(value));
  return value < -1e-9 * step ? std::string("\u2212") + buffer : buffer;
}

inline constexpr rgb ink{30, 30, 34};

struct axis_labels {
  std::string horizontal, vertical;
  bool mirrored = false; // the vertical axis counts upwards and downwards from the axis of symmetry
};

/// Frame, ticks, numbers (mm) and labels around a field; `text` is the height of capitals.
inline void draw_axes(image& on, const plot_field& f, const axis_labels& labels, double text) {
  const int line = std::max(1, static_cast<int>(text / 8 + 0.5));
  const double tick = 0.45 * text, mm = 1e-3;
  // about one number for every seven heights of text, the same step on both axes
  draw_frame(on, f.x, f.y, f.width, f.height, line, ink);
  const double step = nice_step(f.space.width() / mm, f.width / (7 * text));
  for (const double value : ticks(f.space.left / mm, f.space.right / mm, step)) {
    const double x = f.column(value * mm), y = f.y + f.height + line;
    draw_line(on, x, y, x, y + tick, line, ink);
    draw_text(on, x, y + tick + 1.75 * text, tick_text(value, step), text, ink, anchor::middle);
  }
  double widest = 0;
  for (const double value : ticks(f.space.bottom / mm, f.space.top / mm, step)) {
    const double x = f.x - line, y = f.row(value * mm);
    const std::string number = tick_text(labels.mirrored ? std::fabs(value) : value, step);
    draw_line(on, x - tick, y, x, y, line, ink);
    draw_text(on, x - tick - 0.6 * text, y + 0.5 * text, number, text, ink, anchor::end);
    widest = std::max(widest, text_width(number, text));
  }
  draw_text(on, f.x + f.width / 2.0, f.y + f.height + 4.6 * text, labels.horizontal, text, ink, anchor::middle);
  draw_text(on, f.x - tick - widest - 1.9 * text, f.y + f.height / 2.0, labels.vertical, text, ink, anchor::middle, true);
}

/// Dash-dot line along vertical = 0, the axis of symmetry.
inline void draw_symmetry_axis(image& on, const plot_field& f, double text) {
  const double y = f.row(0), dash = 1.6 * text, gap = 0.5 * text;
  if (y < f.y || y > f.y + f.height) return;
  for (double x = f.x; x < f.x + f.width; x += dash + 2 * gap + 1) {
    draw_line(on, x, y, std::min(x + dash, double(f.x + f.width)), y, 1, {170, 170, 176});
    if (x + dash + gap + 1 < f.x + f.width) draw_line(on, x + dash + gap, y, x + dash + gap + 1, y, 1, {170, 170, 176});
  }
}

/// Pixels that the numbers of a scale from low to high take.
inline double widest_tick(double low, double high, double step, double text) {
  double widest = 0;
  for (const double value : ticks(low, high, step)) widest = std::max(widest, text_width(tick_text(value, step), text));
  return widest;
}

/// Pixels that a colour bar takes at the right of its field.
inline double color_bar_width(double low, double high, double text) {
  return widest_tick(low, high, nice_step(high - low, 6), text) + 8 * text;
}

/// A colour bar at the right of a field, with numbers and an upright label.
inline void draw_color_bar(image& on, const plot_field& f, const color_map& map, double low, double high, const std::string& label,
                           double text) {
  const int x = f.x + f.width + static_cast<int>(1.8 * text), width = static_cast<int>(1.5 * text);
  const int line = std::max(1, static_cast<int>(text / 8 + 0.5));
  for (int j = 0; j < f.height; ++j) fill_rectangle(on, x, f.y + j, width, 1, map(1 - (j + 0.5) / f.height));
  draw_frame(on, x, f.y, width, f.height, line, ink);
  const double step = nice_step(high - low, 6), widest = widest_tick(low, high, step, text);
  for (const double value : ticks(low, high, step)) {
    const double y = f.y + f.height * (high - value) / (high - low), right = x + width + line;
    const std::string number = tick_text(value, step);
    draw_line(on, right, y, right + 0.35 * text, y, line, ink);
    draw_text(on, right + 0.9 * text, y + 0.5 * text, number, text, ink);
  }
  draw_text(on, x + width + 0.9 * text + widest + 2.3 * text, f.y + f.height / 2.0, label, text, ink, anchor::middle, true);
}

using legend_entries = std::vector<std::pair<std::string, rgb>>;

/// Pixels that a legend takes at the right of its field.
inline double legend_width(const legend_entries& entries, double text) {
  double widest = 0;
  for (const auto& entry : entries) widest = std::max(widest, text_width(entry.first, text));
  return entries.empty() ? 0 : widest + 5.2 * text;
}

/// Swatches with their words, from column x and `row` on downwards; returns the row below the last.
inline double draw_legend(image& on, int x, double row, const legend_entries& entries, double text, bool as_lines = false) {
  const int width = static_cast<int>(1.5 * text);
  for (const auto& [label, color] : entries) {
    const int top = static_cast<int>(row);
    if (as_lines) draw_line(on, x, top + width / 2.0, x + width, top + width / 2.0, std::max(1.5, text / 6), color);
    else fill_rectangle(on, x, top, width, width, color);
    draw_text(on, x + width + 0.8 * text, top + width / 2.0 + 0.5 * text, label, text, ink);
    row += 2.3 * text;
  }
  return row;
}

/// A bar of a round length in the lower right corner of a field.
inline void draw_scale_bar(image& on, const plot_field& f, double text, rgb color) {
  const double length = nice_step(f.space.width(), 7), pixels = length * f.pixels_per_metre();
  const double right = f.x + f.width - 1.6 * text, y = f.y + f.height - 1.6 * text;
  const int thick = std::max(2, static_cast<int>(text / 3));
  fill_rectangle(on, static_cast<int>(right - pixels), static_cast<int>(y), static_cast<int>(pixels), thick, color);
  const double step = nice_step(length / 1e-3, 1);
  draw_text(on, right - pixels / 2, y - 0.7 * text, tick_text(length / 1e-3, step) + " mm", text, color, anchor::middle);
}

} // namespace bolide::observe
