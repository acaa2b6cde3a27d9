// SPDX-License-Identifier: MIT
// The role "failure": has this point failed?
//
// A model that may fail gives, per lane type V, the mask fails(pressure Pa, temperature K, melting temperature K, melt fraction), and
// lists field::failed and field::material_volume. Failure is for good. What a failed point still carries is the
// material's: compression, and neither shear nor tension.
#pragma once

#include "bolide/core/lane.hpp"

#include <concepts>

namespace bolide {

template <class F, class V = double>
concept Failure = requires { typename F::particle_fields; { F::may_fail } -> std::convertible_to<bool>; { F::wants_temperature } -> std::convertible_to<bool>; } &&
                  (!F::may_fail || requires(const F f, V x) {
                    { f.fails(x, x, x, x) } -> std::convertible_to<mask_t<V>>;
                  });

} // namespace bolide
