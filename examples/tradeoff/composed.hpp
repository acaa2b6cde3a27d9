// SPDX-License-Identifier: MIT
// One composition of the solver behind the interface `simulation`.
#pragma once

#include "simulation.hpp"

#include "bolide/observe/take_snapshot.hpp"
#include "bolide/solver/solver.hpp"

#include <string>

namespace tradeoff {

template <class T, class Shape, class Transfer, class Scheme> class composed final : public simulation {
public:
  composed(const settings& s, const scene& of) : solver_(make(s, of)) {
    for (const auto& m : of.mirrors) solver_.add(m);
    const std::string first = body_name(0);
    solver_.initialise([&](auto& p) {
      const start at = of.at_start(p.position, p.body == first ? 0 : 1);
      p.velocity = at.velocity;
      if (at.density > 0) p.density = at.density, p.energy = at.energy;
      for (std::size_t k = 0; k < 4; ++k) p.velocity_gradient[k] = at.gradient[k];
    });
    solver_.run(0);
    particles_ = solver_.particle_count();
  }

  void advance(double until, const std::function<void()>& watch) override try {
    while (until - solver_.time() > 1e-6 * solver_.dt()) {
      const double before = cpu_seconds();
      if (watch) solver_.step(until - solver_.time());
      else solver_.run(until);
      cost_ += cpu_seconds() - before;
      if (watch) watch();
    }
  } catch (const bolide::run_stopped& why) {
    throw failed_run{why.what()};
  }
  double time() const override { return solver_.time(); }
  double dt() const override { return solver_.dt(); }
  void each(const std::function<void(const particle&)>& f) const override {
    int body = 0;
    solver_.for_each_body([&](const auto& set) {
      using namespace bolide;
      const auto& p = set.columns;
      for (std::size_t i = 0; i < p.size(); ++i)
        f({body, p.id()[i], point{p.template get<field::position>(0)[i], p.template get<field::position>(1)[i]},
           point{p.template get<field::velocity>(0)[i], p.template get<field::velocity>(1)[i]}, p.template get<field::mass>()[i],
           p.template get<field::volume>()[i], p.template get<field::pressure>()[i], p.template get<field::energy>()[i]});
      ++body;
    });
  }
  bolide::observe::snapshot snapshot() const override { return bolide::observe::take_snapshot(solver_); }
  outcome costs() const override { return {0, cost_, solver_.steps(), static_cast<double>(solver_.particle_steps()), particles_}; }

private:
  using material = bolide::any_material<T, bolide::space::axisymmetric>;
  using solver_type = bolide::solver<T, bolide::space::axisymmetric, bolide::grid::sparse, Shape, Transfer, Scheme, bolide::contact::single_field, material, material>;

  static std::string body_name(int body) { return body == 0 ? "first" : "second"; }
  static bolide::body<region, material> make_body(const settings& s, const scene& of, std::size_t k) {
    // a scene of one part has a second body without particles
    const part& p = of.parts[k < of.parts.size() ? k : 0];
    region shape = p.shape;
    if (k >= of.parts.size()) shape.inside = [](const point&) { return false; }, shape.cubic_metres = 0;
    material m = [&] {
      if constexpr (sizeof(T) == sizeof(float)) return p.material.in_float;
      else return p.material.in_double;
    }();
    return {body_name(static_cast<int>(k)), shape, m, of.cell / s.per_axis, bolide::initial_state{p.material.density, p.material.energy}};
  }
  static solver_type make(const settings& s, const scene& of) {
    bolide::controls<T> c;
    c.courant = s.courant;
    c.skip_quiet = s.skip;
    c.first_step = of.first_step;
    c.dt_floor = of.dt_floor;
    c.threads = 1;
    return solver_type{bolide::space::axisymmetric{}, bolide::grid::sparse{of.cell}, Shape{}, Transfer{}, Scheme{}, c, make_body(s, of, 0), make_body(s, of, 1)};
  }

  solver_type solver_;
  double cost_ = 0;
  std::size_t particles_ = 0;
};

template <class T, class Shape, class Transfer, class Scheme> std::unique_ptr<simulation> compose_as(const settings& s, const scene& of) {
  return std::make_unique<composed<T, Shape, Transfer, Scheme>>(s, of);
}

} // namespace tradeoff
