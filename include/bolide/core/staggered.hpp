// SPDX-License-Identifier: MIT
// Vectors that begin at different places of a page. A sweep reads a dozen columns at the same index; were they all to begin at the start of a page,
// as large allocations do, their lines would compete for the same few sets of the first-level cache.
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace bolide {

/// Number `place` of a group of vectors begins 5 cache lines further in its page than number `place` - 1.
template <class T> class staggered_allocator {
public:
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  explicit staggered_allocator(std::size_t place = 0) : offset_(place % 12 * 5 * line) {}
  template <class U> staggered_allocator(const staggered_allocator<U>& o) : offset_(o.offset()) {}

  T* allocate(std::size_t n) { return reinterpret_cast<T*>(static_cast<std::byte*>(::operator new(n * sizeof(T) + offset_, page)) + offset_); }
  void deallocate(T* p, std::size_t) { ::operator delete(reinterpret_cast<std::byte*>(p) - offset_, page); }
  std::size_t offset() const { return offset_; }
  friend bool operator==(const staggered_allocator& a, const staggered_allocator& b) { return a.offset_ == b.offset_; }

private:
  static constexpr std::size_t line = 64;
  static constexpr std::align_val_t page{4096};
  std::size_t offset_;
};

template <class T> using staggered_vector = std::vector<T, staggered_allocator<T>>;

/// N of them, each with a place of its own.
template <class T, std::size_t N> std::array<staggered_vector<T>, N> staggered_vectors() {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return std::array<staggered_vector<T>, N>{staggered_vector<T>(staggered_allocator<T>(I))...}; }(std::make_index_sequence<N>{});
}

} // namespace bolide
