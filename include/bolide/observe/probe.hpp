// SPDX-License-Identifier: MIT
// Samples chosen fields at fixed points of space: one row per point and sample in a table of comma-separated values.
//
//   using point = vec<double, 2>;
//   observe::probe gauge("gauge.csv", std::vector{point{0, 1.1 * mm}, point{2 * mm, 1.1 * mm}}, 0.05 * us, {"pressure", "velocity"});
//   sim.run(6.6 * us, gauge);
//
// The value at point x is the mean over the particles within a cell (side h) of it along every axis, with the weights
//   w_p = V_p prod_d (1 - |x_d - x_pd| / h),     V_p the spatial volume of the particle (in r-z that of its ring),
// so it is continuous in time as particles come and go, and smooths over 2 h. It is no interpolation: a linear field is met up to the
// scatter of the particles (on an undisturbed lattice to round-off inside the material; within h of a free surface the mean is one-sided).
// A field that numbers kinds (region) is that of the particle with the largest weight. In r-z a point closer than h to
// the axis also sees the images of particles at -r, with the signs that the mirror gives, so that v_r is 0 at r = 0.
// `particles` says how many particles were within a cell. None: no material there, and the fields are empty cells, not 0. The same for a field that
// none of these particles has.
// Columns: time, step, point (its number), its coordinates, particles, and the chosen fields (default: density, velocity, pressure, energy,
// temperature). Times as in observe/tracer.hpp. A row is on disk as soon as it is written.
// Cost: O(particles x points) comparisons a sample; fields are computed for particles within a cell of a point.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"
#include "bolide/observe/csv.hpp"
#include "bolide/observe/every.hpp"
#include "bolide/observe/selection.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bolide::observe {

template <int Dim> class probe {
 public:
  using point = vec<double, Dim>;

  probe(std::filesystem::path path, std::vector<point> points, schedule when = 0.0, selection chosen = {})
      : path_(std::move(path)), points_(std::move(points)), when_(std::move(when)), chosen_(std::move(chosen)), strict_(!chosen_.empty()) {
    if (!strict_) chosen_ = {"density", "velocity", "pressure", "energy", "temperature"};
    require(!points_.empty(), "points of the probe " + path_.string(), 0, "at least 1");
    for (const point& x : points_)
      for (int d = 0; d < Dim; ++d) require(std::isfinite(x[d]), "coordinate of a point of the probe " + path_.string(), x[d], "finite", "m");
  }

  template <class Solver> void watch(const Solver& sim) {
    static_assert(Solver::dim == Dim, "bolide: probe: its points have another number of axes than the space of the solver");
    if (!table_) open(sim);
    if (sim.steps() != last_step_ && when_.due(sim.time())) sample(sim);
  }
  template <class Solver> void finish(const Solver& sim) {
    if (sim.steps() != last_step_ && when_.with_end()) sample(sim);
  }
  std::size_t rows() const { return table_ ? table_->rows() : 0; }
  /// For the message of a run that stops.
  std::string last_output() const { return rows() > 0 ? path_.string() : ""; }
  /// For checkpoints (concepts/archive.hpp): the table goes on where it stood, without a row twice.
  template <class A> void archive(A& a) {
    if (table_ && !A::reading) from_ = table_->mark();
    a.value("table", from_);
    a.value("last_step", last_step_);
    a.value("when", when_);
    if (A::reading) table_.reset();
  }

 private:
  /// What has come together at one point.
  struct sums {
    long particles = 0;
    std::vector<double> value, weight; // per component; of a field of kinds: the value and the largest weight so far
  };

  template <class Solver> void open(const Solver& sim) {
    if (Solver::space::hoop)
      for (const point& x : points_) require(x[0] >= 0, "radius of a point of the probe " + path_.string(), x[0], "non-negative", "m");
    std::vector<std::string> header{"time (s)", "step", "point"};
    for (const char axis : axes_of<typename Solver::space>()) header.push_back(std::string(1, axis) + " (m)");
    header.emplace_back("particles");
    const std::size_t before = header.size();
    for (std::string& name : field_reader<Solver>(sim, chosen_, strict_).column_names()) header.push_back(std::move(name));
    cells_ = header.size() - before;
    table_.emplace(path_, header, from_);
  }

  template <class Solver> void sample(const Solver& sim) {
    last_step_ = sim.steps();
    const field_reader<Solver> fields(sim, chosen_, strict_);
    std::vector<sums> at(points_.size(), {0, std::vector<double>(cells_, 0.0), std::vector<double>(cells_, 0.0)});
    std::size_t body = 0;
    sim.for_each_body([&](const auto& set) {
      auto particle = particles_of<Solver>(set);
      for (std::size_t i = 0; i < set.columns.size(); ++i) {
        point x;
        for (int d = 0; d < Dim; ++d) x[d] = static_cast<double>(set.columns.template get<field::position>(d)[i]);
        for (std::size_t k = 0; k < points_.size(); ++k) {
          const double direct = hat(points_[k], x, sim.cell());
          double image = 0;
          if constexpr (Solver::space::hoop) {
            point mirrored = x;
            mirrored[0] = -x[0];
            image = hat(points_[k], mirrored, sim.cell());
          }
          if (!(direct > 0 || image > 0)) continue;
          particle.move_to(i);
          add(at[k], fields, particle, body, direct, image);
        }
      }
      ++body;
    });
    for (std::size_t k = 0; k < points_.size(); ++k) row(sim, k, at[k], fields);
  }

  static double hat(const point& a, const point& b, double h) {
    double w = 1;
    for (int d = 0; d < Dim; ++d) w *= std::fmax(0.0, 1 - std::abs(a[d] - b[d]) / h);
    return w;
  }

  template <class Fields, class Particle>
  void add(sums& s, const Fields& fields, const Particle& particle, std::size_t body, double direct, double image) const {
    using space = typename Fields::space;
    ++s.particles;
    const double volume = particle.template stored<field::volume>();
    fields.read(particle, body, [&](std::size_t c, int component, double x) {
      const std::size_t cell = fields.first_cell(c) + static_cast<std::size_t>(component);
      const double weight = (direct + image) * volume;
      if (numbers_kinds(chosen_[c])) {
        if (weight > s.weight[cell]) s.value[cell] = x, s.weight[cell] = weight;
        return;
      }
      // a component with an odd number of radial axes changes its sign in the mirror
      const std::string axes = component_axes<space>(fields.headings()[c].order)[static_cast<std::size_t>(component)];
      const bool odd = std::count(axes.begin(), axes.end(), 'r') % 2 == 1;
      s.value[cell] += volume * (odd ? direct - image : direct + image) * x;
      s.weight[cell] += weight;
    });
  }
  static bool numbers_kinds(const chosen_field& f) { return f.name == "region"; }

  template <class Solver> void row(const Solver& sim, std::size_t k, const sums& s, const field_reader<Solver>& fields) {
    std::vector<csv_cell> cells{sim.time(), sim.steps(), k};
    for (int d = 0; d < Dim; ++d) cells.emplace_back(points_[k][d]);
    cells.emplace_back(s.particles);
    for (std::size_t c = 0; c < chosen_.size(); ++c)
      for (int component = 0; component < fields.headings()[c].components(); ++component) {
        const std::size_t cell = fields.first_cell(c) + static_cast<std::size_t>(component);
        if (!(s.weight[cell] > 0)) cells.emplace_back("");
        else cells.emplace_back(numbers_kinds(chosen_[c]) ? s.value[cell] : s.value[cell] / s.weight[cell]);
      }
    table_->row(cells);
  }

  std::filesystem::path path_;
  std::vector<point> points_;
  schedule when_;
  selection chosen_;
  bool strict_;
  long last_step_ = -1;
  std::size_t cells_ = 0;
  csv_mark from_; // of a checkpoint
  std::optional<csv_table> table_; // opened at the first look, when the fields are known
};

template <int Dim> probe(std::filesystem::path, std::vector<vec<double, Dim>>, schedule, selection) -> probe<Dim>;
template <int Dim> probe(std::filesystem::path, std::vector<vec<double, Dim>>, schedule) -> probe<Dim>;
template <int Dim> probe(std::filesystem::path, std::vector<vec<double, Dim>>) -> probe<Dim>;

} // namespace bolide::observe
