// SPDX-License-Identifier: MIT
// summary.json: what was run and what came out, in one file: composition, steps and what limited them, masses, the energy ledger
// with all its channels, and the count of every floor and clamp.
//
//   observe::summary report("out/summary.json");
//   sim.run(6.6 * us, report);
//
// Written at the start (status "running"), at the times asked for, at the end ("done"), and by a run that stops ("stopped", with the
// message), so that there is one whatever happens. `extra` is merged at the end of the file:
//   report.extra["front_speed_m_s"] = cloud.front_speed;
// composition_of(sim) alone is a composed solver that prints itself: roles, settings, and per body the type of its material, fields, bytes per
// particle and the validity range of its equation of state. All numbers are SI.
// Cost: one pass over the particles each time it is written; a comparison and a count per step.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/floors.hpp"
#include "bolide/eos/validity.hpp"
#include "bolide/material/report.hpp"
#include "bolide/observe/every.hpp"
#include "bolide/observe/json.hpp"
#include "bolide/observe/whole_file.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace bolide::observe {

namespace detail {
/// The name of a type as the compiler spells it, without "bolide::".
template <class T> std::string type_name() {
  const std::string_view all = __PRETTY_FUNCTION__; // "... [with T = X; std::string = ...]" or "... [T = X]"
  const std::size_t from = all.find("T = ") + 4, semicolon = all.find(';', from);
  std::string name(all.substr(from, (semicolon == all.npos ? all.rfind(']') : semicolon) - from));
  const std::string_view prefix = "bolide::";
  for (std::size_t at = name.find(prefix); at != name.npos; at = name.find(prefix)) name.erase(at, prefix.size());
  return name;
}

/// An archive (concepts/archive.hpp) that writes what it is told into an object of JSON.
class json_archive {
 public:
  static constexpr bool reading = false;
  explicit json_archive(json_value& to) : to_(&to) {}
  template <class X> void value(std::string_view name, const X& x) { (*to_)[name] = json_of(x); }
  template <class F> void group(std::string_view name, F&& f) {
    json_value* const outer = std::exchange(to_, &(*to_)[name]);
    f();
    to_ = outer;
  }
  void expect(bool, std::string_view) {}
  void same(std::string_view name, std::string_view text) { (*to_)[name] = text; }
  void same(std::string_view name, double number, std::string_view unit) {
    (*to_)[unit.empty() ? std::string(name) : std::string(name).append(" (").append(unit).append(")")] = number;
  }
  template <class Numbers, class What> void alike(std::string_view, const Numbers&, double, What&&) {} // samples for a comparison, nothing to read

 private:
  template <class X> static json_value json_of(const X& x) {
    if constexpr (requires { x.begin(); } && !std::is_convertible_v<X, std::string_view>) return std::vector(x.begin(), x.end());
    else return x;
  }
  json_value* to_;
};

template <class Columns> struct storage_text;
template <template <class, class, class> class Columns, class T, class Space, class... Tag> struct storage_text<Columns<T, Space, fields<Tag...>>> {
  static json_value fields_of() {
    json_value j;
    ((j[Tag::name] = Space::components(Tag::order)), ...);
    return j;
  }
};
} // namespace detail

/// A composed solver as text: an object of JSON.
template <class Solver> json_value composition_of(const Solver& sim) {
  json_value j;
  detail::json_archive a(j);
  sim.describe(a);
  j["time step"] = "least over the particles of Courant number x cell / (Q + sqrt(Q^2 + c^2 + 4 G / 3 rho) + |v|) and 0.25 / |L|, growing by at most "
                   "`growth` a step";
  json_value bodies;
  sim.for_each_body([&](const auto& set) {
    using columns = std::remove_cvref_t<decltype(set.columns)>;
    json_value b;
    b["name"] = set.name;
    b["particles"] = set.columns.size();
    b["mass of its shape (kg)"] = set.geometric_mass;
    b["material"] = detail::type_name<std::remove_cvref_t<decltype(set.material)>>();
    if constexpr (requires { set.material.eos; }) {
      const auto box = eos::validity_of(set.material.eos);
      b["valid density (kg/m3)"] = std::vector{box.density_low, box.density_high};
      b["valid energy (J/kg)"] = std::vector{box.energy_low, box.energy_high};
    }
    b["fields"] = detail::storage_text<columns>::fields_of();
    b["bytes per particle"] = columns::bytes_per_particle;
    bodies.push_back(std::move(b));
  });
  j["storage"] = std::move(bodies);
  return j;
}

class summary {
 public:
  json_value extra; // members that are added at the end of the file

  explicit summary(std::filesystem::path path, schedule when = std::vector{0.0}) : path_(std::move(path)), when_(std::move(when)) {}

  template <class Solver> void watch(Solver& sim) {
    if (sim.steps() > counted_) count(static_cast<std::size_t>(sim.cause())), counted_ = sim.steps();
    if (when_.due(sim.time())) write(sim, "running", "");
  }
  template <class Solver> void finish(Solver& sim) { write(sim, "done", ""); }
  template <class Solver> void stopped(Solver& sim, const std::string& why) { write(sim, "stopped", why); }
  std::string last_output() const { return written_ ? path_.string() : ""; }
  /// For checkpoints (concepts/archive.hpp).
  template <class A> void archive(A& a) {
    a.value("steps_by_cause", causes_);
    a.value("counted", counted_);
    a.value("when", when_);
  }

  /// The content of the file.
  template <class Solver> json_value content(Solver& sim, const std::string& status, const std::string& message) const {
    json_value j;
    j["status"] = status;
    if (!message.empty()) j["message"] = message;
    j["time_s"] = sim.time();
    j["steps"] = sim.steps();
    j["dt_s"] = sim.dt();
    j["particles"] = sim.particle_count();
    j["nodes"] = sim.node_count();
    j["threads"] = sim.threads();
    j["solver_s"] = sim.solver_seconds();
    j["ns_per_particle_step"] = sim.particle_steps() > 0 ? 1e9 * sim.solver_seconds() / static_cast<double>(sim.particle_steps()) : 0.0;
    for (std::size_t k = 0; k < causes_.size(); ++k) j["steps_by_cause"][name(static_cast<step_cause>(k))] = causes_[k];
    auto l = sim.energies(); // a copy: its list of members is made for writing and reading
    double mass = 0;
    sim.for_each_body([&](const auto& set) {
      for (std::size_t i = 0; i < set.columns.size(); ++i) mass += static_cast<double>(set.columns.template get<field::mass>()[i]);
    });
    j["mass_kg"] = mass;
    j["mass_of_shapes_kg"] = sim.geometric_mass();
    for (std::size_t k = 0; k < floor_names.size(); ++k) j["floors"][floor_names[k]] = l.floors.count[k];
    detail::json_archive a(j["ledger"]);
    l.archive(a);
    j["energy_drift"] = l.drift();
    j["ledger_residual"] = l.residual();
    j["composition"] = composition_of(sim);
    j.merge(extra);
    return j;
  }

 private:
  void count(std::size_t cause) {
    causes_.resize(std::max(causes_.size(), cause + 1), 0);
    ++causes_[cause];
  }
  template <class Solver> void write(Solver& sim, const std::string& status, const std::string& message) {
    write_whole_file(path_, content(sim, status, message).text() + "\n");
    written_ = true;
  }
  std::filesystem::path path_;
  schedule when_;
  std::vector<std::uint64_t> causes_; // [step_cause]: how many steps it limited
  long counted_ = 0;
  bool written_ = false;
};

} // namespace bolide::observe
