// SPDX-License-Identifier: MIT
// Linear algebra of the library: the only header that includes Eigen.
#pragma once

#include <Eigen/Core>

namespace bolide {

/// A point, a velocity: N components in the order of the space's axes (r, z in axisymmetry).
template <class T, int N> using vec = Eigen::Matrix<T, N, 1>;

} // namespace bolide
