// SPDX-License-Identifier: MIT
// Linear algebra of the library: the only header that includes Eigen.
#pragma once

#include <Eigen/Core>

namespace bolide {

/// A point, a velocity: N components in the order of the space's axes (r, z in axisymmetry).
template <class T, int N> using vec = Eigen::Matrix<T, N, 1>;

/// The values of one grid node, kept together so that a transfer is one multiply-add of a register per node.
template <class T, int N> using node_values = Eigen::Array<T, N, 1>;

/// Node values are padded to a power of two so that they fill a register.
constexpr int padded(int n) { return n <= 1 ? 1 : n <= 2 ? 2 : n <= 4 ? 4 : 8; }

} // namespace bolide
