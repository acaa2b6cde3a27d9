// SPDX-License-Identifier: MIT
// The layout of a figure: panels side by side, each with its axes, ticks and a legend where no curve runs.
#include "canvas.hpp"
#include "figure.hpp"

#include "bolide/observe/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace explorer {
namespace {

namespace observe = bolide::observe;
constexpr double text = 6.5, panel_width = 235, panel_height = 185; // points; of the field inside the frame
constexpr double left = 52, right = 14, top = 12, bottom = 40;
constexpr double row_height = 12, swatch = 20;

struct range {
  double low, high, step;
};

/// The step between numbers along the horizontal axis, so wide that none touches the next.
double roomy_step(const range& r) {
  for (double count = 6;; count -= 1) {
    const double step = observe::nice_step(r.high - r.low, count), room = panel_width * step / (r.high - r.low);
    if (count <= 2 || observe::widest_tick(r.low, r.high, step, text) + 1.5 * text < room) return step;
  }
}

/// The ticks' range around the data.
range nice_range(double low, double high) {
  if (!(high > low)) {
    const double half = low == 0 ? 1 : 0.1 * std::abs(low);
    low -= half, high += half;
  }
  const double width = high - low, step = observe::nice_step(width, 6);
  if (std::abs(low) < 0.01 * width) low = 0;
  return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, step};
}

/// No curve runs along the frame, except where 0 is its lower end.
range with_margin(range r, double low, double high) {
  const double width = r.high - r.low;
  if (r.high - high < 0.02 * width) r.high += 0.5 * r.step;
  if ((r.low != 0 || low < -0.003 * width) && low - r.low < 0.02 * width) r.low -= 0.5 * r.step;
  return r;
}

template <class Get> range range_of(const panel& p, const Get& values, bool upright) {
  double low = 1e300, high = -1e300;
  for (const curve& c : p.curves)
    for (std::size_t i = 0; i < values(c).size(); ++i) {
      const double error = upright && i < c.error.size() ? c.error[i] : 0;
      low = std::min(low, values(c)[i] - error), high = std::max(high, values(c)[i] + error);
    }
  if (!(low <= high)) return nice_range(0, 1);
  return upright ? with_margin(nice_range(low, high), low, high) : nice_range(low, high);
}

struct field {
  double x0, y0; // upper left corner, points
  range across, up;
  place at(double x, double y) const {
    return {x0 + panel_width * (x - across.low) / (across.high - across.low), y0 + panel_height * (up.high - y) / (up.high - up.low)};
  }
};

struct rectangle {
  double x, y, width, height;
  bool contains(place p) const { return p.x > x && p.x < x + width && p.y > y && p.y < y + height; }
};

std::vector<const curve*> legend_of(const panel& p) {
  std::vector<const curve*> entries;
  for (const curve& c : p.curves)
    if (!c.label.empty() && !c.x.empty()) entries.push_back(&c);
  return entries;
}

/// Does a curve run through the rectangle?
bool is_crossed(const rectangle& r, const panel& p, const field& f) {
  for (const curve& c : p.curves)
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      const place b = f.at(c.x[i], c.y[i]), a = i > 0 && c.style != line_style::marks ? f.at(c.x[i - 1], c.y[i - 1]) : b;
      for (int k = 0; k <= 40; ++k)
        if (r.contains({a.x + (b.x - a.x) * k / 40, a.y + (b.y - a.y) * k / 40})) return true;
      const double error = i < c.error.size() ? c.error[i] : 0;
      for (int k = -10; error > 0 && k <= 10; ++k)
        if (r.contains(f.at(c.x[i], c.y[i] + error * k / 10))) return true;
    }
  return false;
}

/// A corner that no curve crosses; where there is none the vertical axis grows until there is.
rectangle find_legend_place(const panel& p, field& f) {
  double width = 0;
  for (const curve* c : legend_of(p)) width = std::max(width, observe::text_width(c->label, text));
  width += swatch + 18;
  const double height = row_height * static_cast<double>(legend_of(p).size()) + 8;
  for (int grown = 0;; ++grown) {
    const double far_x = f.x0 + panel_width - width - 2, far_y = f.y0 + panel_height - height - 2;
    const std::array<rectangle, 4> corners = {{{f.x0 + 2, f.y0 + 2, width, height},
                                               {far_x, far_y, width, height},
                                               {far_x, f.y0 + 2, width, height},
                                               {f.x0 + 2, far_y, width, height}}};
    for (const rectangle& r : corners)
      if (!is_crossed(r, p, f)) return r;
    if (grown == 20) return corners[0];
    f.up.high += f.up.step;
  }
}

void draw_axes(canvas& on, const panel& p, const field& f) {
  using observe::anchor;
  const double end_x = f.x0 + panel_width, end_y = f.y0 + panel_height, tick = 3.5;
  const double step = roomy_step(f.across);
  for (const double v : observe::ticks(f.across.low, f.across.high, step)) {
    const double x = f.at(v, 0).x;
    on.line({{x, end_y}, {x, end_y - tick}}, 0.6, false, observe::ink);
    on.line({{x, f.y0}, {x, f.y0 + tick}}, 0.6, false, observe::ink);
    on.text({x, end_y + text + 5}, observe::tick_text(v, step), text, anchor::middle, false);
  }
  const range nice = nice_range(f.up.low, f.up.high); // as many numbers as fit: the axis may have grown for the legend
  double widest = 0;
  for (const double v : observe::ticks(f.up.low, f.up.high, nice.step)) {
    const double y = f.at(0, v).y;
    const std::string number = observe::tick_text(v, nice.step);
    on.line({{f.x0, y}, {f.x0 + tick, y}}, 0.6, false, observe::ink);
    on.line({{end_x, y}, {end_x - tick, y}}, 0.6, false, observe::ink);
    on.text({f.x0 - 5, y + text / 2}, number, text, anchor::end, false);
    widest = std::max(widest, observe::text_width(number, text));
  }
  on.line({{f.x0, f.y0}, {end_x, f.y0}, {end_x, end_y}, {f.x0, end_y}, {f.x0, f.y0}}, 0.8, false, observe::ink);
  on.text({f.x0 + panel_width / 2, end_y + 3 * text + 11}, p.horizontal, text, anchor::middle, false);
  on.text({f.x0 - widest - 12, f.y0 + panel_height / 2}, p.vertical, text, anchor::middle, true);
}

observe::rgb color_of(const curve& c) { return observe::line_palette[static_cast<std::size_t>(c.color) % observe::line_palette.size()]; }

void draw_curve(canvas& on, const curve& c, const field& f) {
  std::vector<place> way;
  for (std::size_t i = 0; i < c.x.size(); ++i) way.push_back(f.at(c.x[i], c.y[i]));
  if (c.style != line_style::marks) return on.line(way, 1.3, c.style == line_style::dashed, color_of(c));
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i < c.error.size())
      on.line({f.at(c.x[i], c.y[i] - c.error[i]), f.at(c.x[i], c.y[i] + c.error[i])}, 0.8, false, color_of(c));
    on.mark(way[i], 2.4, 1, color_of(c));
  }
}

void draw_legend(canvas& on, const panel& p, const rectangle& r) {
  double y = r.y + 4 + row_height / 2;
  for (const curve* c : legend_of(p)) {
    if (c->style == line_style::marks) on.mark({r.x + 6 + swatch / 2, y}, 2.4, 1, color_of(*c));
    else on.line({{r.x + 6, y}, {r.x + 6 + swatch, y}}, 1.3, c->style == line_style::dashed, color_of(*c));
    on.text({r.x + 12 + swatch, y + text / 2}, c->label, text, observe::anchor::start, false);
    y += row_height;
  }
}

bool has_same_legend(const panel& a, const panel& b) {
  const auto one = legend_of(a), other = legend_of(b);
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const curve* c, const curve* d) { return c->label == d->label; });
}

void draw_panel(canvas& on, const panel& p, double x0, bool with_legend) {
  field f{x0, top, range_of(p, [](const curve& c) -> const auto& { return c.x; }, false),
          range_of(p, [](const curve& c) -> const auto& { return c.y; }, true)};
  const rectangle legend = with_legend ? find_legend_place(p, f) : rectangle{};
  draw_axes(on, p, f);
  for (const bool marks : {false, true}) // marks lie on the lines
    for (const curve& c : p.curves)
      if ((c.style == line_style::marks) == marks) draw_curve(on, c, f);
  if (with_legend) draw_legend(on, p, legend);
}

} // namespace

void check_figure_name(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".png" && ending != ".svg") throw bolide::bad_parameter("--plot = '" + path + "': must end in .png or .svg");
}

void write_figure(const figure& f, const std::filesystem::path& path) {
  const double one = left + panel_width + right, width = one * static_cast<double>(f.panels.size());
  const double height = top + panel_height + bottom;
  const auto on = path.extension() == ".svg" ? svg_canvas(width, height) : png_canvas(width, height);
  for (std::size_t i = 0; i < f.panels.size(); ++i)
    draw_panel(*on, f.panels[i], one * static_cast<double>(i) + left, i == 0 || !has_same_legend(f.panels[i - 1], f.panels[i]));
  on->save(path);
}

} // namespace explorer
