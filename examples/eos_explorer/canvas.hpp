// SPDX-License-Identifier: MIT
// What a figure is drawn on: pixels or SVG. Coordinates are points (1/72 inch), x right, y down.
#pragma once

#include "bolide/observe/draw.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace explorer {

struct place {
  double x, y;
};

class canvas {
public:
  virtual ~canvas() = default;
  virtual void line(const std::vector<place>& through, double width, bool dashed, bolide::observe::rgb color) = 0;
  /// A ring of that radius with a white middle.
  virtual void mark(place at, double radius, double width, bolide::observe::rgb color) = 0;
  /// `height` is that of the capitals; the baseline is at y, or at x where the text runs upwards.
  virtual void text(place at, const std::string& words, double height, bolide::observe::anchor anchored, bool upwards) = 0;
  virtual void save(const std::filesystem::path& path) const = 0;
};

std::unique_ptr<canvas> png_canvas(double width, double height);
std::unique_ptr<canvas> svg_canvas(double width, double height);

} // namespace explorer
