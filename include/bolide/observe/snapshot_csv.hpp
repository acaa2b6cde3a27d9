// SPDX-License-Identifier: MIT
// A snapshot as a table of comma-separated values: one row per particle in the order of the snapshot, 17 significant digits, written whole.
//
//   write_csv("particles.csv", take_snapshot(sim, {"pressure", "von_mises"}));
//
// Columns: id and body where the snapshot has them, then its own. Components of vectors are named after the axes ("r (m)", "v_z (m/s)"),
// those of other columns by number.
#pragma once

#include "bolide/observe/csv.hpp"
#include "bolide/observe/snapshot.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bolide::observe {

inline void write_csv(const std::filesystem::path& path, const snapshot& s) {
  std::string text;
  const auto add = [&](const std::vector<csv_cell>& cells) {
    for (const csv_cell& c : cells) text += c.text() + ',';
    text.back() = '\n';
  };
  const std::string axes = s.axis_letters();
  const bool ids = s.id.size() == s.size(), bodies = s.body.size() == s.size();
  std::vector<csv_cell> header;
  if (ids) header.emplace_back("id");
  if (bodies) header.emplace_back("body");
  for (const column& c : s.columns)
    for (int k = 0; k < c.components; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const bool vector = c.components == s.dimension && (c.components > 1 || c.name == "position" || c.name == "velocity");
      const std::string suffix = vector ? std::string(1, axes[axis]) : std::to_string(k), stem = c.name == "velocity" ? "v" : c.name;
      header.emplace_back((c.name == "position" ? suffix : !vector && c.components == 1 ? c.name : stem + "_" + suffix) + " (" + c.unit + ")");
    }
  add(header);
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::vector<csv_cell> cells;
    if (ids) cells.emplace_back(s.id[i]);
    if (bodies) cells.emplace_back(s.body_names.at(static_cast<std::size_t>(s.body[i])));
    for (const column& c : s.columns)
      for (int k = 0; k < c.components; ++k) cells.emplace_back(c(i, k));
    add(cells);
  }
  write_whole_file(path, text);
}

} // namespace bolide::observe
