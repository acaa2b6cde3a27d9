// SPDX-License-Identifier: MIT
// What an observer sees: a copy of the particles at one time, in double precision and independent of how the solver stores them.
//
// A snapshot is a table. Its rows are particles, its columns have a name, an SI unit and a number of components; a column that
// the composed material does not know (a temperature without a thermal equation of state) is absent, not zero.
// Always there: position, velocity, mass. Names that the observers of this room understand besides:
//   volume (m3, spatial, voids included)  density (kg/m3, of the material, voids excluded)  energy (J/kg)  pressure (Pa)
//   temperature, melting_temperature (K)  melt_fraction (0..1)  region (numbers of bolide::region)  failed (0/1)
//   plastic_strain  peak_pressure (Pa, largest so far)  void_fraction (0..1)
// In an axisymmetric snapshot position and velocity are (r, z) and mass and volume are those of the whole ring, not per radian.
// Cost: one copy of the chosen columns; taken when an observer is due, never in the time loop.
#pragma once

#include "bolide/core/contract.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::observe {

/// One column: component k of particle i is data[i*components + k].
struct column {
  std::string name;
  std::string unit; // SI, "1" for a pure number
  int components = 1;
  std::vector<double> data;

  double operator()(std::size_t particle, int component = 0) const {
    return data[particle * static_cast<std::size_t>(components) + static_cast<std::size_t>(component)];
  }
};

struct snapshot {
  double time = 0; // s
  long step = 0;
  int dimension = 2;         // components of position and velocity
  bool axisymmetric = false; // position is (r, z), mass that of the ring
  double spacing = 0;        // m, distance of the particles at the start
  std::vector<std::uint32_t> id;
  std::vector<int> body; // index into body_names
  std::vector<std::string> body_names;
  std::vector<column> columns;
  std::string axes{}; // one letter per component of the position; empty: r z, or x y z

  std::string axis_letters() const {
    return !axes.empty() ? axes : axisymmetric ? "rz" : std::string("xyz").substr(0, static_cast<std::size_t>(dimension));
  }

  /// Number of particles (rows of the mass column; zero without one).
  std::size_t size() const {
    const column* mass = find("mass");
    return mass ? mass->data.size() : 0;
  }

  /// The column of that name, or nullptr.
  const column* find(std::string_view name) const {
    for (const column& c : columns)
      if (c.name == name) return &c;
    return nullptr;
  }

  /// The column of that name; throws a sentence that lists what there is.
  const column& at(std::string_view name) const {
    if (const column* c = find(name)) return *c;
    throw bad_parameter("the snapshot has no column \"" + std::string(name) + "\"; it has " + listing());
  }

  /// Adds a column. Its length must fit the particles that are there.
  column& add(std::string name, std::string unit, int components, std::vector<double> data) {
    require(components >= 1, "components of column \"" + name + "\"", components, "at least 1");
    require(find(name) == nullptr, "number of columns named \"" + name + "\"", 2, "1");
    const std::size_t rows = data.size() / static_cast<std::size_t>(components);
    require(rows * static_cast<std::size_t>(components) == data.size(), "numbers in column \"" + name + "\"",
            static_cast<double>(data.size()), "a multiple of its components");
    for (const column& c : columns) {
      const std::size_t expected = c.data.size() / static_cast<std::size_t>(c.components);
      require(rows == expected, "particles in column \"" + name + "\"", static_cast<double>(rows),
              "the " + std::to_string(expected) + " of column \"" + c.name + "\"");
    }
    columns.push_back({std::move(name), std::move(unit), components, std::move(data)});
    return columns.back();
  }

  /// The names of the columns, for messages.
  std::string listing() const {
    std::string text;
    for (const column& c : columns) text += (text.empty() ? "" : ", ") + c.name;
    return text.empty() ? "no columns" : text;
  }
};

} // namespace bolide::observe
