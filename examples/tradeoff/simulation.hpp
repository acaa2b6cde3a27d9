// SPDX-License-Identifier: MIT
// A scene in r-z as the problems describe it, and a run as they see it. Compositions, materials and problems are compiled apart and meet here:
// materials behind any_material (one virtual call per chunk of particles), geometries as functions.
#pragma once

#include "settings.hpp"

#include "bolide/core/algebra.hpp"
#include "bolide/grid/mirror.hpp"
#include "bolide/material/any_material.hpp"
#include "bolide/observe/snapshot.hpp"
#include "bolide/space/axisymmetric.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace tradeoff {

using point = bolide::vec<double, 2>; // r, z

/// A material in both precisions, and the state that it starts in.
struct chosen_material {
  bolide::any_material<double, bolide::space::axisymmetric> in_double;
  bolide::any_material<float, bolide::space::axisymmetric> in_float;
  double density, energy; // kg/m3, J/kg
};
template <class Material> chosen_material choose(const Material& m, double density, double energy) {
  return {bolide::any_material<double, bolide::space::axisymmetric>(m), bolide::any_material<float, bolide::space::axisymmetric>(m), density, energy};
}

/// A geometry (particles/geometry.hpp) known at run time.
struct region {
  static constexpr int dim = 2;
  point from, to, first;                      // bounds; the lattice's anchor
  std::function<bool(const point&)> inside;   // empty: all within the bounds
  double cubic_metres;
  point anchor() const { return first; }
  point low() const { return from; }
  point high() const { return to; }
  bool contains(const point& x, double) const { return (x.array() > from.array()).all() && (x.array() < to.array()).all() && (!inside || inside(x)); }
  double volume(bool) const { return cubic_metres; }
};
/// Ring, disc or cylinder between two corners.
region block(point low, point high);
/// The half z > 0 of a ball about the origin, by the lattice points' centres.
region half_ball(double radius);

/// How a particle starts. The gradient (dv_i/dx_j row by row) is what APIC carries.
struct start {
  point velocity{0, 0};
  double density = 0, energy = 0; // 0: the material's own
  double gradient[4] = {0, 0, 0, 0};
};

struct part {
  region shape;
  chosen_material material;
};

struct scene {
  std::vector<part> parts; // one or two
  std::vector<bolide::grid::mirror> mirrors{};
  std::function<start(const point& x, int body)> at_start;
  double cell;      // m
  double first_step = 0.1;
  double dt_floor = 1e-6;
};

/// One particle as the measures see it (SI).
struct particle {
  int body;
  std::size_t id;
  point x, v;
  double mass, volume, pressure, energy;
};

class simulation {
public:
  virtual ~simulation() = default;
  /// To time `until` (s), looking at every step if a watch is given. Throws failed_run.
  virtual void advance(double until, const std::function<void()>& watch = {}) = 0;
  virtual double time() const = 0;
  virtual double dt() const = 0;
  virtual void each(const std::function<void(const particle&)>& f) const = 0;
  virtual bolide::observe::snapshot snapshot() const = 0;
  virtual outcome costs() const = 0; // all but the error
};

/// The scene with the settings' composition.
std::unique_ptr<simulation> compose(const settings& s, const scene& of);

/// Thread CPU time, s.
double cpu_seconds();

} // namespace tradeoff
