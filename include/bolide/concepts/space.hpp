// SPDX-License-Identifier: MIT
// The role "space": how many axes are there, what is a gradient, what is a deviator, and how are they combined?
//
// See space/axisymmetric.hpp for the members with their meaning. Invariants: contract(deviatoric_rate(L), s) = s : D,
// divergence(L) = tr D, jacobian(L, dt) = det(I + dt L).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class S, class V = double>
concept Space = requires(const typename S::template gradient<V> l, const typename S::template deviator<V> s, V x, const double* at) {
  { S::dim } -> std::convertible_to<int>;
  { S::hoop } -> std::convertible_to<bool>;
  { S::components(rank::vector) } -> std::convertible_to<int>;
  { S::volume(at, 1.0) } -> std::convertible_to<double>;
  { S::divergence(l) } -> std::convertible_to<V>;
  { S::jacobian(l, x) } -> std::convertible_to<V>;
  { S::contract(s, s) } -> std::convertible_to<V>;
  { S::deviatoric_rate(l) } -> std::convertible_to<typename S::template deviator<V>>;
  { S::jaumann_rate(s, l) } -> std::convertible_to<typename S::template deviator<V>>;
};

} // namespace bolide
