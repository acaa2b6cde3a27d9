// SPDX-License-Identifier: MIT
// A hand-written kernel of one composition: what the composed solver costs is measured against it. r-z, linear shape functions, update stress
// first, FLIP; Mie-Grueneisen, J2 with linear hardening, bulk viscosity; double. The same step as the composed solver to round-off
// (tests/verify/hand_written_test.cpp), its time-step limit and its ledger included:
//
//   map            m_I = sum N m,   v_I = sum N m v / m_I
//   stress         L = sum v_I grad N;   V <- V / det(1 - dt L),   s, q, p, c (material.hpp);   f_I = -sum V (s - (p + q) I) grad N
//   accelerate     dv_I = f_I dt / m_I;   v += sum N dv_I,   u = sum N (v_I + dv_I);   dv~_I = sum N m dv / m_I
//   work_and_move  e += dt sigma : grad(v + dv~/2) V / m;   x += dt u
//
// How it is fast: one SIMD lane per cell. Node columns lie one array per component, so the nodes of W neighbouring cells are plain loads, and what
// the particles of W cells give is summed in registers and added to the grid once. Particles are kept block by block (16 x 16 cells when sorted)
// in the order row, group of W cells, rank in the cell, cell. A tile is up to W particles of a group, at most one per cell: a mask of the cells
// that have one; its particles follow each other in the columns, so nothing is stored for a cell without a particle. The stress is computed on
// dense lanes between two passes over tiles; a tile that is not full is gathered into a buffer, never stored to a column (the next tile's load
// would wait).
// A particle may leave its cell: its tile is processed once more for every distinct drift of its lanes, with the nodes of the cell they are in.
// A block is sorted when a tenth of its tiles have such lanes, all of them when one spreads over 24 rows or 32 columns of cells.
//
// The domain is a box off the axis that the material must not leave (as in textbook.hpp), a group holds at most 64 particles per cell; nothing is
// checked in a step. One thread. 16 numbers and 4 bytes per particle, 9 numbers per node of the box. Any SIMD width; fast with AVX-512, which
// expands and compresses registers.
#pragma once

#include "block_scene.hpp"
#include "textbook.hpp"

#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace hand_written {

using bolide::load;
using bolide::select;
using bolide::store;
using lanes = bolide::native_pack<double>;
inline constexpr int width = bolide::native_width<double>;
using mask = std::uint8_t; // bit l: lane l
inline constexpr mask full = static_cast<mask>((1u << width) - 1);

// ---- lanes and masks ----------------------------------------------------------------------------------------------------------------
BOLIDE_INLINE mask bits(bolide::mask_t<lanes> m) {
#if defined(__AVX512F__)
  return m.bits;
#else
  unsigned b = 0;
  for (int l = 0; l < width; ++l) b |= m[l] ? 1u << l : 0u;
  return static_cast<mask>(b);
#endif
}
BOLIDE_INLINE mask first(std::size_t n) { return n >= static_cast<std::size_t>(width) ? full : static_cast<mask>((1u << n) - 1); }
#if defined(__AVX512F__)
BOLIDE_INLINE lanes pick(mask m, lanes yes, lanes no) { return select(bolide::mask_t<lanes>{{m}}, yes, no); }
BOLIDE_INLINE lanes keep(mask m, lanes x) { return (lanes::value_type)_mm512_maskz_mov_pd(m, (__m512d)x.v); }
/// Consecutive numbers to the lanes of m, zero to the others.
BOLIDE_INLINE lanes spread(mask m, const double* from) { return (lanes::value_type)_mm512_maskz_expandloadu_pd(m, from); }
/// The lanes of m to the first lanes.
BOLIDE_INLINE lanes gathered(mask m, lanes x) { return (lanes::value_type)_mm512_maskz_compress_pd(m, (__m512d)x.v); }
BOLIDE_INLINE void store_lanes(lanes x, double* to, mask m) { _mm512_mask_storeu_pd(to, m, (__m512d)x.v); }
/// {last of `before`, x[0], ... x[W - 2]}
BOLIDE_INLINE lanes shifted(lanes x, lanes before) {
  const __m512i high = _mm512_castpd_si512((__m512d)x.v), low = _mm512_castpd_si512((__m512d)before.v);
  return (lanes::value_type)_mm512_castsi512_pd(_mm512_maskz_alignr_epi64(full, high, low, width - 1));
}
BOLIDE_INLINE lanes least(lanes a, lanes b) { return (lanes::value_type)_mm512_maskz_min_pd(full, (__m512d)a.v, (__m512d)b.v); }
BOLIDE_INLINE lanes most(lanes a, lanes b) { return (lanes::value_type)_mm512_maskz_max_pd(full, (__m512d)a.v, (__m512d)b.v); }
BOLIDE_INLINE lanes magnitude(lanes a) { return (lanes::value_type)_mm512_abs_pd((__m512d)a.v); }
#else
BOLIDE_INLINE lanes pick(mask m, lanes yes, lanes no) {
  return lanes::make([&](int l) { return (m >> l) & 1 ? yes[l] : no[l]; });
}
BOLIDE_INLINE lanes keep(mask m, lanes x) { return pick(m, x, lanes(0)); }
BOLIDE_INLINE lanes spread(mask m, const double* from) {
  return lanes::make([&](int l) { return (m >> l) & 1 ? from[std::popcount(m & ((1u << l) - 1))] : 0.0; });
}
BOLIDE_INLINE lanes gathered(mask m, lanes x) {
  lanes y(0);
  for (int l = 0, n = 0; l < width; ++l)
    if ((m >> l) & 1) y.set(n++, x[l]);
  return y;
}
BOLIDE_INLINE void store_lanes(lanes x, double* to, mask m) {
  for (int l = 0; l < width; ++l)
    if ((m >> l) & 1) to[l] = x[l];
}
BOLIDE_INLINE lanes shifted(lanes x, lanes before) {
  return lanes::make([&](int l) { return l == 0 ? before[width - 1] : x[l == 0 ? 0 : l - 1]; });
}
BOLIDE_INLINE lanes least(lanes a, lanes b) { return min(a, b); }
BOLIDE_INLINE lanes most(lanes a, lanes b) { return max(a, b); }
BOLIDE_INLINE lanes magnitude(lanes a) { return abs(a); }
#endif
/// Which of the numbers are greater than `than`? They begin at a cache line.
BOLIDE_INLINE mask above(const std::uint32_t* numbers, std::uint32_t than) {
#if defined(__AVX512VL__)
  const __m256i x = _mm256_load_si256(reinterpret_cast<const __m256i*>(numbers));
  return _mm256_cmpgt_epu32_mask(x, _mm256_set1_epi32(static_cast<int>(than)));
#else
  unsigned b = 0;
  for (int l = 0; l < width; ++l) b |= numbers[l] > than ? 1u << l : 0u;
  return static_cast<mask>(b);
#endif
}
BOLIDE_INLINE double sum(lanes x) {
  double s = 0;
  for (int l = 0; l < width; ++l) s += x[l];
  return s;
}

/// Columns of numbers in one piece. Each begins at a cache line, and no two at the same place of a page: 16 columns that did would push each other
/// out of the first-level cache (8 ways of 4 KiB), and packs that straddle cache lines cost twice: a quarter of the step.
class table {
public:
  table() = default;
  table(const table&) = delete; // data_ points into storage_
  table& operator=(const table&) = delete;
  double* operator[](std::size_t column) { return data_ + column * pitch_; }
  const double* operator[](std::size_t column) const { return data_ + column * pitch_; }
  std::size_t rows() const { return rows_; }
  void resize(std::size_t columns, std::size_t rows) {
    constexpr std::size_t line = 8;
    const std::size_t pitch = ((rows + line - 1) / line | 1) * line; // an odd number of lines
    std::vector<double> storage(columns * pitch + line, 0.0);
    double* const data = storage.data() + (line - reinterpret_cast<std::uintptr_t>(storage.data()) / sizeof(double) % line) % line;
    for (std::size_t k = 0; k < columns && rows_ > 0; ++k) std::copy_n((*this)[k], std::min(rows, rows_), data + k * pitch);
    storage_ = std::move(storage);
    data_ = data;
    pitch_ = pitch;
    rows_ = rows;
  }

private:
  std::vector<double> storage_;
  double* data_ = nullptr;
  std::size_t pitch_ = 0, rows_ = 0;
};

/// The channels of the composed solver's ledger that this composition has, J.
struct ledger {
  double transfer = 0, work_mismatch = 0, plastic_work = 0, viscous_heating = 0;
};

class rz {
public:
  enum quantity { r, z, vr, vz, ur, uz, particle_mass, volume, srr, szz, srz, strain, e, p, q, c, columns }; // u carries the particle
  table of;                      // by quantity, one number per particle
  std::vector<std::uint32_t> id; // order of appending
  ledger energy;
  double rate = 0; // 1/s, what the last step asks the next for: 1/dt at the Courant number

  rz(const textbook::parameters& a, const textbook::box<2>& b, double courant)
      : law_(a, b.h, courant), sound_speed_(a.c0), box_(b), inverse_h_(1 / b.h), first_node_{b.origin[0] * inverse_h_, b.origin[1] * inverse_h_},
        stride_(b.nodes[1] + 2 * width), rows_(b.nodes[0] + 2) {
    node_.resize(node_columns, static_cast<std::size_t>(rows_) * static_cast<std::size_t>(stride_) + width);
  }
  std::size_t size() const { return id.size(); }
  /// A particle without stress at the reference density.
  void append(double radius, double height, double radial_velocity, double axial_velocity, double mass) {
    std::array<double, columns> x{radius, height, radial_velocity, axial_velocity, radial_velocity, axial_velocity, mass, mass / law_.rho0};
    x[c] = sound_speed_;
    if (size() + padding > of.rows()) of.resize(columns, 2 * size() + padding + 1);
    for (std::size_t k = 0; k < columns; ++k) of[k][size()] = x[k];
    id.push_back(static_cast<std::uint32_t>(size()));
    scattered_ = true;
  }
  void step(double dt) {
    if (scattered_) sort_all();
    dt_ = dt;
    map();
    stress();
    accelerate();
    work_and_move();
  }

private:
  static constexpr std::size_t padding = 2 * width;
  static constexpr int side = 16, most_rows = 24, most_columns = 32, groups_per_row = most_columns / width;
  static constexpr std::size_t batch = 128;               // particles between two passes over tiles, or a group more
  static constexpr std::size_t room = batch + 65 * width; // for them
  struct group {
    std::uint32_t first, tile, tiles; // particle, tile
    int row, column;                  // of its first cell
    bool joins;                       // does it follow the group before in its row?
  };
  struct block {
    std::size_t begin, end; // particles
    std::vector<group> groups;
    std::vector<mask> tiles, home, home_next; // cells with a particle; particles that are in their cell, now and after the motion
    std::size_t dirty = 0;                    // tiles with particles that are not
  };
  struct constants { // what every particle needs
    double rho0, inverse_rho0, c0_squared, slope, half_gamma, gamma_rho, bulk, eta_guard, rho_guard, p_guard, slope_guard, c2_floor;
    double g, four_thirds_g, inverse_2g, inverse_3gh, yield, yield_third, hardening, half_hardening, quadratic, linear, h, inverse_h, per_speed;
    constants(const textbook::parameters& a, double cell, double courant)
        : rho0(a.rho0), inverse_rho0(1 / a.rho0), c0_squared(a.c0 * a.c0), slope(a.slope), half_gamma(a.gamma0 / 2), gamma_rho(a.gamma0 * a.rho0),
          bulk(a.rho0 * a.c0 * a.c0), eta_guard(0.95 / a.slope), rho_guard(a.rho0 / (1 - eta_guard)), c2_floor(0.05 * 0.05 * a.c0 * a.c0),
          g(a.shear_modulus), four_thirds_g(4.0 / 3 * a.shear_modulus), inverse_2g(0.5 / a.shear_modulus),
          inverse_3gh(1 / (3 * a.shear_modulus + a.hardening)), yield(a.yield), yield_third(a.yield * a.yield / 3), hardening(a.hardening),
          half_hardening(0.5 * a.hardening), quadratic(a.quadratic), linear(a.linear), h(cell), inverse_h(1 / cell), per_speed(1 / (courant * cell)) {
      const double d = 1 / (1 - slope * eta_guard), p_h = bulk * eta_guard * d * d, rest = 1 - half_gamma * eta_guard;
      p_guard = p_h * rest;
      slope_guard = (bulk * (1 + slope * eta_guard) * d * d * d * rest - half_gamma * p_h) * (1 - eta_guard) * (1 - eta_guard) / rho0;
    }
  };
  enum nodal { node_mass, velocity, force = velocity + 2, change = force + 2, back = change + 2, node_columns = back + 2 };

  constants law_;
  double sound_speed_; // at the reference density, m/s
  textbook::box<2> box_;
  double inverse_h_, dt_ = 0;
  std::array<double, 2> first_node_; // of the box, in cells
  int stride_, rows_;
  table node_;
  std::vector<block> blocks_;
  bool scattered_ = true;
  alignas(64) std::array<std::array<double, room + padding>, 5> buffer_{};
  std::vector<std::int32_t> key_;
  std::vector<std::uint32_t> rank_, order_, id_copy_, begin_of_tile_;
  std::vector<double> copy_;

  // ---- order of the particles -------------------------------------------------------------------------------------------------------
  BOLIDE_INLINE lanes cells(int axis, std::size_t at) const {
    return load<lanes>(&of[axis == 0 ? r : z][at]) * inverse_h_ - first_node_[static_cast<std::size_t>(axis)];
  }
  int cell_of(int axis, std::size_t i) const {
    return static_cast<int>(std::floor(of[axis == 0 ? r : z][i] * inverse_h_ - first_node_[static_cast<std::size_t>(axis)]));
  }
  void reorder(std::size_t begin, std::size_t n) {
    copy_.resize(std::max(copy_.size(), n));
    id_copy_.resize(std::max(id_copy_.size(), n));
    for (std::size_t k = 0; k < columns; ++k) {
      if (k == ur || k == uz) continue; // made anew in every step
      double* const from = &of[k][begin];
      for (std::size_t i = 0; i < n; ++i) copy_[i] = from[order_[i]];
      std::copy_n(copy_.begin(), n, from);
    }
    for (std::size_t i = 0; i < n; ++i) id_copy_[i] = id[begin + order_[i]];
    std::copy_n(id_copy_.begin(), n, id.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  void sort_all() {
    const int across = (box_.nodes[1] + side - 1) / side, along = (box_.nodes[0] + side - 1) / side;
    std::vector<std::uint32_t> home(size()), next(static_cast<std::size_t>(across * along) + 1, 0);
    for (std::size_t i = 0; i < size(); ++i) {
      home[i] = static_cast<std::uint32_t>(cell_of(0, i) / side * across + cell_of(1, i) / side);
      ++next[home[i] + 1];
    }
    for (std::size_t b = 1; b < next.size(); ++b) next[b] += next[b - 1];
    blocks_.clear();
    for (std::size_t b = 0; b + 1 < next.size(); ++b)
      if (next[b] < next[b + 1]) blocks_.push_back({next[b], next[b + 1], {}, {}, {}, {}});
    order_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) order_[next[home[i]]++] = static_cast<std::uint32_t>(i);
    reorder(0, size());
    for (auto& b : blocks_) sort(b);
    scattered_ = false;
  }
  /// Counting sort of a block by row, group, rank in the cell, cell. A block that has spread too far is left as it is.
  void sort(block& b) {
    const std::size_t n = b.end - b.begin;
    if (key_.size() < n + padding) key_.resize(n + padding), rank_.resize(n);
    if (order_.size() < n) order_.resize(n);
    int low[2], high[2];
    for (int axis = 0; axis < 2; ++axis) {
      lanes lowest(cells(axis, b.begin)[0]), highest = lowest;
      for (std::size_t i = 0; i < n; i += width) {
        const lanes x = cells(axis, b.begin + i);
        const mask active = first(n - i);
        lowest = least(lowest, pick(active, x, lowest));
        highest = most(highest, pick(active, x, highest));
      }
      low[axis] = static_cast<int>(std::floor(lowest[0]));
      high[axis] = static_cast<int>(std::floor(highest[0]));
      for (int l = 1; l < width; ++l) {
        low[axis] = std::min(low[axis], static_cast<int>(std::floor(lowest[l])));
        high[axis] = std::max(high[axis], static_cast<int>(std::floor(highest[l])));
      }
    }
    if (high[0] - low[0] >= most_rows || high[1] - low[1] >= most_columns) {
      scattered_ = true;
      return;
    }
    alignas(64) std::array<std::uint32_t, most_rows * most_columns> count{};
    for (std::size_t i = 0; i < n; i += width)
      store_whole((floor(cells(0, b.begin + i)) - double(low[0])) * double(most_columns) + (floor(cells(1, b.begin + i)) - double(low[1])), &key_[i]);
    for (std::size_t i = 0; i < n; ++i) rank_[i] = count[static_cast<std::size_t>(key_[i])]++;
    b.groups.clear();
    b.tiles.clear();
    std::array<std::uint32_t, most_rows * groups_per_row> tile_of{};
    begin_of_tile_.clear();
    std::uint32_t at = 0;
    int last = -2;
    for (int g = 0; g < most_rows * groups_per_row; ++g) {
      tile_of[static_cast<std::size_t>(g)] = static_cast<std::uint32_t>(b.tiles.size());
      const int across = g % groups_per_row;
      group made{static_cast<std::uint32_t>(b.begin) + at, tile_of[static_cast<std::size_t>(g)], 0, low[0] + g / groups_per_row,
                 low[1] + across * width, last == g - 1 && across != 0};
      for (std::uint32_t rank = 0;; ++rank) {
        const unsigned present = above(&count[static_cast<std::size_t>(g * width)], rank);
        if (present == 0) break;
        begin_of_tile_.push_back(at);
        b.tiles.push_back(static_cast<mask>(present));
        at += static_cast<std::uint32_t>(std::popcount(present));
        ++made.tiles;
      }
      if (made.tiles == 0) continue;
      b.groups.push_back(made);
      last = g;
    }
    b.home = b.home_next = b.tiles;
    b.dirty = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto g = static_cast<std::uint32_t>(key_[i]) / width, l = static_cast<std::uint32_t>(key_[i]) % width, t = tile_of[g] + rank_[i];
      order_[begin_of_tile_[t] + static_cast<std::uint32_t>(std::popcount(b.tiles[t] & ((1u << l) - 1)))] = static_cast<std::uint32_t>(i);
    }
    reorder(b.begin, n);
  }

  // ---- tiles ------------------------------------------------------------------------------------------------------------------------
  template <bool Full> static BOLIDE_INLINE lanes get(const double* from, mask m) {
    if constexpr (Full) return load<lanes>(from);
    else return spread(m, from);
  }
  /// Position in the cell, for each of the two axes, and weights of its nodes.
  struct place {
    lanes f[2];
    BOLIDE_INLINE place(lanes a, lanes b) : f{a, b} {}
    BOLIDE_INLINE place moved(int rows, int columns_) const { return {f[0] - double(rows), f[1] - double(columns_)}; }
    BOLIDE_INLINE mask inside() const { return bits(f[0] >= lanes(0) && f[0] < lanes(1) && f[1] >= lanes(0) && f[1] < lanes(1)); }
    /// A weight is at least a few machine epsilons, as in shape/linear.hpp: a node that sees a particle has mass.
    BOLIDE_INLINE void weights(lanes (&a)[2], lanes (&b)[2]) const {
      constexpr double smallest = 4 * std::numeric_limits<double>::epsilon();
      a[1] = least(most(f[0], lanes(smallest)), lanes(1 - smallest));
      b[1] = least(most(f[1], lanes(smallest)), lanes(1 - smallest));
      a[0] = 1.0 - a[1];
      b[0] = 1.0 - b[1];
    }
  };
  BOLIDE_INLINE place position(lanes radius, lanes height, const group& g) const {
    const lanes number = lanes::make([](int l) { return l; });
    return {radius * inverse_h_ - (first_node_[0] + g.row), height * inverse_h_ - (number + (first_node_[1] + g.column))};
  }
  template <bool Full> BOLIDE_INLINE place position(std::size_t at, mask m, const group& g) const {
    return position(get<Full>(&of[r][at], m), get<Full>(&of[z][at], m), g);
  }
  /// f(rows, columns, lanes) for every distinct number of cells that lanes of m have drifted from theirs.
  template <class F> static BOLIDE_INLINE void for_each_drift(mask m, const place& x, F&& f) {
    const lanes a = floor(x.f[0]), b = floor(x.f[1]);
    for (unsigned rest = m; rest != 0;) {
      const int l = std::countr_zero(rest);
      const unsigned same = bits(a == lanes(a[l]) && b == lanes(b[l])) & rest;
      f(static_cast<int>(a[l]), static_cast<int>(b[l]), static_cast<mask>(same));
      rest &= ~same;
    }
  }
  double* nodes(int column, int row, int at) { return &node_[static_cast<std::size_t>(column)][static_cast<std::size_t>(row * stride_ + at)]; }
  template <int N> using node_lanes = lanes[N][2][2]; // component, row, column
  template <int N> BOLIDE_INLINE void fetch(int first_column, int row, int column, lanes (*v)[2][2]) {
    for (int k = 0; k < N; ++k)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) v[k][a][b] = load<lanes>(nodes(first_column + k, row + a, column + b));
  }
  BOLIDE_INLINE void scale(node_lanes<2>& v) const {
    const double factor = dt_ * inverse_h_;
    for (auto& component : v)
      for (auto& row : component)
        for (auto& x : row) x = x * factor;
  }
  template <int N> static BOLIDE_INLINE void clear(node_lanes<N>& v) {
    for (auto& component : v)
      for (auto& row : component)
        for (auto& x : row) x = lanes(0);
  }
  template <int N> BOLIDE_INLINE void add(int first_column, int row, int column, const node_lanes<N>& v) {
    for (int k = 0; k < N; ++k)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          double* const to = nodes(first_column + k, row + a, column + b);
          store(load<lanes>(to) + v[k][a][b], to);
        }
  }
  /// What the groups of a row give to the nodes, added group by group; the last node of a group waits for the next group.
  template <int N> struct sums_of_row {
    lanes waiting[N][2];
    int row = -1, column = 0;
  };
  template <int N> BOLIDE_INLINE void flush(int first_column, const group& g, const node_lanes<N>& sums, sums_of_row<N>& state) {
    if (!g.joins) finish<N>(first_column, state);
    for (int k = 0; k < N; ++k)
      for (int a = 0; a < 2; ++a) {
        double* const to = nodes(first_column + k, g.row + a, g.column);
        const lanes before = g.joins ? state.waiting[k][a] : lanes(0);
        store(load<lanes>(to) + sums[k][a][0] + shifted(sums[k][a][1], before), to);
        state.waiting[k][a] = sums[k][a][1];
      }
    state.row = g.row;
    state.column = g.column + width;
  }
  template <int N> BOLIDE_INLINE void finish(int first_column, sums_of_row<N>& state) {
    if (state.row < 0) return;
    for (int k = 0; k < N; ++k)
      for (int a = 0; a < 2; ++a) *nodes(first_column + k, state.row + a, state.column) += state.waiting[k][a][width - 1];
    state.row = -1;
  }
  /// f(from, to, begin, end, base) for batches of groups from .. to with the particles begin .. end. In the buffer they are counted from base, the
  /// cache line of the first, so that dense lanes straddle no cache line.
  template <class F> static BOLIDE_INLINE void for_each_batch(const block& b, F&& f) {
    for (std::size_t from = 0; from < b.groups.size();) {
      const std::size_t begin = b.groups[from].first;
      std::size_t to = from + 1;
      while (to < b.groups.size() && b.groups[to].first - begin < batch) ++to;
      f(from, to, begin, to < b.groups.size() ? std::size_t{b.groups[to].first} : b.end, begin - begin % width);
      from = to;
    }
  }
  /// f<full?>(at, lanes) for the packs of the particles begin .. end, from base on.
  template <class F> static BOLIDE_INLINE void for_each_pack(std::size_t begin, std::size_t end, std::size_t base, F&& f) {
    std::size_t at = base;
    if (base < begin) {
      f.template operator()<false>(at, static_cast<mask>(first(end - at) & ~first(begin - at)));
      at += width;
    }
    for (; at + width <= end; at += width) f.template operator()<true>(at, full);
    if (at < end) f.template operator()<false>(at, first(end - at));
  }

  // ---- map --------------------------------------------------------------------------------------------------------------------------
  void map() {
    for (int k = node_mass; k < force; ++k) std::fill_n(node_[static_cast<std::size_t>(k)], node_.rows(), 0.0);
    for (const auto& b : blocks_) map_block(b);
    for_each_node([this](std::size_t i) {
      const lanes total = at(node_mass, i), inverse = select(total > lanes(0), 1.0 / total, lanes(0));
      for (int k = 0; k < 2; ++k) {
        put(velocity + k, i, at(velocity + k, i) * inverse);
        put(force + k, i, lanes(0));
        put(back + k, i, lanes(0));
      }
    });
  }
  BOLIDE_INLINE lanes at(int column, std::size_t i) const { return load<lanes>(&node_[static_cast<std::size_t>(column)][i]); }
  BOLIDE_INLINE void put(int column, std::size_t i, lanes x) { store(x, &node_[static_cast<std::size_t>(column)][i]); }
  template <class F> BOLIDE_INLINE void for_each_node(F&& f) {
    for (std::size_t i = 0; i + width <= node_.rows(); i += width) f(i);
  }
  template <bool Full> BOLIDE_INLINE void map_tile(std::size_t at, mask m, mask active, const place& x, node_lanes<3>& sums) const {
    lanes a[2], b[2];
    x.weights(a, b);
    lanes own = get<Full>(&of[particle_mass][at], m);
    if constexpr (!Full) own = keep(active, own);
    const lanes v = get<Full>(&of[vr][at], m), w = get<Full>(&of[vz][at], m);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const lanes part = own * a[i] * b[j];
        sums[0][i][j] += part;
        sums[1][i][j] += part * v;
        sums[2][i][j] += part * w;
      }
  }
  __attribute__((noinline)) void map_block(const block& b) {
    sums_of_row<3> state;
    for (const auto& g : b.groups) {
      node_lanes<3> sums;
      clear<3>(sums);
      std::size_t at = g.first;
      for (std::size_t t = g.tile; t < g.tile + g.tiles; ++t) {
        const mask m = b.tiles[t], home = b.home[t];
        if (home == full) map_tile<true>(at, m, m, position<true>(at, m, g), sums);
        else {
          const place x = position<false>(at, m, g);
          map_tile<false>(at, m, home, x, sums);
          if (m != home) for_each_drift(m & ~home, x, [&](int rows, int steps, mask moved) {
              node_lanes<3> own;
              clear<3>(own);
              map_tile<false>(at, m, moved, x.moved(rows, steps), own);
              add<3>(node_mass, g.row + rows, g.column + steps, own);
            });
        }
        at += static_cast<std::size_t>(std::popcount(m));
      }
      flush<3>(node_mass, g, sums, state);
    }
    finish<3>(node_mass, state);
  }

  // ---- stress -----------------------------------------------------------------------------------------------------------------------
  void stress() {
    rate /= 1.01 * 1.1; // what asks for less cannot limit the next step, which may grow by 1.1
    for (const auto& b : blocks_) {
      sums_of_row<2> state;
      for_each_batch(b, [&](std::size_t from, std::size_t to, std::size_t begin, std::size_t end, std::size_t base) {
        gradient_groups(velocity, b, from, to, base);
        update_particles(begin, end, base);
        force_groups(b, from, to, base, state);
      });
      finish<2>(force, state);
    }
  }
  /// v_r,r  v_r,z  v_z,r  v_z,z, all times h, and v_r.
  static BOLIDE_INLINE void gradient(const place& x, const node_lanes<2>& v, lanes (&l)[5]) {
    for (int k = 0; k < 2; ++k) {
      const lanes low = v[k][0][1] - v[k][0][0], high = v[k][1][1] - v[k][1][0], below = v[k][0][0] + x.f[1] * low;
      l[2 * k] = v[k][1][0] + x.f[1] * high - below;
      l[2 * k + 1] = low + x.f[0] * (high - low);
      if (k == 0) l[4] = below + x.f[0] * l[0];
    }
  }
  /// dt L of a nodal velocity at the particles of groups from .. to, into the buffer; the last is dt v_r / h.
  __attribute__((noinline)) void gradient_groups(int of_nodes, const block& b, std::size_t from, std::size_t to, std::size_t base) {
    for (std::size_t k = from; k < to; ++k) {
      const group& g = b.groups[k];
      node_lanes<2> v;
      fetch<2>(of_nodes, g.row, g.column, v);
      scale(v);
      std::size_t at = g.first;
      for (std::size_t t = g.tile; t < g.tile + g.tiles; ++t) {
        const mask m = b.tiles[t], home = b.home[t];
        lanes l[5];
        if (home == full) {
          gradient(position<true>(at, m, g), v, l);
          for (std::size_t i = 0; i < 5; ++i) store(l[i], &buffer_[i][at - base]);
        } else {
          const place x = position<false>(at, m, g);
          gradient(x, v, l);
          if (m != home) for_each_drift(m & ~home, x, [&](int rows, int steps, mask moved) {
              node_lanes<2> there;
              fetch<2>(of_nodes, g.row + rows, g.column + steps, there);
              scale(there);
              lanes own[5];
              gradient(x.moved(rows, steps), there, own);
              for (int i = 0; i < 5; ++i) l[i] = pick(moved, own[i], l[i]);
            });
          for (std::size_t i = 0; i < 5; ++i) store(gathered(m, l[i]), &buffer_[i][at - base]); // the next tile overwrites what is too much
        }
        at += static_cast<std::size_t>(std::popcount(m));
      }
    }
  }
  struct increment { // dt L
    lanes rr, rz, zr, zz, tt;
    BOLIDE_INLINE lanes trace() const { return rr + zz + tt; }
  };
  BOLIDE_INLINE increment buffered(std::size_t i, lanes h_over_r) const {
    const auto entry = [&](std::size_t k) { return load<lanes>(&buffer_[k][i]); };
    return {entry(0), entry(1), entry(2), entry(3), entry(4) * h_over_r};
  }
  /// s : E of a deviator; it does not see the trace.
  static BOLIDE_INLINE lanes contract(lanes rr, lanes zz, lanes rz, const increment& l) {
    return rr * (l.rr - l.tt) + zz * (l.zz - l.tt) + rz * (l.rz + l.zr);
  }
  /// s : s / 2
  static BOLIDE_INLINE lanes half_square(lanes rr, lanes zz, lanes rz) { return rr * rr + zz * (rr + zz) + rz * rz; }

  __attribute__((noinline)) void update_particles(std::size_t begin, std::size_t end, std::size_t base) {
    const constants k = law_; // a local copy: no store to a column can change it
    lanes plastic(0);
    double largest = rate;
    for_each_pack(begin, end, base, [&]<bool Full>(std::size_t at, mask active) __attribute__((always_inline)) {
      update_lanes<Full>(k, dt_, at, at - base, active, plastic, largest);
    });
    energy.plastic_work += sum(plastic);
    rate = largest;
  }
  template <bool Full> BOLIDE_INLINE void keep_column(quantity k, std::size_t at, mask active, lanes x) {
    if constexpr (Full) store(x, &of[k][at]);
    else store_lanes(x, &of[k][at], active);
  }
  /// The constitutive update of particles `at`, entry i of the buffer: dt L in (the last: dt v_r / h), -V sigma / h and -V sigma_tt / r out.
  template <bool Full>
  BOLIDE_INLINE void update_lanes(const constants& k, double dt, std::size_t at, std::size_t i, mask active, lanes& plastic, double& largest) {
    const lanes one(1), zero(0), radius = load<lanes>(&of[r][at]), own_mass = load<lanes>(&of[particle_mass][at]);
    const lanes inverse = one / (radius * own_mass), inverse_r = inverse * own_mass; // one division for 1/r and 1/m
    const increment l = buffered(i, k.h * inverse_r);
    const lanes trace = l.trace(), mean = trace * (1.0 / 3);
    const lanes det = ((one - l.rr) * (one - l.zz) - l.rz * l.zr) * (one - l.tt);
    const lanes v = load<lanes>(&of[volume][at]) / det, specific = v * (inverse * radius);

    lanes rr = load<lanes>(&of[srr][at]), zz = load<lanes>(&of[szz][at]), shear = load<lanes>(&of[srz][at]);
    const lanes work = contract(rr, zz, shear, l), shear_energy = half_square(rr, zz, shear) * (specific * k.inverse_2g);
    const lanes spin = l.rz - l.zr, turn = spin * shear, other = 0.5 * spin * (zz - rr);
    rr += 2 * k.g * (l.rr - mean) + turn;
    zz += 2 * k.g * (l.zz - mean) - turn;
    shear += k.g * (l.rz + l.zr) + other;

    const lanes x = k.rho0 * specific, eta = one - x, squeezed = least(eta, lanes(k.eta_guard)), y = one - k.slope * squeezed;
    const lanes both = one / (specific * y), rho = both * y, d = both * specific; // one division for rho and 1/y
    const lanes closing = most(-trace, zero) * (k.h / dt); // h |D| where D < 0
    const lanes viscous = rho * closing * (k.quadratic * closing + k.linear * load<lanes>(&of[c][at]));
    const lanes predicted = load<lanes>(&of[e][at]) - shear_energy + 0.5 * specific * (work - (load<lanes>(&of[p][at]) + viscous) * trace);
    const lanes stiff = k.bulk * d * d, rest = one - k.half_gamma * squeezed;
    lanes reference = stiff * squeezed * rest;
    lanes slope = stiff * ((one + k.slope * squeezed) * d * rest - k.half_gamma * squeezed) * k.rho0; // rho^2 dp/drho
    const auto expanded = eta < zero, beyond = eta > lanes(k.eta_guard);
    if (any(beyond)) {
      reference = select(beyond, k.p_guard + k.slope_guard * (rho - k.rho_guard), reference);
      slope = select(beyond, k.slope_guard * rho * rho, slope);
    }
    reference = select(expanded, k.bulk * (rho * k.inverse_rho0 - one), reference);
    slope = select(expanded, k.c0_squared * rho * rho, slope);
    const lanes pressure = reference + k.gamma_rho * predicted;
    const lanes c2 = most(lanes(k.c2_floor), (slope + k.gamma_rho * pressure) * (specific * specific)), sound = sqrt(c2);

    const lanes third = half_square(rr, zz, shear); // of the square of the equivalent stress
    const auto may_yield = third > lanes(k.yield_third);
    if ((bits(may_yield) & active) != 0) {
      const lanes equivalent = sqrt(3.0 * third), ep = load<lanes>(&of[strain][at]), flow = k.yield + k.hardening * ep;
      const auto yields = may_yield && equivalent > flow;
      const lanes gain = select(yields, (equivalent - flow) * k.inverse_3gh, zero);
      const lanes shrink = select(yields, (flow + k.hardening * gain) / equivalent, one), heat = v * (flow + k.half_hardening * gain) * gain;
      if constexpr (Full) plastic += heat;
      else plastic += keep(active, heat);
      rr = rr * shrink;
      zz = zz * shrink;
      shear = shear * shrink;
      keep_column<Full>(strain, at, active, ep + gain);
    }
    limit(k, dt, at, active, l, closing, c2 + k.four_thirds_g * specific, sound, largest);

    keep_column<Full>(volume, at, active, v);
    keep_column<Full>(srr, at, active, rr);
    keep_column<Full>(szz, at, active, zz);
    keep_column<Full>(srz, at, active, shear);
    keep_column<Full>(p, at, active, pressure);
    keep_column<Full>(q, at, active, viscous);
    keep_column<Full>(c, at, active, sound);
    const lanes total = pressure + viscous, v_h = -v * k.inverse_h;
    store((rr - total) * v_h, &buffer_[0][i]);
    store(shear * v_h, &buffer_[1][i]);
    store((zz - total) * v_h, &buffer_[2][i]);
    store((rr + zz + total) * (v * inverse_r), &buffer_[3][i]);
  }
  /// The largest rate that particles ask for: that of Q + sqrt(Q^2 + w^2) + |v| > B = largest / per_speed, or of 4 |L|. Whether there is one at all
  /// is told without a square root: with A = B - Q and b = A^2 - Q^2 - w^2 - v^2 where A < 0, b < 0 or 4 (Q^2 + w^2) v^2 > b^2.
  BOLIDE_INLINE void limit(const constants& k, double dt, std::size_t at, mask active, const increment& l, lanes closing, lanes wave2, lanes sound,
                           double& largest) const {
    const lanes zero(0), across = most(magnitude(l.rz), magnitude(l.zr));
    const lanes deforming = most(most(most(magnitude(l.rr), magnitude(l.zz)), magnitude(l.tt)), across);
    const lanes v = load<lanes>(&of[vr][at]), w = load<lanes>(&of[vz][at]), v2 = v * v + w * w;
    const lanes speed = select(closing > zero, k.quadratic * closing + k.linear * sound, zero), a = largest / k.per_speed - speed;
    const lanes signal2 = speed * speed + wave2, b = a * a - signal2 - v2;
    if ((bits(a < zero || b < zero || 4.0 * signal2 * v2 > b * b || deforming > lanes(largest * dt / 4)) & active) == 0) return;
    const lanes wanted = most(deforming * (4 / dt), (speed + sqrt(signal2) + sqrt(v2)) * k.per_speed);
    for (int n = 0; n < width; ++n)
      if ((active >> n) & 1) largest = std::max(largest, wanted[n]);
  }
  template <bool Full> BOLIDE_INLINE void force_tile(std::size_t i, mask m, mask active, const place& x, node_lanes<2>& sums) const {
    lanes a[2], b[2], s[4];
    x.weights(a, b);
    for (std::size_t k = 0; k < 4; ++k) {
      s[k] = get<Full>(&buffer_[k][i], m);
      if constexpr (!Full) s[k] = keep(active, s[k]);
    }
    for (int row = 0; row < 2; ++row) { // grad N = (+-b, +-a) / h
      const lanes radial = (row == 0 ? -s[0] : s[0]) + s[3] * a[row], axial = row == 0 ? -s[1] : s[1], along = s[1] * a[row], across = s[2] * a[row];
      sums[0][row][0] += radial * b[0] - along;
      sums[0][row][1] += radial * b[1] + along;
      sums[1][row][0] += axial * b[0] - across;
      sums[1][row][1] += axial * b[1] + across;
    }
  }
  __attribute__((noinline)) void force_groups(const block& b, std::size_t from, std::size_t to, std::size_t base, sums_of_row<2>& kept) {
    sums_of_row<2> state = kept;
    for (std::size_t k = from; k < to; ++k) {
      const group& g = b.groups[k];
      node_lanes<2> sums;
      clear<2>(sums);
      std::size_t at = g.first;
      for (std::size_t t = g.tile; t < g.tile + g.tiles; ++t) {
        const mask m = b.tiles[t], home = b.home[t];
        if (home == full) force_tile<true>(at - base, m, m, position<true>(at, m, g), sums);
        else {
          const place x = position<false>(at, m, g);
          force_tile<false>(at - base, m, home, x, sums);
          if (m != home) for_each_drift(m & ~home, x, [&](int rows, int steps, mask moved) {
              node_lanes<2> own;
              clear<2>(own);
              force_tile<false>(at - base, m, moved, x.moved(rows, steps), own);
              add<2>(force, g.row + rows, g.column + steps, own);
            });
        }
        at += static_cast<std::size_t>(std::popcount(m));
      }
      flush<2>(force, g, sums, state);
    }
    kept = state;
  }

  // ---- accelerate -------------------------------------------------------------------------------------------------------------------
  void accelerate() {
    for_each_node([this](std::size_t i) {
      const lanes total = at(node_mass, i), factor = select(total > lanes(0), dt_ / total, lanes(0));
      for (int k = 0; k < 2; ++k) put(change + k, i, at(force + k, i) * factor);
    });
    lanes gain(0);
    for (auto& b : blocks_) {
      sums_of_row<2> state;
      for_each_batch(b, [&](std::size_t from, std::size_t to, std::size_t, std::size_t, std::size_t base) {
        accelerate_groups(b, from, to, base, state, gain);
      });
      finish<2>(back, state);
    }
    lanes power(0);
    for_each_node([this, &power](std::size_t i) { // back: v + dv~/2 from here on
      const lanes total = at(node_mass, i), half = select(total > lanes(0), 0.5 / total, lanes(0));
      for (int k = 0; k < 2; ++k) {
        const lanes mean = at(velocity + k, i) + half * at(back + k, i);
        put(back + k, i, mean);
        power += at(force + k, i) * mean;
      }
    });
    energy.transfer += sum(gain) - sum(power) * dt_;
    energy.work_mismatch += sum(power) * dt_;
  }
  /// v and dv of the grid at the particles.
  static BOLIDE_INLINE void interpolate(const place& x, const node_lanes<4>& v, lanes (&seen)[4]) {
    lanes a[2], b[2];
    x.weights(a, b);
    const lanes n[2][2] = {{a[0] * b[0], a[0] * b[1]}, {a[1] * b[0], a[1] * b[1]}};
    for (int k = 0; k < 4; ++k) seen[k] = v[k][0][0] * n[0][0] + v[k][0][1] * n[0][1] + v[k][1][0] * n[1][0] + v[k][1][1] * n[1][1];
  }
  static BOLIDE_INLINE void give_back(const place& x, const lanes (&momentum)[2], node_lanes<2>& sums) {
    lanes a[2], b[2];
    x.weights(a, b);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k) sums[k][i][j] += momentum[k] * (a[i] * b[j]);
  }
  template <bool Full>
  BOLIDE_INLINE void accelerate_tile(std::size_t at, std::size_t i, mask m, mask home, mask& home_next, const group& g, const node_lanes<4>& v,
                                     node_lanes<2>& sums, lanes& gain) {
    const lanes radius = get<Full>(&of[r][at], m), height = get<Full>(&of[z][at], m), own_mass = get<Full>(&of[particle_mass][at], m);
    const lanes velocities[2] = {get<Full>(&of[vr][at], m), get<Full>(&of[vz][at], m)};
    const place x = position(radius, height, g);
    lanes seen[4], after[2], carry[2], momentum[2];
    interpolate(x, v, seen);
    if constexpr (!Full)
      if (m != home) for_each_drift(m & ~home, x, [&](int rows, int steps, mask moved) {
          node_lanes<4> there;
          fetch<2>(velocity, g.row + rows, g.column + steps, there);
          fetch<2>(change, g.row + rows, g.column + steps, there + 2);
          lanes own[4];
          interpolate(x.moved(rows, steps), there, own);
          for (int k = 0; k < 4; ++k) seen[k] = pick(moved, own[k], seen[k]);
        });
    for (int k = 0; k < 2; ++k) {
      const lanes dv = seen[2 + k];
      momentum[k] = own_mass * dv; // no particle, no mass
      gain += momentum[k] * (velocities[k] + 0.5 * dv);
      after[k] = velocities[k] + dv;
      carry[k] = seen[k] + dv;
    }
    if constexpr (Full) {
      give_back(x, momentum, sums);
      store(after[0], &of[vr][at]);
      store(after[1], &of[vz][at]);
      store(carry[0], &of[ur][at]);
      store(carry[1], &of[uz][at]);
    } else {
      const auto scatter = [&](mask part, const place& where, node_lanes<2>& to) {
        const lanes kept[2] = {keep(part, momentum[0]), keep(part, momentum[1])};
        give_back(where, kept, to);
      };
      scatter(home, x, sums);
      if (m != home) for_each_drift(m & ~home, x, [&](int rows, int steps, mask moved) {
          node_lanes<2> own;
          clear<2>(own);
          scatter(moved, x.moved(rows, steps), own);
          add<2>(back, g.row + rows, g.column + steps, own);
        });
      for (std::size_t k = 0; k < 2; ++k) {
        store(gathered(m, after[k]), &buffer_[k][i]);
        store(gathered(m, carry[k]), &buffer_[2 + k][i]);
      }
    }
    home_next = position(radius + dt_ * carry[0], height + dt_ * carry[1], g).inside() & m;
  }
  __attribute__((noinline)) void accelerate_groups(block& b, std::size_t from, std::size_t to, std::size_t base, sums_of_row<2>& kept, lanes& gain) {
    sums_of_row<2> state = kept;
    lanes total = gain;
    for (std::size_t k = from; k < to; ++k) {
      const group& g = b.groups[k];
      node_lanes<4> v;
      fetch<2>(velocity, g.row, g.column, v);
      fetch<2>(change, g.row, g.column, v + 2);
      node_lanes<2> sums;
      clear<2>(sums);
      std::size_t at = g.first;
      auto buffered = [&, copied = at](std::size_t upto, bool is_buffered) mutable { // buffered particles go to their columns
        if (is_buffered)
          for (; copied < upto; copied += width)
            for (std::size_t i = 0; i < 4; ++i) store_lanes(load<lanes>(&buffer_[i][copied - base]), &of[vr + i][copied], first(upto - copied));
        copied = upto;
      };
      bool through_buffer = false;
      for (std::size_t t = g.tile; t < g.tile + g.tiles; ++t) {
        const mask m = b.tiles[t], home = b.home[t];
        const std::size_t next = at + static_cast<std::size_t>(std::popcount(m));
        const bool whole = home == full;
        if (whole == through_buffer) {
          buffered(at, through_buffer);
          through_buffer = !whole;
        }
        if (whole) accelerate_tile<true>(at, at - base, m, home, b.home_next[t], g, v, sums, total);
        else accelerate_tile<false>(at, at - base, m, home, b.home_next[t], g, v, sums, total);
        b.dirty += b.home_next[t] != m ? 1 : 0;
        at = next;
      }
      buffered(at, through_buffer);
      flush<2>(back, g, sums, state);
    }
    gain = total;
    kept = state;
  }

  // ---- work and move ------------------------------------------------------------------------------------------------------------------
  void work_and_move() {
    for (auto& b : blocks_) {
      for_each_batch(b, [&](std::size_t from, std::size_t to, std::size_t begin, std::size_t end, std::size_t base) {
        gradient_groups(back, b, from, to, base);
        work_particles(begin, end, base);
      });
      b.home.swap(b.home_next);
      const bool mixed = 10 * b.dirty > b.tiles.size();
      b.dirty = 0;
      if (mixed) sort(b);
    }
  }
  __attribute__((noinline)) void work_particles(std::size_t begin, std::size_t end, std::size_t base) {
    const double h = law_.h;
    lanes heat(0), work(0);
    for_each_pack(begin, end, base, [&]<bool Full>(std::size_t at, mask active) __attribute__((always_inline)) {
      work_lanes<Full>(h, dt_, at, at - base, active, heat, work);
    });
    energy.viscous_heating += sum(heat);
    energy.work_mismatch += sum(work);
  }
  template <bool Full> BOLIDE_INLINE void work_lanes(double h, double dt, std::size_t at, std::size_t i, mask active, lanes& heat, lanes& work) {
    const lanes radius = load<lanes>(&of[r][at]), height = load<lanes>(&of[z][at]), own_mass = load<lanes>(&of[particle_mass][at]);
    const lanes inverse = 1.0 / (radius * own_mass), v = load<lanes>(&of[volume][at]);
    const increment l = buffered(i, h * (inverse * own_mass));
    const lanes trace = l.trace(), viscous = -load<lanes>(&of[q][at]) * trace;
    const lanes shape = contract(load<lanes>(&of[srr][at]), load<lanes>(&of[szz][at]), load<lanes>(&of[srz][at]), l);
    const lanes gain = v * (viscous - load<lanes>(&of[p][at]) * trace + shape);
    heat += Full ? viscous * v : keep(active, viscous * v);
    work += Full ? gain : keep(active, gain);
    keep_column<Full>(e, at, active, load<lanes>(&of[e][at]) + gain * (inverse * radius));
    keep_column<Full>(r, at, active, radius + dt * load<lanes>(&of[ur][at]));
    keep_column<Full>(z, at, active, height + dt * load<lanes>(&of[uz][at]));
  }
};

/// The block of block_scene.hpp in a box `margin` cells wider on all sides; f(x, v) may change position and velocity of a particle.
template <class F> std::unique_ptr<rz> by_hand(const bolide::scenes::block<2>& scene, int margin, F&& f, double courant = 0.4) {
  textbook::box<2> domain{{}, {}, scene.h};
  for (std::size_t d = 0; d < 2; ++d) {
    domain.origin[d] = scene.corner() - margin * scene.h;
    domain.nodes[d] = scene.cells + 2 * margin + 1;
  }
  auto sim = std::make_unique<rz>(scene.metal, domain, courant);
  bolide::for_each_lattice_point(scene.geometry(), scene.geometry().anchor(), scene.spacing(), true, [&](bolide::vec<double, 2> x) {
    auto v = scene.velocity(x);
    const double mass = scene.metal.rho0 * bolide::space::axisymmetric::volume(x.data(), scene.spacing() * scene.spacing());
    f(x, v);
    sim->append(x[0], x[1], v[0], v[1], mass);
  });
  return sim;
}
inline std::unique_ptr<rz> by_hand(const bolide::scenes::block<2>& scene) {
  return by_hand(scene, scene.margin, [](const auto&, const auto&) {});
}

} // namespace hand_written
