// SPDX-License-Identifier: MIT
// Fragments: the connected components of a cloud of particles, what each of them is, and how they are distributed.
//
//   const observe::fragments pieces(take_snapshot(sim), {.least_particles = 4});
//   pieces.write_csv("fragments.csv");     one row per fragment, heaviest first
//   pieces.write_json("fragments.json");   totals, options and distributions
//
// Two particles are linked when their distance is at most the linking length (to 1e-9 of it); a fragment is whatever hangs together by
// links. Default: 2 x the particle spacing of the start, one cell with two particles to a cell and axis: material stretched so far has lost contact on
// the grid. The number of fragments depends on this choice (docs/debris_cloud.md has a measured sensitivity): state it with the result.
// A fragment of one or two particles is not resolved; `least_particles` counts such ones as dust.
//
// Space. 1-D: slabs. 2-D plane: cylinders of unit thickness. 3-D: pieces. r-z: a component is a body of revolution: an axis body, if its
// innermost particle is linked with its own image across the axis (2 r <= linking length), or a ring. A ring is no piece of debris: a
// real one breaks up along its circumference, so the number of rings is no count of fragments, while their masses and sections say
// how much material is in clumps of which width.
//
// Of each fragment, x over its particles: mass M = sum m;  centre = sum m x / M and velocity = sum m v / M (in r-z of the section, (r, z));
//   volume = sum m / density (voids excluded; of the rings in r-z);   extents: largest less smallest coordinate of particle centres
//   diameter: of the sphere of that volume, (6 V / pi)^1/3, in 3-D and of an axis body; of the circle of the section's area A,
//     sqrt(4 A / pi), in the plane (A = V per metre) and of a ring (A = sum V / 2 pi r); the length V in 1-D
//   angular momentum about the centre = sum m (x - centre) x (v - velocity): (z) in the plane, (x, y, z) in 3-D; none in 1-D and in r-z
//   kinetic energy of the motion relative to the mean velocity = sum m |v - velocity|^2 / 2, J
// Sums run in the order of the particles' ids, so the answer has the same bits whatever the order of the rows. Every particle is in
// exactly one of: a fragment, the dust, what was left out, what is not finite.
// Cost: O(n) for a linking length of a few spacings: a hash grid of cells of that length and a union-find with path halving. 1e6 particles of
// a dense lattice, 2 spacings: 1.8 s in 2-D, 4.3 s in 3-D.
#pragma once

#include "bolide/observe/csv.hpp"
#include "bolide/observe/json.hpp"
#include "bolide/observe/snapshot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bolide::observe {

/// What becomes of particles that have failed (column `failed` above 0.5).
enum class failed_particles {
  linked,  // as any other
  dust,    // each for itself: part of no fragment, counted as dust
  left_out // not counted at all but as left out
};
inline const char* name(failed_particles f) { return f == failed_particles::linked ? "linked" : f == failed_particles::dust ? "dust" : "left_out"; }

/// Space that repeats along an axis: particles near `high` are neighbours of those near `low`.
struct periodic_range {
  int axis;
  double low, high; // m
};

struct fragment_options {
  double linking_length = 0; // m; 0: twice the spacing of the particles at the start
  std::size_t least_particles = 1;
  failed_particles failed = failed_particles::linked;
  bool across_bodies = true; // may particles of different bodies be linked?
  std::vector<periodic_range> periodic{};
};

enum class fragment_kind { piece, axis_body, ring };
inline const char* name(fragment_kind k) { return k == fragment_kind::piece ? "piece" : k == fragment_kind::axis_body ? "axis_body" : "ring"; }

struct fragment {
  fragment_kind kind = fragment_kind::piece;
  std::size_t particles = 0;
  std::uint32_t first_id = 0; // smallest id of its particles (their row where the snapshot has no ids)
  double mass = 0, volume = 0, diameter = 0, internal_kinetic = 0; // kg, m3, m, J
  std::array<double, 3> centre{}, velocity{}, extent{}, angular_momentum{}; // m, m/s, m, kg m2/s
  std::vector<double> mass_by_body; // kg

  double speed() const { return std::hypot(velocity[0], velocity[1], velocity[2]); }
};

/// Particles that are part of no fragment.
struct loose_material {
  std::size_t particles = 0;
  double mass = 0; // kg
};

/// Number and mass of fragments by ranges of a value: range k is edge[k] <= value < edge[k + 1], the last one closed.
struct histogram {
  std::vector<double> edge, mass; // mass in kg
  std::vector<std::size_t> number;
};

class fragments {
 public:
  explicit fragments(const snapshot& s, fragment_options options = {});

  const std::vector<fragment>& list() const { return list_; } // heaviest first, equal ones by first_id
  std::size_t size() const { return list_.size(); }
  const fragment& operator[](std::size_t k) const { return list_[k]; }
  /// Number in list() of the fragment that holds row i of the snapshot, -1: none.
  const std::vector<int>& of_particle() const { return of_particle_; }
  double linking_length() const { return link_; }
  const loose_material& dust() const { return dust_; }
  const loose_material& left_out() const { return left_out_; }
  std::size_t not_finite() const { return not_finite_; } // particles whose place, velocity or mass is no number
  double mass() const {
    double sum = 0;
    for (const fragment& f : list_) sum += f.mass;
    return sum;
  }

  /// N(m), the number of fragments of at least mass m, as its steps (m, N) from the heaviest on.
  std::vector<std::pair<double, std::size_t>> cumulative_by_mass() const {
    std::vector<std::pair<double, std::size_t>> steps;
    for (std::size_t k = 0; k < list_.size(); ++k) {
      if (!steps.empty() && steps.back().first == list_[k].mass) ++steps.back().second;
      else steps.emplace_back(list_[k].mass, k + 1);
    }
    return steps;
  }
  /// Diameters in `bins` ranges of equal ratio from the smallest to the largest.
  histogram by_size(int bins = 12) const {
    return count([](const fragment& f) { return f.diameter; }, bins, true);
  }
  /// Speeds in `bins` equal ranges from the least to the largest.
  histogram by_speed(int bins = 12) const {
    return count([](const fragment& f) { return f.speed(); }, bins, false);
  }

  void write_csv(const std::filesystem::path& path) const;
  void write_json(const std::filesystem::path& path) const;

 private:
  struct cell {
    std::array<std::int64_t, 3> index{};
    friend bool operator==(const cell&, const cell&) = default;
  };
  struct cell_hash {
    std::size_t operator()(const cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t i : c.index) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
      return static_cast<std::size_t>(h);
    }
  };

  void check(const snapshot& s) const;
  void link_up(const snapshot& s, const std::vector<std::size_t>& rows);
  fragment measure(const snapshot& s, const std::vector<std::size_t>& rows) const;
  /// Component `axis` of the positions of the rows; along a periodic axis shifted by whole periods, so that the widest gap of the fragment
  /// lies outside of it.
  std::vector<double> coordinates(const snapshot& s, const std::vector<std::size_t>& rows, int axis) const;
  const periodic_range* periodic(int axis) const {
    for (const periodic_range& p : options_.periodic)
      if (p.axis == axis) return &p;
    return nullptr;
  }
  static double into(const periodic_range& p, double x) { return x - (p.high - p.low) * std::floor((x - p.low) / (p.high - p.low)); }
  /// floor(x), which far out is as much as a whole number can be: particles there share a cell and are told apart by their distances.
  static std::int64_t cell_number(double x) { return static_cast<std::int64_t>(std::floor(std::clamp(x, -0x1p62, 0x1p62))); }
  static std::uint32_t id_of(const snapshot& s, std::size_t row) { return s.id.size() == s.size() ? s.id[row] : static_cast<std::uint32_t>(row); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  template <class Value> histogram count(Value&& value, int bins, bool by_ratio) const;

  fragment_options options_;
  double link_ = 0, time_ = 0;
  int dimension_ = 0;
  bool axisymmetric_ = false;
  std::string axes_;
  std::vector<std::string> body_names_;
  std::vector<std::uint32_t> parent_; // union-find over the particles that may be linked
  std::vector<fragment> list_;
  std::vector<int> of_particle_;
  loose_material dust_, left_out_;
  std::size_t not_finite_ = 0;
};

inline void fragments::check(const snapshot& s) const {
  require(s.dimension >= 1 && s.dimension <= 3, "dimension of the snapshot", s.dimension, "in 1..3");
  const double asked = options_.linking_length;
  require(asked >= 0 && std::isfinite(asked), "linking length", asked, "non-negative and finite", "m");
  require(options_.least_particles >= 1, "least number of particles of a fragment", static_cast<double>(options_.least_particles), "at least 1");
  require(link_ > 0 || s.size() == 0, "particle spacing of the snapshot", s.spacing, "positive, or a linking length given", "m");
  for (const periodic_range& p : options_.periodic) {
    require(p.axis >= (s.axisymmetric ? 1 : 0) && p.axis < s.dimension, "periodic axis", p.axis, "an axis of the snapshot, and not the radius");
    const double least = 3 * link_;
    require(p.high - p.low >= least, "length of the periodic range", p.high - p.low, "at least three linking lengths, " + to_text(least), "m");
  }
}

inline fragments::fragments(const snapshot& s, fragment_options options)
    : options_(std::move(options)), link_(options_.linking_length > 0 ? options_.linking_length : 2 * s.spacing), time_(s.time),
      dimension_(s.dimension), axisymmetric_(s.axisymmetric), axes_(s.axis_letters()), body_names_(s.body_names), of_particle_(s.size(), -1) {
  check(s);
  if (s.size() == 0) return;
  const column &x = s.at("position"), &v = s.at("velocity"), &mass = s.at("mass");
  const column* failed = options_.failed == failed_particles::linked ? nullptr : &s.at("failed");
  std::vector<std::size_t> rows, order(s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return id_of(s, a) < id_of(s, b); });
  const auto count_loose = [&](loose_material& to, std::size_t i) { ++to.particles, to.mass += mass(i); };
  for (const std::size_t i : order) {
    bool finite = std::isfinite(mass(i));
    for (int d = 0; d < dimension_; ++d) finite = finite && std::isfinite(x(i, d)) && std::isfinite(v(i, d));
    if (!finite) ++not_finite_;
    else if (failed && (*failed)(i) > 0.5) count_loose(options_.failed == failed_particles::dust ? dust_ : left_out_, i);
    else rows.push_back(i);
  }
  link_up(s, rows);

  std::vector<std::vector<std::size_t>> components; // in the order of their smallest id, their rows in that of the ids
  std::vector<std::int32_t> number(rows.size(), -1);
  for (std::uint32_t k = 0; k < rows.size(); ++k) {
    std::int32_t& n = number[root(k)];
    if (n < 0) n = static_cast<std::int32_t>(components.size()), components.emplace_back();
    components[static_cast<std::size_t>(n)].push_back(rows[k]);
  }
  std::vector<std::pair<fragment, std::size_t>> found; // and the component that it is
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (components[c].size() >= options_.least_particles) found.emplace_back(measure(s, components[c]), c);
    else
      for (const std::size_t i : components[c]) count_loose(dust_, i);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.first.mass != b.first.mass ? a.first.mass > b.first.mass : a.first.first_id < b.first.first_id;
  });
  for (auto& [f, c] : found) {
    for (const std::size_t i : components[c]) of_particle_[i] = static_cast<int>(list_.size());
    list_.push_back(std::move(f));
  }
}

/// Puts one particle after the other into the cells of a hash grid and links it with those already in its cell and in the cells around.
inline void fragments::link_up(const snapshot& s, const std::vector<std::size_t>& rows) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  constexpr double slack = 1 + 1e-9; // a lattice whose spacing is the linking length hangs together in spite of rounding
  const column& x = s.at("position");
  const bool bodies = !options_.across_bodies && s.body.size() == s.size();
  parent_.resize(rows.size());
  std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  std::unordered_map<cell, std::uint32_t, cell_hash> head;
  head.reserve(rows.size());
  std::vector<std::uint32_t> next(rows.size(), none);
  std::array<std::int64_t, 3> around{}; // cells of a periodic axis, 0: not periodic
  std::array<double, 3> width{}, length{};
  for (int d = 0; d < dimension_; ++d) {
    const auto at = static_cast<std::size_t>(d);
    width[at] = link_ * slack;
    if (const periodic_range* p = periodic(d)) {
      length[at] = p->high - p->low;
      around[at] = static_cast<std::int64_t>(length[at] / width[at]);
      width[at] = length[at] / static_cast<double>(around[at]);
    }
  }
  const auto linked = [&](std::size_t a, std::size_t b) {
    if (bodies && s.body[a] != s.body[b]) return false;
    double d2 = 0;
    for (int d = 0; d < dimension_; ++d) {
      const double period = length[static_cast<std::size_t>(d)];
      double difference = x(a, d) - x(b, d);
      if (period > 0) difference -= period * std::round(difference / period);
      d2 += difference * difference;
    }
    return d2 <= link_ * link_ * slack * slack;
  };
  const int neighbours = dimension_ == 1 ? 3 : dimension_ == 2 ? 9 : 27;
  for (std::uint32_t k = 0; k < rows.size(); ++k) {
    cell home;
    for (int d = 0; d < dimension_; ++d) {
      const auto at = static_cast<std::size_t>(d);
      const periodic_range* p = periodic(d);
      home.index[at] = cell_number((p ? into(*p, x(rows[k], d)) - p->low : x(rows[k], d)) / width[at]);
      if (p) home.index[at] = std::clamp<std::int64_t>(home.index[at], 0, around[at] - 1);
    }
    for (int n = 0; n < neighbours; ++n) {
      cell there = home;
      for (int d = 0, rest = n; d < dimension_; ++d, rest /= 3) {
        const auto at = static_cast<std::size_t>(d);
        there.index[at] += rest % 3 - 1;
        if (around[at] > 0) there.index[at] = (there.index[at] + around[at]) % around[at];
      }
      const auto first = head.find(there);
      if (first == head.end()) continue;
      for (std::uint32_t other = first->second; other != none; other = next[other])
        if (root(k) != root(other) && linked(rows[k], rows[other])) parent_[std::max(root(k), root(other))] = std::min(root(k), root(other));
    }
    const auto [place, fresh] = head.try_emplace(home, k);
    if (!fresh) next[k] = place->second, place->second = k;
  }
}

inline std::vector<double> fragments::coordinates(const snapshot& s, const std::vector<std::size_t>& rows, int axis) const {
  const column& x = s.at("position");
  std::vector<double> at;
  for (const std::size_t i : rows) at.push_back(x(i, axis));
  const periodic_range* p = periodic(axis);
  if (!p) return at;
  for (double& a : at) a = into(*p, a);
  std::vector<double> sorted = at;
  std::sort(sorted.begin(), sorted.end());
  double widest = sorted.front() + (p->high - p->low) - sorted.back(), cut = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (sorted[k] - sorted[k - 1] > widest) widest = sorted[k] - sorted[k - 1], cut = sorted[k - 1];
  for (double& a : at)
    if (a <= cut) a += p->high - p->low;
  return at;
}

inline fragment fragments::measure(const snapshot& s, const std::vector<std::size_t>& rows) const {
  const column &v = s.at("velocity"), &mass = s.at("mass"), *density = s.find("density"), &amount = density ? *density : s.at("volume");
  const auto n = static_cast<std::size_t>(dimension_);
  fragment f;
  f.particles = rows.size();
  f.first_id = id_of(s, rows.front());
  f.mass_by_body.assign(body_names_.size(), 0.0);
  std::array<std::vector<double>, 3> x;
  for (std::size_t d = 0; d < n; ++d) x[d] = coordinates(s, rows, static_cast<int>(d));
  double section = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double m = mass(rows[k]), volume = density ? m / amount(rows[k]) : amount(rows[k]);
    f.mass += m;
    f.volume += volume;
    if (axisymmetric_) section += volume / (2 * std::numbers::pi * x[0][k]);
    for (std::size_t d = 0; d < n; ++d) f.centre[d] += m * x[d][k], f.velocity[d] += m * v(rows[k], static_cast<int>(d));
    if (s.body.size() == s.size()) f.mass_by_body.at(static_cast<std::size_t>(s.body[rows[k]])) += m;
  }
  for (std::size_t d = 0; d < n; ++d) {
    const auto [low, high] = std::minmax_element(x[d].begin(), x[d].end());
    f.centre[d] /= f.mass, f.velocity[d] /= f.mass, f.extent[d] = *high - *low;
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::array<double, 3> r{}, u{};
    for (std::size_t d = 0; d < n; ++d) r[d] = x[d][k] - f.centre[d], u[d] = v(rows[k], static_cast<int>(d)) - f.velocity[d];
    const double m = mass(rows[k]);
    f.internal_kinetic += 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    if (axisymmetric_) continue;
    f.angular_momentum[0] += m * (r[1] * u[2] - r[2] * u[1]);
    f.angular_momentum[1] += m * (r[2] * u[0] - r[0] * u[2]);
    f.angular_momentum[2] += m * (r[0] * u[1] - r[1] * u[0]);
  }
  if (axisymmetric_) f.kind = 2 * *std::min_element(x[0].begin(), x[0].end()) <= link_ ? fragment_kind::axis_body : fragment_kind::ring;
  const bool whole = dimension_ == 3 || f.kind == fragment_kind::axis_body;
  f.diameter = whole ? std::cbrt(6 * f.volume / std::numbers::pi)
               : dimension_ == 1 ? f.volume
                                 : std::sqrt(4 * (f.kind == fragment_kind::ring ? section : f.volume) / std::numbers::pi);
  for (int d = 0; d < dimension_; ++d)
    if (const periodic_range* p = periodic(d)) f.centre[static_cast<std::size_t>(d)] = into(*p, f.centre[static_cast<std::size_t>(d)]);
  return f;
}

template <class Value> histogram fragments::count(Value&& value, int bins, bool by_ratio) const {
  require(bins >= 1, "ranges of a histogram", bins, "at least 1");
  histogram h;
  if (list_.empty()) return h;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const fragment& f : list_) low = std::min(low, value(f)), high = std::max(high, value(f));
  if (!(high > low)) bins = 1;
  const auto ranges = static_cast<std::size_t>(bins);
  for (std::size_t k = 0; k <= ranges; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(ranges);
    h.edge.push_back(k == 0 ? low : k == ranges ? high : by_ratio ? low * std::pow(high / low, t) : low + t * (high - low));
  }
  h.number.assign(ranges, 0), h.mass.assign(ranges, 0.0);
  for (const fragment& f : list_) {
    const auto above = static_cast<std::size_t>(std::upper_bound(h.edge.begin(), h.edge.end(), value(f)) - h.edge.begin());
    const std::size_t k = std::min(above, ranges) - 1;
    ++h.number[k], h.mass[k] += f.mass;
  }
  return h;
}

/// One row per fragment, heaviest first; vectors in the components that the space has.
inline void fragments::write_csv(const std::filesystem::path& path) const {
  std::vector<std::string> header{"fragment", "kind", "particles", "first_id", "mass (kg)", "diameter (m)", "volume (m3)"};
  const auto name_axes = [&](const char* stem, const char* unit) {
    for (const char axis : axes_) header.push_back(std::string(stem) + axis + " (" + unit + ")");
  };
  name_axes("", "m"), name_axes("v_", "m/s"), name_axes("extent_", "m");
  header.emplace_back("speed (m/s)");
  const std::size_t spins = axisymmetric_ || dimension_ == 1 ? 0 : dimension_ == 2 ? 1 : 3;
  for (std::size_t k = 3 - spins; k < 3; ++k) header.push_back(std::string("angular_momentum_") + "xyz"[k] + " (kg m2/s)");
  header.emplace_back("internal_kinetic (J)");
  for (const std::string& body : body_names_) header.push_back("mass of " + body + " (kg)");
  std::string text;
  const auto add = [&](const std::vector<csv_cell>& cells) {
    for (const csv_cell& c : cells) text += c.text() + ',';
    text.back() = '\n';
  };
  add({header.begin(), header.end()});
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const fragment& f = list_[k];
    std::vector<csv_cell> cells{k, name(f.kind), f.particles, f.first_id, f.mass, f.diameter, f.volume};
    for (const auto* vector : {&f.centre, &f.velocity, &f.extent}) cells.insert(cells.end(), vector->begin(), vector->begin() + dimension_);
    cells.emplace_back(f.speed());
    cells.insert(cells.end(), f.angular_momentum.end() - static_cast<std::ptrdiff_t>(spins), f.angular_momentum.end());
    cells.emplace_back(f.internal_kinetic);
    cells.insert(cells.end(), f.mass_by_body.begin(), f.mass_by_body.end());
    add(cells);
  }
  write_whole_file(path, text);
}

/// The options, the totals and the distributions.
inline void fragments::write_json(const std::filesystem::path& path) const {
  json_value j;
  j["time_s"] = time_;
  j["linking_length_m"] = link_;
  j["least_particles"] = options_.least_particles;
  j["failed_particles"] = name(options_.failed);
  j["across_bodies"] = options_.across_bodies;
  j["fragments"] = size();
  for (const fragment_kind k : {fragment_kind::piece, fragment_kind::axis_body, fragment_kind::ring})
    if (const auto n = std::count_if(list_.begin(), list_.end(), [k](const fragment& f) { return f.kind == k; })) j["kinds"][name(k)] = n;
  j["mass_kg"] = mass();
  const auto loose = [&](const char* what, const loose_material& m) { j[what]["particles"] = m.particles, j[what]["mass_kg"] = m.mass; };
  loose("dust", dust_), loose("left_out", left_out_);
  j["particles_not_finite"] = not_finite_;
  std::vector<double> masses;
  std::vector<std::size_t> numbers;
  for (const auto& [m, n] : cumulative_by_mass()) masses.push_back(m), numbers.push_back(n);
  j["cumulative_by_mass"]["mass_kg"] = masses;
  j["cumulative_by_mass"]["number"] = numbers;
  const auto put = [&](const char* what, const char* edges, const histogram& h) {
    json_value& to = j[what];
    to[edges] = h.edge, to["number"] = h.number, to["mass_kg"] = h.mass;
  };
  put("by_size", "edge_m", by_size()), put("by_speed", "edge_m_s", by_speed());
  write_whole_file(path, j.text() + "\n");
}

} // namespace bolide::observe
