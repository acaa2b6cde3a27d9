// SPDX-License-Identifier: MIT
// The role "observer": who looks at a run while it runs?
//
// solver.run(until, observers...) calls watch(sim) at the start and after every step, and finish(sim) once when the end time is reached
// (not when a run stops with an error: what an observer wrote until then must be whole). watch decides by itself what is due.
// Two members are optional: `std::string last_output() const` names the file that it wrote last (empty: none yet), which the message of a run
// that stops repeats; `stopped(sim, message)` is called once when a run stops, to write a last word. The state may then hold what made it stop.
// Invariants: an observer changes nothing of the run; the same scene with and without it gives the same bits.
// Cost: watch is called every step, so a look that is not due costs a comparison.
// The solver lends itself as a non-const reference because energies() measures when it is asked; take `const auto&` otherwise.
#pragma once

namespace bolide {

template <class O, class Simulation>
concept Observer = requires(O& observer, Simulation& sim) {
  observer.watch(sim);
  observer.finish(sim);
};

} // namespace bolide
