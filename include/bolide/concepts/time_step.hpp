// SPDX-License-Identifier: MIT
// The role "time step": how long may a step be, and when is a run given up?
//
// The particles say what they ask for, a rate in 1/s (material/material.hpp, limit_step); a model gives the numbers that turn it into a
// step: `courant` divides the rates of sound, viscosity and velocity, `first_step` and `growth` bound the first step and the change
// from step to step, `dt_floor`, `energy_bound` and `step_cap` stop a run with a message. validate() throws bad_parameter.
// `scalar` is the number type of particles and nodes.
// Invariants: growth > 1 (the step recovers), 0 < courant inside the stable range that the model states.
#pragma once

#include <concepts>

namespace bolide {

template <class C>
concept TimeStep = std::floating_point<typename C::scalar> && requires(const C c) {
  { c.courant } -> std::convertible_to<double>;
  { c.first_step } -> std::convertible_to<double>;
  { c.growth } -> std::convertible_to<double>;
  { c.dt_floor } -> std::convertible_to<double>;
  { c.energy_bound } -> std::convertible_to<double>;
  { c.step_cap } -> std::convertible_to<long>;
  { c.threads } -> std::convertible_to<int>;
  c.validate();
};

} // namespace bolide
