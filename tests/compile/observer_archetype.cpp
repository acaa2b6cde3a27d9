// SPDX-License-Identifier: MIT
// expect: ok
// The least that is an observer.
#include "bolide/concepts/observer.hpp"

struct simulation {
  double time() const { return 0; }
};
struct least_observer {
  template <class Sim> void watch(const Sim& s) { last = s.time(); }
  template <class Sim> void finish(const Sim&) {}
  double last = 0;
};
struct never_finishes {
  template <class Sim> void watch(const Sim&) {}
};
static_assert(bolide::Observer<least_observer, simulation>);
static_assert(!bolide::Observer<never_finishes, simulation>);
