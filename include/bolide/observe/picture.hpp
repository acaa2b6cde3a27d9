// SPDX-License-Identifier: MIT
// Pictures of a debris cloud: the particles of a snapshot, drawn for a paper.
//
// An axisymmetric snapshot is a section through the axis: z to the right, r up and, mirrored, down. A plane one shows x and y. Of a
// three-dimensional one draw a slice or its mean about the axis (observe/slice.hpp).
// Each particle is a disc; a point of the picture has the colour of the particle whose middle is nearest, if it lies in that one's
// disc. So dense material is solid and shows its true mixture (no particle hides another because it was drawn later), while a lone
// fragment stays a visible dot: the discs have the radius 0.75 spacings, but at least `least_radius` pixels.
// Edges are smoothed by 3 x 3 samples a pixel.
// The window (cloud_window) and the range of colours follow mass quantiles, so that a few runaways shrink neither.
// Cost: about 0.1 s for a picture of 1100 pixels; memory 8 bytes a sample (60 MB).
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/observe/axes.hpp"
#include "bolide/observe/snapshot.hpp"
#include "bolide/observe/weighted_quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

/// What the colours mean.
struct paint {
  enum class kind { value, phase, body };
  kind by = kind::value;
  std::string column; // of the snapshot; "speed" is the length of the velocity
  std::string label;  // of the colour bar, with the unit shown
  double unit = 1;    // one shown unit in SI
  color_map map = color_map::ocean();
  double low = std::numeric_limits<double>::quiet_NaN(), high = low; // shown units; NaN: from the particles in the window

  static paint phase() { return {kind::phase, {}, {}}; }
  static paint body() { return {kind::body, {}, {}}; }
  static paint of(std::string column, std::string label, double unit, color_map map = color_map::ember()) {
    require(unit > 0, "unit shown for column \"" + column + "\"", unit, "more than 0");
    return {kind::value, std::move(column), std::move(label), unit, map};
  }
  static paint speed() { return of("speed", "speed (km/s)", 1e3, color_map::ocean()); }
  static paint temperature() { return of("temperature", "temperature (K)", 1); }
  static paint pressure() { return of("pressure", "pressure (GPa)", 1e9); }

  paint between(double from, double to) const {
    require(to > from, "upper end of the colours", to, "above the lower end " + to_text(from), label);
    paint p = *this;
    p.low = from, p.high = to;
    return p;
  }
};

/// A curve over the particles, in metres (z, r); in a mirrored picture it is drawn above and below.
struct curve {
  std::vector<std::pair<double, double>> points;
  std::string label; // empty: not in the legend
  rgb color = black;
};

struct panel {
  const snapshot* particles = nullptr;
  paint how = paint::speed();
  std::string title;
  std::vector<curve> curves{};
};

struct picture_style {
  int width = 1100;           // pixels of the field of one panel
  double text = 15;           // pixels, height of capitals
  double least_radius = 1.05; // pixels, of a particle
};

namespace detail {
inline double magnitude(const column& c, std::size_t i) {
  double sum = 0;
  for (int k = 0; k < c.components; ++k) sum += c(i, k) * c(i, k);
  return std::sqrt(sum);
}

/// Which particles are faster than `share` times the 99.9 % mass quantile of the speed.
inline std::vector<char> moving(const snapshot& s, double share) {
  const column &mass = s.at("mass"), &velocity = s.at("velocity");
  weighted_samples speed;
  for (std::size_t i = 0; i < s.size(); ++i) speed.add(magnitude(velocity, i), mass(i));
  const double threshold = share * speed.quantile(0.999);
  std::vector<char> yes(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) yes[i] = magnitude(velocity, i) >= threshold;
  return yes;
}

/// Horizontal and vertical place of a particle: (z, r) if axisymmetric, else (x, y).
struct section {
  const column& position;
  int across, up;
  explicit section(const snapshot& s) : position(s.at("position")), across(s.axisymmetric ? 1 : 0), up(s.axisymmetric ? 0 : 1) {
    require(s.dimension == 2 && position.components == 2, "dimension of the snapshot to draw", s.dimension,
            "2: a picture shows a section, plane or through the axis (of a 3-D snapshot take slice() or around_axis())");
  }
  double horizontal(std::size_t i) const { return position(i, across); }
  double vertical(std::size_t i) const { return position(i, up); }
};
} // namespace detail

struct cloud_window_options {
  double left = -25e-3;       // m, no further back than this
  double least_top = 25e-3;   // m, at least this high
  double margin = 0.07;       // of the cloud's length
  double moving = 0.1;        // of the fast particles' speed: what counts as cloud
};

/// The window that shows the cloud: forward to the 99.9 % mass quantile of what moves (faster than `moving` times the 99.9 % quantile
/// of the speed) and a margin, back to `left`, up to the 99 % quantile of the radius of what lies between them
/// (the ejecta further back fly wide) and a margin.
inline window cloud_window(const snapshot& s, const cloud_window_options& options = {}) {
  const detail::section at(s);
  const column& mass = s.at("mass");
  const std::vector<char> moving = detail::moving(s, options.moving);
  weighted_samples horizontal, vertical;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (moving[i]) horizontal.add(at.horizontal(i), mass(i));
  require(horizontal.size() > 0, "particles with a finite place and speed", 0, "at least 1 to choose a window");
  const double back = std::max(options.left, std::min(horizontal.quantile(0.001), -options.least_top));
  const double front = std::max(horizontal.quantile(0.999), back + options.least_top), margin = options.margin * (front - back);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (moving[i] && at.horizontal(i) >= back && at.horizontal(i) <= front) vertical.add(std::fabs(at.vertical(i)), mass(i));
  const double top = std::max(options.least_top, vertical.size() > 0 ? vertical.quantile(0.99) + margin : 0.0);
  return {back, front + margin, -top, top};
}

namespace detail {
/// The particles' values, the colour of each, and what the legend or the colour bar must say.
struct coloring {
  std::vector<rgb> color;
  legend_entries legend; // empty for values
  double low = 0, high = 1;
};

inline std::vector<char> inside(const snapshot& s, const window& w) {
  const section at(s);
  std::vector<char> yes(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double x = at.horizontal(i), y = at.vertical(i);
    yes[i] = x >= w.left && x <= w.right && y >= w.bottom && y <= w.top;
  }
  return yes;
}

inline coloring color_by_category(const std::vector<std::size_t>& kind, const legend_entries& palette,
                                  const std::vector<char>& shown) {
  coloring c;
  std::vector<bool> present(palette.size(), false);
  for (std::size_t i = 0; i < kind.size(); ++i) {
    c.color.push_back(palette[kind[i]].second);
    if (shown[i]) present[kind[i]] = true;
  }
  for (std::size_t k = 0; k < palette.size(); ++k)
    if (present[k]) c.legend.push_back(palette[k]);
  return c;
}

/// Index into phase_palette: the region, a solid that has failed apart.
inline coloring color_by_phase(const snapshot& s, const std::vector<char>& shown) {
  const column& where = s.at("region");
  const column* failed = s.find("failed");
  std::vector<std::size_t> kind(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::size_t r = where(i) > 0 ? std::min<std::size_t>(static_cast<std::size_t>(to_region(where(i))), 4) : 0;
    kind[i] = r > 0 ? r + 1 : failed && (*failed)(i) > 0.5 ? 1 : 0;
  }
  legend_entries palette;
  for (const category& c : phase_palette) palette.emplace_back(c.label, c.color);
  return color_by_category(kind, palette, shown);
}

inline coloring color_by_body(const snapshot& s, const std::vector<char>& shown) {
  legend_entries palette;
  for (std::size_t b = 0; b < s.body_names.size(); ++b) palette.emplace_back(s.body_names[b], line_palette[b % line_palette.size()]);
  require(!palette.empty() && s.body.size() == s.size(), "bodies named in the snapshot", double(palette.size()), "at least 1");
  std::vector<std::size_t> kind(s.size());
  for (std::size_t i = 0; i < s.size(); ++i)
    kind[i] = static_cast<std::size_t>(std::clamp(s.body[i], 0, static_cast<int>(palette.size()) - 1));
  return color_by_category(kind, palette, shown);
}

inline coloring color_by_value(const snapshot& s, const paint& how, const std::vector<char>& shown) {
  const bool speed = how.column == "speed" && !s.find("speed");
  const column &source = s.at(speed ? "velocity" : how.column), &mass = s.at("mass");
  coloring c{std::vector<rgb>(s.size()), {}, how.low, how.high};
  std::vector<double> value(s.size());
  weighted_samples seen, cloud;
  const std::vector<char> moving = detail::moving(s, 0.1);
  for (std::size_t i = 0; i < s.size(); ++i) {
    value[i] = (speed ? magnitude(source, i) : source(i)) / how.unit;
    if (!shown[i]) continue;
    seen.add(value[i], mass(i));
    if (moving[i]) cloud.add(value[i], mass(i));
  }
  if (!(c.high > c.low)) { // rounded outwards; the upper end by the cloud alone, which a heavy plate at rest would drown
    const double least = speed ? 0 : seen.quantile(0.001), most = std::fmax(cloud.quantile(0.99), seen.quantile(0.9));
    const double step = nice_step(most > least ? most - least : std::fmax(std::fabs(least), 1.0), 10);
    c.low = std::isfinite(least) ? std::floor(least / step + 1e-9) * step : 0;
    c.high = std::isfinite(most) ? std::max(std::ceil(most / step - 1e-9) * step, c.low + step) : 1;
  }
  for (std::size_t i = 0; i < s.size(); ++i) c.color[i] = how.map((value[i] - c.low) / (c.high - c.low));
  return c;
}

inline coloring color_particles(const snapshot& s, const paint& how, const window& w) {
  const std::vector<char> shown = inside(s, w);
  return how.by == paint::kind::phase ? color_by_phase(s, shown)
         : how.by == paint::kind::body ? color_by_body(s, shown)
                                       : color_by_value(s, how, shown);
}

/// For each sample of the field the nearest particle whose disc covers it: what makes the picture independent of the order of the
/// particles. Samples are `fine` to a pixel.
class nearest_particle {
 public:
  nearest_particle(int columns, int rows)
      : columns_(columns), rows_(rows), distance2_(std::size_t(columns) * std::size_t(rows), std::numeric_limits<float>::infinity()),
        particle_(distance2_.size(), none) {}

  void add(std::int32_t particle, double x, double y, double radius) {
    if (!(x > -radius && y > -radius && x < columns_ + radius && y < rows_ + radius)) return;
    const int left = std::max(0, static_cast<int>(std::floor(x - radius))), right = std::min(columns_ - 1, static_cast<int>(x + radius));
    const int top = std::max(0, static_cast<int>(std::floor(y - radius))), bottom = std::min(rows_ - 1, static_cast<int>(y + radius));
    for (int j = top; j <= bottom; ++j)
      for (int i = left; i <= right; ++i) {
        const double dx = i + 0.5 - x, dy = j + 0.5 - y, d2 = dx * dx + dy * dy;
        const std::size_t sample = std::size_t(j) * std::size_t(columns_) + std::size_t(i);
        if (d2 > radius * radius || static_cast<float>(d2) >= distance2_[sample]) continue;
        distance2_[sample] = static_cast<float>(d2);
        particle_[sample] = particle;
      }
  }
  std::int32_t operator()(int i, int j) const { return particle_[std::size_t(j) * std::size_t(columns_) + std::size_t(i)]; }
  static constexpr std::int32_t none = -1;

 private:
  int columns_, rows_;
  std::vector<float> distance2_;
  std::vector<std::int32_t> particle_;
};

/// The particles alone, on what is already drawn in the field.
inline void draw_particles(image& on, const plot_field& f, const snapshot& s, const coloring& c, double least_radius) {
  constexpr int fine = 3;
  const section at(s);
  nearest_particle nearest(fine * f.width, fine * f.height);
  // a disc of 0.75 spacings covers the corners of its lattice cell (0.71), so an undisturbed lattice has no gaps
  const double scale = fine * f.pixels_per_metre(), radius = std::max(0.75 * s.spacing * scale, fine * least_radius);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double x = (at.horizontal(i) - f.space.left) * scale;
    const auto particle = static_cast<std::int32_t>(i);
    nearest.add(particle, x, (f.space.top - at.vertical(i)) * scale, radius);
    if (s.axisymmetric) nearest.add(particle, x, (f.space.top + at.vertical(i)) * scale, radius);
  }
  for (int y = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x) {
      int sum[3] = {0, 0, 0}, covered = 0;
      // the mean colour of the covered samples, laid on with the share that is covered
      for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i) {
          const std::int32_t particle = nearest(fine * x + i, fine * y + j);
          if (particle == nearest_particle::none) continue;
          const rgb color = c.color[static_cast<std::size_t>(particle)];
          sum[0] += color.r, sum[1] += color.g, sum[2] += color.b, ++covered;
        }
      if (covered == 0) continue;
      const auto mean = [&](int k) { return static_cast<std::uint8_t>((sum[k] + covered / 2) / covered); };
      on.blend(f.x + x, f.y + y, {mean(0), mean(1), mean(2)}, double(covered) / (fine * fine));
    }
}

inline void draw_curve(image& on, const plot_field& f, const curve& line, bool mirrored, double width) {
  image layer(f.width, f.height); // drawn on a copy of the field, so that the curve ends at its border
  for (int y = 0; y < f.height; ++y)
    for (int x = 0; x < f.width; ++x) layer(x, y) = on(f.x + x, f.y + y);
  const plot_field local{f.space, 0, 0, f.width, f.height};
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !mirrored) break;
    std::vector<pen_segment> way;
    for (std::size_t i = 1; i < line.points.size(); ++i)
      way.push_back({local.column(line.points[i - 1].first), local.row(side * line.points[i - 1].second),
                     local.column(line.points[i].first), local.row(side * line.points[i].second)});
    draw_strokes(layer, way, width, line.color);
  }
  on.paste(layer, f.x, f.y);
}

inline std::string time_text(double seconds) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "t = %.2f \u00b5s", seconds / 1e-6);
  return buffer;
}
} // namespace detail

/// One panel with its margins, axes, title, and colour bar or legend.
inline image draw_panel(const panel& p, const window& space, const picture_style& style = {}) {
  require(p.particles != nullptr, "snapshots given to the panel \"" + p.title + "\"", 0, "1");
  require(style.width >= 100, "width of a panel", style.width, "at least 100", "pixels");
  require(style.text >= 4 && style.text <= 0.1 * style.width, "height of the text", style.text,
          "at least 4 and at most a tenth of the width", "pixels");
  space.validate();
  const snapshot& s = *p.particles;
  const double text = style.text;
  const detail::coloring colors = detail::color_particles(s, p.how, space);

  const int height = std::max(1, static_cast<int>(style.width * space.height() / space.width() + 0.5));
  const bool values = p.how.by == paint::kind::value;
  legend_entries lines;
  for (const curve& c : p.curves)
    if (!c.label.empty()) lines.emplace_back(c.label, c.color);
  const double side = values ? color_bar_width(colors.low, colors.high, text)
                             : std::max({2 * text, legend_width(colors.legend, text), legend_width(lines, text)});
  const plot_field f{space, static_cast<int>(6.6 * text), static_cast<int>(3.6 * text), style.width, height};
  image on(f.x + f.width + static_cast<int>(side), f.y + f.height + static_cast<int>(6 * text));

  if (s.axisymmetric) draw_symmetry_axis(on, f, text);
  detail::draw_particles(on, f, s, colors, style.least_radius);
  for (const curve& c : p.curves) detail::draw_curve(on, f, c, s.axisymmetric, std::max(1.5, text / 7));
  const std::string axes = s.axis_letters();
  const axis_labels plane{axes.substr(0, 1) + " (mm)", axes.substr(1, 1) + " (mm)", false};
  draw_axes(on, f, s.axisymmetric ? axis_labels{"z (mm)", "r (mm)", true} : plane, text);
  draw_text(on, f.x, f.y - 1.1 * text, p.title, 1.15 * text, ink);
  draw_text(on, f.x + f.width, f.y - 1.1 * text, detail::time_text(s.time), 1.15 * text, ink, anchor::end);

  const int beside = f.x + f.width + static_cast<int>(1.8 * text);
  const int within = f.x + f.width - static_cast<int>(legend_width(lines, text) - text);
  if (values) { // the bar fills the side, so the names of the curves go into the upper right corner of the field
    draw_color_bar(on, f, p.how.map, colors.low, colors.high, p.how.label, text);
    draw_legend(on, within, f.y + 1.2 * text, lines, text, true);
  } else {
    const double below = draw_legend(on, beside, f.y, colors.legend, text);
    draw_legend(on, beside, below + text, lines, text, true);
  }
  return on;
}

/// Pictures on one sheet, row by row, `columns` to a row, under a heading.
inline image arrange(const std::vector<image>& parts, int columns, const std::string& heading = {}, double text = 15) {
  require(!parts.empty(), "pictures to arrange", 0, "at least 1");
  require(columns >= 1, "columns of the sheet", columns, "at least 1");
  int cell_width = 0, cell_height = 0;
  for (const image& p : parts) cell_width = std::max(cell_width, p.width()), cell_height = std::max(cell_height, p.height());
  const int count = static_cast<int>(parts.size()), used = std::min(columns, count), rows = (count + used - 1) / used;
  const int top = heading.empty() ? 0 : static_cast<int>(3.4 * text);
  image on(used * cell_width, top + rows * cell_height);
  draw_text(on, on.width() / 2.0, 2.5 * text, heading, 1.4 * text, ink, anchor::middle);
  for (int i = 0; i < count; ++i) on.paste(parts[static_cast<std::size_t>(i)], (i % used) * cell_width, top + (i / used) * cell_height);
  return on;
}

/// Several panels on one sheet; they share the window, so that they can be compared by eye.
inline image draw_panels(const std::vector<panel>& panels, const window& space, int columns, const std::string& heading = {},
                         const picture_style& style = {}) {
  std::vector<image> parts;
  for (const panel& p : panels) parts.push_back(draw_panel(p, space, style));
  return arrange(parts, columns, heading, style.text);
}

} // namespace bolide::observe
