// SPDX-License-Identifier: MIT
// A chart: lines and marks of one quantity against another, for profiles, histories and comparisons with exact solutions.
//
//   observe::chart plot{"Pressure at 1 us", "z (mm)", "p (GPa)"};
//   plot.marks("particles", z, p);
//   plot.line("exact", z_exact, p_exact);
//   png::write_png("profile.png", observe::draw_chart(plot));
//
// Numbers are drawn as they are given: divide by the unit that the label names. Points that are not finite are left out (a line has a
// gap there). The axes hold all finite points and end at multiples of the tick step; `vertical_range` and `horizontal_range` set them.
// The legend lies in the corner of the field that holds the fewest points. Marks are discs, drawn over the lines.
// Cost: about 10 ms for 1000 points on 900 x 500 pixels.
#pragma once

#include "bolide/observe/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

struct chart {
  struct series {
    std::string label; // empty: not in the legend
    std::vector<double> x, y;
    bool as_marks;
    rgb color;
  };
  struct range {
    double low = 0, high = 0; // equal: from the points
  };

  std::string title, horizontal, vertical; // the labels with their units
  std::vector<series> curves{};
  range horizontal_range{}, vertical_range{};

  chart& line(std::string label, std::vector<double> x, std::vector<double> y) { return add(std::move(label), std::move(x), std::move(y), false); }
  chart& marks(std::string label, std::vector<double> x, std::vector<double> y) { return add(std::move(label), std::move(x), std::move(y), true); }

private:
  chart& add(std::string label, std::vector<double> x, std::vector<double> y, bool as_marks) {
    require(x.size() == y.size(), "ordinates of the curve \"" + label + "\"", static_cast<double>(y.size()),
            "as many as abscissas, " + std::to_string(x.size()));
    const rgb color = line_palette[curves.size() % line_palette.size()];
    curves.push_back({std::move(label), std::move(x), std::move(y), as_marks, color});
    return *this;
  }
};

struct chart_style {
  int width = 900, height = 520; // pixels, of the field inside the frame
  double text = 15;              // pixels, height of capitals
  double mark = 2.2;             // pixels, radius of a mark
};

namespace detail {
/// The field of a chart: values to pixels, each axis with its own scale.
struct chart_field {
  chart::range across, up;
  double across_step, up_step;
  int x, y, width, height;
  double column(double v) const { return x + (v - across.low) / (across.high - across.low) * width; }
  double row(double v) const { return y + (up.high - v) / (up.high - up.low) * height; }
};

template <class Get> chart::range range_of(const chart& c, const chart::range& asked, Get&& values) {
  if (asked.high > asked.low) return asked;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& s : c.curves)
    for (const double v : values(s))
      if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (!(low <= high)) return {0, 1};
  if (high - low <= 1e-12 * std::max(std::abs(low), std::abs(high))) {
    const double half = low == 0 ? 1 : 0.1 * std::abs(low);
    return {low - half, high + half};
  }
  const double step = nice_step(high - low, 8), margin = 0.02 * (high - low);
  const double floor_low = low >= 0 && low < margin ? 0 : std::floor((low - margin) / step) * step;
  return {floor_low, std::ceil((high + margin) / step) * step};
}

/// f(row of points) for every unbroken run of finite points, in pixels.
template <class F> void for_each_run(const chart::series& s, const chart_field& f, F&& run) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i <= s.x.size(); ++i) {
    const bool finite = i < s.x.size() && std::isfinite(s.x[i]) && std::isfinite(s.y[i]);
    if (finite) points.emplace_back(f.column(s.x[i]), f.row(s.y[i]));
    else if (!points.empty()) run(points), points.clear();
  }
}

inline void draw_series(image& on, const chart_field& f, const chart::series& s, const chart_style& style) {
  for_each_run(s, f, [&](const std::vector<std::pair<double, double>>& points) {
    std::vector<pen_segment> way;
    if (s.as_marks)
      for (const auto& [x, y] : points) way.push_back({x, y, x, y}), draw_strokes(on, way, 2 * style.mark, s.color), way.clear();
    for (std::size_t i = 1; !s.as_marks && i < points.size(); ++i)
      way.push_back({points[i - 1].first, points[i - 1].second, points[i].first, points[i].second});
    draw_strokes(on, way, std::max(1.5, style.text / 7), s.color);
  });
}

inline void draw_chart_axes(image& on, const chart_field& f, const chart& c, double text) {
  const int line = std::max(1, static_cast<int>(text / 8 + 0.5));
  const double tick = 0.45 * text, bottom = f.y + f.height;
  draw_frame(on, f.x, f.y, f.width, f.height, line, ink);
  for (const double v : ticks(f.across.low, f.across.high, f.across_step)) {
    draw_line(on, f.column(v), bottom + line, f.column(v), bottom + line + tick, line, ink);
    draw_text(on, f.column(v), bottom + line + tick + 1.75 * text, tick_text(v, f.across_step), text, ink, anchor::middle);
  }
  for (const double v : ticks(f.up.low, f.up.high, f.up_step)) {
    draw_line(on, f.x - line - tick, f.row(v), f.x - line, f.row(v), line, ink);
    draw_text(on, f.x - line - tick - 0.6 * text, f.row(v) + 0.5 * text, tick_text(v, f.up_step), text, ink, anchor::end);
  }
  draw_text(on, f.x + f.width / 2.0, bottom + 4.6 * text, c.horizontal, text, ink, anchor::middle);
  draw_text(on, 1.6 * text, f.y + f.height / 2.0, c.vertical, text, ink, anchor::middle, true);
  draw_text(on, f.x, f.y - 1.1 * text, c.title, 1.15 * text, ink);
}

/// Upper left corner of the legend: of the four corners the one with the fewest points in it.
inline std::pair<int, int> legend_place(const chart& c, const chart_field& f, int width, int height, int margin) {
  const std::array<std::pair<int, int>, 4> corners = {{{f.x + f.width - width - margin, f.y + margin},
                                                       {f.x + margin, f.y + margin},
                                                       {f.x + f.width - width - margin, f.y + f.height - height - margin},
                                                       {f.x + margin, f.y + f.height - height - margin}}};
  std::array<int, 4> inside{};
  for (const auto& s : c.curves)
    for_each_run(s, f, [&](const std::vector<std::pair<double, double>>& points) {
      for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 16; ++k) { // a line also between its points
          const double t = s.as_marks || i == 0 ? 0 : k / 16.0;
          const auto& before = points[i > 0 ? i - 1 : 0];
          const double x = points[i].first + t * (before.first - points[i].first), y = points[i].second + t * (before.second - points[i].second);
          for (std::size_t n = 0; n < 4; ++n)
            inside[n] += x > corners[n].first && x < corners[n].first + width && y > corners[n].second && y < corners[n].second + height;
        }
    });
  return corners[static_cast<std::size_t>(std::min_element(inside.begin(), inside.end()) - inside.begin())];
}

inline void draw_chart_legend(image& on, const chart_field& f, const chart& c, const chart_style& style) {
  legend_entries named;
  for (const auto& s : c.curves)
    if (!s.label.empty()) named.emplace_back(s.label, s.color);
  if (named.empty()) return;
  const double text = style.text;
  const auto [x, y] = legend_place(c, f, static_cast<int>(legend_width(named, text) - 2.5 * text),
                                   static_cast<int>(2.3 * text * static_cast<double>(named.size())), static_cast<int>(text));
  double row = y;
  for (const auto& s : c.curves) {
    if (s.label.empty()) continue;
    const double right = x + 1.5 * text, middle = row + 0.75 * text;
    if (s.as_marks) draw_line(on, (x + right) / 2, middle, (x + right) / 2, middle, 2 * style.mark, s.color);
    else draw_line(on, x, middle, right, middle, std::max(1.5, text / 7), s.color);
    draw_text(on, right + 0.8 * text, middle + 0.5 * text, s.label, text, ink);
    row += 2.3 * text;
  }
}
} // namespace detail

inline image draw_chart(const chart& c, const chart_style& style = {}) {
  require(!c.curves.empty(), "curves of the chart \"" + c.title + "\"", 0, "at least 1");
  require(style.width >= 100 && style.height >= 60, "width of a chart", style.width, "at least 100 by 60", "pixels");
  require(style.text >= 4 && style.text <= 0.1 * style.width, "height of the text", style.text, "at least 4 and at most a tenth of the width",
          "pixels");
  require(style.mark > 0, "radius of a mark", style.mark, "positive", "pixels");
  const double text = style.text;
  detail::chart_field f{};
  f.across = detail::range_of(c, c.horizontal_range, [](const auto& s) -> const auto& { return s.x; });
  f.up = detail::range_of(c, c.vertical_range, [](const auto& s) -> const auto& { return s.y; });
  f.y = static_cast<int>(3.6 * text), f.width = style.width, f.height = style.height;
  f.across_step = nice_step(f.across.high - f.across.low, style.width / (7 * text));
  f.up_step = nice_step(f.up.high - f.up.low, style.height / (5 * text));
  f.x = static_cast<int>(5 * text + widest_tick(f.up.low, f.up.high, f.up_step, text));
  image field(f.width, f.height); // curves are drawn on a copy of the field, so that they end at its border
  detail::chart_field local = f;
  local.x = local.y = 0;
  for (const bool marks : {false, true})
    for (const auto& s : c.curves)
      if (s.as_marks == marks) detail::draw_series(field, local, s, style);
  image on(f.x + f.width + static_cast<int>(2 * text), f.y + f.height + static_cast<int>(6 * text));
  on.paste(field, f.x, f.y);
  detail::draw_chart_axes(on, f, c, text);
  detail::draw_chart_legend(on, f, c, style);
  return on;
}

} // namespace bolide::observe
