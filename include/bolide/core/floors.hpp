// SPDX-License-Identifier: MIT
// Floors, clamps and continuations of the time loop: each kind is counted wherever it acts, none is silent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace bolide {

enum class floor_kind : std::size_t {
  sound_speed,      // c^2 of the EOS below the material's floor: raised to it
  cold_energy,      // e below the cold curve: the EOS's linear continuation is used
  validity,         // density or energy outside the range that the EOS states: its documented continuation is used
  void_iteration,   // the zero-pressure volume of a failed point moved by the most that one step allows
  expansion,        // volume capped at expansion_limit times the reference volume
  reflected         // a particle crossed a mirror plane and was reflected
};
inline constexpr std::array<const char*, 6> floor_names{"sound_speed", "cold_energy", "validity", "void_iteration", "expansion", "reflected"};

/// How often each floor acted (particle-steps).
struct floor_counts {
  std::array<std::uint64_t, floor_names.size()> count{};
  void add(floor_kind kind, int n) { count[static_cast<std::size_t>(kind)] += static_cast<std::uint64_t>(n); }
  std::uint64_t operator[](floor_kind kind) const { return count[static_cast<std::size_t>(kind)]; }
  floor_counts& operator+=(const floor_counts& o) {
    for (std::size_t i = 0; i < count.size(); ++i) count[i] += o.count[i];
    return *this;
  }
};

} // namespace bolide
