// SPDX-License-Identifier: MIT
// Two-dimensional views of a three-dimensional snapshot, for everything in this room that draws or measures sections.
//
//   slice(s, 1, 0, 0.2 * mm)    the particles within 0.1 mm of the plane y = 0, seen along y: z to the right, x up
//   around_axis(s, 4)           (r, z) of every particle about the z axis, as if the cloud were axisymmetric; 4: the run is a quarter of it
//
// A slice keeps masses and volumes of its particles; its axes are the two others in the order x -> (y, z), y -> (z, x), z -> (x, y). Of
// vectors (three components) the part in the plane is kept, all other columns as they are. around_axis keeps of vectors the radial and the
// axial component, and multiplies mass and volume by the number of sectors, so that masses are those of the whole cloud; its pictures, outlines
// and radiographs are means over the angle.
#pragma once

#include "bolide/observe/snapshot.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

namespace detail {
/// A snapshot of those rows of `s`; vectors become pair(vector, row) of two components.
template <class Pair> snapshot two_dimensional(const snapshot& s, const std::vector<std::size_t>& rows, Pair&& pair) {
  snapshot out;
  out.time = s.time, out.step = s.step, out.spacing = s.spacing, out.dimension = 2, out.body_names = s.body_names;
  for (const std::size_t i : rows) {
    if (s.id.size() == s.size()) out.id.push_back(s.id[i]);
    if (s.body.size() == s.size()) out.body.push_back(s.body[i]);
  }
  for (const column& c : s.columns) {
    std::vector<double> data;
    for (const std::size_t i : rows) {
      if (c.components == 3) {
        const std::array<double, 2> two = pair(c, i);
        data.insert(data.end(), two.begin(), two.end());
      } else
        for (int k = 0; k < c.components; ++k) data.push_back(c(i, k));
    }
    out.add(c.name, c.unit, c.components == 3 ? 2 : c.components, std::move(data));
  }
  return out;
}
inline void require_3d(const snapshot& s) { require(s.dimension == 3, "dimension of the snapshot to look at in two dimensions", s.dimension, "3"); }
} // namespace detail

/// The particles whose distance from the plane `axis` = `at` is at most half the thickness (0: one particle spacing).
inline snapshot slice(const snapshot& s, int axis, double at, double thickness = 0) {
  detail::require_3d(s);
  require(axis >= 0 && axis < 3, "axis across the slice", axis, "0, 1 or 2");
  require(thickness >= 0, "thickness of the slice", thickness, "non-negative", "m");
  const column& x = s.at("position");
  const double half = (thickness > 0 ? thickness : s.spacing) / 2;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (std::abs(x(i, axis) - at) <= half) rows.push_back(i);
  const int right = (axis + 1) % 3, up = (axis + 2) % 3;
  snapshot out = detail::two_dimensional(s, rows, [&](const column& c, std::size_t i) { return std::array{c(i, right), c(i, up)}; });
  const std::string axes = s.axis_letters();
  out.axes = {axes[static_cast<std::size_t>(right)], axes[static_cast<std::size_t>(up)]};
  return out;
}

/// Every particle at its radius from the z axis and its z; `sectors` such parts make the whole cloud.
inline snapshot around_axis(const snapshot& s, double sectors = 1) {
  detail::require_3d(s);
  require(sectors >= 1, "sectors of the cloud", sectors, "at least 1");
  const column& x = s.at("position");
  std::vector<std::size_t> rows(s.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  snapshot out = detail::two_dimensional(s, rows, [&](const column& c, std::size_t i) {
    const double r = std::hypot(x(i, 0), x(i, 1)), radial = r > 0 ? (c(i, 0) * x(i, 0) + c(i, 1) * x(i, 1)) / r : 0.0;
    return std::array{radial, c(i, 2)};
  });
  for (column& c : out.columns)
    if (c.name == "mass" || c.name == "volume" || c.name == "material_volume")
      for (double& value : c.data) value *= sectors;
  out.axisymmetric = true;
  return out;
}

} // namespace bolide::observe
