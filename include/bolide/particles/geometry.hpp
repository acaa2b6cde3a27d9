// SPDX-License-Identifier: MIT
// Shapes of bodies, filled with particles on a lattice of half-offset points: anchor + (i + 1/2) spacing on every axis.
//
// A geometry gives its anchor, its bounds, whether a lattice point belongs to it, and its exact volume (so that the discrete mass can be
// reported beside the geometric one): volume(radial) in m3, of the body of revolution where axis 0 is a radius, of one metre of depth in
// plane strain, of one square metre in 1-D. Lengths in m.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/contract.hpp"

#include <cmath>
#include <numbers>

namespace bolide {

/// A sphere: in r-z its centre lies on the axis. A lattice point belongs to it when it is at most R - spacing/2 from the centre: for the
/// paper's sphere (R = 4.75 mm, spacing 0.05 mm) these are its 14,010 points, 1.7 % light in mass. A coarse sphere is lighter (14 % at 20 points per
/// diameter in 3-D): shell{centre, 0, R} takes the points by their centre and has the right mass on average.
template <int Dim> struct sphere {
  static constexpr int dim = Dim;
  vec<double, Dim> centre;
  double radius;

  sphere(vec<double, Dim> c, double r) : centre(std::move(c)), radius(r) { require(r > 0, "sphere radius", r, "positive", "m"); }
  vec<double, Dim> anchor() const { return centre; }
  vec<double, Dim> low() const { return centre.array() - radius; }
  vec<double, Dim> high() const { return centre.array() + radius; }
  bool contains(const vec<double, Dim>& x, double spacing) const { return (x - centre).norm() <= radius - spacing / 2; }
  double volume(bool radial) const {
    if (Dim == 1) return 2 * radius;
    return Dim == 2 && !radial ? std::numbers::pi * radius * radius : 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  }
};

/// What lies between two concentric spheres: a hollow sphere (3-D, and r-z with its centre on the axis) or a ring (plane strain). Lattice
/// points belong to it by their centre, so that its mass is right on average.
template <int Dim> struct shell {
  static constexpr int dim = Dim;
  vec<double, Dim> centre;
  double inner, outer;

  shell(vec<double, Dim> c, double from, double to) : centre(std::move(c)), inner(from), outer(to) {
    require(from >= 0, "inner radius of a shell", from, "non-negative", "m");
    require(to > from, "outer radius of a shell", to, "greater than the inner one", "m");
  }
  vec<double, Dim> anchor() const { return centre; }
  vec<double, Dim> low() const { return centre.array() - outer; }
  vec<double, Dim> high() const { return centre.array() + outer; }
  bool contains(const vec<double, Dim>& x, double) const {
    const double r = (x - centre).norm();
    return r > inner && r < outer;
  }
  double volume(bool radial) const { return sphere<Dim>(centre, outer).volume(radial) - (inner > 0 ? sphere<Dim>(centre, inner).volume(radial) : 0); }
};

/// A box between two corners; in r-z a disc or, when its lower radius is positive, a ring.
template <int Dim> struct box {
  static constexpr int dim = Dim;
  vec<double, Dim> corner_low, corner_high;

  box(vec<double, Dim> a, vec<double, Dim> b) : corner_low(std::move(a)), corner_high(std::move(b)) {
    for (int d = 0; d < Dim; ++d) require(corner_high[d] > corner_low[d], "box edge", corner_high[d] - corner_low[d], "positive", "m");
  }
  vec<double, Dim> anchor() const { return corner_low; }
  vec<double, Dim> low() const { return corner_low; }
  vec<double, Dim> high() const { return corner_high; }
  bool contains(const vec<double, Dim>& x, double) const { return (x.array() > corner_low.array()).all() && (x.array() < corner_high.array()).all(); }
  double volume(bool radial) const {
    if (!radial) return (corner_high - corner_low).prod();
    const double from = std::max(corner_low[0], 0.0);
    return std::numbers::pi * (corner_high[0] * corner_high[0] - from * from) * (corner_high[1] - corner_low[1]);
  }
};

template <int Dim> sphere(vec<double, Dim>, double) -> sphere<Dim>;
template <int Dim> shell(vec<double, Dim>, double, double) -> shell<Dim>;
template <int Dim> box(vec<double, Dim>, vec<double, Dim>) -> box<Dim>;

/// Calls place(point) for every lattice point of a geometry, last axis fastest. In r-z (`radial`) only points of r > 0 count.
template <class Geometry, int Dim, class F> void for_each_lattice_point(const Geometry& g, const vec<double, Dim>& anchor, double spacing, bool radial, F&& place) {
  require(spacing > 0, "particle spacing", spacing, "positive", "m");
  vec<double, Dim> first = g.low(), last = g.high();
  if (radial) first[0] = std::max(first[0], 0.0);
  const auto lower = ((first - anchor) / spacing).array().floor().eval(), upper = ((last - anchor) / spacing).array().ceil().eval();
  vec<double, Dim> i = lower;
  for (;;) {
    const vec<double, Dim> x = anchor.array() + (i.array() + 0.5) * spacing;
    if ((!radial || x[0] > 0) && g.contains(x, spacing)) place(x);
    int d = Dim - 1;
    for (; d >= 0; --d) {
      if (++i[d] < upper[d]) break;
      i[d] = lower[d];
    }
    if (d < 0) return;
  }
}

} // namespace bolide
