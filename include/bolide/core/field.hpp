// SPDX-License-Identifier: MIT
// Particle fields are declared: a model lists the tags of the fields that it needs, and the storage of a body is the union of the
// lists of everything that it is composed of. What nobody declares is not stored.
//
// A tag carries name, unit and rank; how many numbers a rank takes is the space's answer (a deviator has one independent
// component in 1-D and three in r-z).
#pragma once

#include <type_traits>

namespace bolide {

enum class rank { scalar, vector, deviator, gradient };

namespace field {
struct mass { static constexpr auto name = "mass", unit = "kg"; static constexpr rank order = rank::scalar; };
struct position { static constexpr auto name = "position", unit = "m"; static constexpr rank order = rank::vector; };
struct velocity { static constexpr auto name = "velocity", unit = "m/s"; static constexpr rank order = rank::vector; };
struct volume { static constexpr auto name = "volume", unit = "m3"; static constexpr rank order = rank::scalar; };          // spatial, void included
struct energy { static constexpr auto name = "energy", unit = "J/kg"; static constexpr rank order = rank::scalar; };        // specific internal energy
struct pressure { static constexpr auto name = "pressure", unit = "Pa"; static constexpr rank order = rank::scalar; };      // of the equation of state
struct viscous_pressure { static constexpr auto name = "viscous_pressure", unit = "Pa"; static constexpr rank order = rank::scalar; };
struct sound_speed { static constexpr auto name = "sound_speed", unit = "m/s"; static constexpr rank order = rank::scalar; };
struct deviator { static constexpr auto name = "deviator", unit = "Pa"; static constexpr rank order = rank::deviator; };
struct plastic_strain { static constexpr auto name = "plastic_strain", unit = "1"; static constexpr rank order = rank::scalar; };
struct shear_modulus { static constexpr auto name = "shear_modulus", unit = "Pa"; static constexpr rank order = rank::scalar; };    // where it varies
/// 0 sound, 1 failed, 2 failed and settled at zero pressure in an open void: what changes the energy of such a particle sets it back to 1.
struct failed { static constexpr auto name = "failed", unit = "1"; static constexpr rank order = rank::scalar; };
struct material_volume { static constexpr auto name = "material_volume", unit = "m3"; static constexpr rank order = rank::scalar; }; // without the void
struct damage { static constexpr auto name = "damage", unit = "1"; static constexpr rank order = rank::scalar; };                   // 1: fails
/// Of a failed point that softens: the part of its capacity that is gone (0 .. 1), and the tension that it bore when it failed.
struct lost_capacity { static constexpr auto name = "lost_capacity", unit = "1"; static constexpr rank order = rank::scalar; };
struct held_tension { static constexpr auto name = "held_tension", unit = "Pa"; static constexpr rank order = rank::scalar; };
struct peak_pressure { static constexpr auto name = "peak_pressure", unit = "Pa"; static constexpr rank order = rank::scalar; };
struct carrying_velocity { static constexpr auto name = "carrying_velocity", unit = "m/s"; static constexpr rank order = rank::vector; }; // moves the particle
struct velocity_residual { static constexpr auto name = "velocity_residual", unit = "m/s"; static constexpr rank order = rank::vector; }; // unseen by the grid
struct filter_loss { static constexpr auto name = "filter_loss", unit = "J/kg"; static constexpr rank order = rank::scalar; };
struct affine_velocity { static constexpr auto name = "affine_velocity", unit = "1/s"; static constexpr rank order = rank::gradient; };
} // namespace field

/// A list of field tags.
template <class... F> struct fields {
  static constexpr int count = sizeof...(F);
  template <class Tag> static constexpr bool contains = (std::is_same_v<Tag, F> || ...);
};

namespace detail {
template <class List, class Tag> struct add_field;
template <class... F, class Tag> struct add_field<fields<F...>, Tag> {
  using type = std::conditional_t<fields<F...>::template contains<Tag>, fields<F...>, fields<F..., Tag>>;
};
template <class... Lists> struct field_union { using type = fields<>; };
template <class List> struct field_union<List> { using type = List; };
template <class A, class... Rest> struct field_union<A, fields<>, Rest...> { using type = typename field_union<A, Rest...>::type; };
template <class A, class F, class... More, class... Rest> struct field_union<A, fields<F, More...>, Rest...> {
  using type = typename field_union<typename add_field<A, F>::type, fields<More...>, Rest...>::type;
};
} // namespace detail

/// Union of field lists, duplicates removed, order of first mention kept.
template <class... Lists> using field_union_t = typename detail::field_union<Lists...>::type;

} // namespace bolide
