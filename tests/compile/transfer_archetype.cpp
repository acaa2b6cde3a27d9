// SPDX-License-Identifier: MIT
// expect: ok
// The least that is a transfer, of either family, and the library's own.
#include "bolide/concepts/transfer.hpp"
#include "bolide/transfer/apic.hpp"
#include "bolide/transfer/flip.hpp"
#include "bolide/transfer/pic.hpp"
#include "bolide/transfer/xpic.hpp"

struct least_transfer {
  using particle_fields = bolide::fields<>;
  static constexpr bool affine = false, wants_smooth_shape = false;
  static constexpr int filter_order = 0;
  static constexpr const char* name = "least";
};
struct affine_without_its_field : least_transfer {
  static constexpr bool affine = true;
  double heat = 1;
};
static_assert(bolide::Transfer<least_transfer> && bolide::Transfer<bolide::transfer::flip> && bolide::Transfer<bolide::transfer::apic> &&
              bolide::Transfer<bolide::transfer::pic> && bolide::Transfer<bolide::transfer::xpic<1>> && bolide::Transfer<bolide::transfer::xpic<4>>);
struct filter_without_heat : least_transfer {
  static constexpr int filter_order = 1;
};
static_assert(!bolide::Transfer<filter_without_heat>);
static_assert(!bolide::Transfer<affine_without_its_field>);
