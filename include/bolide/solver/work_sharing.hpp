// SPDX-License-Identifier: MIT
// Who does which part of a loop: every thread its own part first, the same one in every loop over the same list, then what the others have not begun.
//
// What lies in a thread's part stays in its core's cache from one loop to the next, and a part that takes longer is finished by all. Which thread does
// what changes nothing of the answer: the places of a list do not depend on each other.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace bolide {

class work_sharing {
public:
  /// Before the threads: for so many lists.
  void begin(std::size_t lists, int threads) {
    threads_ = static_cast<std::size_t>(threads);
    if (next_.size() < lists * threads_) next_ = std::vector<counter>(lists * threads_);
    for (auto& n : next_) n.value.store(0, std::memory_order_relaxed);
  }
  /// In every thread: f(i) for the places 0 .. n - 1 of a list, each in one thread. Returns when all are done.
  template <class F> void run(std::size_t list, std::size_t n, F&& f) {
#if defined(_OPENMP)
    const auto threads = static_cast<std::size_t>(omp_get_num_threads()), own = static_cast<std::size_t>(omp_get_thread_num());
#else
    constexpr std::size_t threads = 1, own = 0;
#endif
    for (std::size_t k = 0; k < threads; ++k) {
      const std::size_t part = (own + k) % threads, end = n * (part + 1) / threads;
      std::atomic<std::size_t>& next = next_[list * threads_ + part].value;
      for (std::size_t i; (i = n * part / threads + next.fetch_add(1, std::memory_order_relaxed)) < end;) f(i);
    }
#if defined(_OPENMP)
#pragma omp barrier
#endif
  }

private:
  struct alignas(64) counter { // a cache line of its own
    std::atomic<std::size_t> value{0};
    counter() = default;
    counter(const counter&) {} // a copied solver begins its loops anew
    counter& operator=(const counter&) { return *this; }
  };
  std::vector<counter> next_;
  std::size_t threads_ = 1;
};

} // namespace bolide
