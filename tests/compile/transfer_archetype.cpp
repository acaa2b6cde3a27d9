// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a transfer, of either family, and the library's own.
#include "bolide/concepts/transfer.hpp"
#include "bolide/transfer/apic.hpp"
#include "bolide/transfer/flip.hpp"

struct least_transfer {
  using particle_fields = bolide::fields<>;
  static constexpr bool affine = false, wants_smooth_shape = false;
  static constexpr const char* name = "least";
};
struct affine_without_its_field : least_transfer {
  static constexpr bool affine = true;
  double heat = 1;
};
static_assert(bolide::Transfer<least_transfer> && bolide::Transfer<bolide::transfer::flip> && bolide::Transfer<bolide::transfer::apic>);
static_assert(!bolide::Transfer<affine_without_its_field>);
