// SPDX-License-Identifier: MIT
// Files are read back by a small parser of the format, written from the VTK file format's description.
#include "bolide/observe/vtk.hpp"

#include "test_folder.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

namespace bolide::observe {
namespace {

/// The value of an attribute of the element that starts at `at`.
std::string attribute(const std::string& text, std::size_t at, const std::string& name) {
  const std::size_t end = text.find('>', at), found = text.find(" " + name + "=\"", at);
  if (found == std::string::npos || found > end) return {};
  const std::size_t from = found + name.size() + 3;
  return text.substr(from, text.find('"', from) - from);
}

/// One array of an appended block: its type, components and bytes.
struct array {
  std::string type;
  int components = 1;
  std::string bytes;
  template <class T> std::vector<T> as() const {
    std::vector<T> out(bytes.size() / sizeof(T));
    std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
  }
};

std::map<std::string, array> parse(const std::string& file) {
  const std::size_t appended = file.find("<AppendedData encoding=\"raw\">");
  const std::size_t start = file.find('_', appended) + 1;
  std::map<std::string, array> out;
  for (std::size_t at = file.find("<DataArray"); at < appended; at = file.find("<DataArray", at + 1)) {
    if (attribute(file, at, "format") != "appended") continue;
    array a;
    a.type = attribute(file, at, "type");
    const std::string components = attribute(file, at, "NumberOfComponents");
    if (!components.empty()) a.components = std::stoi(components);
    const std::size_t offset = start + std::stoul(attribute(file, at, "offset"));
    std::uint64_t length = 0;
    std::memcpy(&length, file.data() + offset, sizeof length);
    a.bytes = file.substr(offset + sizeof length, length);
    EXPECT_EQ(a.bytes.size(), length);
    out[attribute(file, at, "Name")] = a;
  }
  return out;
}

snapshot three() {
  snapshot s;
  s.time = 1.5e-6, s.axisymmetric = true, s.id = {7, 8, 9}, s.body = {0, 1, 1};
  s.add("position", "m", 2, {1, 2, 3, 4, 5, 6}), s.add("velocity", "m/s", 2, {10, 20, 30, 40, 50, 60});
  s.add("mass", "kg", 1, {0.1, 0.2, 0.3}), s.add("temperature", "K", 1, {300, 400, 500});
  return s;
}

TEST(vtk, vtu_reads_back) {
  const std::string file = vtu_content(three());
  auto arrays = parse(file);
  EXPECT_NE(file.find("NumberOfPoints=\"3\" NumberOfCells=\"3\""), std::string::npos);
  EXPECT_NE(file.find("header_type=\"UInt64\""), std::string::npos);
  EXPECT_EQ(arrays["position"].components, 3);
  EXPECT_EQ(arrays["position"].as<float>(), (std::vector<float>{2, 1, 0, 4, 3, 0, 6, 5, 0})) << "(r, z) becomes (z, r, 0)";
  EXPECT_EQ(arrays["velocity"].as<float>(), (std::vector<float>{20, 10, 0, 40, 30, 0, 60, 50, 0}));
  EXPECT_EQ(arrays["temperature"].as<float>(), (std::vector<float>{300, 400, 500}));
  EXPECT_EQ(arrays["connectivity"].as<std::int32_t>(), (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(arrays["offsets"].as<std::int32_t>(), (std::vector<std::int32_t>{1, 2, 3}));
  EXPECT_EQ(arrays["types"].as<std::uint8_t>(), (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(arrays["id"].as<std::uint32_t>(), (std::vector<std::uint32_t>{7, 8, 9}));
  EXPECT_EQ(arrays["body"].as<std::int32_t>(), (std::vector<std::int32_t>{0, 1, 1}));
}

TEST(vtk, columns_are_chosen_and_kept_in_double) {
  auto arrays = parse(vtu_content(three(), {.columns = {"mass"}, .double_precision = true}));
  EXPECT_EQ(arrays.count("temperature"), 0u);
  EXPECT_EQ(arrays["mass"].type, "Float64");
  EXPECT_EQ(arrays["mass"].as<double>(), (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_THROW(vtu_content(three(), {.columns = {"colour"}}), bad_parameter);
}

TEST(vtk, line_of_particles_gets_three_coordinates) {
  snapshot s;
  s.dimension = 1;
  s.add("position", "m", 1, {1, 2}), s.add("velocity", "m/s", 1, {3, 4}), s.add("mass", "kg", 1, {1, 1});
  auto arrays = parse(vtu_content(s));
  EXPECT_EQ(arrays["position"].as<float>(), (std::vector<float>{1, 0, 0, 2, 0, 0}));
  EXPECT_EQ(arrays["mass"].components, 1);
}

TEST(vtk, no_particles_is_a_valid_file) {
  snapshot s;
  s.add("position", "m", 2, {}), s.add("mass", "kg", 1, {});
  EXPECT_EQ(parse(vtu_content(s))["position"].bytes.size(), 0u);
}

TEST(vtk, collection_is_complete_after_every_frame) {
  const test::folder f("vtk");
  vtk_series series(f.path / "out", "cloud");
  snapshot s = three();
  for (int frame = 0; frame < 3; ++frame) {
    s.time = frame * 1e-6;
    series.write(s);
    const std::string pvd = test::bytes_of(series.collection());
    EXPECT_NE(pvd.find("</Collection>\n</VTKFile>\n"), std::string::npos);
    int listed = 0;
    for (std::size_t at = pvd.find("<DataSet"); at != std::string::npos; at = pvd.find("<DataSet", at + 1), ++listed) {
      EXPECT_EQ(std::stod(attribute(pvd, at, "timestep")), listed * 1e-6);
      EXPECT_TRUE(std::filesystem::exists(f.path / "out" / attribute(pvd, at, "file")));
    }
    EXPECT_EQ(listed, frame + 1);
  }
  EXPECT_EQ(parse(test::bytes_of(f.path / "out" / "cloud_0002.vtu"))["mass"].as<float>().size(), 3u);
}

} // namespace
} // namespace bolide::observe
