// SPDX-License-Identifier: MIT
// SVG 1.1, text as text.
#include "canvas.hpp"

#include "bolide/observe/axes.hpp"
#include "bolide/observe/whole_file.hpp"

#include <cstdio>

namespace explorer {
namespace {

namespace observe = bolide::observe;
constexpr double capitals = 0.72; // height of the capitals of common sans-serif fonts, in their size

std::string number(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f", x);
  return buffer;
}
std::string color_name(observe::rgb c) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", unsigned{c.r}, unsigned{c.g}, unsigned{c.b});
  return buffer;
}
std::string escaped(const std::string& words) {
  std::string all;
  for (const char c : words) all += c == '&' ? std::string("&amp;") : c == '<' ? std::string("&lt;") : std::string(1, c);
  return all;
}

class scalable : public canvas {
public:
  scalable(double width, double height) {
    const std::string w = number(width), h = number(height);
    body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "pt\" height=\"" + h + "pt\" viewBox=\"0 0 " + w + " " + h +
            "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }
  void line(const std::vector<place>& through, double width, bool dashed, observe::rgb color) override {
    body_ += "<polyline fill=\"none\" stroke=\"" + color_name(color) + "\" stroke-width=\"" + number(width) +
             "\" stroke-linejoin=\"round\" stroke-linecap=\"" + (dashed ? "butt\" stroke-dasharray=\"5.5 3" : "round") + "\" points=\"";
    for (const place p : through) body_ += number(p.x) + "," + number(p.y) + " ";
    body_ += "\"/>\n";
  }
  void mark(place at, double radius, double width, observe::rgb color) override {
    body_ += "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" + number(radius) + "\" fill=\"#ffffff\" stroke=\"" +
             color_name(color) + "\" stroke-width=\"" + number(width) + "\"/>\n";
  }
  void text(place at, const std::string& words, double height, observe::anchor anchored, bool upwards) override {
    const char* names[] = {"start", "middle", "end"};
    const std::string x = number(at.x), y = number(at.y);
    body_ += "<text x=\"" + x + "\" y=\"" + y + "\" font-family=\"Helvetica,Arial,sans-serif\" font-size=\"" + number(height / capitals) +
             "\" fill=\"" + color_name(observe::ink) + "\" text-anchor=\"" + names[static_cast<int>(anchored)] + "\"" +
             (upwards ? " transform=\"rotate(-90 " + x + " " + y + ")\"" : "") + ">" + escaped(words) + "</text>\n";
  }
  void save(const std::filesystem::path& path) const override { observe::write_whole_file(path, body_ + "</svg>\n"); }

private:
  std::string body_;
};

} // namespace

std::unique_ptr<canvas> svg_canvas(double width, double height) { return std::make_unique<scalable>(width, height); }

} // namespace explorer
