// SPDX-License-Identifier: MIT
// The phases of a step: sweeps over the particles of every block, and loops over nodes. A scheme puts them in order.
//
// A sweep takes the blocks colour by colour; blocks of one colour run in parallel. Each copies the nodes that it needs into a window,
// runs its particles chunk by chunk (stencil, gather, lanes, scatter), and adds its sums back. What a block reports is
// kept per block and added up in the order of the blocks, so the number of threads does not change a bit.
#pragma once

#include "bolide/core/algebra.hpp"
#include "bolide/grid/mirror.hpp"
#include "bolide/grid/sparse.hpp"
#include "bolide/solver/ledger.hpp"
#include "bolide/solver/particle_set.hpp"
#include "bolide/solver/stencil.hpp"

#include <tuple>
#include <vector>

namespace bolide {

template <class T, class Space, class Shape, class Transfer, class Scheme, class... Sets> class phases {
public:
  static constexpr int dim = Space::dim;
  using map = grid::block_map<dim>;
  using sums = node_values<T, padded(dim + 1)>;      // m, P
  using forces = node_values<T, padded(dim)>;        // f, or the momentum change mapped back
  using motion = node_values<T, padded(2 * dim)>;    // v, dv
  using stencil_type = stencil<T, Space, Shape>;

  std::tuple<Sets...> sets;
  map blocks;
  double h;
  T dt = 0;
  T courant;
  Transfer transfer;
  std::vector<grid::mirror_nodes<dim>> mirrors;
  ledger energy;
  step_limit limit;   // of the next step
  bool sorted = false; // does every particle touch only the blocks around its own?

  phases(double spacing, T courant_number, Transfer t, std::tuple<Sets...> s) : sets(std::move(s)), h(spacing), courant(courant_number), transfer(t) {}

  // ---- the phases -------------------------------------------------------------------------------------------------------------
  /// m_I = sum N m, P_I = sum N m v; with a stress that was updated last also f_I = -sum V sigma grad N.
  void map_to_nodes() {
    sums_.assign(node_count(), sums::Zero());
    if constexpr (!Scheme::stress_first) forces_.assign(node_count(), forces::Zero());
    sweep([this](auto& set, auto& range, update_report&) {
      scatter(sums_, range, [&](auto& win) {
        chunks(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
          for (int k = 0; k < n; ++k) scatter_momentum(set.columns, begin, k, st, win);
        });
      });
      if constexpr (!Scheme::stress_first)
        scatter(forces_, range, [&](auto& win) {
          chunks(set, range, [&](std::size_t begin, int n, const stencil_type& st) { scatter_force(set, begin, n, st, win); });
        });
    });
    for (const auto& m : mirrors) m.complete(sums_, 1);
    motion_.resize(node_count());
    each_node([this](std::size_t i) {
      const auto& s = sums_[i];
      motion v = motion::Zero();
      if (s[0] > T(0))
        for (int d = 0; d < dim; ++d) v[d] = s[1 + d] / s[0];
      motion_[i] = v;
    });
  }

  /// Stress from the velocities that the particles brought to the nodes, then its forces.
  void update_stress_first() {
    forces_.assign(node_count(), forces::Zero());
    start_report();
    sweep([this](auto& set, auto& range, update_report& report) {
      gather(motion_, range, [&](auto& nodes) {
        scatter(forces_, range, [&](auto& win) {
          chunks(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            T l[Space::gradient_size][chunk_size];
            velocity_gradient(n, st, nodes, T(0), set.columns, begin, l);
            set.material.template update<Space>(set.columns, begin, n, l, context(true), report);
            scatter_force(set, begin, n, st, win);
          });
        });
      });
    });
    finish_report();
  }

  /// dv_I = f_I dt / m_I, boundary conditions; the nodal work of steps without a map back is known here.
  void accelerate_nodes() {
    for (const auto& m : mirrors) m.complete(forces_, 0);
    each_node([this](std::size_t i) {
      if (sums_[i][0] > T(0))
        for (int d = 0; d < dim; ++d) motion_[i][dim + d] = forces_[i][d] * dt / sums_[i][0];
    });
    if constexpr (Transfer::affine) nodal_work();
  }

  /// New particle velocities; what the scheme or the transfer needs back on the nodes.
  void map_to_particles() {
    constexpr bool maps_back = !Transfer::affine || !Scheme::stress_first;
    if constexpr (maps_back) back_.assign(node_count(), forces::Zero());
    sweep([this](auto& set, auto& range, update_report& report) {
      gather(motion_, range, [&](auto& nodes) {
        const auto run = [&](auto& win) {
          chunks(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            if constexpr (Transfer::affine) {
              T l[Space::gradient_size][chunk_size];
              velocity_gradient(n, st, nodes, T(0.5), set.columns, begin, l);
              set.material.template work<Space>(set.columns, begin, n, l, dt, report);
              for (int k = 0; k < n; ++k) take_affine(set.columns, begin, k, st, nodes, report);
              if constexpr (maps_back)
                for (int k = 0; k < n; ++k) scatter_velocity_back(set.columns, begin, k, st, win);
            } else {
              for (int k = 0; k < n; ++k) add_change(set.columns, begin, k, st, nodes, win, report);
            }
          });
        };
        if constexpr (maps_back) scatter(back_, range, run);
        else run(nodes);
      });
    });
    finish_kinetic();
    if constexpr (maps_back) {
      for (const auto& m : mirrors) m.complete(back_, 0);
      each_node([this](std::size_t i) {
        if (!(sums_[i][0] > T(0))) return;
        for (int d = 0; d < dim; ++d) // FLIP: dv~ = sum N m dv_p / m_I; APIC: v'_I - v_I
          motion_[i][dim + d] = back_[i][d] / sums_[i][0] - (Transfer::affine ? motion_[i][d] : T(0));
      });
    }
    if constexpr (!Transfer::affine) nodal_work();
  }

  /// Work of the nodal forces to the particles, stress where it is updated last, and motion.
  void work_and_move() {
    if constexpr (!Scheme::stress_first) start_report();
    sweep([this](auto& set, auto& range, update_report& report) {
      if constexpr (!Transfer::affine || !Scheme::stress_first)
        gather(motion_, range, [&](auto& nodes) {
          chunks(set, range, [&](std::size_t begin, int n, const stencil_type& st) {
            T l[Space::gradient_size][chunk_size];
            if constexpr (!Transfer::affine) {
              velocity_gradient(n, st, nodes, T(0.5), set.columns, begin, l);
              set.material.template work<Space>(set.columns, begin, n, l, dt, report);
            }
            if constexpr (!Scheme::stress_first) {
              velocity_gradient(n, st, nodes, T(1), set.columns, begin, l);
              set.material.template update<Space>(set.columns, begin, n, l, context(false), report);
            }
          });
        });
      move(set, range, report);
    });
    finish_report();
  }

  /// Pressure, sound speed and the first time step from the initial state.
  void initialise_stress() {
    start_report();
    sweep([this](auto& set, auto& range, update_report& report) {
      T l[Space::gradient_size][chunk_size] = {};
      auto still = context(true);
      still.dt = 0;
      for (std::size_t begin = range.begin; begin < range.end; begin += chunk_size)
        set.material.template update<Space>(set.columns, begin, static_cast<int>(std::min<std::size_t>(chunk_size, range.end - begin)), l, still, report);
    });
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
    blocks.rebuild(std::move(occupied));
    for (auto& m : mirrors) m.rebuild(blocks);
    for_each_set([&](auto& s) { s.sort(blocks, h); });
    sorted = true;
  }

  std::size_t node_count() const { return blocks.size() * map::nodes_per_block; }

private:
  std::vector<sums> sums_;
  std::vector<forces> forces_, back_;
  std::vector<motion> motion_;
  std::vector<update_report> reports_; // one per range

  step_context<T> context(bool gradient_at_end) const { return {dt, static_cast<T>(h), courant, gradient_at_end}; }

  /// f(set, range, report) for every block range of every body, colour by colour.
  template <class F> void sweep(F&& f) {
    std::size_t total = 0;
    for_each_set([&](auto& s) { total += s.ranges.size(); });
    reports_.assign(total, update_report{});
    std::size_t first = 0;
    for_each_set([&](auto& s) {
      for (const auto& colour : s.by_colour) {
        const auto count = static_cast<std::int64_t>(colour.size());
#pragma omp parallel for schedule(dynamic, 4) if (count > 8)
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
    if (total_.limit.rate > 0 || !(total_.limit.rate == total_.limit.rate)) limit = total_.limit;
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

  template <class F> void each_node(F&& f) {
    const auto n = static_cast<std::int64_t>(node_count());
#pragma omp parallel for schedule(static) if (n > 4096)
    for (std::int64_t i = 0; i < n; ++i) f(static_cast<std::size_t>(i));
  }

  /// W = sum f.(v + dv/2) dt over the real nodes, in a fixed order: leaves the nodes, so transfer loses and mismatch gains it.
  void nodal_work() {
    double work = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      double part = 0;
      for (std::size_t i = b * map::nodes_per_block; i < (b + 1) * map::nodes_per_block; ++i) {
        if (!(sums_[i][0] > T(0)) || is_image(i)) continue;
        for (int d = 0; d < dim; ++d)
          part += static_cast<double>(forces_[i][d]) * (static_cast<double>(motion_[i][d]) + 0.5 * static_cast<double>(motion_[i][dim + d]));
      }
      work += part;
    }
    work *= static_cast<double>(dt);
    energy.transfer -= work;
    energy.work_mismatch += work;
  }
  bool is_image(std::size_t node) const {
    for (const auto& m : mirrors)
      if (m.is_image(node)) return true;
    return false;
  }

  /// Runs f on a window that holds a copy of the touched nodes.
  template <class Values, class F> static BOLIDE_INLINE void gather(const std::vector<Values>& column, const block_range<dim>& range, F&& f) {
    grid::window<dim, Values> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; ++i) win.node[static_cast<std::size_t>(at + i)] = column[static_cast<std::size_t>(node + i)];
    });
    f(win);
  }
  /// Runs f on a zeroed window and adds it to the touched nodes.
  template <class Values, class F> static BOLIDE_INLINE void scatter(std::vector<Values>& column, const block_range<dim>& range, F&& f) {
    grid::window<dim, Values> win;
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t, int at, int count) {
      for (int i = 0; i < count; ++i) win.node[static_cast<std::size_t>(at + i)] = Values::Zero();
    });
    f(win);
    grid::for_each_run<dim>(range.near, range.touched, [&](std::int32_t node, int at, int count) {
      for (int i = 0; i < count; ++i) column[static_cast<std::size_t>(node + i)] += win.node[static_cast<std::size_t>(at + i)];
    });
  }
  /// f(begin, n, stencil) for the particles of a range, chunk_size at a time.
  template <class Set, class F> BOLIDE_INLINE void chunks(Set& set, const block_range<dim>& range, F&& f) const {
    stencil_type st;
    for (std::size_t begin = range.begin; begin < range.end; begin += chunk_size) {
      const int n = static_cast<int>(std::min<std::size_t>(chunk_size, range.end - begin));
      st.make(set.columns, begin, n, range.origin, range.touched, h, set.half_size);
      f(begin, n, st);
    }
  }

  // ---- what one particle does --------------------------------------------------------------------------------------------------
  template <class Columns, class Window> BOLIDE_INLINE void scatter_momentum(const Columns& p, std::size_t begin, int k, const stencil_type& st, Window& win) const {
    const std::size_t i = begin + static_cast<std::size_t>(k);
    const T m = p.template get<field::mass>()[i];
    sums q = sums::Zero();
    q[0] = m;
    for (int d = 0; d < dim; ++d) q[1 + d] = m * p.template get<field::velocity>(d)[i];
    if constexpr (Transfer::affine) {
      std::array<sums, dim> slope; // m C_.d h: change of the momentum per cell along axis d
      for (int d = 0; d < dim; ++d) {
        slope[static_cast<std::size_t>(d)] = sums::Zero();
        for (int c = 0; c < dim; ++c) slope[static_cast<std::size_t>(d)][1 + c] = m * static_cast<T>(h) * p.template get<field::affine_velocity>(c * dim + d)[i];
      }
      st.for_each_node(k, [&](int o, auto a) {
        sums at = q;
        for (int d = 0; d < dim; ++d) at += st.distance(k, a, d) * slope[static_cast<std::size_t>(d)];
        win.node[static_cast<std::size_t>(o)] += st.value(k, a) * at;
      });
    } else {
      st.for_each_node(k, [&](int o, auto a) { win.node[static_cast<std::size_t>(o)] += st.value(k, a) * q; });
    }
  }

  /// Gradient of v + fraction * dv at n particles.
  template <class Columns, class Window>
  BOLIDE_INLINE void velocity_gradient(int n, const stencil_type& st, const Window& nodes, T fraction, const Columns&, std::size_t, T (*l)[chunk_size]) const {
    for (int k = 0; k < n; ++k) {
      std::array<motion, dim> g;
      for (auto& x : g) x.setZero();
      motion hoop = motion::Zero();
      st.for_each_node(k, [&](int o, auto a) {
        const motion& v = nodes.node[static_cast<std::size_t>(o)];
        for (int d = 0; d < dim; ++d) g[static_cast<std::size_t>(d)] += st.gradient(k, a, d) * v;
        if constexpr (Space::hoop) hoop += st.hoop_value(k, a) * v;
      });
      for (int c = 0; c < dim; ++c)
        for (int d = 0; d < dim; ++d) l[c * dim + d][k] = g[static_cast<std::size_t>(d)][c] + fraction * g[static_cast<std::size_t>(d)][dim + c];
      if constexpr (Space::hoop) l[dim * dim][k] = hoop[0] + fraction * hoop[dim];
    }
    for (int c = 0; c < Space::gradient_size; ++c) // the last register of a chunk is read whole
      for (int k = n; k < chunk_size && k < n + native_width<T>; ++k) l[c][k] = T(0);
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
    for (int k = 0; k < n; ++k) {
      std::array<forces, dim> column; // of -V sigma, one per direction of the gradient
      for (int d = 0; d < dim; ++d) {
        column[static_cast<std::size_t>(d)] = forces::Zero();
        for (int c = 0; c < dim; ++c) column[static_cast<std::size_t>(d)][c] = stress[c * dim + d][k];
      }
      forces hoop = forces::Zero();
      if constexpr (Space::hoop) hoop[0] = stress[dim * dim][k];
      st.for_each_node(k, [&](int o, auto a) {
        forces f = st.gradient(k, a, 0) * column[0];
        for (int d = 1; d < dim; ++d) f += st.gradient(k, a, d) * column[static_cast<std::size_t>(d)];
        if constexpr (Space::hoop) f += st.hoop_value(k, a) * hoop;
        win.node[static_cast<std::size_t>(o)] += f;
      });
    }
  }

  /// FLIP: v_p += sum N dv, carried along with sum N (v + dv); m dv_p goes back to the nodes.
  template <class Columns, class Window, class Back>
  BOLIDE_INLINE void add_change(Columns& p, std::size_t begin, int k, const stencil_type& st, const Window& nodes, Back& win, update_report& report) const {
    const std::size_t i = begin + static_cast<std::size_t>(k);
    motion seen = motion::Zero();
    st.for_each_node(k, [&](int o, auto a) { seen += st.value(k, a) * nodes.node[static_cast<std::size_t>(o)]; });
    const T m = p.template get<field::mass>()[i];
    forces back = forces::Zero();
    T gain = 0;
    for (int d = 0; d < dim; ++d) {
      T& v = p.template get<field::velocity>(d)[i];
      const T dv = seen[dim + d];
      gain += dv * (v + T(0.5) * dv);
      v += dv;
      back[d] = m * dv;
      p.template get<field::carrying_velocity>(d)[i] = seen[d] + dv;
    }
    report.kinetic_gain += static_cast<double>(m) * static_cast<double>(gain);
    st.for_each_node(k, [&](int o, auto a) { win.node[static_cast<std::size_t>(o)] += st.value(k, a) * back; });
  }

  /// APIC: velocity and affine field from the grid; what is lost on both ways becomes heat.
  template <class Columns, class Window>
  BOLIDE_INLINE void take_affine(Columns& p, std::size_t begin, int k, const stencil_type& st, const Window& nodes, update_report& report) const {
    const std::size_t i = begin + static_cast<std::size_t>(k);
    const T m = p.template get<field::mass>()[i], cell = static_cast<T>(h), inertia = cell * cell * T(Shape::inertia);
    T old_v[dim], old_c[dim][dim];
    for (int c = 0; c < dim; ++c) {
      old_v[c] = p.template get<field::velocity>(c)[i];
      for (int d = 0; d < dim; ++d) old_c[c][d] = p.template get<field::affine_velocity>(c * dim + d)[i] * cell;
    }
    // sums relative to the old velocity: differences, not squares of speeds, are summed
    T v[dim] = {}, moment[dim][dim] = {}, to_grid = 0, square_after = 0;
    st.for_each_node(k, [&](int o, auto a) {
      const T w = st.value(k, a);
      const motion& node = nodes.node[static_cast<std::size_t>(o)];
      for (int c = 0; c < dim; ++c) {
        T before = node[c] - old_v[c];
        const T after = before + node[dim + c];
        for (int d = 0; d < dim; ++d) before -= old_c[c][d] * st.distance(k, a, d);
        to_grid += w * before * before;
        v[c] += w * after;
        square_after += w * after * after;
        for (int d = 0; d < dim; ++d) moment[c][d] += w * after * st.distance(k, a, d);
      }
    });
    T kinetic = 0, resolved = 0;
    for (int c = 0; c < dim; ++c) {
      kinetic += v[c] * (old_v[c] + T(0.5) * v[c]);
      resolved += v[c] * v[c];
      p.template get<field::velocity>(c)[i] = old_v[c] + v[c];
      p.template get<field::carrying_velocity>(c)[i] = old_v[c] + v[c];
      for (int d = 0; d < dim; ++d) {
        const T affine = moment[c][d] * cell / inertia;
        kinetic += T(0.5) * inertia * (affine * affine - old_c[c][d] * old_c[c][d] / (cell * cell));
        resolved += inertia * affine * affine;
        p.template get<field::affine_velocity>(c * dim + d)[i] = affine;
      }
    }
    const T loss = T(0.5) * (to_grid + max(square_after - resolved, T(0))) * static_cast<T>(transfer.heat);
    p.template get<field::energy>()[i] += loss;
    report.kinetic_gain += static_cast<double>(m) * static_cast<double>(kinetic);
    report.returned_heat += static_cast<double>(m) * static_cast<double>(loss);
  }

  template <class Columns, class Back> BOLIDE_INLINE void scatter_velocity_back(const Columns& p, std::size_t begin, int k, const stencil_type& st, Back& win) const {
    const std::size_t i = begin + static_cast<std::size_t>(k);
    const T m = p.template get<field::mass>()[i];
    st.for_each_node(k, [&](int o, auto a) {
      forces q = forces::Zero();
      for (int c = 0; c < dim; ++c) {
        T v = p.template get<field::velocity>(c)[i];
        for (int d = 0; d < dim; ++d) v += p.template get<field::affine_velocity>(c * dim + d)[i] * st.distance(k, a, d) * static_cast<T>(h);
        q[c] = m * v;
      }
      win.node[static_cast<std::size_t>(o)] += st.value(k, a) * q;
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
          detail::store_first(select(beyond, -v, v), p.template get<field::velocity>(d) + at, n);
          if constexpr (Transfer::affine)
            for (int e = 0; e < dim * dim; ++e)
              if ((e / dim == d) != (e % dim == d)) {
                const V c = load<V>(p.template get<field::affine_velocity>(e) + at);
                detail::store_first(select(beyond, -c, c), p.template get<field::affine_velocity>(e) + at, n);
              }
        }
        detail::store_first(x, p.template get<field::position>(d) + at, n);
      }
    }
    if (!set.measure(range, h)) report.moved_out = true;
  }
};

} // namespace bolide
