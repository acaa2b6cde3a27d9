// SPDX-License-Identifier: MIT
// The particles of one body on the grid: their columns, sorted by block, and the block ranges that the sweeps run over.
#pragma once

#include "bolide/grid/sparse.hpp"
#include "bolide/material/report.hpp"
#include "bolide/material/response.hpp"
#include "bolide/particles/columns.hpp"
#include "bolide/solver/ledger.hpp"
#include "bolide/solver/tiles.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bolide {

/// Particles of one body whose home is one block.
template <int Dim> struct block_range {
  using map = grid::block_map<Dim>;
  grid::cell_index<Dim> origin;                       // first node of the block
  std::size_t begin, end;                             // particles
  std::array<std::int32_t, map::neighbours> near;     // the blocks around
  grid::node_range<Dim> touched;                      // nodes that the particles touch, relative to origin
  int quiet = 0;                                      // 0: awake; else asleep, and how many blocks off the next awake one is (3: or more)
  step_limit rest;                                    // while asleep: the shortest step that its particles ask for
  std::vector<tile> tiles;                            // over its particles, in their order; none where they would not fill them
  std::size_t tiles_at_best = 0;                      // how many there were when the particles were last put in order
  std::size_t excess_tiles = 0;                       // how many more there were since, summed over the steps
  std::vector<std::int32_t> nodes;                    // the node at every place of its window (grid/sparse.hpp)

  /// The nodes of neighbour n (of 3^Dim, last axis fastest) that the particles touch, relative to that block.
  grid::node_range<Dim> part_in_neighbour(int n) const {
    grid::node_range<Dim> part;
    for (int d = Dim - 1; d >= 0; --d, n /= 3) {
      const auto at = static_cast<std::size_t>(d);
      const int shift = (n % 3 - 1) * map::side;
      part.low[at] = std::max(0, touched.low[at] - shift);
      part.high[at] = std::min(map::side - 1, touched.high[at] - shift);
    }
    return part;
  }
};

template <class T, class Space, class Shape, class Material, class Fields> struct particle_set {
  static constexpr int dim = Space::dim;
  using map = grid::block_map<dim>;
  using index = grid::cell_index<dim>;

  std::string name;
  Material material;
  T half_size;            // half a particle over the cell size
  double geometric_mass;  // kg
  std::uint32_t first_id;
  std::size_t number;     // of the body, from 0
  particles::columns<T, Space, Fields> columns;
  std::vector<block_range<dim>> ranges;
  std::array<std::vector<std::int32_t>, map::colours> by_colour; // ranges of each colour

  /// First node of the support of particle i: what the particles are sorted by.
  index first_node(std::size_t i, double h) const {
    index c;
    for (int d = 0; d < dim; ++d) {
      const double x = static_cast<double>(columns.template get<field::position>(d)[i]) / h;
      c[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(std::floor(x - Shape::offset));
    }
    return c;
  }

  /// Blocks that hold particles, each once per run of particles.
  void collect_blocks(double h, std::vector<index>& blocks) const {
    index last{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto b = map::block_of(first_node(i, h));
      if (i == 0 || b != last) blocks.push_back(b);
      last = b;
    }
  }

  /// Counting sort by block, then by first node within the block, in the order that fills tiles; equals keep their order.
  template <class Map> void sort(const Map& blocks, double h) {
    const std::size_t n = columns.size();
    std::vector<std::uint32_t> key(n), count(blocks.size() * map::nodes_per_block + 1, 0), order(n);
    index last{};
    std::int32_t last_block = -1;
    for (std::size_t i = 0; i < n; ++i) {
      const auto first = first_node(i, h);
      const auto b = map::block_of(first);
      if (last_block < 0 || b != last) {
        last_block = blocks.find(b);
        last = b;
      }
      std::int32_t local = 0;
      for (std::size_t d = 0; d < dim; ++d) local = local * map::side + (first[d] - b[d] * map::side);
      key[i] = static_cast<std::uint32_t>(last_block * map::nodes_per_block + local);
      ++count[key[i] + 1];
    }
    for (std::size_t c = 1; c < count.size(); ++c) count[c] += count[c - 1];
    std::vector<std::uint32_t> next(count.begin(), count.end() - 1);
    for (std::size_t i = 0; i < n; ++i) order[next[key[i]]++] = static_cast<std::uint32_t>(i);
    interleave(count, std::min<std::size_t>(lanes, map::side), order);
    columns.reorder(order);

    ranges.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const std::size_t begin = count[b * map::nodes_per_block], end = count[(b + 1) * map::nodes_per_block];
      if (begin == end) continue;
      ranges.push_back({{}, begin, end, {}, {}, 0, {}, {}, 0, 0, {}});
      for (std::size_t d = 0; d < dim; ++d) ranges.back().origin[d] = blocks.coordinate(b)[d] * map::side;
    }
    link(blocks);
    for (auto& r : ranges) {
      measure(r, h);
      begin_tiles(r, h);
      if (r.tiles.empty()) put_settled_last(r);
    }
  }

  /// Particles that have failed and settled in their void (material/material.hpp) come after the others, so that whole registers and chunks of them
  /// need no equation of state and give no force.
  void put_settled_last(const block_range<dim>& r) {
    if constexpr (decltype(columns)::template has<field::failed>) {
      const T* const failed = columns.template get<field::failed>() + r.begin;
      const auto is_awake = [failed](std::uint32_t k) { return !(failed[k] > T(1)); };
      std::vector<std::uint32_t> order(r.end - r.begin);
      std::iota(order.begin(), order.end(), 0u);
      if (std::is_partitioned(order.begin(), order.end(), is_awake)) return;
      std::stable_partition(order.begin(), order.end(), is_awake);
      columns.reorder(r.begin, order);
    }
  }
  /// Puts tiles over the particles of a range, after measure().
  void lay_tiles(block_range<dim>& r, double h) const {
    tile_layer<lanes, grid::window<dim>::stride> layer(r.tiles);
    std::array<std::int32_t, chunk_size> first;
    for (std::size_t begin = r.begin; begin < r.end; begin += chunk_size) {
      const std::size_t n = std::min<std::size_t>(chunk_size, r.end - begin);
      first_nodes(r, begin, n, h, first.data());
      layer.add(static_cast<std::uint32_t>(begin), static_cast<int>(n), first.data());
    }
    layer.close();
  }
  /// Tiles over particles in the order that fills them, if they do.
  void begin_tiles(block_range<dim>& r, double h) const {
    lay_tiles(r, h);
    if (r.end - r.begin < least_in_tile * r.tiles.size()) r.tiles.clear();
    r.tiles_at_best = r.tiles.size();
    r.excess_tiles = 0;
  }
  /// After a motion: new tiles, and a new order where what the decayed one has cost would have paid for it.
  void renew_tiles(block_range<dim>& r, double h) {
    if (r.tiles.empty()) return;
    lay_tiles(r, h);
    r.excess_tiles += r.tiles.size() - std::min(r.tiles.size(), r.tiles_at_best);
    if (arranging_costs * r.excess_tiles > r.end - r.begin + 16) arrange(r, h);
  }
  /// Brings the particles of a range into the order that fills tiles.
  void arrange(block_range<dim>& r, double h) {
    const std::size_t n = r.end - r.begin;
    std::vector<std::int32_t> first(n + chunk_size);
    for (std::size_t k = 0; k < n; k += chunk_size) first_nodes(r, r.begin + k, std::min<std::size_t>(chunk_size, n - k), h, first.data() + k);
    using win = grid::window<dim>;
    const std::int32_t lowest = win::offset(r.touched.low) / win::stride * win::stride; // the row of the first touched node
    std::vector<std::uint32_t> start(static_cast<std::size_t>(win::offset(r.touched.high) + 1 - lowest) + 1, 0), order(n);
    for (std::size_t k = 0; k < n; ++k) ++start[static_cast<std::size_t>(first[k] - lowest) + 1];
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t k = 0; k < n; ++k) order[next[static_cast<std::size_t>(first[k] - lowest)]++] = static_cast<std::uint32_t>(k);
    interleave(start, lanes, order);
    columns.reorder(r.begin, order);
    begin_tiles(r, h);
  }

  /// Are all particles of a range without void, and without velocity and stress beyond `speed` (m/s) and rho c times it? With speed = 0 nothing of
  /// them changes until their nodes move.
  bool at_rest(const block_range<dim>& r, T speed, T cell) const {
    const T stress = static_cast<T>(material.impedance()) * speed;
    const auto is_below = [&]<class Tag>(Tag, T bound) {
      if constexpr (decltype(columns)::template has<Tag>)
        for (int c = 0; c < Space::components(Tag::order); ++c) {
          const T* x = columns.template get<Tag>(c);
          if (std::any_of(x + r.begin, x + r.end, [bound](T v) { return !(std::abs(v) <= bound); })) return false;
        }
      return true;
    };
    return is_below(field::velocity{}, speed) && is_below(field::pressure{}, stress) && is_below(field::deviator{}, stress) && is_below(field::viscous_pressure{}, stress) &&
           is_below(field::affine_velocity{}, speed / cell) && is_below(field::failed{}, T(0));
  }

  /// Finds which nodes the particles of a range touch. False where they have drifted further than the neighbouring blocks allow.
  bool measure(block_range<dim>& r, double h) const {
    using V = native_pack<T>;
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const T* x = columns.template get<field::position>(d) + r.begin;
      T low = x[0], high = x[0], finite = 0; // finite: 0, or NaN where a position is none or infinite (min and max may pass over NaN)
      const std::size_t n = r.end - r.begin;
      std::size_t k = 0;
      if (n >= static_cast<std::size_t>(lane_width<V>)) {
        V l = load<V>(x), u = l, rest = V(T(0));
        for (; k + lane_width<V> <= n; k += lane_width<V>) {
          const V v = load<V>(x + k);
          l = min(l, v);
          u = max(u, v);
          rest += v - v;
        }
        for (int i = 0; i < lane_width<V>; ++i) {
          finite += lane(rest, i);
          low = std::min(low, lane(l, i));
          high = std::max(high, lane(u, i));
        }
      }
      for (; k < n; ++k) {
        low = std::min(low, x[k]);
        high = std::max(high, x[k]);
        finite += x[k] - x[k];
      }
      const T inverse_h = static_cast<T>(1 / h);
      const T first = std::floor(low * inverse_h - T(Shape::offset)), last = std::floor(high * inverse_h - T(Shape::offset));
      const auto at = static_cast<std::size_t>(d);
      const T lo = first - static_cast<T>(r.origin[at]), hi = last - static_cast<T>(r.origin[at]);
      constexpr int least = -grid::window<dim>::reach, most = grid::window<dim>::stride - grid::window<dim>::reach - Shape::support;
      if (!(lo >= T(least)) || !(hi <= T(most)) || !(finite == T(0))) inside = false; // NaN is outside
      else {
        r.touched.low[at] = static_cast<int>(lo);
        r.touched.high[at] = static_cast<int>(hi) + Shape::support - 1;
      }
    }
    return inside;
  }

  /// What this body is composed of (concepts/archive.hpp).
  template <class A> void describe(A& a) const {
    a.same("name", name);
    a.same("half particle over cell", static_cast<double>(half_size), "");
    a.same("mass of its shape", geometric_mass, "kg");
    a.same("first particle", static_cast<double>(first_id), "");
    const material_response<T, Space, Material> response(material);
    std::vector<double> numbers;
    for (const auto& n : response.numbers()) numbers.push_back(n.value);
    a.alike("material", numbers, response.tolerance, [&](std::size_t k) { return response.numbers()[k].what; });
  }
  /// Particles and their ranges; what follows from these, the neighbours and colours, is made by connect().
  template <class A> void archive(A& a) {
    a.value("columns", columns);
    std::uint64_t count = ranges.size();
    a.value("ranges", count);
    ranges.resize(count);
    const auto column = [&](const std::string& of, auto&& member) { // a member of all ranges
      std::vector<std::remove_cvref_t<decltype(member(ranges[0]))>> x;
      for (auto& r : ranges) x.push_back(member(r));
      a.value("range_" + of, x);
      a.expect(x.size() == ranges.size(), "the ranges' " + of + " are another number");
      for (std::size_t k = 0; k < ranges.size(); ++k) member(ranges[k]) = x[k];
    };
    column("begin", [](auto& r) -> auto& { return r.begin; });
    column("end", [](auto& r) -> auto& { return r.end; });
    for (std::size_t d = 0; d < dim; ++d) {
      const std::string axis = "_" + std::to_string(d);
      column("origin" + axis, [d](auto& r) -> auto& { return r.origin[d]; });
      column("touched_low" + axis, [d](auto& r) -> auto& { return r.touched.low[d]; });
      column("touched_high" + axis, [d](auto& r) -> auto& { return r.touched.high[d]; });
    }
    column("quiet", [](auto& r) -> auto& { return r.quiet; });
    column("rest_rate", [](auto& r) -> auto& { return r.rest.rate; });
    column("rest_particle", [](auto& r) -> auto& { return r.rest.particle; });
    column("rest_cause", [](auto& r) -> auto& { return r.rest.cause; });
    column("tiles_at_best", [](auto& r) -> auto& { return r.tiles_at_best; });
    column("excess_tiles", [](auto& r) -> auto& { return r.excess_tiles; });
    for (const auto& r : ranges) a.expect(r.begin < r.end && r.end <= columns.size(), "a range of particles is none");
  }
  /// Finds neighbours, colours, nodes and tiles of the ranges in the blocks.
  template <class Map> void connect(const Map& blocks, double h) {
    link(blocks);
    for (auto& r : ranges) {
      r.tiles.clear();
      if (r.tiles_at_best > 0) lay_tiles(r, h);
    }
  }

private:
  static constexpr int lanes = native_width<T>;
  static constexpr std::size_t least_in_tile = static_cast<std::size_t>(3 * lanes / 4); // particles, on average, for tiles to be worth it
  static constexpr std::size_t arranging_costs = 2; // a tile in a step costs about as much as arranging so many particles

  /// Finds neighbours, nodes and colours of the ranges in the blocks.
  template <class Map> void link(const Map& blocks) {
    for (auto& c : by_colour) c.clear();
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      const auto block = map::block_of(ranges[k].origin);
      ranges[k].near = blocks.neighbourhood(block);
      ranges[k].nodes = grid::window<dim>::nodes(ranges[k].near);
      by_colour[static_cast<std::size_t>(map::colour_of(block))].push_back(static_cast<std::int32_t>(k));
    }
  }

  /// Window offsets of the first nodes of n <= chunk_size particles (whole registers are written). They are held among the touched nodes, so that a
  /// rounding of x / h on a cell face names no foreign node.
  BOLIDE_INLINE void first_nodes(const block_range<dim>& r, std::size_t begin, std::size_t n, double h, std::int32_t* first) const {
    using V = native_pack<T>;
    using win = grid::window<dim>;
    const T inverse_h = static_cast<T>(1 / h);
    for (std::size_t k = 0; k < n; k += static_cast<std::size_t>(lane_width<V>)) {
      V sum(T(0));
      for (std::size_t d = 0; d < dim; ++d) {
        const V x = load<V>(columns.template get<field::position>(static_cast<int>(d)) + begin + k);
        const V node = clip(floor(x * inverse_h - T(Shape::offset)), V(T(r.origin[d] + r.touched.low[d])), V(T(r.origin[d] + r.touched.high[d] - Shape::support + 1)));
        sum = sum * T(win::stride) + (node - T(r.origin[d] - win::reach));
      }
      store_whole(sum, first + k);
    }
  }
};

} // namespace bolide
