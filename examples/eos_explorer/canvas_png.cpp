// SPDX-License-Identifier: MIT
// Four pixels to the point: 288 dots per inch.
#include "canvas.hpp"

#include "bolide/observe/axes.hpp"
#include "bolide/png/write_png.hpp"

#include <cmath>

namespace explorer {
namespace {

namespace observe = bolide::observe;
constexpr double scale = 4, dash = 5.5, gap = 3; // pixels per point; points

class pixels : public canvas {
public:
  pixels(double width, double height) : image_(static_cast<int>(std::ceil(width * scale)), static_cast<int>(std::ceil(height * scale))) {}

  void line(const std::vector<place>& through, double width, bool dashed, observe::rgb color) override {
    std::vector<observe::pen_segment> pieces;
    double way = 0; // along the whole line, in points: dashes go on around corners
    for (std::size_t i = 1; i < through.size(); ++i) {
      const place a = through[i - 1], b = through[i];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (dashed) add_dashes(a, b, length, way, pieces);
      else pieces.push_back({a.x * scale, a.y * scale, b.x * scale, b.y * scale});
      way += length;
    }
    observe::draw_strokes(image_, pieces, width * scale, color);
  }
  void mark(place at, double radius, double width, observe::rgb color) override {
    disc(at, radius + width / 2, color);
    disc(at, radius - width / 2, observe::white);
  }
  void text(place at, const std::string& words, double height, observe::anchor anchored, bool upwards) override {
    observe::draw_text(image_, at.x * scale, at.y * scale, words, height * scale, observe::ink, anchored, upwards);
  }
  void save(const std::filesystem::path& path) const override { bolide::png::write_png(path, image_); }

private:
  void disc(place at, double radius, observe::rgb color) {
    observe::draw_line(image_, at.x * scale, at.y * scale, at.x * scale, at.y * scale, 2 * radius * scale, color);
  }
  static void add_dashes(place a, place b, double length, double way, std::vector<observe::pen_segment>& pieces) {
    const double period = dash + gap;
    for (double from = -std::fmod(way, period); from < length; from += period) {
      const double s = std::fmax(from, 0) / length, t = std::fmin(from + dash, length) / length;
      if (!(t > s)) continue;
      pieces.push_back({(a.x + s * (b.x - a.x)) * scale, (a.y + s * (b.y - a.y)) * scale, (a.x + t * (b.x - a.x)) * scale,
                        (a.y + t * (b.y - a.y)) * scale});
    }
  }
  observe::image image_;
};

} // namespace

std::unique_ptr<canvas> png_canvas(double width, double height) { return std::make_unique<pixels>(width, height); }

} // namespace explorer
