// SPDX-License-Identifier: MIT
// The role "transfer": how do velocities go from the particles to the grid and back?
//
// The sweeps hold the two families (solver/phases.hpp): a particle keeps its velocity and adds the change of the grid (affine = false), or
// takes velocity and an affine field from the grid (affine = true). A model says which family it is of, which particle
// fields it needs, and whether it is sound with a shape function whose slope jumps. One that keeps velocities may filter them: filter_order m
// > 0 takes filter() times (1 - S S+)^m v_p away, S+ the map to the nodes and S the one back. A model that loses kinetic energy by
// design (affine, or filtered) gives `heat`, the fraction that is returned as heat; an affine one needs a shape of constant inertia.
// Invariants: momentum is kept; what is lost in kinetic energy is booked in the ledger's channel `transfer`.
#pragma once

#include "bolide/core/field.hpp"

#include <concepts>

namespace bolide {

template <class X>
concept Transfer = requires(const X transfer) {
  typename X::particle_fields;
  { X::affine } -> std::convertible_to<bool>;
  { X::wants_smooth_shape } -> std::convertible_to<bool>;
  { X::filter_order } -> std::convertible_to<int>;
  { X::name } -> std::convertible_to<const char*>;
} && (X::filter_order == 0 || requires(const X transfer) {
  { transfer.heat } -> std::convertible_to<double>;
  { transfer.filter() } -> std::convertible_to<double>;
}) && (!X::affine || requires(const X transfer) {
  { transfer.heat } -> std::convertible_to<double>;
  requires X::particle_fields::template contains<field::affine_velocity>;
});

} // namespace bolide
