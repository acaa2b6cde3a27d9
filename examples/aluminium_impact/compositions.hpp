// SPDX-License-Identifier: MIT
// The compositions that the program offers, each defined in composition_NAME.cpp.
#pragma once

#include "chosen_material.hpp"
#include "simulation.hpp"

#include <memory>

namespace impact {

template <class T>
std::unique_ptr<simulation> compose_linear_flip(const settings&, const chosen_material<T>& ball, const chosen_material<T>& plate);
template <class T>
std::unique_ptr<simulation> compose_bspline_flip(const settings&, const chosen_material<T>& ball, const chosen_material<T>& plate);
template <class T>
std::unique_ptr<simulation> compose_bspline_apic(const settings&, const chosen_material<T>& ball, const chosen_material<T>& plate);

} // namespace impact
