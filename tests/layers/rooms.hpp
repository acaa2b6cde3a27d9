// SPDX-License-Identifier: MIT
// The rooms of the house and the arrows between them, read from the include lines of a source tree.
//
//   read_tree(folder)      every header below folder/ with its room and its include lines
//   violations(headers)    one sentence per include line that the house forbids
//   picture(headers)       the rooms and their arrows as SVG (docs/img/rooms.svg)
//
// The rules are the table `house` and the function `outside_violation` below, and nothing else.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace rooms {

/// A room, the floor it is drawn on, and the rooms it stands on. It may include these and, through them, whatever they stand on;
/// it never includes a room beside it or above it.
struct room {
  std::string name;
  int floor;
  std::vector<std::string> stands_on;
};

inline const std::vector<std::string> models = {"space", "shape", "grid", "particles", "eos", "strength", "failure", "viscosity", "transfer", "contact", "time"};

inline room& find(std::vector<room>& house, const std::string& name) {
  return *std::find_if(house.begin(), house.end(), [&](const room& r) { return r.name == name; });
}
inline std::vector<room> make_house() {
  std::vector<room> house = {{"core", 0, {}}, {"concepts", 1, {"core"}}};
  house.push_back({"potential", 2, {"concepts"}});
  for (const auto& name : models) house.push_back({name, 3, {"concepts"}});
  find(house, "eos").stands_on.push_back("potential");
  house.push_back({"material", 4, models});
  house.push_back({"scheme", 4, models});
  house.push_back({"analysis", 4, {"eos"}});
  house.push_back({"solver", 5, {"material", "scheme"}});
  house.push_back({"gsl", 5, {"analysis"}});
  house.push_back({"conformance", 5, {"analysis"}});
  house.push_back({"observe", 6, {"solver"}});
  house.push_back({"png", 7, {"observe"}});
  house.push_back({"hdf5", 7, {"observe"}});
  house.push_back({"advise", 8, {"core"}});
  return house;
}
inline const std::vector<room> house = make_house();

inline const room* find_room(const std::string& name) {
  const auto at = std::find_if(house.begin(), house.end(), [&](const room& r) { return r.name == name; });
  return at == house.end() ? nullptr : &*at;
}

/// May a header of room `from` include one of room `to`?
inline bool may_include(const std::string& from, const std::string& to) {
  if (from == to) return true;
  const auto* r = find_room(from);
  return r && std::any_of(r->stands_on.begin(), r->stands_on.end(), [&](const std::string& below) { return may_include(below, to); });
}

/// One include line: what stands between the quotes or angle brackets.
struct include_line {
  std::string target;
  bool quoted;
};

struct header {
  std::string path; // relative to the folder read, with '/'
  std::string room; // first folder of the path; empty for the umbrella
  std::vector<include_line> includes;
};

inline std::string room_of(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

inline std::vector<include_line> read_includes(std::istream& text) {
  std::vector<include_line> found;
  for (std::string line; std::getline(text, line);) {
    const auto hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const auto word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const auto open = line.find_first_of("\"<", word);
    if (open == std::string::npos) continue;
    const auto close = line.find_first_of("\">", open + 1);
    found.push_back({line.substr(open + 1, close - open - 1), line[open] == '"'});
  }
  return found;
}

/// All headers below `folder` (which is include/bolide or a tree made to look like it), sorted by path.
inline std::vector<header> read_tree(const std::filesystem::path& folder) {
  std::vector<header> headers;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".hpp") continue;
    const auto path = entry.path().lexically_relative(folder).generic_string();
    std::ifstream text(entry.path());
    headers.push_back({path, room_of(path), read_includes(text)});
  }
  std::sort(headers.begin(), headers.end(), [](const header& a, const header& b) { return a.path < b.path; });
  return headers;
}

/// What is wrong with including `target` (no header of this library) from `room`; empty if nothing.
inline std::string outside_violation(const std::string& room, const std::string& target) {
  static const std::set<std::string> heavy = {"iostream", "fstream", "functional", "regex", "ranges"};
  static const std::set<std::string> edge_rooms = {"observe", "analysis", "conformance", "potential", "png"};
  static const std::map<std::string, std::string> owner = {{"Eigen/", "core"}, {"unsupported/Eigen/", "core"}, {"gsl/", "gsl"}, {"png.h", "png"}, {"hdf5.h", "hdf5"}};
  static const std::set<std::string> compiler_headers = {"immintrin.h", "arm_neon.h"}; // core
  static const std::set<std::string> system_headers = {"unistd.h", "sys/ioctl.h", "fcntl.h"};   // observe: is it a terminal, how wide; files flushed to the disk
  for (const auto& [prefix, home] : owner)
    if (target.rfind(prefix, 0) == 0) return room == home ? "" : "<" + target + "> belongs to room " + home + " alone";
  if (heavy.count(target)) return edge_rooms.count(room) ? "" : "<" + target + "> only in observe, analysis, conformance, potential and png: it is slow to parse";
  if (target == "omp.h") return room == "core" || room == "solver" ? "" : "<omp.h> belongs to rooms core and solver alone";
  if (compiler_headers.count(target)) return room == "core" ? "" : "<" + target + "> belongs to room core alone";
  if (system_headers.count(target)) return room == "observe" ? "" : "<" + target + "> belongs to room observe alone";
  if (target.find('/') != std::string::npos || target.find('.') != std::string::npos)
    return "<" + target + "> is an outside library: it needs a room and a CMake target of its own";
  return "";
}

/// One sentence per forbidden include line.
inline std::vector<std::string> violations(const std::vector<header>& headers) {
  std::set<std::string> known;
  for (const auto& h : headers) known.insert("bolide/" + h.path);
  std::vector<std::string> found;
  for (const auto& h : headers) {
    const auto say = [&](const std::string& what) { found.push_back(h.path + ": " + what); };
    if (!h.room.empty() && !find_room(h.room)) say("room " + h.room + " is not in the table of tests/layers/rooms.hpp");
    for (const auto& line : h.includes) {
      if (!line.quoted) {
        const auto wrong = outside_violation(h.room, line.target);
        if (!wrong.empty()) say(wrong);
        continue;
      }
      const auto target_room = line.target.rfind("bolide/", 0) == 0 ? room_of(line.target.substr(7)) : std::string();
      if (!known.count(line.target)) say("\"" + line.target + "\" is no header of the library (write \"bolide/room/name.hpp\")");
      else if (line.target == "bolide/bolide.hpp") say("the umbrella is for users, no library header includes it");
      else if (h.room.empty()) { // the umbrella sees every room but those of optional targets
        if (target_room == "gsl" || target_room == "png" || target_room == "hdf5") say("room " + target_room + " is an optional target, the umbrella leaves it out");
      } else if (find_room(h.room) && find_room(target_room) && !may_include(h.room, target_room)) {
        const bool up = find_room(target_room)->floor > find_room(h.room)->floor;
        say("room " + h.room + " must not include room " + target_room + ": the arrow runs " + (up ? "up" : "sideways"));
      }
    }
  }
  return found;
}

/// The arrows that exist: room -> rooms that its headers include.
inline std::map<std::string, std::set<std::string>> arrows(const std::vector<header>& headers) {
  std::map<std::string, std::set<std::string>> found;
  for (const auto& h : headers) {
    if (h.room.empty()) continue;
    found[h.room];
    for (const auto& line : h.includes)
      if (line.quoted && line.target.rfind("bolide/", 0) == 0 && room_of(line.target.substr(7)) != h.room) found[h.room].insert(room_of(line.target.substr(7)));
  }
  return found;
}

/// An arrow is drawn only if no longer way along other arrows says the same.
inline bool implied(const std::map<std::string, std::set<std::string>>& graph, const std::string& from, const std::string& to) {
  const auto reaches = [&](const auto& self, const std::string& start) -> bool {
    const auto at = graph.find(start);
    if (at == graph.end()) return false;
    return std::any_of(at->second.begin(), at->second.end(), [&](const std::string& next) { return next == to || self(self, next); });
  };
  const auto& direct = graph.at(from);
  return std::any_of(direct.begin(), direct.end(), [&](const std::string& next) { return next != to && reaches(reaches, next); });
}

/// Where a room's box lies in the picture.
struct box {
  int left, top, width, floor;
  int middle() const { return left + width / 2; }
};
inline constexpr int box_height = 34, floor_height = 100, margin = 20, picture_width = 1080;

/// Boxes floor by floor: core as wide as the house, upper rooms with room between them for the arrows that pass.
inline std::map<std::string, box> lay_out(const std::map<std::string, std::set<std::string>>& graph) {
  std::map<int, std::vector<std::string>> floors;
  for (const auto& r : house)
    if (graph.count(r.name)) floors[r.floor].push_back(r.name);
  const int top = floors.empty() ? 0 : floors.rbegin()->first;
  std::map<std::string, box> boxes;
  for (const auto& [floor, names] : floors) {
    const int n = static_cast<int>(names.size());
    const int width = floor == 0 ? picture_width - 2 * margin : floor == 1 ? 260 : 84;
    const int gap = n < 2 ? 0 : floor == 3 ? (picture_width - 2 * margin - n * width) / (n - 1) : 200;
    int left = (picture_width - n * width - (n - 1) * gap) / 2;
    for (const auto& name : names) {
      boxes[name] = {left, margin + (top - floor) * floor_height, width, floor};
      left += width + gap;
    }
  }
  return boxes;
}

/// The gap between (or beside) the boxes of a floor that lies nearest to x.
inline int nearest_gap(const std::map<std::string, box>& boxes, int floor, int x) {
  std::vector<box> row;
  for (const auto& [name, b] : boxes)
    if (b.floor == floor) row.push_back(b);
  std::sort(row.begin(), row.end(), [](const box& a, const box& b) { return a.left < b.left; });
  if (row.empty()) return x;
  int best = row.front().left - 12;
  const auto consider = [&](int candidate) {
    if (std::abs(candidate - x) < std::abs(best - x)) best = candidate;
  };
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    const int low = row[k].left + row[k].width + 8, high = row[k + 1].left - 8;
    consider(std::min(std::max(x, low), std::max(low, high)));
  }
  consider(row.back().left + row.back().width + 12);
  if (x < row.front().left - 12) best = x;
  if (x > row.back().left + row.back().width + 12) best = x;
  return best;
}

/// An arrow from one box down to another, around the boxes of the floors between.
inline std::string arrow(const std::map<std::string, box>& boxes, const box& from, const box& to) {
  int x = from.middle(), y = from.top + box_height;
  std::ostringstream path;
  path << "<path d=\"M" << x << ' ' << y;
  const auto go = [&](int next_x, int next_y) {
    const int bend = (next_y - y) / 2;
    path << 'C' << x << ' ' << y + bend << ' ' << next_x << ' ' << next_y - bend << ' ' << next_x << ' ' << next_y;
    x = next_x;
    y = next_y;
  };
  for (int floor = from.floor - 1; floor > to.floor; --floor) {
    const int row = from.top + (from.floor - floor) * floor_height;
    const int aim = x + (to.width > 500 ? 0 : (to.middle() - x) / (floor - to.floor + 1));
    go(nearest_gap(boxes, floor, aim), row - 4);
    path << 'L' << x << ' ' << (y = row + box_height + 4);
  }
  const int inset = std::min(30, to.width / 4);
  go(to.width > 100 ? std::min(std::max(x, to.left + inset), to.left + to.width - inset) : to.middle(), to.top - 2);
  path << "\" fill=\"none\" stroke=\"#5a6b7b\" stroke-width=\"1.2\" marker-end=\"url(#tip)\"/>\n";
  return path.str();
}

/// The rooms on their floors, core at the bottom, and the arrows of the include lines (those that others imply left out).
inline std::string picture(const std::vector<header>& headers) {
  const auto graph = arrows(headers);
  const auto boxes = lay_out(graph);
  const int height = boxes.count("core") ? boxes.at("core").top + box_height + margin : margin;
  std::ostringstream svg;
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << picture_width << ' ' << height
      << "\" font-family=\"sans-serif\" font-size=\"15\">\n"
      << "<title>The rooms of bolide and which includes which</title>\n"
      << "<defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">"
      << "<path d=\"M0 0L8 4L0 8z\" fill=\"#5a6b7b\"/></marker></defs>\n"
      << "<rect width=\"" << picture_width << "\" height=\"" << height << "\" fill=\"#ffffff\"/>\n";
  for (const auto& [from, targets] : graph)
    for (const auto& to : targets)
      if (boxes.count(from) && boxes.count(to) && !implied(graph, from, to)) svg << arrow(boxes, boxes.at(from), boxes.at(to));
  for (const auto& [name, b] : boxes) {
    const bool optional = name == "gsl" || name == "png" || name == "hdf5";
    svg << "<rect x=\"" << b.left << "\" y=\"" << b.top << "\" width=\"" << b.width << "\" height=\"" << box_height << "\" rx=\"5\" fill=\""
        << (optional ? "#fff4e0" : "#e8f0f8") << "\" stroke=\"#2c3e50\"" << (optional ? " stroke-dasharray=\"4 3\"" : "") << "/>"
        << "<text x=\"" << b.middle() << "\" y=\"" << b.top + 22 << "\" text-anchor=\"middle\" fill=\"#1b2733\">" << name << "</text>\n";
  }
  svg << "</svg>\n";
  return svg.str();
}

} // namespace rooms
