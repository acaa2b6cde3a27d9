// SPDX-License-Identifier: MIT
// What one core of this machine can do, measured in the run that asks: the denominators of the shares that benchmarks report.
//
//   fma_rate<T>()             flop/s of fused multiply-adds in the widest pack, 12 independent chains (latency 4 x 2 units is 8; 14 registers)
//   update_bandwidth(bytes)   bytes/s of x <- a x + b over an array, read and written bytes both counted; 256 MiB is memory, 512 KiB the
//                             second-level cache
//   clock_rate()              Hz, of a chain of dependent integer additions (one per cycle; x86-64 only, elsewhere 0)
// Each takes the best of several tries in thread CPU time: other work on the machine only takes away. Some 0.1 s each.
#pragma once

#include "bolide/core/lane.hpp"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace bolide::limits {

/// CPU time of this thread, s.
inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
/// Shortest thread CPU time of `tries` calls, s.
template <class F> double shortest(int tries, F&& f) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tries; ++i) {
    const double begin = thread_seconds();
    f();
    best = std::min(best, thread_seconds() - begin);
  }
  return best;
}

inline constexpr int chains = 12;
template <class T> inline constexpr double flops_per_round = 2.0 * chains * native_width<T>;
/// `rounds` multiply-adds in each of the chains; returns a number that depends on all of them. One expression on the raw vector type: clang fuses
/// within an expression only.
template <class T> __attribute__((noinline)) T fma_chains(long rounds, T factor, T shift) {
  using vector = typename native_pack<T>::value_type;
  const vector a = native_pack<T>(factor).v, b = native_pack<T>(shift).v;
  vector x[chains];
  for (int k = 0; k < chains; ++k) x[k] = native_pack<T>(T(2 + k)).v; // 1 would be the fixed point of a = 0.999, b = 0.001
  for (long i = 0; i < rounds; ++i)
    for (int k = 0; k < chains; ++k) x[k] = x[k] * a + b;
  for (int k = 1; k < chains; ++k) x[0] += x[k];
  asm volatile(""); // not a pure function: every call is made
  return x[0][0];
}
template <class T> double fma_rate() {
  constexpr long rounds = 2'000'000;
  volatile T factor = T(0.999), shift = T(1e-3), sink = T(0); // unknown to the compiler
  const double seconds = shortest(7, [&] { sink = sink + fma_chains<T>(rounds, factor, shift); });
  return flops_per_round<T> * static_cast<double>(rounds) / seconds;
}

__attribute__((noinline)) inline void update(std::vector<double>& x, double factor, double shift) {
  for (double& v : x) v = v * factor + shift;
}
inline double update_bandwidth(std::size_t bytes) {
  std::vector<double> x(bytes / sizeof(double), 1.0);
  const int rounds = static_cast<int>(std::max<std::size_t>(1, (std::size_t{1} << 28) / bytes)); // 256 MiB in a try
  const double seconds = shortest(7, [&] {
    for (int i = 0; i < rounds; ++i) update(x, 0.999, 1e-3);
  });
  return 2.0 * static_cast<double>(x.size() * sizeof(double)) * rounds / seconds;
}
inline constexpr std::size_t memory_bytes = std::size_t{256} << 20, second_level_bytes = std::size_t{512} << 10;

inline double clock_rate() {
#if defined(__x86_64__)
  constexpr long additions = 20'000'000;
  const double seconds = shortest(7, [] {
    long x = 1;
    const long one = 1;
    for (long i = 0; i < additions / 10; ++i)
      asm volatile("add %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0\n\tadd %1,%0"
                   : "+r"(x)
                   : "r"(one));
  });
  return static_cast<double>(additions) / seconds;
#else
  return 0;
#endif
}

} // namespace bolide::limits
