// SPDX-License-Identifier: MIT
// ParaView files: one .vtu per frame and a .pvd that lists the frames with their times.
//
// A .vtu is an UnstructuredGrid (VTK file format 1.0) of one vertex cell per particle, its arrays appended raw after the XML: no
// text, no base64, 4 bytes a number by default. An axisymmetric particle (r, z) is put at (x, y) = (z, r), so that ParaView shows it as
// the pictures do; vectors are turned alike. Other snapshots keep their axes; missing components are 0.
// Both kinds of file are written aside and renamed: after every frame the collection is complete, whenever the run is stopped.
// Cost: a copy and a write of the chosen columns, about 9 + 4 (3 + components) bytes a particle.
#pragma once

#include "bolide/observe/snapshot.hpp"
#include "bolide/observe/whole_file.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::observe {

struct vtk_options {
  std::vector<std::string> columns{}; // names; empty: all that the snapshot has
  bool double_precision = false;      // 8 bytes a number instead of 4
};

namespace detail {
/// Text that may stand in an XML attribute.
inline std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

/// The XML of the arrays on one side, their bytes on the other.
class vtk_arrays {
 public:
  /// Appends a block of `values` (its length in bytes first) and returns the element that refers to it.
  template <class T> std::string add(std::string_view type, std::string_view name, int components, const std::vector<T>& values) {
    std::string element = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + xml_text(name) + "\"";
    if (components > 1) element += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    element += " format=\"appended\" offset=\"" + std::to_string(bytes_.size()) + "\"/>\n";
    const std::uint64_t length = values.size() * sizeof(T);
    bytes_.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes_.append(reinterpret_cast<const char*>(values.data()), length);
    return element;
  }
  std::string add_numbers(std::string_view name, int components, const std::vector<double>& values, bool doubles) {
    if (doubles) return add("Float64", name, components, values);
    std::vector<float> narrow(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) narrow[i] = static_cast<float>(values[i]);
    return add("Float32", name, components, narrow);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// A column as ParaView wants it: vectors of the space get three components, (r, z) becomes (z, r, 0).
inline std::pair<int, std::vector<double>> vtk_layout(const snapshot& s, const column& c) {
  const bool vector = c.components == s.dimension && (c.components > 1 || c.name == "position" || c.name == "velocity");
  if (!vector) return {c.components, c.data};
  std::vector<double> out(3 * s.size(), 0.0);
  for (std::size_t i = 0; i < s.size(); ++i)
    for (int k = 0; k < c.components && k < 3; ++k) out[3 * i + static_cast<std::size_t>(s.axisymmetric && k < 2 ? 1 - k : k)] = c(i, k);
  return {3, std::move(out)};
}
} // namespace detail

/// The bytes of a .vtu file.
inline std::string vtu_content(const snapshot& s, const vtk_options& options = {}) {
  const std::size_t n = s.size();
  detail::vtk_arrays arrays;
  std::string points, cells, data;
  points = arrays.add_numbers("position", 3, detail::vtk_layout(s, s.at("position")).second, options.double_precision);
  std::vector<std::int32_t> particle(n), end(n);
  for (std::size_t i = 0; i < n; ++i) particle[i] = static_cast<std::int32_t>(i), end[i] = static_cast<std::int32_t>(i + 1);
  cells = arrays.add("Int32", "connectivity", 1, particle) + arrays.add("Int32", "offsets", 1, end) +
          arrays.add("UInt8", "types", 1, std::vector<std::uint8_t>(n, 1)); // 1 is VTK_VERTEX

  const auto add = [&](const column& c) {
    const auto [components, values] = detail::vtk_layout(s, c);
    data += arrays.add_numbers(c.name, components, values, options.double_precision);
  };
  if (options.columns.empty()) {
    for (const column& c : s.columns)
      if (c.name != "position") add(c);
  } else {
    for (const std::string& name : options.columns)
      if (name != "position") add(s.at(name));
  }
  if (s.id.size() == n) data += arrays.add("UInt32", "id", 1, s.id);
  if (s.body.size() == n) data += arrays.add("Int32", "body", 1, std::vector<std::int32_t>(s.body.begin(), s.body.end()));

  const std::string order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", count = std::to_string(n);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" + order +
         "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
         "format=\"ascii\">" + to_text(s.time) + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" + count + "\" NumberOfCells=\"" +
         count + "\">\n<PointData>\n" + data + "</PointData>\n<Points>\n" + points + "</Points>\n<Cells>\n" + cells +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + arrays.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

inline void write_vtu(const std::filesystem::path& path, const snapshot& s, const vtk_options& options = {}) {
  write_whole_file(path, vtu_content(s, options));
}

/// The frames of one run: FOLDER/NAME_0000.vtu, ... and FOLDER/NAME.pvd.
class vtk_series {
 public:
  explicit vtk_series(std::filesystem::path folder, std::string name = "particles", vtk_options options = {})
      : folder_(std::move(folder)), name_(std::move(name)), options_(std::move(options)) {}

  void write(const snapshot& s) {
    const std::string file = file_name(frames_.size());
    write_vtu(folder_ / file, s, options_);
    frames_.emplace_back(s.time, file);
    write_whole_file(collection(), collection_content());
  }

  std::filesystem::path collection() const { return folder_ / (name_ + ".pvd"); }
  std::size_t frames() const { return frames_.size(); }
  /// For checkpoints (concepts/archive.hpp): the numbering goes on; a frame that was written after the checkpoint is written again.
  template <class A> void archive(A& a) {
    std::vector<double> times;
    for (const auto& f : frames_) times.push_back(f.first);
    a.value("times", times);
    frames_.clear();
    for (const double t : times) frames_.emplace_back(t, file_name(frames_.size()));
  }
  /// The file of the last frame; empty: none is written yet.
  std::filesystem::path last_frame() const { return frames_.empty() ? std::filesystem::path() : folder_ / frames_.back().second; }

 private:
  std::string file_name(std::size_t frame) const {
    char number[32];
    std::snprintf(number, sizeof number, "_%04zu.vtu", frame);
    return name_ + number;
  }
  std::string collection_content() const {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const auto& [time, file] : frames_)
      if (std::filesystem::exists(folder_ / file)) // not there: the run went on in another folder
        text += "<DataSet timestep=\"" + to_text(time) + "\" file=\"" + detail::xml_text(file) + "\"/>\n";
    return text + "</Collection>\n</VTKFile>\n";
  }
  std::filesystem::path folder_;
  std::string name_;
  vtk_options options_;
  std::vector<std::pair<double, std::string>> frames_; // time, file name
};

} // namespace bolide::observe
