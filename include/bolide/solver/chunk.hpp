// SPDX-License-Identifier: MIT
// Consecutive particles of a range that go through a sweep together, few enough for their scratch to stay in the first-level cache.
#pragma once

#include "bolide/grid/sparse.hpp"
#include "bolide/material/report.hpp"
#include "bolide/solver/stencil.hpp"
#include "bolide/solver/tiles.hpp"

#include <cstddef>
#include <cstdint>

namespace bolide {

/// N numbers for every particle of a chunk, component by component. A register may be written from the last particle on.
template <class T, int N> struct chunk_scratch {
  alignas(64) T value[N][chunk_size];
  T* operator[](int c) { return value[c]; }
  const T* operator[](int c) const { return value[c]; }
};

template <class T, class Space, class Shape> struct chunk {
  static constexpr int dim = Space::dim, support = Shape::support;

  std::size_t begin;        // first particle
  int n;                    // particles
  T inverse_h, half_size;   // 1/m; half a particle over h
  grid::cell_index<dim> origin;  // first node of the block
  alignas(64) T inverse_r[Space::hoop ? chunk_size : 1]; // 1/m
  const tile *tiles, *tiles_end; // solver/by_tiles.hpp; none where the range has none
  // the other particles' stencils (solver/by_rows.hpp)
  const std::int32_t* node;                            // of every place in the range's window
  alignas(64) std::int32_t first[chunk_size];          // place of the first node of the support
  alignas(64) T weight[dim][support][chunk_size];      // N along an axis
  alignas(64) T slope[dim][support][chunk_size];       // its derivative, 1/cell
  alignas(64) T moment[dim][support][chunk_size];      // N (x_n - x_p), cells
  alignas(64) T hoop_weight[Space::hoop ? support : 1][chunk_size]; // N_t of the radius
};

} // namespace bolide
