// SPDX-License-Identifier: MIT
// The role "contact": do bodies share one velocity on a node, and if not, what do they do to each other there?
//
// multi_field = false: one velocity field for all. multi_field = true: a field per body, and correction(u, n) gives the change of a body's node
// velocity from its velocity u relative to the centre of mass of the two and its unit outward normal n.
// Invariants: correction(-u, -n) = -correction(u, n), which keeps momentum; u.n <= 0 gives none.
#pragma once

#include <array>
#include <concepts>

namespace bolide {

template <class C>
concept Contact = requires {
  { C::multi_field } -> std::convertible_to<bool>;
  { C::name } -> std::convertible_to<const char*>;
} && (!C::multi_field || requires(const C contact, const std::array<double, 2>& u) {
  { contact.correction(u, u) } -> std::convertible_to<std::array<double, 2>>;
});

} // namespace bolide
