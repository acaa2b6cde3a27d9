// SPDX-License-Identifier: MIT
// A view of some columns of a particle storage: the pointers to the fields of one list, whatever else the storage holds.
// It lets code that is compiled once per material work on the storage of any composition (material/any_material.hpp).
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/particles/columns.hpp"

namespace bolide::particles {

template <class T, class Space, class Fields> class column_view;

template <class T, class Space, class... F> class column_view<T, Space, fields<F...>> {
public:
  using scalar = T;
  using space = Space;
  template <class Tag> static constexpr bool has = fields<F...>::template contains<Tag>;

  template <class Columns> explicit column_view(Columns& p) : id_(p.id()) {
    std::size_t at = 0;
    (add<F>(p, at), ...);
  }
  template <class Tag> T* get(int component = 0) const { return column_[first<Tag>() + static_cast<std::size_t>(component)]; }
  const std::uint32_t* id() const { return id_; }

private:
  static constexpr std::size_t count = static_cast<std::size_t>((Space::components(F::order) + ... + 0));
  template <class Tag> static constexpr std::size_t first() {
    static_assert(has<Tag>, "bolide: this particle field is not stored: no model of the composition declares it");
    int at = 0;
    bool found = false;
    ((found = found || std::is_same_v<Tag, F>, at += found ? 0 : Space::components(F::order)), ...);
    return static_cast<std::size_t>(at);
  }
  template <class Tag, class Columns> void add(Columns& p, std::size_t& at) {
    for (int c = 0; c < Space::components(Tag::order); ++c) column_[at++] = const_cast<T*>(p.template get<Tag>(c));
  }
  std::array<T*, count> column_;
  const std::uint32_t* id_;
};

} // namespace bolide::particles
