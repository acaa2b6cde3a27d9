// SPDX-License-Identifier: MIT
// The phases of a step: sweeps over the particles of every block, and loops over nodes. A scheme puts them in order.
//
// A sweep takes the blocks colour by colour; blocks of one colour run in parallel. Each copies the nodes that it needs into a window,
// runs its particles chunk by chunk (stencil, gather, lanes, scatter), and adds its sums back. What a block reports is
// kept per block and added up in the order of the blocks, so the number of threads does not change a bit.
//
// What is at rest is not computed. A range whose particles had neither velocity nor stress when they were sorted sleeps until one of its
// nodes moves; material without stress gives no force and does no work. Both leave out only additions of zero: the answer is the same.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/core/field.hpp"
#include "bolide/core/math.hpp"
#include "bolide/grid/mirror.hpp"
#include "bolide/grid/moving_wall.hpp"
#include "bolide/grid/periodic.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/body_force.hpp"
#include "bolide/solver/ledger.hpp"
#include "bolide/solver/particle_set.hpp"
#include "bolide/solver/stencil.hpp"

#include <tuple>
#include <vector>

namespace bolide {

template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme, class Contact, class... Sets> class phases {
public:
  static constexpr int dim = Space::dim;
  static constexpr int velocity_fields = Contact::multi_field ? static_cast<int>(sizeof...(Sets)) : 1; // per node; that of a body begins at field_of(set)
  using map = typename Grid::template map<dim>;
  using sums = grid::node_values<T, dim + 1>;     // m, P
  using forces = grid::node_values<T, dim>;       // f, or the momentum change mapped back
  using motion = grid::node_values<T, 2 * dim>;   // v at the beginning, and its change (FLIP) or v at the end (APIC)
  using stencil_type = stencil<T, Space, Shape>;

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
  bool sorted = false; // does every particle touch only the blocks around its own?

  phases(const Grid& grid, T courant_number, Transfer t, Contact c, std::tuple<Sets...> s)
      : sets(std::move(s)), blocks(grid.template make<dim>()), h(grid.spacing), courant(courant_number), transfer(t), contact(c) {}

  // ---- the phases -------------------------------------------------------------------------------------------------------------
  /// m_I = sum N m, P_I = sum N m v; with a stress that was updated last also f_I = -sum V sigma grad N.
  void map_to_nodes() {
    find_quiet_ranges();
    find_touched_nodes();
    clear(sums_);
    if constexpr (!Scheme::stress_first) clear(forces_);
    sweep([this](auto& set, auto& range, update_report&) {
      if (range.quiet == asleep) return;
      scatter(sums_, field_of(set), range, [&](auto& win) {
        chunks<wants::values>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
          scatter_momentum(set.columns, begin, n, st, win);
        });
      });
      if constexpr (!Scheme::stress_first)
        if (range.quiet == 0) scatter(forces_, field_of(set), range, [&](auto& win) {
          chunks<wants::gradients>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            if (carries_stress(set.columns, begin, static_cast<std::size_t>(n))) scatter_force(set, begin, n, st, win);
          });
        });
    });
    complete(sums_, 1);
    motion_.resize(column_size());
    if constexpr (Scheme::stress_first) forces_.resize(column_size());
    if constexpr (maps_back) back_.resize(column_size());
    if constexpr (keeps_raw) raw_.resize(column_size());
    each_node([this](std::size_t i) {
      const sums s = sums_[i];
      motion v(T(0));
      if (s[0] > T(0)) {
        const T inverse_mass = T(1) / s[0];
        v = motion::make([&](int c) { return c < dim ? s[c < dim ? 1 + c : 0] * inverse_mass : T(0); });
      }
      motion_[i] = v;
      if constexpr (Scheme::stress_first) forces_[i] = forces(T(0));
      if constexpr (maps_back) back_[i] = forces(T(0));
    });
    if (constrained()) {
      clear(wall_forces_);
      if constexpr (Contact::multi_field) find_normals();
      if constexpr (Scheme::stress_first) constrain<true>();
    }
  }

  /// Stress from the velocities that the particles brought to the nodes, then its forces.
  void update_stress_first() {
    start_report();
    sweep([this](auto& set, auto& range, update_report& report) {
      if (sleeps_on(set, range, report)) return;
      gather(motion_, field_of(set), range, [&](auto& nodes) {
        scatter(forces_, field_of(set), range, [&](auto& win) {
          chunks<wants::gradients>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            T l[Space::gradient_size][chunk_size];
            velocity_gradient(n, st, nodes, T(1), constrained() ? T(1) : T(0), l);
            set.material.template update<Space>(set.columns, begin, n, l, context(true), report);
            if (carries_stress(set.columns, begin, static_cast<std::size_t>(n))) scatter_force(set, begin, n, st, win);
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
    each_node([this, with_constraints](std::size_t i) {
      if (!(sums_[i][0] > T(0))) return;
      const T factor = dt / sums_[i][0];
      for (int d = 0; d < dim; ++d) {
        const T f = body_forces.empty() ? forces_[i][d] : forces_[i][d] + external_[i][d];
        const T before = with_constraints ? motion_[i][dim + d] : T(0); // what constrain() did before the stress
        motion_[i].set(dim + d, f * factor + (before + (Transfer::affine ? motion_[i][d] : T(0))));
      }
    });
    if (with_constraints) constrain<false>();
    if constexpr (keeps_raw) each_node([this](std::size_t i) {
      for (int d = 0; d < dim; ++d) raw_[i].set(d, motion_[i][d] + motion_[i][dim + d]);
    });
    if constexpr (Transfer::affine) nodal_work(sum_over_nodes([this](std::size_t i) { return power_of(forces_, i); }));
  }

  /// New particle velocities; what the scheme or the transfer needs back on the nodes.
  void map_to_particles() {
    if constexpr (Transfer::filter_order > 1) filter_velocities();
    sweep([this](auto& set, auto& range, update_report& report) {
      if (sleeps_on(set, range)) return;
      gather(motion_, field_of(set), range, [&](auto& nodes) {
        const auto run = [&](auto& win) {
          chunks<Transfer::affine ? wants::both : wants::values>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            if constexpr (Transfer::affine) {
              T l[Space::gradient_size][chunk_size];
              velocity_gradient(n, st, nodes, T(0.5), T(0.5), l);
              set.material.template work<Space>(set.columns, begin, n, l, dt, report);
              take_affine(set.columns, begin, n, st, nodes, report);
              if constexpr (maps_back)
                scatter_velocity_back(set.columns, begin, n, st, win);
            } else {
              add_change(set.columns, begin, n, st, nodes, win, report);
            }
          });
        };
        if constexpr (maps_back) scatter(back_, field_of(set), range, run);
        else run(nodes);
      });
    });
    finish_kinetic();
    if constexpr (maps_back) {
      complete(back_, 0);
      const double power = sum_over_nodes([this](std::size_t i) {
        if (!(sums_[i][0] > T(0))) return 0.0;
        for (int d = 0; d < dim; ++d) motion_[i].set(dim + d, back_[i][d] / sums_[i][0]); // FLIP: dv~ = sum N m dv_p / m_I; APIC: v'_I
        return Transfer::affine ? 0.0 : power_of(forces_, i);
      });
      if constexpr (!Transfer::affine) nodal_work(power);
    }
  }

  /// Work of the nodal forces to the particles, stress where it is updated last, and motion.
  void work_and_move() {
    if constexpr (!Scheme::stress_first) start_report();
    sweep([&](auto& set, auto& range, update_report& report) {
      constexpr bool only_work = Scheme::stress_first;
      if (only_work ? range.quiet > 0 : sleeps_on(set, range, report)) return;
      if constexpr (!Transfer::affine || !Scheme::stress_first)
        if (!only_work || carries_stress(set.columns, range.begin, range.end - range.begin)) gather(motion_, field_of(set), range, [&](auto& nodes) {
          chunks<wants::gradients>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            T l[Space::gradient_size][chunk_size];
            if constexpr (!Transfer::affine) {
              velocity_gradient(n, st, nodes, T(1), T(0.5), l);
              set.material.template work<Space>(set.columns, begin, n, l, dt, report);
            }
            if constexpr (!Scheme::stress_first && !keeps_raw) {
              velocity_gradient(n, st, nodes, Transfer::affine ? T(0) : T(1), T(1), l);
              set.material.template update<Space>(set.columns, begin, n, l, context(false), report);
            }
          });
        });
      if constexpr (keeps_raw) gather(raw_, field_of(set), range, [&](auto& nodes) {
        chunks<wants::gradients>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
          T l[Space::gradient_size][chunk_size];
          gradient_of(n, st, nodes, l);
          set.material.template update<Space>(set.columns, begin, n, l, context(false), report);
        });
      });
      move(set, range, report);
    });
    finish_report();
  }

  /// Pressure, sound speed and the first time step from the initial state.
  void initialise_stress() {
    start_report();
    sweep([this](auto& set, auto& range, update_report& report) { this->update_without_motion(set, range, report); });
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
        if (!skip_quiet || !s.at_rest(r)) continue;
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
      for_each_set([&](auto& s) { s.connect(blocks); });
    }
  }

private:
  static constexpr int asleep = 3;
  static constexpr bool maps_back = !Transfer::affine || Scheme::maps_velocity_back;
  /// Does the stress follow the velocities that the forces left on the nodes, where the column `motion_` no longer has them?
  static constexpr bool keeps_raw = !Transfer::affine && !Scheme::stress_first && !Scheme::maps_velocity_back;
  static constexpr bool filters = Transfer::filter_order > 0;
  static constexpr std::int64_t worth_threads = 16384; // particles (or half as many nodes) below which threads cost more than they give
  std::vector<sums> sums_;
  std::vector<forces> forces_, back_, external_, raw_, residual_, next_residual_, normals_, wall_forces_, contact_forces_;
  std::vector<motion> motion_;
  struct touched_part {
    std::int32_t block;
    grid::node_range<dim> nodes; // relative to the block
  };
  std::vector<touched_part> touched_;  // nodes that particles touch in this step
  std::vector<double> node_sums_;      // of a loop over nodes, one per touched block
  std::vector<update_report> reports_; // one per range

  /// Makes the blocks around the occupied ones, and what the boundaries know of them.
  void rebuild(std::vector<grid::cell_index<dim>> occupied) {
    blocks.rebuild(std::move(occupied));
    require(static_cast<double>(column_size()) < 2147483647.0, "nodes of the grid times velocity fields", static_cast<double>(column_size()), "less than 2^31: take larger cells");
    for (auto& m : mirrors) m.rebuild(blocks);
    for (auto& p : periods) p.rebuild(blocks);
  }
  /// The boundary conditions on a sum over particles, in every velocity field; components first .. first + dim - 1 are a vector.
  template <class Values> void complete(std::vector<Values>& column, int first) const {
    for (std::size_t f = 0; f < velocity_fields; ++f) {
      for (const auto& m : mirrors) m.complete(column, first, f * node_count());
      for (const auto& p : periods) p.complete(column, first, f * node_count());
    }
  }

  step_context<T> context(bool gradient_at_end) const { return {dt, static_cast<T>(h), courant, ignore_below, gradient_at_end}; }

  /// f(set, range, report) for every block range of every body, colour by colour.
  template <class F> void sweep(F&& f) {
    std::size_t total = 0;
    for_each_set([&](auto& s) { total += s.ranges.size(); });
    reports_.assign(total, update_report{});
    std::size_t first = 0;
    for_each_set([&](auto& s) {
      for (const auto& colour : s.by_colour) {
        const auto count = static_cast<std::int64_t>(colour.size());
#if defined(_OPENMP)
#pragma omp parallel for schedule(dynamic, 4) if (static_cast<std::int64_t>(s.columns.size()) > worth_threads)
#endif
        for (std::int64_t i = 0; i < count; ++i) {
          const auto r = static_cast<std::size_t>(colour[static_cast<std::size_t>(i)]);
          f(s, s.ranges[r], reports_[first + r]);
        }
      }
      first += s.ranges.size();
    });
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
      for (int i = 0; i < count; ++i) moves = moves || any(motion_[field_of(set) + static_cast<std::size_t>(node + i)] != motion(T(0)));
    });
    if (moves) range.quiet = 0;
    return !moves;
  }
  /// Has any of n particles from `begin` a stress? Without one there is no force and no work.
  template <class Columns> static BOLIDE_INLINE bool carries_stress(const Columns& p, std::size_t begin, std::size_t n) {
    using V = native_pack<T>;
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

  /// Which nodes of which blocks do particles touch? Only they are cleared and looped over: empty halo costs nothing.
  void find_touched_nodes() {
    const grid::node_range<dim> whole = map::whole_block();
    std::vector<grid::node_range<dim>> nodes(blocks.size(), grid::node_range<dim>{whole.high, whole.low}); // of no node
    std::vector<char> touched(blocks.size(), 0);
    for_each_set([&](const auto& s) {
      for (const auto& r : s.ranges) {
        if (r.quiet == asleep) continue;
        for (int n = 0; n < map::neighbours; ++n) {
          const auto part = r.part_in_neighbour(n);
          if (part.empty()) continue;
          const auto b = static_cast<std::size_t>(r.near[static_cast<std::size_t>(n)]);
          if (!touched[b]) nodes[b] = part;
          else nodes[b].merge(part);
          touched[b] = 1;
        }
      }
    });
    std::vector<char> mirrored = touched;
    for (auto& m : mirrors) m.spread(mirrored);
    for (auto& p : periods) p.spread(mirrored);
    touched_.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (mirrored[b]) touched_.push_back({static_cast<std::int32_t>(b), mirrored[b] == map::holds_images ? whole : nodes[b]});
  }
  template <class Values> void clear(std::vector<Values>& column) {
    column.resize(column_size());
    each_node([&](std::size_t i) { column[i] = Values(T(0)); });
  }
  /// f(index into the node columns) for every touched node of every velocity field.
  template <class F> void each_node(F&& f) {
    each_place([&](std::size_t place) {
      if constexpr (velocity_fields == 1) return f(place);
      else if constexpr (std::is_same_v<std::invoke_result_t<F, std::size_t>, double>) {
        double sum = 0;
        for (std::size_t at = place; at < column_size(); at += node_count()) sum += f(at);
        return sum;
      } else
        for (std::size_t at = place; at < column_size(); at += node_count()) f(at);
    });
  }
  /// f(node) for every touched node; what it returns is summed block by block.
  template <class F> void each_place(F&& f) {
    constexpr bool sums_up = std::is_same_v<std::invoke_result_t<F, std::size_t>, double>;
    const auto n = static_cast<std::int64_t>(touched_.size());
    if constexpr (sums_up) node_sums_.assign(touched_.size(), 0);
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) if (n * map::nodes_per_block > 2 * worth_threads)
#endif
    for (std::int64_t b = 0; b < n; ++b) {
      const auto& part = touched_[static_cast<std::size_t>(b)];
      double sum = 0;
      map::for_each_row(part.nodes, [&](int local, int count) {
        const std::size_t first = static_cast<std::size_t>(part.block) * map::nodes_per_block + static_cast<std::size_t>(local);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(count); ++i) {
          if constexpr (sums_up) sum += f(i);
          else f(i);
        }
      });
      if constexpr (sums_up) node_sums_[static_cast<std::size_t>(b)] = sum;
    }
  }

  /// f.(v + dv/2) of a real node, f a column of nodal forces.
  double power_of(const std::vector<forces>& f, std::size_t i) const {
    if (!(sums_[i][0] > T(0)) || is_image(i)) return 0;
    double power = 0;
    for (int d = 0; d < dim; ++d)
      power += static_cast<double>(f[i][d]) * ((Transfer::affine ? 0.5 : 1) * static_cast<double>(motion_[i][d]) + 0.5 * static_cast<double>(motion_[i][dim + d]));
    return power;
  }
  /// Sum of f(index) over the touched nodes, in the order of the blocks.
  template <class F> double sum_over_nodes(F&& f) {
    each_node(f);
    double sum = 0;
    for (const double part : node_sums_) sum += part;
    return sum;
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
      give_momentum([this](std::size_t i, int d) { return sums_[i][0] > T(0) && !is_image(i) ? static_cast<double>(wall_forces_[i][d]) : 0.0; });
    }
    if constexpr (Contact::multi_field) book(contact_forces_, energy.contact);
  }
  /// Books the work of a column of forces in a channel of its own instead of in `transfer`.
  void book(const std::vector<forces>& f, double& channel) {
    const double work = sum_over_nodes([this, &f](std::size_t i) { return power_of(f, i); }) * static_cast<double>(dt);
    energy.transfer -= work;
    channel += work;
  }

  // ---- moving walls, and contact between bodies that keep a velocity of their own -------------------------------------------------
  bool constrained() const { return Contact::multi_field || !walls.empty(); }

  /// Outward direction of every body: sum V grad N, which points from its particles to the node.
  void find_normals() {
    clear(normals_);
    clear(contact_forces_);
    sweep([this](auto& set, auto& range, update_report&) {
      if (range.quiet == asleep) return;
      scatter(normals_, field_of(set), range, [&](auto& win) {
        chunks<wants::gradients>(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
          const T* const volume = set.columns.template get<field::volume>() + begin;
          accumulate(win.node.data(), st, n, [&](int k, auto& sum) {
            for (int a = 0; a < stencil_type::nodes; ++a)
              sum[static_cast<std::size_t>(a)] += forces::make([&](int c) { return c < dim ? volume[k] * st.gradient[c < dim ? c : 0][a][k] : T(0); });
          });
        });
      });
    });
    complete(normals_, 0);
  }

  /// Changes node velocities to what contact and walls allow: before the stress those that the particles brought, then those that the forces
  /// left. The change goes to the second half of `motion_`, the force that makes it is remembered for the ledger.
  template <bool Before> void constrain() {
    if constexpr (Contact::multi_field) each_place([this](std::size_t place) { this->template separate_bodies<Before>(place); });
    for (const auto& w : walls)
      for (const auto& part : touched_)
        map::for_each_row(part.nodes, [&](int local, int count) {
          for (int n = local; n < local + count; ++n) {
            const double x = blocks.node_at(static_cast<std::size_t>(part.block), n)[static_cast<std::size_t>(w.axis)] * h;
            if (!w.holds(x, time + static_cast<double>(dt), h)) continue;
            const std::size_t place = static_cast<std::size_t>(part.block) * map::nodes_per_block + static_cast<std::size_t>(n);
            for (std::size_t at = place; at < column_size(); at += node_count()) this->template push<Before>(w, at);
          }
        });
  }
  /// The velocity that constrain() looks at, component d of node value i.
  template <bool Before> T free_velocity(std::size_t i, int d) const {
    return motion_[i][dim + d] + (Before || !Transfer::affine ? motion_[i][d] : T(0));
  }
  void change_velocity(std::vector<forces>& by, std::size_t i, int d, T change) {
    motion_[i].set(dim + d, motion_[i][dim + d] + change);
    by[i].set(d, by[i][d] + sums_[i][0] * change / dt);
  }
  template <bool Before> void push(const grid::moving_wall& w, std::size_t i) {
    if (!(sums_[i][0] > T(0)) || !w.approaches(this->template free_velocity<Before>(i, w.axis))) return;
    for (int d = 0; d < dim; ++d)
      if (d == w.axis || w.stick) change_velocity(wall_forces_, i, d, (d == w.axis ? static_cast<T>(w.velocity) : T(0)) - this->template free_velocity<Before>(i, d));
  }
  template <bool Before> void separate_bodies(std::size_t place) {
    std::size_t bodies[velocity_fields];
    std::size_t count = 0;
    T mass = 0;
    std::array<T, dim> mean{}; // velocity of the centre of mass
    for (std::size_t at = place; at < column_size(); at += node_count())
      if (sums_[at][0] > T(0)) {
        bodies[count++] = at;
        mass += sums_[at][0];
        for (std::size_t d = 0; d < dim; ++d) mean[d] += sums_[at][0] * this->template free_velocity<Before>(at, static_cast<int>(d));
      }
    if (count < 2) return;
    for (auto& v : mean) v /= mass;
    // out of the first body: the direction of the body that has more of a surface here, so that a corner does not tilt the plane it lies on
    std::array<T, dim> n{}, u{};
    T length = 0;
    for (std::size_t b = 0; b < 2 && count == 2; ++b) {
      T squares = 0;
      for (int d = 0; d < dim; ++d) squares += square(normals_[bodies[b]][d]);
      if (!(squares > length)) continue;
      length = squares;
      for (int d = 0; d < dim; ++d) n[static_cast<std::size_t>(d)] = (b == 0 ? T(1) : T(-1)) * normals_[bodies[b]][d];
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
      energy.momentum_given[static_cast<std::size_t>(d)] += static_cast<double>(dt) * sum_over_nodes([&](std::size_t i) { return force(i, d); });
  }

  /// sum N m b(x_p, t), and the momentum that it gives.
  void scatter_body_forces() {
    clear(external_);
    sweep([this](auto& set, auto& range, update_report&) {
      scatter(external_, field_of(set), range, [&](auto& win) {
        chunks<wants::values>(set, range, [&](std::size_t begin, int n, const stencil_type& st) { scatter_body_force(set.columns, begin, n, st, win); });
      });
    });
    give_momentum([this](std::size_t i, int d) { return static_cast<double>(external_[i][d]); }); // of the real particles: before the boundaries
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

  /// Runs f on a window that holds a copy of the touched nodes.
  template <class Values, class F> static BOLIDE_INLINE void gather(const std::vector<Values>& column, std::size_t field, const block_range<dim>& range, F&& f) {
    grid::window<dim, Values> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; ++i) win.node[static_cast<std::size_t>(at + i)] = column[field + static_cast<std::size_t>(node + i)];
    });
    f(win);
  }
  /// Runs f on a zeroed window and adds it to the touched nodes.
  template <class Values, class F> static BOLIDE_INLINE void scatter(std::vector<Values>& column, std::size_t field, const block_range<dim>& range, F&& f) {
    grid::window<dim, Values> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t, int at, int count) {
      for (int i = 0; i < count; ++i) win.node[static_cast<std::size_t>(at + i)] = Values(T(0));
    });
    f(win);
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; ++i) column[field + static_cast<std::size_t>(node + i)] += win.node[static_cast<std::size_t>(at + i)];
    });
  }
  /// f(begin, n, stencil) for the particles of a range, chunk_size at a time.
  template <wants Wanted, class Set, class F> BOLIDE_INLINE void chunks(Set& set, const block_range<dim>& range, F&& f) const {
    stencil_type st;
    for (std::size_t begin = range.begin; begin < range.end; begin += chunk_size) {
      const int n = static_cast<int>(std::min<std::size_t>(chunk_size, range.end - begin));
      st.template make<Wanted>(set.columns, begin, n, range.origin, range.touched, h, set.half_size);
      f(begin, n, st);
    }
  }

  /// The columns of a field's components from a particle on: held in registers by the loops below.
  template <class Tag, std::size_t N, class Columns> static BOLIDE_INLINE auto columns_of(Columns& p, std::size_t begin) {
    std::array<decltype(p.template get<Tag>()), N> column;
    for (std::size_t c = 0; c < N; ++c) column[c] = p.template get<Tag>(static_cast<int>(c)) + begin;
    return column;
  }
  /// add(k, sum) adds what particle k gives to the nodes of its support. Particles are sorted by their first node, so that those of the same
  /// support follow each other: they are summed in registers and the window is touched once for all of them.
  template <class Values, class F> static BOLIDE_INLINE void accumulate(Values* nodes, const stencil_type& st, int n, F&& add) {
    alignas(64) std::array<Values, stencil_type::nodes> sum; // said aloud: g++ 12 does not align it by itself in a function that calls nothing
    for (int k = 0; k < n;) {
      const std::int32_t base = st.base[k];
      for (auto& x : sum) x = Values(T(0));
      do add(k, sum);
      while (++k < n && st.base[k] == base);
      for (int a = 0; a < stencil_type::nodes; ++a) nodes[base + stencil_type::offset(a)] += sum[static_cast<std::size_t>(a)];
    }
  }

  // ---- what one particle does --------------------------------------------------------------------------------------------------
  template <class Columns, class Window> BOLIDE_INLINE void scatter_momentum(const Columns& p, std::size_t begin, int n, const stencil_type& st, Window& win) const {
    const T* const mass = p.template get<field::mass>() + begin;
    const auto velocity = columns_of<field::velocity, dim>(p, begin);
    [[maybe_unused]] std::array<const T*, dim * dim> affine{};
    if constexpr (Transfer::affine) affine = columns_of<field::affine_velocity, dim * dim>(p, begin);
    sums* const nodes = win.node.data();
    const T cell = static_cast<T>(h);
    accumulate(nodes, st, n, [=, &st](int k, auto& sum) {
      const T m = mass[k];
      const sums q = sums::make([&](int c) { return c == 0 ? m : c <= dim ? m * velocity[static_cast<std::size_t>(c <= dim && c > 0 ? c - 1 : 0)][k] : T(0); });
      if constexpr (Transfer::affine) {
        alignas(64) std::array<sums, dim> slope; // m C_.d h: change of the momentum per cell along axis d
        for (std::size_t d = 0; d < dim; ++d) {
          slope[d] = sums::make([&](int c) { return c > 0 && c <= dim ? m * cell * affine[static_cast<std::size_t>(c > 0 && c <= dim ? c - 1 : 0) * dim + d][k] : T(0); });
        }
        for (int a = 0; a < stencil_type::nodes; ++a) {
          sums here = q;
          for (int d = 0; d < dim; ++d) here += slope[static_cast<std::size_t>(d)] * st.distance(k, a, d);
          sum[static_cast<std::size_t>(a)] += here * st.value[a][k];
        }
      } else {
        for (int a = 0; a < stencil_type::nodes; ++a) sum[static_cast<std::size_t>(a)] += q * st.value[a][k];
      }
    });
  }

  /// Gradient at n particles of `first` times the first velocity of the nodes plus `second` times the second.
  template <class Window> BOLIDE_INLINE void velocity_gradient(int n, const stencil_type& st, const Window& nodes, T first, T second, T (*l)[chunk_size]) const {
    const motion* const from = nodes.node.data();
    for (int k = 0; k < n; ++k) {
      const motion* const at = from + st.base[k];
      alignas(64) std::array<motion, dim> g;
      for (auto& x : g) x = motion(T(0));
      motion hoop(T(0));
      for (int a = 0; a < stencil_type::nodes; ++a) {
        const motion v = at[stencil_type::offset(a)];
        for (int d = 0; d < dim; ++d) g[static_cast<std::size_t>(d)] += v * st.gradient[d][a][k];
        if constexpr (Space::hoop) hoop += v * st.hoop[a][k];
      }
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d) l[c * dim + d][k] = first * g[static_cast<std::size_t>(d)][c] + second * g[static_cast<std::size_t>(d)][dim + c];
      if constexpr (Space::hoop) l[dim * dim][k] = first * hoop[0] + second * hoop[dim];
    }
    for (int c = 0; c < Space::gradient_size; ++c) // the last register of a chunk is read whole
      for (int k = n; k < chunk_size && k < n + native_width<T>; ++k) l[c][k] = T(0);
  }

  /// Gradient at n particles of the velocity in a column that holds it alone.
  template <class Window> BOLIDE_INLINE void gradient_of(int n, const stencil_type& st, const Window& nodes, T (*l)[chunk_size]) const {
    for (int c = 0; c < Space::gradient_size; ++c)
      for (int k = 0; k < chunk_size && k < n + native_width<T>; ++k) l[c][k] = T(0);
    for (int k = 0; k < n; ++k)
      for (int a = 0; a < stencil_type::nodes; ++a) {
        const forces v = nodes.node[static_cast<std::size_t>(st.base[k] + stencil_type::offset(a))];
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d) l[c * dim + d][k] += v[c] * st.gradient[d][a][k];
        if constexpr (Space::hoop) l[dim * dim][k] += v[0] * st.hoop[a][k];
      }
  }

  /// f_I = -V (sigma grad N), in r-z with the hoop stress.
  template <class Set, class Window> BOLIDE_INLINE void scatter_force(const Set& set, std::size_t begin, int n, const stencil_type& st, Window& win) const {
    using V = native_pack<T>;
    using columns = std::remove_cvref_t<decltype(set.columns)>;
    const auto& p = set.columns;
    T stress[dim * dim + 1][chunk_size]; // -V sigma, and -V s_tt
    for (int k = 0; k < n; k += lane_width<V>) {
      const std::size_t at = begin + static_cast<std::size_t>(k);
      V pressure = load<V>(p.template get<field::pressure>() + at);
      if constexpr (columns::template has<field::viscous_pressure>) pressure = pressure + load<V>(p.template get<field::viscous_pressure>() + at);
      const V minus_volume = -load<V>(p.template get<field::volume>() + at);
      typename Space::template deviator<V> s{};
      if constexpr (columns::template has<field::deviator>)
        for (int c = 0; c < Space::deviator_size; ++c) s[static_cast<std::size_t>(c)] = load<V>(p.template get<field::deviator>(c) + at);
      const auto sigma = Space::in_plane(pressure, s);
      for (int c = 0; c < dim * dim; ++c) store(minus_volume * sigma[static_cast<std::size_t>(c)], stress[c] + k);
      if constexpr (Space::hoop) store(minus_volume * Space::hoop_stress(pressure, s), stress[dim * dim] + k);
    }
    forces* const nodes = win.node.data();
    accumulate(nodes, st, n, [=, &st, &stress](int k, auto& sum) {
      alignas(64) std::array<forces, dim> column; // of -V sigma, one per direction of the gradient
      for (int d = 0; d < dim; ++d) {
        column[static_cast<std::size_t>(d)] = forces::make([&](int c) { return c < dim ? stress[(c < dim ? c : 0) * dim + d][k] : T(0); });
      }
      [[maybe_unused]] const forces hoop = forces::make([&](int c) { return Space::hoop && c == 0 ? stress[dim * dim][k] : T(0); });
      for (int a = 0; a < stencil_type::nodes; ++a) {
        forces f = column[0] * st.gradient[0][a][k];
        for (int d = 1; d < dim; ++d) f += column[static_cast<std::size_t>(d)] * st.gradient[d][a][k];
        if constexpr (Space::hoop) f += hoop * st.hoop[a][k];
        sum[static_cast<std::size_t>(a)] += f;
      }
    });
  }

  /// m b(x_p, t)
  template <class Columns> vec<double, dim> body_force_on(const Columns& p, std::size_t i) const {
    vec<double, dim> x, total = vec<double, dim>::Zero();
    for (int d = 0; d < dim; ++d) x[d] = static_cast<double>(p.template get<field::position>(d)[i]);
    for (const auto& f : body_forces) total += f.acceleration(x, time);
    return total * static_cast<double>(p.template get<field::mass>()[i]);
  }
  template <class Columns, class Window>
  void scatter_body_force(const Columns& p, std::size_t begin, int n, const stencil_type& st, Window& win) const {
    accumulate(win.node.data(), st, n, [&](int k, auto& sum) {
      const auto b = body_force_on(p, begin + static_cast<std::size_t>(k));
      const forces f = forces::make([&](int c) { return c < dim ? static_cast<T>(b[c < dim ? c : 0]) : T(0); });
      for (int a = 0; a < stencil_type::nodes; ++a) sum[static_cast<std::size_t>(a)] += f * st.value[a][k];
    });
  }

  /// FLIP: v_p += sum N dv, carried along with sum N (v + dv); m dv_p goes back to the nodes.
  template <class Columns, class Window, class Back>
  BOLIDE_INLINE void add_change(Columns& p, std::size_t begin, int n, const stencil_type& st, const Window& nodes, Back& win, update_report& report) const {
    const T* const mass = p.template get<field::mass>() + begin;
    const auto velocity = columns_of<field::velocity, dim>(p, begin), carrying = columns_of<field::carrying_velocity, dim>(p, begin);
    const motion* const from = nodes.node.data();
    forces* const to = win.node.data();
    double kinetic_gain = 0, returned_heat = 0;
    accumulate(to, st, n, [=, this, &st, &p, &kinetic_gain, &returned_heat](int k, auto& sum) {
      motion seen(T(0));
      for (int a = 0; a < stencil_type::nodes; ++a) seen += from[st.base[k] + stencil_type::offset(a)] * st.value[a][k];
      T gain = 0;
      if constexpr (filters) {
        const auto filtered = filter(p, begin + static_cast<std::size_t>(k), k, st, from, seen);
        gain = filtered.kinetic_gain;
        returned_heat += static_cast<double>(mass[k]) * static_cast<double>(filtered.heat);
      } else { // clang warns of captures that only the other branch uses
        static_cast<void>(this);
        static_cast<void>(p);
        static_cast<void>(returned_heat);
      }
      for (std::size_t d = 0; d < dim; ++d) {
        const T v = velocity[d][k], dv = seen[static_cast<int>(dim + d)];
        gain += dv * (v + T(0.5) * dv);
        velocity[d][k] = v + dv;
        carrying[d][k] = seen[static_cast<int>(d)] + dv;
      }
      const T m = mass[k];
      const forces back = forces::make([&](int c) { return c < dim ? m * seen[c < dim ? dim + c : 0] : T(0); });
      kinetic_gain += static_cast<double>(m) * static_cast<double>(gain);
      for (int a = 0; a < stencil_type::nodes; ++a) sum[static_cast<std::size_t>(a)] += back * st.value[a][k];
    });
    report.kinetic_gain += kinetic_gain;
    report.returned_heat += returned_heat;
  }

  /// Takes filter() r, r = (1 - S S+)^m v, from the velocity of a particle before it takes the change dv of the grid, and returns what that
  /// loses as heat (transfer/pic.hpp, transfer/xpic.hpp).
  struct filtering {
    T kinetic_gain, heat; // J/kg
  };
  template <class Columns>
  BOLIDE_INLINE filtering filter(Columns& p, std::size_t i, int k, const stencil_type& st, const motion* from, const motion& seen) const {
    const T part = static_cast<T>(transfer.filter());
    std::array<T, dim> r;
    T unseen = 0, squares = 0, product = 0; // v . r as a sum that is not negative, |r|^2, dv . r
    if constexpr (Transfer::filter_order == 1) {
      const motion v = motion::make([&](int c) { return p.template get<field::velocity>(c % dim)[i]; });
      motion spread(T(0));
      for (int a = 0; a < stencil_type::nodes; ++a) {
        const motion b = from[st.base[k] + stencil_type::offset(a)] - v;
        spread += b * b * st.value[a][k];
      }
      for (int d = 0; d < dim; ++d) {
        r[static_cast<std::size_t>(d)] = v[d] - seen[d];
        unseen += spread[d];
      }
    } else {
      for (int d = 0; d < dim; ++d) r[static_cast<std::size_t>(d)] = p.template get<field::velocity_residual>(d)[i];
      unseen = p.template get<field::filter_loss>()[i];
    }
    T gain = 0;
    for (int d = 0; d < dim; ++d) {
      T& v = p.template get<field::velocity>(d)[i];
      const T x = r[static_cast<std::size_t>(d)], next = v - part * x;
      squares += x * x;
      product += seen[dim + d] * x;
      gain += T(0.5) * (next - v) * (next + v);
      v = next;
    }
    const T heat = static_cast<T>(transfer.heat) * part * (unseen - T(0.5) * part * squares + product);
    p.template get<field::energy>()[i] += heat;
    if constexpr (Columns::template has<field::failed>)
      if (heat != T(0)) p.template get<field::failed>()[i] = std::min(p.template get<field::failed>()[i], T(1)); // no longer settled
    return {gain, heat};
  }

  /// (1 - S S+)^m v_p of every particle, m > 1: the map to the nodes and back, m times.
  void filter_velocities() {
    for (int j = 1; j <= Transfer::filter_order; ++j) {
      const bool last = j == Transfer::filter_order;
      if (!last) clear(next_residual_);
      sweep([&](auto& set, auto& range, update_report&) {
        if (sleeps_on(set, range)) return;
        const auto run = [&](auto& nodes) {
          const auto one_map = [&](auto* to) {
            chunks<wants::values>(set, range, [&](std::size_t begin, int n, const stencil_type& st) { apply_filter(set.columns, begin, n, st, nodes, to, j); });
          };
          if (last) one_map(static_cast<forces*>(nullptr));
          else scatter(next_residual_, field_of(set), range, [&](auto& win) { one_map(win.node.data()); });
        };
        if (j == 1) gather(motion_, field_of(set), range, run);
        else gather(residual_, field_of(set), range, run);
      });
      if (last) return;
      complete(next_residual_, 0);
      each_node([this](std::size_t i) {
        for (int d = 0; d < dim; ++d)
          if (sums_[i][0] > T(0)) next_residual_[i].set(d, next_residual_[i][d] / sums_[i][0]);
      });
      std::swap(residual_, next_residual_);
    }
  }
  /// r_j = r_(j-1) - S S+ r_(j-1) for n particles; `nodes` hold S+ r_(j-1), and m r_j goes `to` the nodes of the next round.
  template <class Columns, class Window>
  void apply_filter(Columns& p, std::size_t begin, int n, const stencil_type& st, const Window& nodes, forces* to, int j) const {
    constexpr int order = Transfer::filter_order;
    const T* const mass = p.template get<field::mass>() + begin;
    T* const loss = p.template get<field::filter_loss>() + begin;
    const auto residual = columns_of<field::velocity_residual, dim>(p, begin), velocity = columns_of<field::velocity, dim>(p, begin);
    const bool whole = order % 2 == 0 && j == order / 2, half = order % 2 == 1 && j == (order + 1) / 2;
    for (int k = 0; k < n; ++k) {
      T square_sum = 0, spread = 0;
      for (std::size_t d = 0; d < dim; ++d) {
        const T before = (j == 1 ? velocity : residual)[d][k];
        T mean = 0;
        for (int a = 0; a < stencil_type::nodes; ++a) {
          const T u = nodes.node[static_cast<std::size_t>(st.base[k] + stencil_type::offset(a))][static_cast<int>(d)];
          mean += st.value[a][k] * u;
          spread += st.value[a][k] * square(before - u);
        }
        residual[d][k] = before - mean;
        square_sum += square(before - mean);
      }
      if (whole) loss[k] = square_sum;
      if (half) loss[k] = spread;
      if (!to) continue;
      const forces back = forces::make([&](int c) { return c < dim ? mass[k] * residual[static_cast<std::size_t>(c < dim ? c : 0)][k] : T(0); });
      for (int a = 0; a < stencil_type::nodes; ++a) to[st.base[k] + stencil_type::offset(a)] += back * st.value[a][k];
    }
  }

  /// APIC: velocity and affine field from the grid; what is lost on both ways becomes heat:
  ///   to the grid    1/2 sum N |v_I - v_p - C dx|^2 = 1/2 (sum N |b|^2 - 2 C : M + inertia |C|^2),  b = v_I - v_p, M = sum N b dx^T
  ///   from the grid  1/2 sum N |v'_I - v'_p - C' dx|^2 = 1/2 (sum N |b'|^2 - |sum N b'|^2 - inertia |C'|^2),  b' = v'_I - v_p
  template <class Columns, class Window>
  BOLIDE_INLINE void take_affine(Columns& p, std::size_t begin, int n, const stencil_type& st, const Window& nodes, update_report& report) const {
    const T* const mass = p.template get<field::mass>() + begin;
    T* const specific_energy = p.template get<field::energy>() + begin;
    const auto velocity = columns_of<field::velocity, dim>(p, begin), carrying = columns_of<field::carrying_velocity, dim>(p, begin);
    const auto affine = columns_of<field::affine_velocity, dim * dim>(p, begin);
    [[maybe_unused]] T* failed = nullptr;
    if constexpr (Columns::template has<field::failed>) failed = p.template get<field::failed>() + begin;
    const motion* const from = nodes.node.data();
    const T cell = static_cast<T>(h), inertia = cell * cell * T(Shape::inertia), heat = static_cast<T>(transfer.heat);
    double kinetic_gain = 0, returned_heat = 0;
    for (int k = 0; k < n; ++k) {
      // sums relative to the old velocity: squares of differences, not of speeds
      const motion old = motion::make([&](int c) { return velocity[static_cast<std::size_t>(c % dim)][k]; });
      motion mean(T(0)), squares(T(0));
      alignas(64) std::array<motion, dim> moment;
      for (auto& m : moment) m = motion(T(0));
      for (int a = 0; a < stencil_type::nodes; ++a) {
        const motion b = from[st.base[k] + stencil_type::offset(a)] - old, weighted = b * st.value[a][k];
        mean += weighted;
        squares += weighted * b;
        for (int d = 0; d < dim; ++d) moment[static_cast<std::size_t>(d)] += weighted * (st.distance(k, a, d) * cell);
      }
      T kinetic = 0, loss = 0;
      for (int c = 0; c < dim; ++c) {
        const T v = velocity[static_cast<std::size_t>(c)][k], dv = mean[dim + c];
        kinetic += dv * (v + T(0.5) * dv);
        loss += squares[c] + squares[dim + c] - dv * dv;
        velocity[static_cast<std::size_t>(c)][k] = v + dv;
        carrying[static_cast<std::size_t>(c)][k] = v + dv;
        for (int d = 0; d < dim; ++d) {
          T& slope = affine[static_cast<std::size_t>(c * dim + d)][k];
          const T next = moment[static_cast<std::size_t>(d)][dim + c] / inertia;
          loss += slope * (inertia * slope - T(2) * moment[static_cast<std::size_t>(d)][c]) - inertia * next * next;
          kinetic += T(0.5) * inertia * (next * next - slope * slope);
          slope = next;
        }
      }
      loss *= T(0.5) * heat;
      specific_energy[k] += loss;
      if constexpr (Columns::template has<field::failed>) failed[k] = std::min(failed[k], T(1)); // no longer settled
      kinetic_gain += static_cast<double>(mass[k]) * static_cast<double>(kinetic);
      returned_heat += static_cast<double>(mass[k]) * static_cast<double>(loss);
    }
    report.kinetic_gain += kinetic_gain;
    report.returned_heat += returned_heat;
  }

  template <class Columns, class Back> BOLIDE_INLINE void scatter_velocity_back(const Columns& p, std::size_t begin, int n, const stencil_type& st, Back& win) const {
    const T* const mass = p.template get<field::mass>() + begin;
    const auto velocity = columns_of<field::velocity, dim>(p, begin);
    const auto affine = columns_of<field::affine_velocity, dim * dim>(p, begin);
    const T cell = static_cast<T>(h);
    accumulate(win.node.data(), st, n, [=, &st](int k, auto& sum) {
      for (int a = 0; a < stencil_type::nodes; ++a) {
        const forces q = forces::make([&](int axis) {
          if (axis >= dim) return T(0);
          const auto c = static_cast<std::size_t>(axis < dim ? axis : 0);
          T v = velocity[c][k];
          for (std::size_t d = 0; d < dim; ++d) v += affine[c * dim + d][k] * st.distance(k, a, static_cast<int>(d)) * cell;
          return mass[k] * v;
        });
        sum[static_cast<std::size_t>(a)] += q * st.value[a][k];
      }
    });
  }

  /// x_p += dt sum N (v + dv); a particle that crosses a mirror comes back reflected, and is counted.
  template <class Set> void move(Set& set, block_range<dim>& range, update_report& report) const {
    using V = native_pack<T>;
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
  }
};

} // namespace bolide
