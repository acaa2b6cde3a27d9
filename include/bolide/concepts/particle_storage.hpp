// SPDX-License-Identifier: MIT
// The role "particle storage": where do the numbers of the particles lie?
//
//   get<field>(component)   pointer to the contiguous column of one component, lane loads past the end allowed by one register
//   has<field>, field_list, bytes_per_particle   what is stored, known at compile time
//   size(), append(id), reorder(order), id()     identity survives every sort
// Invariants: nothing is stored that no model declares; reading what is not stored is a compile error with a sentence.
// `ParticleStorage<P, field::a, field::b>` also asks that these fields are there.
#pragma once

#include "bolide/core/field.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bolide {

template <class P, class... Tags>
concept ParticleStorage = requires(P p, const P& is, std::uint32_t id, const std::vector<std::uint32_t>& order) {
  typename P::scalar;
  typename P::space;
  typename P::field_list;
  { P::bytes_per_particle } -> std::convertible_to<std::size_t>;
  { is.size() } -> std::convertible_to<std::size_t>;
  { p.append(id) } -> std::convertible_to<std::size_t>;
  p.reorder(order);
  { is.id() } -> std::convertible_to<const std::uint32_t*>;
} && (P::field_list::template contains<Tags> && ...) && (requires(P p, const P& is) {
  { p.template get<Tags>(0) } -> std::convertible_to<typename P::scalar*>;
  { is.template get<Tags>(0) } -> std::convertible_to<const typename P::scalar*>;
} && ...);

} // namespace bolide
