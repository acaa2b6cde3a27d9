// SPDX-License-Identifier: MIT
// Mirror plane on a grid line: the symmetry axis of r-z, a symmetry plane, a slip wall, a wall that holds on - one idea.
//
// The material has a mirror image beyond the plane. Image particles give to real nodes what real particles give to image nodes, so
// after every sum over particles a node and its image both hold (own sum) + (reflected sum of the other); the component normal to the
// plane changes sign under reflection and vanishes on the plane. With linear shapes no particle reaches an image node and only
// the condition on the plane is left. A wall that holds on (stick) reflects the other components of vectors with changed sign too, so that all of them
// vanish on it.
#pragma once

#include "bolide/core/contract.hpp"
#include "bolide/grid/node_pairs.hpp"
#include "bolide/grid/sparse.hpp"

#include <cmath>
#include <string>

namespace bolide::grid {

/// The user's choice: plane normal to `axis` through `position` (m), material on the side of larger coordinates or not.
struct mirror {
  int axis = 0;
  double position = 0;
  bool material_above = true;
  bool stick = false; // does the wall hold the material on it, tangentially too?
};

/// A mirror on a particular grid: the node pairs that it couples. Made anew with every rebuild of the blocks.
template <int Dim> class mirror_nodes {
public:
  mirror_nodes(const mirror& m, double spacing) : axis_(static_cast<std::size_t>(m.axis)), above_(m.material_above), stick_(m.stick) {
    require(m.axis >= 0 && m.axis < Dim, "mirror axis", m.axis, "an axis of the space, 0 to " + std::to_string(Dim - 1));
    line_ = on_grid_line(m.position, spacing, "mirror position");
  }

  template <class Map> void rebuild(const Map& map) {
    pairs_.clear(map.size() * block_map<Dim>::nodes_per_block);
    plane_.clear();
    for (std::size_t b = 0; b < map.size(); ++b) {
      for (int local = 0; local < block_map<Dim>::nodes_per_block; ++local) {
        auto at = map.node_at(b, local);
        const auto node = static_cast<std::int32_t>(b) * block_map<Dim>::nodes_per_block + local;
        const std::int32_t depth = above_ ? line_ - at[axis_] : at[axis_] - line_; // > 0: beyond the plane
        if (depth == 0) plane_.push_back(node);
        if (depth <= 0) continue;
        pairs_.mark_image(node);
        if (depth > reach) continue;
        at[axis_] = 2 * line_ - at[axis_];
        if (const auto real = map.node(at); real >= 0) pairs_.add(node, real);
      }
    }
  }

  void spread(std::vector<char>& touched) { pairs_.spread(touched); }
  /// Completes sums over particles of the node column that begins at `offset`; components first .. first + Dim - 1 are a vector, and
  /// `first + axis` is the one normal to the plane (first < 0: all are scalars).
  template <class Column> void complete(Column& sums, int first, std::size_t offset = 0) const {
    const int normal = first < 0 ? -1 : first + static_cast<int>(axis_);
    const int low = stick_ && first >= 0 ? first : normal, high = stick_ && first >= 0 ? first + Dim - 1 : normal; // components that change sign
    for (int c = 0; c < Column::components; ++c) {
      const bool odd = normal >= 0 && c >= low && c <= high;
      for (const auto& [image, real] : pairs_.active()) {
        auto &a = sums(c, offset + static_cast<std::size_t>(image)), &b = sums(c, offset + static_cast<std::size_t>(real));
        if (odd) {
          b -= a;
          a = -b;
        } else {
          b += a;
          a = b;
        }
      }
      if (odd)
        for (const auto node : plane_) sums(c, offset + static_cast<std::size_t>(node)) = 0;
    }
  }
  /// Is this node beyond the plane? Such a node is a copy and must not be counted in sums over nodes.
  bool is_image(std::size_t node) const { return pairs_.is_image(node); }
  std::size_t axis() const { return axis_; }
  std::int32_t line() const { return line_; }
  bool material_above() const { return above_; }
  bool sticks() const { return stick_; }

private:
  static constexpr int reach = 2; // image nodes deeper than this are touched by no shape function of the library
  std::size_t axis_;
  bool above_, stick_;
  std::int32_t line_ = 0;
  node_pairs<Dim> pairs_; // image, real
  std::vector<std::int32_t> plane_;
};

} // namespace bolide::grid
