// SPDX-License-Identifier: MIT
// Particle storage: one contiguous column per component of every declared field (structure of arrays), and nothing else but an id.
//
// Columns are padded by one register so that a lane may read past the last particle; what it reads there is a copy of a particle.
// Cost: bytes_per_particle, pinned by tests for named compositions.
#pragma once

#include "bolide/core/field.hpp"
#include "bolide/core/lane.hpp"
#include "bolide/core/staggered.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bolide::particles {

template <class T, class Space, class Fields> class columns;

template <class T, class Space, class... F> class columns<T, Space, fields<F...>> {
public:
  using scalar = T;
  using space = Space;
  using field_list = fields<F...>;
  static constexpr int column_count = (Space::components(F::order) + ... + 0);
  static constexpr std::size_t bytes_per_particle = sizeof(T) * column_count + sizeof(std::uint32_t);
  template <class Tag> static constexpr bool has = field_list::template contains<Tag>;

  std::size_t size() const { return id_.size(); }

  /// Column of one component of a field.
  template <class Tag> T* get(int component = 0) { return data_[static_cast<std::size_t>(first<Tag>() + component)].data(); }
  template <class Tag> const T* get(int component = 0) const { return data_[static_cast<std::size_t>(first<Tag>() + component)].data(); }
  /// Identity of a particle: the order in which it was seeded, kept through every sort.
  std::uint32_t* id() { return id_.data(); }
  const std::uint32_t* id() const { return id_.data(); }

  /// Appends a particle whose fields are all zero; returns its index.
  std::size_t append(std::uint32_t id) {
    const std::size_t i = size();
    id_.push_back(id);
    for (auto& c : data_) {
      c.resize(i + 1 + padding, T(0));
      c[i] = T(0);
    }
    return i;
  }

  /// New particle i is old particle order[i]; particles that are not named are dropped.
  void reorder(const std::vector<std::uint32_t>& order) {
    std::vector<T> moved(order.size() + padding);
    for (auto& c : data_) {
      for (std::size_t i = 0; i < order.size(); ++i) moved[i] = c[order[i]];
      for (std::size_t i = order.size(); i < moved.size(); ++i) moved[i] = order.empty() ? T(0) : moved[order.size() - 1];
      c.assign(moved.begin(), moved.end());
    }
    std::vector<std::uint32_t> ids(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) ids[i] = id_[order[i]];
    id_.swap(ids);
  }

  /// The same for the particles from `begin` on alone: new particle begin + i is old particle begin + order[i].
  void reorder(std::size_t begin, const std::vector<std::uint32_t>& order) {
    std::vector<T> moved(order.size());
    for (auto& c : data_) {
      for (std::size_t i = 0; i < order.size(); ++i) moved[i] = c[begin + order[i]];
      std::copy(moved.begin(), moved.end(), c.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    std::vector<std::uint32_t> ids(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) ids[i] = id_[begin + order[i]];
    std::copy(ids.begin(), ids.end(), id_.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  /// Every column with its padding, and the ids, in their present order (concepts/archive.hpp).
  template <class A> void archive(A& a) {
    a.value("id", id_);
    const auto field_columns = [&]<class Tag>(Tag) {
      for (int c = 0; c < Space::components(Tag::order); ++c) {
        auto& stored = data_[static_cast<std::size_t>(first<Tag>() + c)];
        std::vector<T> column(stored.begin(), stored.end());
        const std::string number = Space::components(Tag::order) > 1 ? "_" + std::to_string(c) : "";
        a.value(Tag::name + number, column);
        if constexpr (A::reading) stored.assign(column.begin(), column.end());
        a.expect(column.size() == (size() == 0 ? column.size() : size() + padding), "the column " + (Tag::name + number) + " has another length than the ids");
      }
    };
    (field_columns(F{}), ...);
  }

private:
  static constexpr std::size_t padding = 16;
  template <class Tag> static constexpr int first() {
    static_assert(has<Tag>, "bolide: this particle field is not stored: no model of the composition declares it");
    int at = 0;
    bool found = false;
    ((found = found || std::is_same_v<Tag, F>, at += found ? 0 : Space::components(F::order)), ...);
    return at;
  }
  std::array<staggered_vector<T>, static_cast<std::size_t>(column_count)> data_ = staggered_vectors<T, static_cast<std::size_t>(column_count)>();
  std::vector<std::uint32_t> id_;
};

} // namespace bolide::particles
