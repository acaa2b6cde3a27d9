// SPDX-License-Identifier: MIT
// The phases of a step: sweeps over the particles of every block, and loops over nodes. A scheme puts them in order.
//
// A sweep takes the blocks colour by colour; blocks of one colour touch no common node and run in parallel. Each runs its particles chunk by
// chunk (gather, lanes, scatter; solver/kernels.hpp). What a block reports is kept per block and added up in the order of the blocks, so the
// number of threads does not change a bit.
//
// What is at rest is not computed. A range whose particles had neither velocity nor stress when they were sorted sleeps until one of its
// nodes moves; material without stress gives no force and does no work. Both leave out only additions of zero: the answer is the same.
// With a quiet speed above 0 (controls::quiet_speed) slower material sleeps too, where it is, and keeps its velocity until it wakes.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/mirror.hpp"
#include "bolide/grid/moving_wall.hpp"
#include "bolide/grid/periodic.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/material/material.hpp"
#include "bolide/solver/body_force.hpp"
#include "bolide/solver/kernels.hpp"
#include "bolide/solver/ledger.hpp"
#include "bolide/solver/particle_set.hpp"
#include "bolide/solver/touched_nodes.hpp"
#include "bolide/solver/work_sharing.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace bolide {

template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme, class Contact, class... Sets> class phases {
public:
  static constexpr int dim = Space::dim;
  static constexpr int velocity_fields = Contact::multi_field ? static_cast<int>(sizeof...(Sets)) : 1; // per node; that of a body begins at field_of(set)
  using map = typename Grid::template map<dim>;
  using sums = grid::node_column<T, dim + 1>;     // m, P
  using forces = grid::node_column<T, dim>;       // f, or the momentum change mapped back
  using motion = grid::node_column<T, 2 * dim>;   // v at the beginning, and its change (FLIP) or v at the end (APIC)
  using kernel = kernels<T, Space, Shape, Transfer>;
  using V = native_pack<T>;

  std::tuple<Sets...> sets;
  map blocks;
  double h;
  T dt = 0;
  T courant;
  Transfer transfer;
  Contact contact;
  std::vector<grid::mirror_nodes<dim>> mirrors;
  std::vector<grid::periodic_nodes<dim>> periods;
  std::vector<grid::moving_wall> walls;
  std::vector<detail::any_body_force<dim>> body_forces;
  double time = 0; // s, of the beginning of the step
  ledger energy;
  step_limit limit;   // of the next step
  double ignore_below = 0; // 1/s: a particle that asks for less cannot limit the next step, whose growth is bounded
  bool skip_quiet = true;  // leave out what is at rest?
  T quiet_speed = 0;       // m/s, up to which it counts as at rest
  bool sorted = false; // does every particle touch only the blocks around its own?
  int threads = 1;     // of the sweeps; the process's own number is left alone

  phases(const Grid& grid, T courant_number, Transfer t, Contact c, std::tuple<Sets...> s)
      : sets(std::move(s)), blocks(grid.template make<dim>()), h(grid.spacing), courant(courant_number), transfer(t), contact(c) {}

  // ---- the phases -------------------------------------------------------------------------------------------------------------
  /// m_I = sum N m, P_I = sum N m v; with a stress that was updated last also f_I = -sum V sigma grad N.
  void map_to_nodes() {
    find_quiet_ranges();
    nodes_.find(blocks.size(), threads, [this](auto&& touch) {
      this->for_each_set([&](const auto& s) {
        for (const auto& r : s.ranges)
          if (r.quiet != asleep) touch(r);
      });
    }, mirrors, periods);
    nodes_.clear(sums_, forces_);
    if constexpr (maps_back) nodes_.clear(back_);
    if constexpr (keeps_raw) nodes_.clear(raw_);
    sweep([this](auto& set, auto& range, update_report&) {
      if (range.quiet == asleep) return;
      kernel::scatter(sums_, field_of(set), range, [&](const auto& to) {
        chunks<for_momentum>(set, range, [&](const auto& c) { kernel::template scatter_momentum<dim + 1>(set.columns, c, to); });
      });
      if constexpr (!Scheme::stress_first)
        if (range.quiet == 0) kernel::scatter(forces_, field_of(set), range, [&](const auto& to) {
          chunks<for_gradients>(set, range, [&](const auto& c) {
            if (carries_stress(set.columns, c.begin, static_cast<std::size_t>(c.n))) kernel::scatter_force(set.columns, c, to);
          });
        });
    });
    complete(sums_, 1);
    motion_.resize(column_size());
    nodes_.find_mass([this](std::size_t i) {
      const T* const m = sums_.row(i);
      T* const v = motion_.row(i);
      const T inverse = T(has_mass(i)) / std::max(m[0], least_mass); // no branch: in debris it would go either way
      for (int d = 0; d < dim; ++d) v[d] = m[1 + d] * inverse, v[dim + d] = T(0);
      return has_mass(i);
    });
    if (constrained()) {
      nodes_.clear(wall_forces_);
      if constexpr (Contact::multi_field) find_normals();
      if constexpr (Scheme::stress_first) constrain<true>();
    }
  }

  /// Stress from the velocities that the particles brought to the nodes, then its forces.
  void update_stress_first() {
    start_report();
    sweep([this](auto& set, auto& range, update_report& report) {
      if (sleeps_on(set, range, report)) return;
      kernel::gather(motion_, field_of(set), range, [&](const auto& nodes) {
        kernel::scatter(forces_, field_of(set), range, [&](const auto& to) {
          chunks<for_gradients>(set, range, [&](const auto& c) {
            typename kernel::template scratch<Space::gradient_size> l;
            if (constrained()) kernel::velocity_gradient(set.columns, c, nodes, T(1), T(1), l);
            else kernel::velocity_gradient(set.columns, c, nodes, l);
            set.material.template update<Space>(set.columns, c.begin, c.n, l.value, context(true), report);
            if (carries_stress(set.columns, c.begin, static_cast<std::size_t>(c.n))) kernel::scatter_force(set.columns, c, to);
          });
        });
      });
    });
    finish_report();
  }

  /// dv_I = f_I dt / m_I, boundary conditions; the nodal work of steps without a map back is known here.
  void accelerate_nodes() {
    if (!body_forces.empty()) scatter_body_forces();
    complete(forces_, 0);
    const bool with_constraints = constrained();
    nodes_.each_with_mass([this, with_constraints](std::size_t i) {
      const T factor = dt / sums_(0, i);
      const T *const f = forces_.row(i), *const b = body_forces.empty() ? nullptr : external_.row(i);
      T* const v = motion_.row(i);
      for (int d = 0; d < dim; ++d) {
        const T before = (with_constraints ? v[dim + d] : T(0)) + (Transfer::affine ? v[d] : T(0)); // with what constrain() did before the stress
        v[dim + d] = before + (b ? f[d] + b[d] : f[d]) * factor;
      }
    });
    if (with_constraints) constrain<false>();
    if constexpr (keeps_raw) nodes_.each_with_mass([this](std::size_t i) {
      for (int d = 0; d < dim; ++d) raw_(d, i) = motion_(d, i) + motion_(dim + d, i);
    });
    if constexpr (Transfer::affine) nodal_work(power_of(forces_));
  }

  /// New particle velocities; what the scheme or the transfer needs back on the nodes.
  void map_to_particles() {
    if constexpr (Transfer::filter_order > 1) filter_velocities();
    sweep<maps_back>([this](auto& set, auto& range, update_report& report) {
      if (sleeps_on(set, range)) return;
      kernel::gather(motion_, field_of(set), range, [&](const auto& nodes) {
        const auto run = [&](const auto& to) {
          chunks<for_transfer>(set, range, [&](const auto& c) {
            if constexpr (Transfer::affine) {
              typename kernel::template scratch<Space::gradient_size> l;
              kernel::velocity_gradient(set.columns, c, nodes, T(0.5), T(0.5), l);
              set.material.template work<Space>(set.columns, c.begin, c.n, l.value, dt, report);
              take_affine(set.columns, c, nodes, report);
              if constexpr (maps_back) kernel::template scatter_momentum<dim>(set.columns, c, to);
            } else add_change(set.columns, c, nodes, to, report);
          });
        };
        if constexpr (maps_back) kernel::scatter(back_, field_of(set), range, run);
        else run(nodes);
      });
    });
    finish_kinetic();
    if constexpr (maps_back) {
      complete(back_, 0);
      const double power = sum_over_nodes([this](std::size_t i) { // FLIP: dv~ = sum N m dv_p / m_I; APIC: v'_I
        const T inverse = T(1) / sums_(0, i);
        for (int d = 0; d < dim; ++d) motion_(dim + d, i) = back_(d, i) * inverse;
        return Transfer::affine ? T(0) : power_at(forces_, i);
      });
      if constexpr (!Transfer::affine) nodal_work(power);
    }
  }

  /// Work of the nodal forces to the particles, stress where it is updated last, and motion.
  void work_and_move() {
    if constexpr (!Scheme::stress_first) start_report();
    sweep<only_reads>([&](auto& set, auto& range, update_report& report) {
      constexpr bool only_work = Scheme::stress_first;
      if (only_work ? range.quiet > 0 : sleeps_on(set, range, report)) return;
      if constexpr (!Transfer::affine || !Scheme::stress_first)
        if (!only_work || carries_stress(set.columns, range.begin, range.end - range.begin)) kernel::gather(motion_, field_of(set), range, [&](const auto& nodes) {
          chunks<for_gradients>(set, range, [&](const auto& c) {
            if (only_work && !carries_stress(set.columns, c.begin, static_cast<std::size_t>(c.n))) return;
            typename kernel::template scratch<Space::gradient_size> l;
            if constexpr (!Transfer::affine) {
              kernel::velocity_gradient(set.columns, c, nodes, T(1), T(0.5), l);
              set.material.template work<Space>(set.columns, c.begin, c.n, l.value, dt, report);
            }
            if constexpr (!Scheme::stress_first && !keeps_raw) {
              kernel::velocity_gradient(set.columns, c, nodes, Transfer::affine ? T(0) : T(1), T(1), l);
              set.material.template update<Space>(set.columns, c.begin, c.n, l.value, context(false), report);
            }
          });
        });
      if constexpr (keeps_raw) kernel::gather(raw_, field_of(set), range, [&](const auto& nodes) {
        chunks<for_gradients>(set, range, [&](const auto& c) {
          typename kernel::template scratch<Space::gradient_size> l;
          kernel::velocity_gradient(set.columns, c, nodes, l);
          set.material.template update<Space>(set.columns, c.begin, c.n, l.value, context(false), report);
        });
      });
      move(set, range, report);
    });
    finish_report();
  }

  /// Pressure, sound speed and the first time step from the initial state.
  void initialise_stress() {
    start_report();
    sweep<only_reads>([this](auto& set, auto& range, update_report& report) { this->update_without_motion(set, range, report); });
    finish_report();
  }

  // ---- book-keeping ---------------------------------------------------------------------------------------------------------
  template <class F> void for_each_set(F&& f) {
    std::apply([&](auto&... s) { (f(s), ...); }, sets);
  }
  template <class F> void for_each_set(F&& f) const {
    std::apply([&](const auto&... s) { (f(s), ...); }, sets);
  }

  /// Rebuilds the blocks around the particles and sorts the particles into them.
  void sort() {
    std::vector<grid::cell_index<dim>> occupied;
    for_each_set([&](auto& s) { s.collect_blocks(h, occupied); });
    rebuild(std::move(occupied));
    for_each_set([&](auto& s) {
      s.sort(blocks, h);
      for (auto& r : s.ranges) {
        if (!skip_quiet || !s.at_rest(r, quiet_speed, static_cast<T>(h))) continue;
        r.quiet = asleep;
        update_report report;
        update_without_motion(s, r, report);
        r.rest = report.limit;
      }
    });
    sorted = true;
  }

  std::size_t node_count() const { return blocks.size() * map::nodes_per_block; }
  /// Values in a node column: one per node and velocity field.
  std::size_t column_size() const { return node_count() * velocity_fields; }
  /// Where the velocity field of a body begins in the node columns.
  template <class Set> std::size_t field_of(const Set& set) const { return Contact::multi_field ? set.number * node_count() : 0; }

  /// Is a particle beyond this box (m)? Known to a cell: what is less than a cell beyond may go unseen.
  bool beyond(const vec<double, dim>& low, const vec<double, dim>& high) const {
    bool any_beyond = false;
    for_each_set([&](const auto& s) {
      for (const auto& r : s.ranges)
        for (std::size_t d = 0; d < dim; ++d) {
          const double lowest = r.origin[d] + r.touched.low[d] + Shape::offset, highest = r.origin[d] + r.touched.high[d] - Shape::support + 1 + Shape::offset;
          any_beyond = any_beyond || (lowest + 1) * h < low[static_cast<int>(d)] || highest * h > high[static_cast<int>(d)];
        }
    });
    return any_beyond;
  }

  /// All that the next step starts from (concepts/archive.hpp). Node values are made anew in every step, mirrors with the blocks.
  template <class A> void archive(A& a) {
    a.value("dt", dt);
    a.value("limit_rate", limit.rate);
    a.value("limit_cause", limit.cause);
    a.value("limit_particle", limit.particle);
    a.value("ignore_below", ignore_below);
    a.value("sorted", sorted);
    a.value("ledger", energy);
    std::vector<grid::cell_index<dim>> occupied;
    int body = 0;
    for_each_set([&](auto& s) {
      a.value("body_" + std::to_string(body++), s);
      for (const auto& r : s.ranges) occupied.push_back(map::block_of(r.origin));
    });
    if constexpr (A::reading) {
      rebuild(std::move(occupied));
      for_each_set([&](auto& s) { s.connect(blocks, h); });
    }
  }

private:
  static constexpr int asleep = 3;
  static constexpr bool maps_back = !Transfer::affine || Scheme::maps_velocity_back;
  /// Does the stress follow the velocities that the forces left on the nodes, where the column `motion_` no longer has them?
  static constexpr bool keeps_raw = !Transfer::affine && !Scheme::stress_first && !Scheme::maps_velocity_back;
  static constexpr bool filters = Transfer::filter_order > 0;
  static constexpr bool only_reads = false; // the nodes: a sweep that adds nothing to them
  static constexpr wants for_gradients{true, false}, for_momentum{false, Transfer::affine}, for_transfer{Transfer::affine, Transfer::affine};
  static constexpr T least_mass = std::numeric_limits<T>::min(); // of a node: less is subnormal, and its inverse may be infinite (3-D GIMP in float)
  static constexpr std::size_t worth_threads = 16384; // particles below which threads cost more than they give
  bool has_mass(std::size_t i) const { return sums_(0, i) > least_mass; }

  sums sums_;
  forces forces_, back_, external_, raw_, residual_, next_residual_, normals_, wall_forces_, contact_forces_;
  motion motion_;
  touched_nodes<dim, velocity_fields> nodes_;
  std::vector<update_report> reports_; // one per range
  work_sharing work_;

  /// Makes the blocks around the occupied ones, and what the boundaries know of them.
  void rebuild(std::vector<grid::cell_index<dim>> occupied) {
    blocks.rebuild(std::move(occupied));
    require(static_cast<double>(column_size()) < 2147483647.0, "nodes of the grid times velocity fields", static_cast<double>(column_size()), "less than 2^31: take larger cells");
    for (auto& m : mirrors) m.rebuild(blocks);
    for (auto& p : periods) p.rebuild(blocks);
  }
  /// The boundary conditions on a sum over particles, in every velocity field; components first .. first + dim - 1 are a vector.
  template <class Column> void complete(Column& column, int first) const {
    for (std::size_t f = 0; f < velocity_fields; ++f) {
      for (const auto& m : mirrors) m.complete(column, first, f * node_count());
      for (const auto& p : periods) p.complete(column, first, f * node_count());
    }
  }

  step_context<T> context(bool gradient_at_end) const { return {dt, static_cast<T>(h), courant, ignore_below, gradient_at_end}; }

  /// f(set, range, report) for every block range of every body; colour by colour if it adds to nodes, else no block waits for another.
  template <bool AddsToNodes = true, class F> void sweep(F&& f) {
    std::size_t ranges = 0, particles = 0;
    for_each_set([&](const auto& s) { ranges += s.ranges.size(), particles += s.columns.size(); });
    reports_.assign(ranges, update_report{});
    const int used = particles > worth_threads ? threads : 1;
    work_.begin(sizeof...(Sets) * map::colours, used);
#if defined(_OPENMP)
#pragma omp parallel num_threads(used)
#endif
    {
      std::size_t first = 0, number = 0;
      for_each_set([&](auto& s) {
        const auto run = [&](std::size_t r) { f(s, s.ranges[r], reports_[first + r]); };
        if constexpr (AddsToNodes)
          for (const auto& colour : s.by_colour) work_.run(number++, colour.size(), [&](std::size_t i) { run(static_cast<std::size_t>(colour[i])); });
        else work_.run(number++, s.ranges.size(), run);
        first += s.ranges.size();
      });
    }
    for (const auto& r : reports_) total_ += r;
  }
  update_report total_;
  void start_report() { total_.limit = {}; }
  void finish_report() {
    limit = total_.limit;
    limit.rate = std::max(limit.rate, ignore_below);
    energy.work_mismatch += total_.work_energy;
    energy.plastic_work += total_.plastic_work;
    energy.failure_release += total_.failure_release;
    energy.viscous_heating += total_.viscous_heating;
    energy.floors += total_.floors;
    if (total_.moved_out) sorted = false;
    const auto keep = total_.limit;
    total_ = {};
    total_.limit = keep;
  }
  void finish_kinetic() {
    energy.transfer += total_.kinetic_gain;
    energy.returned_heat += total_.returned_heat;
    total_.kinetic_gain = total_.returned_heat = 0;
  }

  template <class Set> void update_without_motion(Set& set, const block_range<dim>& range, update_report& report) const {
    const T l[Space::gradient_size][chunk_size] = {};
    auto still = context(true);
    still.dt = 0;
    still.ignore_below = 0;
    for (std::size_t begin = range.begin; begin < range.end; begin += chunk_size)
      set.material.template update<Space>(set.columns, begin, static_cast<int>(std::min<std::size_t>(chunk_size, range.end - begin)), l, still, report);
  }

  /// How far off is the next awake range? Next to it a sleeper listens (1): it brings its mass to the nodes and wakes when they move. Next
  /// to a listener, which may wake, it brings its mass (2). Blocks further apart than that share no node (grid/sparse.hpp).
  void find_quiet_ranges() {
    std::vector<char> distance(blocks.size(), asleep);
    const auto spread = [&](int from, int to) {
      for_each_set([&](auto& s) {
        for (const auto& r : s.ranges)
          if (r.quiet == from)
            for (const auto b : r.near) distance[static_cast<std::size_t>(b)] = std::min(distance[static_cast<std::size_t>(b)], static_cast<char>(to));
      });
      for_each_set([&](auto& s) {
        for (auto& r : s.ranges)
          if (r.quiet > to) r.quiet = std::min<int>(asleep, distance[static_cast<std::size_t>(r.near[map::neighbours / 2])]);
      });
    };
    for_each_set([](auto& s) {
      for (auto& r : s.ranges)
        if (r.quiet > 0) r.quiet = asleep;
    });
    spread(0, 1);
    spread(1, 2);
  }
  /// Does a range go on sleeping? It wakes when a node of it moves.
  template <class Set> bool sleeps_on(const Set& set, block_range<dim>& range, update_report& report) const {
    if (!sleeps_on(set, range)) return false;
    report.limit = range.rest;
    return true;
  }
  template <class Set> bool sleeps_on(const Set& set, block_range<dim>& range) const {
    if (range.quiet == 0) return false;
    if (range.quiet > 1) return true;
    bool moves = false;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int, int count) {
      const T* const v = motion_.row(field_of(set) + static_cast<std::size_t>(node));
      for (int i = 0; i < count; ++i)
        for (int c = 0; c < 2 * dim; ++c) moves = moves || !(std::abs(v[i * motion::width + c]) <= quiet_speed);
    });
    if (moves) range.quiet = 0;
    return !moves;
  }
  /// Has any of n particles from `begin` a stress? Without one there is no force and no work.
  template <class Columns> static BOLIDE_INLINE bool carries_stress(const Columns& p, std::size_t begin, std::size_t n) {
    const V zero(T(0));
    for (std::size_t k = 0; k < n; k += static_cast<std::size_t>(lane_width<V>)) {
      auto some = load<V>(p.template get<field::pressure>() + begin + k) != zero;
      if constexpr (Columns::template has<field::viscous_pressure>) some = some || load<V>(p.template get<field::viscous_pressure>() + begin + k) != zero;
      if constexpr (Columns::template has<field::deviator>)
        for (int c = 0; c < Space::deviator_size; ++c) some = some || load<V>(p.template get<field::deviator>(c) + begin + k) != zero;
      if (any(some && first_lanes<V>(static_cast<int>(std::min<std::size_t>(n - k, static_cast<std::size_t>(lane_width<V>)))))) return true;
    }
    return false;
  }

  /// f.(v + dv/2), f a column of nodal forces; for affine transfers f.(v + v')/2. Nodes without mass have no velocity.
  BOLIDE_INLINE T power_at(const forces& f, std::size_t i) const {
    constexpr T half = T(0.5), first = Transfer::affine ? half : T(1);
    T power(0);
    for (int d = 0; d < dim; ++d) power += f(d, i) * (first * motion_(d, i) + half * motion_(dim + d, i));
    return power;
  }
  /// Sum of what f(i) returns for the real nodes that have mass.
  template <class F> double sum_over_nodes(F&& f) {
    return nodes_.sum_with_mass(f, [this](std::size_t i) { return is_image(i); });
  }
  double power_of(const forces& f) {
    return sum_over_nodes([&](std::size_t i) { return power_at(f, i); });
  }
  /// The work of the stress leaves the nodes for the particles' energy: transfer loses and mismatch gains it. That of other forces has channels of
  /// its own.
  void nodal_work(double power) {
    const double work = power * static_cast<double>(dt);
    energy.transfer -= work;
    energy.work_mismatch += work;
    if (!body_forces.empty()) book(external_, energy.body_work);
    if (!walls.empty()) {
      book(wall_forces_, energy.boundary_work);
      give_momentum([this](std::size_t i, int d) { return has_mass(i) && !is_image(i) ? static_cast<double>(wall_forces_(d, i)) : 0.0; });
    }
    if constexpr (Contact::multi_field) book(contact_forces_, energy.contact);
  }
  /// Books the work of a column of forces in a channel of its own instead of in `transfer`.
  void book(const forces& f, double& channel) {
    const double work = power_of(f) * static_cast<double>(dt);
    energy.transfer -= work;
    channel += work;
  }

  // ---- moving walls, and contact between bodies that keep a velocity of their own -------------------------------------------------
  bool constrained() const { return Contact::multi_field || !walls.empty(); }

  /// Outward direction of every body: sum V grad N, which points from its particles to the node.
  void find_normals() {
    nodes_.clear(normals_, contact_forces_);
    sweep([this](auto& set, auto& range, update_report&) {
      if (range.quiet == asleep) return;
      kernel::scatter(normals_, field_of(set), range, [&](const auto& to) {
        chunks<for_gradients>(set, range, [&](const auto& c) { kernel::scatter_normal(set.columns, c, to); });
      });
    });
    complete(normals_, 0);
  }

  /// Changes node velocities to what contact and walls allow: before the stress those that the particles brought, then those that the forces
  /// left. The change goes to the second half of `motion_`, the force that makes it is remembered for the ledger.
  template <bool Before> void constrain() {
    if constexpr (Contact::multi_field)
      nodes_.each_place([this](std::size_t block, int n) { this->template separate_bodies<Before>(place(block, n)); });
    for (const auto& w : walls)
      nodes_.each_place([&](std::size_t block, int n) {
        const double x = blocks.node_at(block, n)[static_cast<std::size_t>(w.axis)] * h;
        if (!w.holds(x, time + static_cast<double>(dt), h)) return;
        for (std::size_t at = place(block, n); at < column_size(); at += node_count()) this->template push<Before>(w, at);
      });
  }
  static constexpr std::size_t place(std::size_t block, int n) { return block * map::nodes_per_block + static_cast<std::size_t>(n); }
  /// The velocity that constrain() looks at, component d of node value i.
  template <bool Before> T free_velocity(std::size_t i, int d) const {
    return motion_(dim + d, i) + (Before || !Transfer::affine ? motion_(d, i) : T(0));
  }
  void change_velocity(forces& by, std::size_t i, int d, T change) {
    motion_(dim + d, i) += change;
    by(d, i) += sums_(0, i) * change / dt;
  }
  template <bool Before> void push(const grid::moving_wall& w, std::size_t i) {
    if (!has_mass(i) || !w.approaches(this->template free_velocity<Before>(i, w.axis))) return;
    for (int d = 0; d < dim; ++d)
      if (d == w.axis || w.stick) change_velocity(wall_forces_, i, d, (d == w.axis ? static_cast<T>(w.velocity) : T(0)) - this->template free_velocity<Before>(i, d));
  }
  template <bool Before> void separate_bodies(std::size_t place) {
    std::size_t bodies[velocity_fields];
    std::size_t count = 0;
    T mass = 0;
    std::array<T, dim> mean{}; // velocity of the centre of mass
    for (std::size_t at = place; at < column_size(); at += node_count())
      if (has_mass(at)) {
        bodies[count++] = at;
        mass += sums_(0, at);
        for (std::size_t d = 0; d < dim; ++d) mean[d] += sums_(0, at) * this->template free_velocity<Before>(at, static_cast<int>(d));
      }
    if (count < 2) return;
    for (auto& v : mean) v /= mass;
    // out of the first body: the direction of the body that has more of a surface here, so that a corner does not tilt the plane it lies on
    std::array<T, dim> n{}, u{};
    T length = 0;
    for (std::size_t b = 0; b < 2 && count == 2; ++b) {
      T squares = 0;
      for (int d = 0; d < dim; ++d) squares += square(normals_(d, bodies[b]));
      if (!(squares > length)) continue;
      length = squares;
      for (int d = 0; d < dim; ++d) n[static_cast<std::size_t>(d)] = (b == 0 ? T(1) : T(-1)) * normals_(d, bodies[b]);
    }
    const T inverse = length > T(0) ? T(1) / std::sqrt(length) : T(0);
    for (std::size_t b = 0; b < count; ++b) {
      for (std::size_t d = 0; d < dim; ++d) u[d] = this->template free_velocity<Before>(bodies[b], static_cast<int>(d)) - mean[d];
      std::array<T, dim> change;
      if (inverse > T(0)) {
        std::array<T, dim> outward;
        for (std::size_t d = 0; d < dim; ++d) outward[d] = (b == 0 ? inverse : -inverse) * n[d];
        change = contact.correction(u, outward);
      } else
        for (std::size_t d = 0; d < dim; ++d) change[d] = -u[d]; // three bodies, or no direction: they stick
      for (std::size_t d = 0; d < dim; ++d) change_velocity(contact_forces_, bodies[b], static_cast<int>(d), change[d]);
    }
  }
  /// Counts the momentum that forces on the nodes give in this step; force(node value, axis).
  template <class F> void give_momentum(F&& force) {
    for (int d = 0; d < dim; ++d)
      energy.momentum_given[static_cast<std::size_t>(d)] += static_cast<double>(dt) * nodes_.sum([&](std::size_t i) { return force(i, d); });
  }

  /// sum N m b(x_p, t), and the momentum that it gives.
  void scatter_body_forces() {
    nodes_.clear(external_);
    sweep([this](auto& set, auto& range, update_report&) {
      kernel::scatter(external_, field_of(set), range, [&](const auto& to) {
        chunks<wants{}>(set, range, [&](const auto& c) {
          typename kernel::template scratch<dim> force;
          for (int k = 0; k < c.n; ++k) {
            const auto b = body_force_on(set.columns, c.begin + static_cast<std::size_t>(k));
            for (int d = 0; d < dim; ++d) force[d][k] = static_cast<T>(b[d]);
          }
          kernel::scatter_values(set.columns, c, force, to);
        });
      });
    });
    give_momentum([this](std::size_t i, int d) { return static_cast<double>(external_(d, i)); }); // of the real particles: before the boundaries
    complete(external_, 0);
  }
  bool is_image(std::size_t at) const {
    const std::size_t node = velocity_fields == 1 ? at : at % node_count();
    for (const auto& m : mirrors)
      if (m.is_image(node)) return true;
    for (const auto& p : periods)
      if (p.is_image(node)) return true;
    return false;
  }

  template <wants Wanted, class Set, class F> BOLIDE_INLINE void chunks(const Set& set, const block_range<dim>& range, F&& f) const {
    kernel::template chunks<Wanted>(set, range, h, f);
  }

  // ---- what particles do -------------------------------------------------------------------------------------------------------
  /// m b(x_p, t)
  template <class Columns> vec<double, dim> body_force_on(const Columns& p, std::size_t i) const {
    vec<double, dim> x, total = vec<double, dim>::Zero();
    for (int d = 0; d < dim; ++d) x[d] = static_cast<double>(p.template get<field::position>(d)[i]);
    for (const auto& f : body_forces) total += f.acceleration(x, time);
    return total * static_cast<double>(p.template get<field::mass>()[i]);
  }
  /// FLIP: v_p += sum N dv, carried along with sum N (v + dv); m dv_p goes back to the nodes.
  template <class Columns, class Nodes, class Back>
  BOLIDE_INLINE void add_change(Columns& p, const typename kernel::chunk_type& c, const Nodes& nodes, const Back& back, update_report& report) const {
    typename kernel::template scratch<2 * dim> seen; // v and dv
    [[maybe_unused]] typename kernel::template scratch<dim> given; // m dv_p
    kernel::mean(p, c, nodes, seen);
    [[maybe_unused]] typename kernel::template scratch<1> spread_squares;
    if constexpr (Transfer::filter_order == 1)
      kernel::mean_square(p, c, nodes, [&](int d) { return p.template get<field::velocity>(d); }, spread_squares[0]);
    detail::lane_sum<V> kinetic_gain;
    for (int k = 0; k < c.n; k += lane_width<V>) {
      const std::size_t at = c.begin + static_cast<std::size_t>(k);
      const int n = std::min(c.n - k, lane_width<V>);
      const V m = load<V>(p.template get<field::mass>() + at);
      V gain(T(0));
      if constexpr (filters) gain = filter(p, at, n, k, seen, spread_squares, report);
      for (int d = 0; d < dim; ++d) {
        T* const velocity = p.template get<field::velocity>(d) + at;
        const V v = load<V>(velocity), mean = load<V>(seen[d] + k), dv = load<V>(seen[dim + d] + k);
        gain += dv * (v + T(0.5) * dv);
        store_first(v + dv, velocity, n);
        store_first(mean + dv, p.template get<field::carrying_velocity>(d) + at, n);
        store(m * dv, given[d] + k);
      }
      kinetic_gain.add(m * gain, n);
    }
    report.kinetic_gain += kinetic_gain.total();
    if constexpr (maps_back) kernel::scatter_values(p, c, given, back);
  }

  /// Takes filter() r, r = (1 - S S+)^m v, from the velocity of n particles before they take the change dv of the grid, and returns what that
  /// loses as heat (transfer/pic.hpp, transfer/xpic.hpp). The change of v^2/2.
  template <class Columns, class Seen, class Squares>
  BOLIDE_INLINE V filter(Columns& p, std::size_t at, int n, int k, const Seen& seen, const Squares& spread_squares, update_report& report) const {
    const T part = static_cast<T>(transfer.filter());
    V unseen, squares(T(0)), product(T(0)), gain(T(0)); // v . r as a sum that is not negative, |r|^2, dv . r
    if constexpr (Transfer::filter_order == 1) unseen = load<V>(spread_squares[0] + k);
    else unseen = load<V>(p.template get<field::filter_loss>() + at);
    for (int d = 0; d < dim; ++d) {
      T* const velocity = p.template get<field::velocity>(d) + at;
      const V v = load<V>(velocity);
      V r;
      if constexpr (Transfer::filter_order == 1) r = v - load<V>(seen[d] + k);
      else r = load<V>(p.template get<field::velocity_residual>(d) + at);
      const V next = v - part * r;
      squares += r * r;
      product += load<V>(seen[dim + d] + k) * r;
      gain += T(0.5) * (next - v) * (next + v);
      store_first(next, velocity, n);
    }
    const V heat = static_cast<T>(transfer.heat) * part * (unseen - T(0.5) * part * squares + product);
    return_heat(p, at, n, heat, report);
    return gain;
  }
  /// Specific energy for n particles; one that had settled is no longer.
  template <class Columns> static BOLIDE_INLINE void return_heat(Columns& p, std::size_t at, int n, V heat, update_report& report) {
    T* const energy = p.template get<field::energy>() + at;
    store_first(load<V>(energy) + heat, energy, n);
    report.returned_heat += detail::sum(load<V>(p.template get<field::mass>() + at) * heat, n);
    if constexpr (Columns::template has<field::failed>) {
      T* const failed = p.template get<field::failed>() + at;
      const V state = load<V>(failed);
      store_first(select(heat != V(T(0)), min(state, V(T(1))), state), failed, n);
    }
  }

  /// (1 - S S+)^m v_p of every particle, m > 1: the map to the nodes and back, m times.
  void filter_velocities() {
    for (int j = 1; j <= Transfer::filter_order; ++j) {
      const bool last = j == Transfer::filter_order;
      if (!last) nodes_.clear(next_residual_);
      sweep([&](auto& set, auto& range, update_report&) {
        if (sleeps_on(set, range)) return;
        const auto run = [&](const auto& nodes) {
          const auto one_map = [&](const typename kernel::template sink<dim>* to) {
            chunks<wants{}>(set, range, [&](const auto& c) { apply_filter(set.columns, c, nodes, to, j); });
          };
          if (last) one_map(nullptr);
          else kernel::scatter(next_residual_, field_of(set), range, [&](const auto& to) { one_map(&to); });
        };
        if (j == 1) kernel::gather(motion_, field_of(set), range, run);
        else kernel::gather(residual_, field_of(set), range, run);
      });
      if (last) return;
      complete(next_residual_, 0);
      nodes_.each_with_mass([this](std::size_t i) {
        for (int d = 0; d < dim; ++d) next_residual_(d, i) /= sums_(0, i);
      });
      std::swap(residual_, next_residual_);
    }
  }
  /// r_j = r_(j-1) - S S+ r_(j-1) for the particles of a chunk; `nodes` hold S+ r_(j-1), and m r_j goes `to` the nodes of the next round.
  template <class Columns, class Nodes, class To>
  BOLIDE_INLINE void apply_filter(Columns& p, const typename kernel::chunk_type& c, const Nodes& nodes, const To* to, int j) const {
    constexpr int order = Transfer::filter_order;
    T* const loss = p.template get<field::filter_loss>() + c.begin;
    const bool whole = order % 2 == 0 && j == order / 2, half = order % 2 == 1 && j == (order + 1) / 2;
    const auto before = [&](int d) { return j == 1 ? p.template get<field::velocity>(d) : p.template get<field::velocity_residual>(d); };
    typename kernel::template scratch<Nodes::components> mean;
    typename kernel::template scratch<1> squares;
    typename kernel::template scratch<dim> given; // m r_j
    kernel::mean(p, c, nodes, mean);
    if (half) kernel::mean_square(p, c, nodes, before, squares[0]);
    for (int k = 0; k < c.n; k += lane_width<V>) {
      const std::size_t at = c.begin + static_cast<std::size_t>(k);
      const int n = std::min(c.n - k, lane_width<V>);
      const V m = load<V>(p.template get<field::mass>() + at);
      V square_sum(T(0));
      for (int d = 0; d < dim; ++d) {
        const V next = load<V>(before(d) + at) - load<V>(mean[d] + k);
        store_first(next, p.template get<field::velocity_residual>(d) + at, n);
        square_sum += next * next;
        store(m * next, given[d] + k);
      }
      if (whole) store_first(square_sum, loss + k, n);
      if (half) store_first(load<V>(squares[0] + k), loss + k, n);
    }
    if (to) kernel::scatter_values(p, c, given, *to);
  }

  /// APIC: velocity and affine field from the grid; what is lost on both ways becomes heat:
  ///   to the grid    1/2 sum N |v_I - v_p - C dx|^2 = 1/2 (sum N |b|^2 - 2 C : M + inertia |C|^2),  b = v_I - v_p, M = sum N b dx^T
  ///   from the grid  1/2 sum N |v'_I - v'_p - C' dx|^2 = 1/2 (sum N |b'|^2 - |sum N b'|^2 - inertia |C'|^2),  b' = v'_I - v_p
  /// as sums relative to the old velocity: squares of differences, not of speeds.
  template <class Columns, class Nodes> BOLIDE_INLINE void take_affine(Columns& p, const typename kernel::chunk_type& c, const Nodes& nodes, update_report& report) const {
    const T cell = static_cast<T>(h), inertia = cell * cell * T(Shape::inertia);
    typename kernel::template scratch<kernel::moments> sum;
    kernel::affine_moments(p, c, nodes, sum, cell);
    detail::lane_sum<V> kinetic_gain;
    for (int k = 0; k < c.n; k += lane_width<V>) {
      const std::size_t at = c.begin + static_cast<std::size_t>(k);
      const int n = std::min(c.n - k, lane_width<V>);
      V kinetic(T(0)), loss = load<V>(sum[2 * dim] + k);
      for (int i = 0; i < dim; ++i) {
        T* const velocity = p.template get<field::velocity>(i) + at;
        const V v = load<V>(velocity), dv = load<V>(sum[dim + i] + k);
        kinetic += dv * (v + T(0.5) * dv);
        loss -= dv * dv;
        store_first(v + dv, velocity, n);
        store_first(v + dv, p.template get<field::carrying_velocity>(i) + at, n);
        for (int d = 0; d < dim; ++d) {
          T* const affine = p.template get<field::affine_velocity>(i * dim + d) + at;
          const V slope = load<V>(affine), next = load<V>(sum[2 * dim + 1 + (dim + i) * dim + d] + k) / inertia;
          loss += slope * (inertia * slope - T(2) * load<V>(sum[2 * dim + 1 + i * dim + d] + k)) - inertia * next * next;
          kinetic += T(0.5) * inertia * (next * next - slope * slope);
          store_first(next, affine, n);
        }
      }
      kinetic_gain.add(load<V>(p.template get<field::mass>() + at) * kinetic, n);
      return_heat(p, at, n, T(0.5) * static_cast<T>(transfer.heat) * loss, report);
    }
    report.kinetic_gain += kinetic_gain.total();
  }

  /// x_p += dt sum N (v + dv); a particle that crosses a mirror comes back reflected, and is counted.
  template <class Set> void move(Set& set, block_range<dim>& range, update_report& report) const {
    auto& p = set.columns;
    for (std::size_t at = range.begin; at < range.end; at += static_cast<std::size_t>(lane_width<V>)) {
      const int n = static_cast<int>(std::min<std::size_t>(range.end - at, static_cast<std::size_t>(lane_width<V>)));
      for (int d = 0; d < dim; ++d) {
        V x = load<V>(p.template get<field::position>(d) + at) + dt * load<V>(p.template get<field::carrying_velocity>(d) + at);
        for (const auto& m : mirrors) {
          if (m.axis() != static_cast<std::size_t>(d)) continue;
          const V plane(static_cast<T>(m.line() * h));
          const auto beyond = (m.material_above() ? x < plane : x > plane) && first_lanes<V>(n);
          if (!any(beyond)) continue;
          report.floors.add(floor_kind::reflected, count(beyond));
          x = select(beyond, T(2) * plane - x, x);
          const V v = load<V>(p.template get<field::velocity>(d) + at);
          store_first(select(beyond, -v, v), p.template get<field::velocity>(d) + at, n);
          if constexpr (Transfer::affine)
            for (int e = 0; e < dim * dim; ++e)
              if ((e / dim == d) != (e % dim == d)) {
                const V c = load<V>(p.template get<field::affine_velocity>(e) + at);
                store_first(select(beyond, -c, c), p.template get<field::affine_velocity>(e) + at, n);
              }
        }
        for (const auto& period : periods) {
          if (period.axis() != static_cast<std::size_t>(d)) continue;
          const V low(static_cast<T>(period.low() * h)), high(static_cast<T>(period.high() * h));
          x = select(x < low, x + (high - low), select(x >= high, x - (high - low), x));
        }
        store_first(x, p.template get<field::position>(d) + at, n);
      }
    }
    if (!set.measure(range, h)) report.moved_out = true;
    else set.renew_tiles(range, h);
  }
};

} // namespace bolide
