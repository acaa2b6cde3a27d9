// SPDX-License-Identifier: MIT
// The solver: a space, a grid, a shape function, a transfer, a scheme and bodies, combined at compile time into one explicit MPM.
//
//   auto sim = solver{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::linear{}, transfer::flip{}, scheme::usf{}, controls<>{}, ball, plate};
//   sim.run(6.6 * us);
//
// Cost per particle and step: see docs/performance.md. Errors: bad_parameter at construction; run_stopped from step() and run() when the
// step falls below its floor, the total energy leaves its bound, or the step cap is reached.
#pragma once

#include "bolide/concepts/grid.hpp"
#include "bolide/concepts/observer.hpp"
#include "bolide/concepts/scheme.hpp"
#include "bolide/concepts/shape_function.hpp"
#include "bolide/concepts/space.hpp"
#include "bolide/concepts/transfer.hpp"
#include "bolide/contact/frictional.hpp"
#include "bolide/contact/single_field.hpp"
#include "bolide/grid/uniform.hpp"
#include "bolide/material/material.hpp"
#include "bolide/particles/geometry.hpp"
#include "bolide/scheme/musl.hpp"
#include "bolide/scheme/usf.hpp"
#include "bolide/scheme/usl.hpp"
#include "bolide/solver/body.hpp"
#include "bolide/solver/body_force.hpp"
#include "bolide/solver/phases.hpp"
#include "bolide/time/courant.hpp"
#include "bolide/transfer/apic.hpp"
#include "bolide/transfer/flip.hpp"
#include "bolide/transfer/pic.hpp"
#include "bolide/transfer/xpic.hpp"

#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace bolide {

/// Thrown when a run cannot go on. what() names step, time, particle, cause and state.
struct run_stopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Material that leaves this box (m) is taken out and counted with its mass, momentum and energy.
template <int Dim> struct leaving_box {
  vec<double, Dim> low, high;
};

template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme, class Contact, class... Materials> class solver {
  static_assert(bolide::Space<Space>, "bolide: solver: the first argument is no space: see concepts/space.hpp");
  static_assert(requires(const Grid g) { { g.spacing } -> std::convertible_to<double>; requires bolide::Grid<typename Grid::template map<Space::dim>>; },
                "bolide: solver: the second argument is no grid: it must have spacing, map<Dim> and make<Dim>(): see grid/sparse.hpp");
  static_assert(bolide::ShapeFunction<Shape>, "bolide: solver: the third argument is no shape function: it must have support, offset, smooth, value, slope "
                                              "and curvature");
  static_assert(bolide::Contact<Contact>, "bolide: solver: no contact: it must have multi_field and name and, if it is multi-field, correction(u, n)");
  static_assert(bolide::Transfer<Transfer>, "bolide: solver: the fourth argument is no transfer: it must have particle_fields, affine, wants_smooth_shape, "
                                            "filter_order and name; if it filters, heat and filter(); if it is affine, heat and field::affine_velocity among its "
                                            "fields");
  static_assert(bolide::Scheme<Scheme>, "bolide: solver: the fifth argument is no scheme: it must have particle_fields, stress_first, maps_velocity_back, "
                                        "wants_smooth_shape, name and step(phases)");
  static_assert(!Transfer::wants_smooth_shape || Shape::smooth,
                "bolide: solver: APIC with linear shape functions is unsound (its affine field is amplified at nodes of tiny mass); take "
                "shape::quadratic_bspline, or transfer::flip");
  static_assert(!Transfer::affine || !Shape::smooth || requires { Shape::inertia; },
                "bolide: solver: APIC divides by the inertia of the shape function, sum N (x_I - x)^2, and that of this shape is not constant (it gives no "
                "`inertia`); take a B-spline, or transfer::flip");
  static_assert(!Scheme::wants_smooth_shape || Shape::smooth,
                "bolide: solver: USL with linear shape functions is unsound (a particle is strained by nodes of tiny mass that it has just reached); take "
                "scheme::musl, a smooth shape, or accept_unsound<scheme::usl>");

public:
  static constexpr int dim = Space::dim;
  using scalar = T;
  using space = Space;
  template <class Material>
  using particle_fields = field_union_t<fields<field::mass, field::position, field::velocity, field::carrying_velocity>, typename Material::particle_fields,
                                        typename Transfer::particle_fields, typename Scheme::particle_fields>;
  template <class Material> using set_type = particle_set<T, Space, Shape, Material, particle_fields<Material>>;
  using phases_type = phases<T, Space, Grid, Shape, Transfer, Scheme, Contact, set_type<Materials>...>;

  template <class... Bodies>
  solver(Space, Grid g, Shape, Transfer transfer, Scheme scheme, controls<T> c, const Bodies&... bodies)
      : solver(Space{}, g, Shape{}, transfer, scheme, Contact{}, c, bodies...) {}
  template <class... Bodies>
  solver(Space, Grid g, Shape, Transfer transfer, Scheme scheme, Contact contact, controls<T> c, const Bodies&... bodies)
      : controls_(c), scheme_(scheme), phases_(g, checked(c), transfer, contact, seed_all(g.spacing, bodies...)) {
    (check_spacing(g.spacing, bodies.name, bodies.spacing), ...);
    if constexpr (requires { transfer.validate(); }) transfer.validate();
    if constexpr (Space::hoop) add(grid::mirror{0, 0.0, true});
    require(particle_count() > 0, "number of particles", 0, "positive (no lattice point lies inside a body)");
  }

  /// Adds a mirror plane (symmetry plane, slip or sticking wall). Before the first step.
  solver& add(const grid::mirror& m) {
    const grid::mirror_nodes<dim> plane(m, phases_.h);
    for (const auto& other : phases_.mirrors) // closer ones would have image nodes of images
      require(other.axis() != plane.axis() || std::abs(other.line() - plane.line()) >= 3, "distance of two mirrors of one axis",
              std::abs(other.line() - plane.line()) * phases_.h, "at least three cells", "m");
    phases_.mirrors.push_back(plane);
    return *this;
  }
  /// Makes an axis periodic. Before the first step.
  solver& add(const grid::periodic& p) {
    const grid::periodic_nodes<dim> period(p, phases_.h);
    require(!(Space::hoop && p.axis == 0), "periodic axis", p.axis, "not the radius of r-z");
    for (const auto& other : phases_.periods) require(other.axis() != period.axis(), "periodic axis", p.axis, "periodic once");
    for (const auto& m : phases_.mirrors) require(m.axis() != period.axis(), "periodic axis", p.axis, "without mirrors");
    phases_.periods.push_back(period);
    return *this;
  }
  /// Adds a rigid wall that moves along an axis. Before the first step.
  solver& add(const grid::moving_wall& w) {
    w.validate(dim);
    phases_.walls.push_back(w);
    return *this;
  }
  /// Lets material leave through a box (free outflow). Before the first step.
  solver& add(const leaving_box<dim>& b) {
    box_ = b;
    return *this;
  }
  /// Adds a force on every particle. Before the first step.
  template <class F> solver& add(const body_force<F>& f) {
    static_assert(requires { { f.acceleration(vec<double, dim>(), 0.0) } -> std::convertible_to<vec<double, dim>>; },
                  "bolide: solver: a body force must be callable as acceleration(position, time) and give a vector of the space");
    phases_.body_forces.emplace_back(f);
    return *this;
  }
  /// f(point) for every particle before the first step: a start that varies from place to place (see initial_point).
  template <class F> solver& initialise(F&& f) {
    require(!started_, "steps done before initialise", static_cast<double>(steps_), "none: the run has started");
    phases_.for_each_set([&](auto& s) {
      auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const double volume = static_cast<double>(p.template get<field::volume>()[i]);
        initial_point<dim> point{s.name, {}, {}, static_cast<double>(p.template get<field::mass>()[i]) / volume, static_cast<double>(p.template get<field::energy>()[i])};
        for (int d = 0; d < dim; ++d) {
          point.position[d] = static_cast<double>(p.template get<field::position>(d)[i]);
          point.velocity[d] = static_cast<double>(p.template get<field::velocity>(d)[i]);
        }
        f(point);
        p.template get<field::mass>()[i] = static_cast<T>(volume * point.density);
        for (int d = 0; d < dim; ++d) {
          p.template get<field::position>(d)[i] = static_cast<T>(point.position[d]);
          p.template get<field::velocity>(d)[i] = p.template get<field::carrying_velocity>(d)[i] = static_cast<T>(point.velocity[d]);
        }
        if constexpr (Transfer::affine)
          for (int c = 0; c < dim * dim; ++c) p.template get<field::affine_velocity>(c)[i] = static_cast<T>(point.velocity_gradient[static_cast<std::size_t>(c)]);
        s.material.initialise(p, i, 1, point.density, point.energy);
      }
    });
    return *this;
  }

  /// One step, no longer than `most`.
  void step(double most = std::numeric_limits<double>::infinity()) {
    require(most >= 0, "longest step", most, "non-negative", "s");
    if (!started_) start();
    const auto begin = std::chrono::steady_clock::now();
    if (box_ && phases_.beyond(box_->low, box_->high)) phases_.sorted = false; // sorting lets material leave
    if (!phases_.sorted) sort();
    choose_step(most);
    phases_.time = time_;
    scheme_.step(phases_);
    time_ += static_cast<double>(phases_.dt);
    ++steps_;
    particle_steps_ += particle_count();
    check_limit();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (steps_ % check_interval == 0) check_energy();
  }

  /// Runs to time `until` (s). Each observer is called as watch(*this) at the start, after every step, and with finish(*this) at the end.
  /// When the run stops with an error, the message names the last_output() of the observers that have one, and stopped(*this, message) is
  /// called of those that have it (concepts/observer.hpp).
  template <class... Observers> void run(double until, Observers&&... observers) {
    require(until >= 0 && until < 1e9, "end time", until, "non-negative and finite", "s");
    static_assert((bolide::Observer<std::remove_cvref_t<Observers>, solver> && ...),
                  "bolide: solver: run: an observer must have watch(solver) and finish(solver)");
    try {
      if (!started_) start();
      (observers.watch(*this), ...);
      while (until - time_ > 1e-6 * dt()) { // what rounding (of a float step) leaves of the last step is no step
        step(until - time_);
        (observers.watch(*this), ...);
      }
    } catch (const run_stopped& why) {
      if constexpr (sizeof...(observers) == 0) throw;
      else end_early(why.what(), observers...);
    }
    measure_energy();
    (observers.finish(*this), ...);
  }

  double time() const { return time_; }
  double dt() const { return static_cast<double>(phases_.dt); }
  step_cause cause() const { return cause_; }
  long steps() const { return steps_; }
  double cell() const { return phases_.h; }
  std::uint64_t particle_steps() const { return particle_steps_; }
  double solver_seconds() const { return seconds_; } // inside step(), observers excluded
  std::size_t particle_count() const {
    std::size_t n = 0;
    phases_.for_each_set([&](const auto& s) { n += s.columns.size(); });
    return n;
  }
  std::size_t node_count() const { return phases_.node_count(); }
  /// Particles whose blocks are at rest and not computed.
  std::size_t sleeping_particles() const {
    std::size_t n = 0;
    phases_.for_each_set([&](const auto& s) {
      for (const auto& r : s.ranges) n += r.quiet > 0 ? r.end - r.begin : 0;
    });
    return n;
  }
  /// f(set) for the particles of every body: set.name, set.material, set.columns.
  template <class F> void for_each_body(F&& f) const { phases_.for_each_set(f); }
  template <class F> void for_each_body(F&& f) { phases_.for_each_set(f); }
  /// The ledger with the energies of this moment.
  const ledger& energies() {
    measure_energy();
    return phases_.energy;
  }
  double geometric_mass() const {
    double m = 0;
    phases_.for_each_set([&](const auto& s) { m += s.geometric_mass; });
    return m;
  }
  int threads() const { return threads_; }

  /// What this simulation is composed of: whatever else the next steps depend on beside archive() (concepts/archive.hpp).
  template <class A> void describe(A& a) const {
    a.same("space", Space::name);
    a.same("grid", Grid::name);
    a.same("contact", Contact::name);
    if constexpr (requires { phases_.contact.friction; }) a.same("friction", phases_.contact.friction, "");
    a.same("shape", Shape::name);
    a.same("transfer", Transfer::name);
    a.same("scheme", Scheme::name);
    a.same("precision", sizeof(T) == sizeof(double) ? "double" : "float");
    a.same("cell size", phases_.h, "m");
    if constexpr (requires { phases_.transfer.heat; }) a.same("heat of the transfer", phases_.transfer.heat, "");
    if constexpr (requires { Transfer::filter_order; }) a.same("filter order of the transfer", Transfer::filter_order, "");
    if constexpr (requires { phases_.transfer.flip; }) a.same("FLIP part of the transfer", phases_.transfer.flip, "");
    a.same("Courant number", controls_.courant, "");
    a.same("first step", controls_.first_step, "");
    a.same("growth", controls_.growth, "");
    a.same("dt floor", controls_.dt_floor, "");
    a.same("quiet speed", controls_.quiet_speed, "m/s");
    a.same("energy bound", controls_.energy_bound, "");
    a.same("mirrors", static_cast<double>(phases_.mirrors.size()), "");
    for (std::size_t k = 0; k < phases_.mirrors.size(); ++k) {
      const auto& m = phases_.mirrors[k];
      a.same("mirror " + std::to_string(k), "axis " + std::to_string(m.axis()) + " at node " + std::to_string(m.line()) + ", material " + (m.material_above() ? "above" : "below") + (m.sticks() ? ", sticking" : ""));
    }
    a.same("periods", static_cast<double>(phases_.periods.size()), "");
    for (std::size_t k = 0; k < phases_.periods.size(); ++k) {
      const auto& p = phases_.periods[k];
      a.same("period " + std::to_string(k), "axis " + std::to_string(p.axis()) + " from node " + std::to_string(p.low()) + " to " + std::to_string(p.high()));
    }
    a.same("moving walls", static_cast<double>(phases_.walls.size()), "");
    for (std::size_t k = 0; k < phases_.walls.size(); ++k) {
      const auto& w = phases_.walls[k];
      a.same("moving wall " + std::to_string(k), "axis " + std::to_string(w.axis) + " at " + to_text(w.position) + " m with " + to_text(w.velocity) + " m/s, material " +
                                                     (w.material_above ? "above" : "below") + (w.stick ? ", sticking" : ""));
    }
    std::string box("none");
    if (box_) {
      box.clear();
      for (int d = 0; d < dim; ++d) box += (d ? " x " : "") + to_text(box_->low[d]) + " .. " + to_text(box_->high[d]) + " m";
    }
    a.same("leaving box", box);
    a.same("body forces", static_cast<double>(phases_.body_forces.size()), "");
    for (std::size_t k = 0; k < phases_.body_forces.size(); ++k)
      a.alike("body force " + std::to_string(k), sampled(phases_.body_forces[k]), 1e-9, [](std::size_t i) { return "acceleration " + std::to_string(i); });
    a.same("bodies", static_cast<double>(sizeof...(Materials)), "");
    int body = 0;
    phases_.for_each_set([&](const auto& s) { a.group("body_" + std::to_string(body++), [&] { s.describe(a); }); });
  }
  /// The state of the run between two steps, for checkpoints: written from here, or read into a solver of the same composition.
  template <class A> void archive(A& a) {
    if (!started_) start();
    a.group("composition", [&] { describe(a); });
    a.value("time", time_);
    a.value("steps", steps_);
    a.value("particle_steps", particle_steps_);
    a.value("solver_seconds", seconds_);
    a.value("first_dt", first_dt_);
    a.value("unclipped_dt", unclipped_dt_);
    a.value("cause", cause_);
    a.value("phases", phases_);
  }

private:
  static constexpr long check_interval = 64;
  controls<T> controls_;
  Scheme scheme_;
  phases_type phases_;
  std::optional<leaving_box<dim>> box_;
  double time_ = 0, seconds_ = 0;
  long steps_ = 0;
  std::uint64_t particle_steps_ = 0;
  bool started_ = false;
  double first_dt_ = 0, unclipped_dt_ = 0; // the step that was wanted before `most` cut it: growth goes on from there
  step_cause cause_ = step_cause::growth;
  int threads_ = 1;

  /// Accelerations of a body force at a few places (within 10 cells) and times (within 100 us).
  std::vector<double> sampled(const detail::any_body_force<dim>& force) const {
    std::vector<double> numbers;
    for (int k = 0; k < 16; ++k) {
      vec<double, dim> x;
      for (int d = 0; d < dim; ++d) x[d] = 10 * phases_.h * std::sin(1.0 + 3 * k + 7 * d);
      const auto b = force.acceleration(x, 1e-4 * (k % 4) / 3);
      for (int d = 0; d < dim; ++d) numbers.push_back(b[d]);
    }
    return numbers;
  }

  /// A body that reaches beyond a mirror would be folded over on the first step, onto its other half.
  void check_side(const grid::mirror_nodes<dim>& m) const {
    const double plane = m.line() * phases_.h, round_off = 1e-6 * phases_.h;
    phases_.for_each_set([&](const auto& s) {
      const T* x = s.columns.template get<field::position>(static_cast<int>(m.axis()));
      for (std::size_t i = 0; i < s.columns.size(); ++i)
        require(m.material_above() ? static_cast<double>(x[i]) >= plane - round_off : static_cast<double>(x[i]) <= plane + round_off,
                "coordinate " + std::to_string(m.axis()) + " of a particle of body " + s.name, static_cast<double>(x[i]),
                std::string(m.material_above() ? "at least " : "at most ") + to_text(plane) + ", where a mirror stands (seed the body on its side only)", "m");
    });
  }
  /// Wide particles leave gaps: with one per cell material that is stretched at all has nodes between its particles that see none of them.
  void check_spacing(double h, const std::string& name, double spacing) const {
    if (!controls_.accept_one_particle_per_cell)
      require(spacing <= 0.75 * h * (1 + 1e-9), "particle spacing of body " + name, spacing, "at most 0.75 of the grid spacing " + to_text(h) +
              " m: fewer particles per cell fracture numerically (controls: accept_one_particle_per_cell)", "m");
    if constexpr (shape_wants_size<Shape>) require(spacing <= h * (1 + 1e-9), "particle spacing of body " + name, spacing, "at most the grid spacing with this shape", "m");
  }
  static T checked(const controls<T>& c) {
    c.validate();
    return static_cast<T>(c.courant);
  }

  template <class... B> static std::tuple<set_type<Materials>...> seed_all(double h, const B&... bodies) {
    std::uint32_t id = 0;
    std::size_t number = 0;
    return std::tuple<set_type<Materials>...>{seed<Materials>(h, bodies, id, number)...}; // braces: in order
  }
  template <class Material, class Body> static set_type<Material> seed(double h, const Body& b, std::uint32_t& id, std::size_t& number) {
    static_assert(std::remove_cvref_t<decltype(b.geometry)>::dim == dim, "bolide: solver: the geometry of a body has another number of axes than the space");
    set_type<Material> set{b.name, b.material, static_cast<T>(b.spacing / (2 * h)), 0, id, number++, {}, {}, {}};
    set.geometric_mass = b.geometry.volume(Space::hoop) * b.state.density;
    auto& p = set.columns;
    std::mt19937_64 random(b.jitter.seed);
    std::uniform_real_distribution<double> shift(-b.jitter.fraction * b.spacing, b.jitter.fraction * b.spacing);
    const double cross_section = std::pow(b.spacing, dim);
    for_each_lattice_point(b.geometry, b.geometry.anchor(), b.spacing, Space::hoop, [&](const vec<double, dim>& x) {
      const auto i = p.append(id++);
      p.template get<field::mass>()[i] = static_cast<T>(b.state.density * Space::volume(x.data(), cross_section));
      for (int d = 0; d < dim; ++d) {
        p.template get<field::position>(d)[i] = static_cast<T>(x[d] + (b.jitter.fraction > 0 ? shift(random) : 0.0));
        p.template get<field::velocity>(d)[i] = static_cast<T>(b.velocity[d]);
        p.template get<field::carrying_velocity>(d)[i] = static_cast<T>(b.velocity[d]);
      }
    });
    set.material.initialise(p, 0, p.size(), b.state.density, b.state.energy);
    return set;
  }

  void start() {
    started_ = true;
    phases_.quiet_speed = static_cast<T>(controls_.quiet_speed);
    phases_.skip_quiet = controls_.skip_quiet && phases_.body_forces.empty() && phases_.periods.empty() && phases_.walls.empty();
#if defined(_OPENMP)
    threads_ = controls_.threads > 0 ? controls_.threads : omp_get_max_threads();
    phases_.threads = threads_;
#endif
    for (const auto& m : phases_.mirrors) check_side(m);
    phases_.energy.momentum_scale = measure_energy(); // before sort(), which may let particles leave that start outside the box
    phases_.energy.initial = phases_.energy.now;
    phases_.energy.momentum_initial = phases_.energy.momentum_now;
    sort();
    phases_.initialise_stress();
    phases_.sorted = false; // what is at rest is known from now on
    phases_.dt = static_cast<T>(controls_.first_step / phases_.limit.rate / controls_.growth);
    first_dt_ = unclipped_dt_ = static_cast<double>(phases_.dt);
  }

  void choose_step(double most) {
    const double allowed = 1 / phases_.limit.rate, grown = unclipped_dt_ * controls_.growth;
    double dt = std::min(allowed, grown);
    unclipped_dt_ = dt;
    cause_ = allowed <= grown ? phases_.limit.cause : step_cause::growth;
    if (dt >= most) {
      dt = most;
      cause_ = step_cause::end;
    }
    phases_.dt = static_cast<T>(dt);
    phases_.ignore_below = 1 / (1.01 * controls_.growth * unclipped_dt_);
  }

  void check_limit() {
    const double rate = phases_.limit.rate;
    if (!(rate > 0) || !(1 / rate >= controls_.dt_floor * first_dt_)) stop("the time step fell to " + to_text(1 / rate) + " s, below its floor of " +
                                                                          to_text(controls_.dt_floor * first_dt_) + " s");
    if (steps_ >= controls_.step_cap) stop("the step cap of " + std::to_string(controls_.step_cap) + " is reached");
  }
  void check_energy() {
    measure_energy();
    if (!(std::abs(phases_.energy.drift()) <= controls_.energy_bound))
      stop("the total energy changed by " + to_text(phases_.energy.drift()) + " of the initial energy, beyond the bound of " + to_text(controls_.energy_bound));
  }
  /// Leaves run() with the reason of the stop, what was written before, and a last word of the observers.
  template <class... Observers> [[noreturn]] void end_early(std::string text, Observers&... observers) {
    std::string outputs;
    const auto add = [&](const auto& o) {
      if constexpr (requires { std::string(o.last_output()); })
        if (const std::string one = o.last_output(); !one.empty()) outputs.append(outputs.empty() ? "" : ", ").append(one);
    };
    (add(observers), ...);
    text.append(". Last good output: ").append(outputs.empty() ? "none" : outputs);
    const std::string message = text;
    const auto tell = [&](auto& o) {
      if constexpr (requires { o.stopped(*this, message); }) {
        try {
          o.stopped(*this, message);
        } catch (const std::exception& failed) { // the cause of the stop must not be lost behind a full disk
          text.append(". Besides: ").append(failed.what());
        }
      }
    };
    (tell(observers), ...);
    throw run_stopped(text);
  }
  [[noreturn]] void stop(const std::string& why) {
    std::string text("bolide: stopped at step ");
    text.append(std::to_string(steps_)).append(", time ").append(to_text(time_)).append(" s: ").append(why);
    text.append(". Shortest step asked for by particle ").append(std::to_string(phases_.limit.particle)).append(" (").append(name(phases_.limit.cause)).append(")");
    phases_.for_each_set([&](const auto& s) {
      const auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.id()[i] != phases_.limit.particle) continue;
        text.append(" of body ").append(s.name).append(": position");
        for (int d = 0; d < dim; ++d) text.append(" ").append(to_text(static_cast<double>(p.template get<field::position>(d)[i])));
        text.append(" m, velocity");
        for (int d = 0; d < dim; ++d) text.append(" ").append(to_text(static_cast<double>(p.template get<field::velocity>(d)[i])));
        const double m = static_cast<double>(p.template get<field::mass>()[i]);
        text.append(" m/s, density ").append(to_text(m / s.material.material_volume(p, i))).append(" kg/m3, energy ");
        text.append(to_text(static_cast<double>(p.template get<field::energy>()[i]))).append(" J/kg, pressure ");
        text.append(to_text(static_cast<double>(p.template get<field::pressure>()[i]))).append(" Pa");
      }
    });
    throw run_stopped(text);
  }

  /// Drops what left the box or flew beyond what a cell index can say, then rebuilds the blocks.
  void sort() {
    phases_.for_each_set([&](auto& s) { drop_leavers(s); });
    phases_.sort();
  }
  template <class Set> void drop_leavers(Set& s) {
    auto& p = s.columns;
    std::vector<std::uint32_t> stay;
    const double far = phases_.h * 1e9;
    for (std::size_t i = 0; i < p.size(); ++i) {
      bool inside = true;
      for (int d = 0; d < dim; ++d) {
        const double x = static_cast<double>(p.template get<field::position>(d)[i]);
        if (!(std::abs(x) < far)) {
          phases_.limit.particle = p.id()[i];
          stop("a particle is at " + to_text(x) + " m");
        }
        if (box_ && !(x >= box_->low[d] && x <= box_->high[d])) inside = false;
      }
      if (inside) stay.push_back(static_cast<std::uint32_t>(i));
      else count_leaver(s, i);
    }
    if (stay.size() != p.size()) p.reorder(stay);
  }
  template <class Set> void count_leaver(const Set& s, std::size_t i) {
    auto& l = phases_.energy;
    const auto e = particle_energy(s, i);
    l.left += e.total();
    l.mass_left += static_cast<double>(s.columns.template get<field::mass>()[i]);
    ++l.particles_left;
    for (int d = 0; d < dim; ++d)
      l.momentum_left[static_cast<std::size_t>(d)] +=
          static_cast<double>(s.columns.template get<field::mass>()[i]) * static_cast<double>(s.columns.template get<field::velocity>(d)[i]);
  }

  template <class Set> energy_state particle_energy(const Set& s, std::size_t i) const {
    const auto& p = s.columns;
    const double m = static_cast<double>(p.template get<field::mass>()[i]);
    energy_state e;
    for (int d = 0; d < dim; ++d) e.kinetic += 0.5 * m * square(static_cast<double>(p.template get<field::velocity>(d)[i]));
    if constexpr (Transfer::affine)
      for (int c = 0; c < dim * dim; ++c)
        e.kinetic += 0.5 * m * Shape::inertia * square(phases_.h * static_cast<double>(p.template get<field::affine_velocity>(c)[i]));
    e.internal = m * static_cast<double>(p.template get<field::energy>()[i]);
    return e;
  }

  /// Energies and momentum of this moment; returns sum m |v|.
  double measure_energy() {
    auto& l = phases_.energy;
    l.now = {};
    l.momentum_now = {};
    double scale = 0;
    phases_.for_each_set([&](const auto& s) {
      const auto& p = s.columns;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const auto e = particle_energy(s, i);
        l.now.kinetic += e.kinetic;
        l.now.internal += e.internal;
        const double m = static_cast<double>(p.template get<field::mass>()[i]);
        for (int d = 0; d < dim; ++d) {
          const double momentum = m * static_cast<double>(p.template get<field::velocity>(d)[i]);
          l.momentum_now[static_cast<std::size_t>(d)] += momentum;
          scale += std::abs(momentum);
        }
      }
    });
    return scale;
  }
};

template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme, class... Geometries, class... Materials>
solver(Space, Grid, Shape, Transfer, Scheme, controls<T>, body<Geometries, Materials>...)
    -> solver<T, Space, Grid, Shape, Transfer, Scheme, contact::single_field, Materials...>;
template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme, class Contact, class... Geometries, class... Materials>
solver(Space, Grid, Shape, Transfer, Scheme, Contact, controls<T>, body<Geometries, Materials>...)
    -> solver<T, Space, Grid, Shape, Transfer, Scheme, Contact, Materials...>;

} // namespace bolide
