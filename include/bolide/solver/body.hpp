// SPDX-License-Identifier: MIT
// A body as the user describes it: a shape, a material, how finely it is divided, how it moves and in what state it starts.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/contract.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace bolide {

/// Density (kg/m3) and specific energy (J/kg) at the start; eos::ambient_state and eos::cold_state make one.
struct initial_state {
  double density;
  double energy;
};

/// One particle before the first step, offered to solver.initialise: position (m), velocity (m/s), density (kg/m3; its mass follows,
/// its volume stays) and specific energy (J/kg) may be changed, and the gradient of the velocity (row by row, 1/s) that APIC starts from.
template <int Dim> struct initial_point {
  const std::string& body;
  vec<double, Dim> position, velocity;
  double density, energy;
  std::array<double, static_cast<std::size_t>(Dim* Dim)> velocity_gradient{};
};

/// Random shift of the lattice points: uniform within +-fraction of the spacing on each axis, mass kept; the same seed, the same points.
struct jitter {
  double fraction = 0;
  std::uint64_t seed = 1;
};

template <class Geometry, class Material> struct body {
  std::string name;
  Geometry geometry;
  Material material;
  double spacing; // m
  initial_state state;
  vec<double, Geometry::dim> velocity = vec<double, Geometry::dim>::Zero(); // m/s
  bolide::jitter jitter{};

  body(std::string n, Geometry g, Material m, double dx, initial_state s, vec<double, Geometry::dim> v = vec<double, Geometry::dim>::Zero(), bolide::jitter j = {})
      : name(std::move(n)), geometry(std::move(g)), material(std::move(m)), spacing(dx), state(s), velocity(std::move(v)), jitter(j) {
    require(dx > 0, "particle spacing of body " + name, dx, "positive", "m");
    require(s.density > 0, "initial density of body " + name, s.density, "positive", "kg/m3");
    require(j.fraction >= 0 && j.fraction < 0.5, "jitter of body " + name, j.fraction, "in [0, 0.5) of the spacing");
  }
};

} // namespace bolide
