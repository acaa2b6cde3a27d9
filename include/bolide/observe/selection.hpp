// SPDX-License-Identifier: MIT
// Which fields an output shows: a list of names, of field tags and of the user's own functions, the same for every output of this room.
//
//   observe::tracer gauge("gauge.csv", {17, 4711}, 0.05 * us, {"pressure", field::velocity{}, "von_mises",
//                         {"impedance", "kg/(m2 s)", [](const observe::particle& p) { return p("density") * p("sound_speed"); }}});
//
// Known by name: every field that the particles store, by the name of its tag (core/field.hpp), and what follows from them:
//   density (kg/m3, of the material, voids excluded)   speed (m/s)   failed (1 or 0, whatever the failure law keeps)
//   von_mises (Pa, sqrt(3/2 s:s), all components of the deviator counted)   shear_energy (J/kg, elastic)   void_fraction (0..1)
//   temperature, melting_temperature (K)   melt_fraction (0..1)   region (numbers of bolide::region)   cold_energy (J/kg)
// A name is known if the material of one body knows it; a name that none knows is refused with the list of those that are.
// Cost: only what is asked for is computed. One evaluation of the equation of state per particle looked at, if one of the last line is asked
// for. A user's function finds what it reads by name: some 50 ns for each.
#pragma once

#include "bolide/concepts/equation_of_state.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/core/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace bolide::observe {

/// A particle as a user's function sees it: whatever its body knows, by name.
class particle {
 public:
  /// The value of a quantity; a name that this particle's body does not know throws a sentence that lists the known ones.
  virtual double operator()(std::string_view name, int component = 0) const = 0;
  virtual bool knows(std::string_view name) const = 0;
  virtual std::string_view body() const = 0;
  virtual std::uint32_t id() const = 0;

 protected:
  ~particle() = default;
};

/// One field of a selection: a name, a tag, or a function of the user's with name and SI unit.
struct chosen_field {
  std::string name;
  std::string unit{};                             // of a function
  std::function<double(const particle&)> value{}; // empty: known by its name

  chosen_field(const char* known) : name(known) {}
  chosen_field(std::string known) : name(std::move(known)) {}
  template <class Tag>
    requires requires { Tag::name, Tag::unit, Tag::order; }
  chosen_field(Tag) : name(Tag::name) {}
  chosen_field(std::string own, std::string in, std::function<double(const particle&)> f)
      : name(std::move(own)), unit(std::move(in)), value(std::move(f)) {
    require(!name.empty() && value, "name and function of a field of the user's", 0, "given");
  }
};

/// Fields in the order in which they are written; empty: the output's own default.
using selection = std::vector<chosen_field>;

/// The letters of the axes of a space: r z, or x y z.
template <class Space> std::string axes_of() { return Space::hoop ? "rz" : std::string("xyz").substr(0, static_cast<std::size_t>(Space::dim)); }

/// The axes of the components of a field: "x" of a vector, "xy" of a gradient or a deviator, "" of a scalar.
template <class Space> std::vector<std::string> component_axes(rank order) {
  const std::string axis = axes_of<Space>();
  std::vector<std::string> names;
  if (order == rank::scalar) names.emplace_back();
  if (order == rank::vector)
    for (const char a : axis) names.emplace_back(1, a);
  if (order == rank::gradient)
    for (const char a : axis)
      for (const char b : axis) names.push_back({a, b});
  if (order == rank::deviator) { // two of the diagonal (one in 1-D: the others follow), then the shears: xx yy xy xz yz
    for (std::size_t d = 0; d < std::min<std::size_t>(2, axis.size()); ++d) names.push_back({axis[d], axis[d]});
    for (std::size_t a = 0; a < axis.size(); ++a)
      for (std::size_t b = a + 1; b < axis.size(); ++b) names.push_back({axis[a], axis[b]});
  }
  return names;
}

namespace detail {
/// The particles of one body, one at a time.
template <class Space, class Set> class particle_of final : public particle {
 public:
  using columns = std::remove_cvref_t<decltype(std::declval<const Set&>().columns)>;
  using material = std::remove_cvref_t<decltype(std::declval<const Set&>().material)>;
  static constexpr bool thermal = material::thermal, shears = columns::template has<field::deviator>, fails = columns::template has<field::failed>;

  /// A quantity that the body knows.
  struct known {
    std::string name, unit;
    rank order;
    double (*value)(const particle_of&, int component);
  };

  explicit particle_of(const Set& set) : set_(set) {}
  void move_to(std::size_t i) {
    at_ = i;
    state_.reset();
  }

  double operator()(std::string_view name, int component = 0) const override {
    const int k = find(name);
    if (k < 0) throw bad_parameter("the particles of body " + set_.name + " have no field \"" + std::string(name) + "\"; they have " + listing());
    const known& q = all()[static_cast<std::size_t>(k)];
    require(component >= 0 && component < Space::components(q.order), "component of field \"" + q.name + "\"", component,
            "in 0.." + std::to_string(Space::components(q.order) - 1));
    return q.value(*this, component);
  }
  bool knows(std::string_view name) const override { return find(name) >= 0; }
  std::string_view body() const override { return set_.name; }
  std::uint32_t id() const override { return set_.columns.id()[at_]; }

  template <class Tag> double stored(int component = 0) const { return static_cast<double>(set_.columns.template get<Tag>(component)[at_]); }
  double own_volume() const { return set_.material.material_volume(set_.columns, at_); }
  double density() const { return stored<field::mass>() / own_volume(); }
  double speed() const {
    double sum = 0;
    for (int d = 0; d < Space::dim; ++d) sum += stored<field::velocity>(d) * stored<field::velocity>(d);
    return std::sqrt(sum);
  }
  double von_mises() const {
    typename Space::template deviator<double> s;
    for (std::size_t c = 0; c < s.size(); ++c) s[c] = stored<field::deviator>(static_cast<int>(c));
    return std::sqrt(1.5 * Space::contract(s, s));
  }
  const thermal_point<double>& state() const {
    if (!state_) state_ = set_.material.thermodynamics(set_.columns, at_);
    return *state_;
  }

  /// All that is known, made once.
  static const std::vector<known>& all() {
    static const std::vector<known> list = make();
    return list;
  }
  static int find(std::string_view name) {
    const auto& list = all();
    const auto at = std::find_if(list.begin(), list.end(), [&](const known& k) { return k.name == name; });
    return at == list.end() ? -1 : static_cast<int>(at - list.begin());
  }
  static std::string listing() {
    std::string text;
    for (const known& k : all()) text += (text.empty() ? "" : ", ") + k.name;
    return text;
  }

 private:
  static std::vector<known> make() {
    using self = particle_of;
    std::vector<known> list;
    const auto add = [&](const char* name, const char* unit, double (*f)(const self&, int)) { list.push_back({name, unit, rank::scalar, f}); };
    if constexpr (fails) add("failed", "1", [](const self& p, int) { return p.template stored<field::failed>() > 0 ? 1.0 : 0.0; });
    add_stored(list, typename columns::field_list{});
    add("density", "kg/m3", [](const self& p, int) { return p.density(); });
    add("speed", "m/s", [](const self& p, int) { return p.speed(); });
    if constexpr (fails) add("void_fraction", "1", [](const self& p, int) { return 1 - p.own_volume() / p.template stored<field::volume>(); });
    if constexpr (shears) {
      add("von_mises", "Pa", [](const self& p, int) { return p.von_mises(); });
      add("shear_energy", "J/kg", [](const self& p, int) { return p.set_.material.shear_energy(p.set_.columns, p.at_); });
    }
    if constexpr (thermal) {
      add("temperature", "K", [](const self& p, int) { return p.state().temperature; });
      add("melting_temperature", "K", [](const self& p, int) { return p.state().melting_temperature; });
      add("melt_fraction", "1", [](const self& p, int) { return p.state().melt_fraction; });
      add("region", "1", [](const self& p, int) { return p.state().region; });
      add("cold_energy", "J/kg", [](const self& p, int) { return p.state().cold_energy; });
    }
    return list;
  }
  template <class... Tag> static void add_stored(std::vector<known>& list, fields<Tag...>) {
    const auto add = [&]<class One>(One) {
      if (std::none_of(list.begin(), list.end(), [](const known& k) { return k.name == One::name; }))
        list.push_back({One::name, One::unit, One::order, [](const particle_of& p, int component) { return p.template stored<One>(component); }});
    };
    (add(Tag{}), ...);
  }

  const Set& set_;
  std::size_t at_ = 0;
  mutable std::optional<thermal_point<double>> state_; // asked for at most once per particle
};
} // namespace detail

/// A selection that has been looked up in a run.
template <class Solver> class field_reader {
 public:
  using space = typename Solver::space;
  struct heading {
    std::string name, unit;
    rank order = rank::scalar;
    int components() const { return space::components(order); }
  };

  /// `strict`: refuse a name that no material knows; else leave it without values.
  field_reader(const Solver& sim, selection wanted, bool strict = true) : wanted_(std::move(wanted)) {
    headings_.resize(wanted_.size());
    for (std::size_t c = 0; c < wanted_.size(); ++c) headings_[c].name = wanted_[c].name, headings_[c].unit = wanted_[c].unit;
    sim.for_each_body([&](const auto& set) {
      using one = detail::particle_of<space, std::remove_cvref_t<decltype(set)>>;
      place_.emplace_back();
      for (std::size_t c = 0; c < wanted_.size(); ++c) {
        const int k = one::find(wanted_[c].name);
        place_.back().push_back(k);
        if (k < 0) continue;
        require(!wanted_[c].value, "number of fields named \"" + wanted_[c].name + "\", which the particles have already", 2, "1");
        headings_[c].unit = one::all()[static_cast<std::size_t>(k)].unit;
        headings_[c].order = one::all()[static_cast<std::size_t>(k)].order;
      }
    });
    for (std::size_t c = 0; c < wanted_.size(); ++c) {
      for (std::size_t other = 0; other < c; ++other)
        require(wanted_[c].name != wanted_[other].name, "number of times that field \"" + wanted_[c].name + "\" is chosen", 2, "1");
      if (strict && !known(c)) throw bad_parameter("no material of this run knows a field \"" + wanted_[c].name + "\"; known are " + known_to(sim));
    }
  }

  const std::vector<heading>& headings() const { return headings_; }
  /// Does the material of any body know column c?
  bool known(std::size_t c) const {
    return wanted_[c].value || std::any_of(place_.begin(), place_.end(), [&](const auto& body) { return body[c] >= 0; });
  }

  /// The names of the table's columns: "pressure (Pa)", "r (m)" and "v_z (m/s)" of position and velocity, "deviator_rz (Pa)".
  std::vector<std::string> column_names() const {
    std::vector<std::string> names;
    for (const heading& h : headings_)
      for (const std::string& axis : component_axes<space>(h.order)) {
        const std::string stem = h.name == "velocity" ? "v" : h.name;
        names.push_back((axis.empty() ? h.name : h.name == "position" ? axis : stem + "_" + axis) + " (" + h.unit + ")");
      }
    return names;
  }

  /// How many components come before those of column c.
  std::size_t first_cell(std::size_t c) const {
    std::size_t n = 0;
    for (std::size_t k = 0; k < c; ++k) n += static_cast<std::size_t>(headings_[k].components());
    return n;
  }

  /// Calls put(column, component, value) for every chosen field that body number `body` knows; `p` stands on the particle.
  template <class Set, class Put> void read(const detail::particle_of<space, Set>& p, std::size_t body, Put&& put) const {
    for (std::size_t c = 0; c < wanted_.size(); ++c) {
      if (wanted_[c].value) put(c, 0, wanted_[c].value(p));
      else if (const int k = place_[body][c]; k >= 0)
        for (int component = 0; component < headings_[c].components(); ++component)
          put(c, component, detail::particle_of<space, Set>::all()[static_cast<std::size_t>(k)].value(p, component));
    }
  }

 private:
  /// The names that the material of any body knows.
  static std::string known_to(const Solver& sim) {
    std::vector<std::string> names;
    sim.for_each_body([&](const auto& set) {
      for (const auto& k : detail::particle_of<space, std::remove_cvref_t<decltype(set)>>::all())
        if (std::find(names.begin(), names.end(), k.name) == names.end()) names.push_back(k.name);
    });
    std::string listing;
    for (const std::string& name : names) listing += (listing.empty() ? "" : ", ") + name;
    return listing;
  }

  selection wanted_;
  std::vector<heading> headings_;
  std::vector<std::vector<int>> place_; // [body][column]: where in the body's list, -1: not there
};

/// The particles of body `set` for a field_reader of that run.
template <class Solver, class Set> auto particles_of(const Set& set) { return detail::particle_of<typename Solver::space, Set>(set); }

} // namespace bolide::observe
