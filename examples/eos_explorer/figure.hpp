// SPDX-License-Identifier: MIT
// Curves in panels side by side, drawn as PNG or SVG by the same code (draw_figure.cpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace explorer {

enum class line_style { solid, dashed, marks };

struct curve {
  std::string label; // empty: not in the legend
  line_style style;
  int color; // of observe::line_palette
  std::vector<double> x, y;
  std::vector<double> error = {}; // half the length of an upright error bar at each mark; empty: none
};

struct panel {
  std::string horizontal, vertical; // labels with units
  std::vector<curve> curves;
};

struct figure {
  std::vector<panel> panels;
};

/// Throws bolide::bad_parameter unless the name ends in .png or .svg; to be asked before any work.
void check_figure_name(const std::string& path);
/// Writes the figure whole or not at all.
void write_figure(const figure& f, const std::filesystem::path& path);

} // namespace explorer
