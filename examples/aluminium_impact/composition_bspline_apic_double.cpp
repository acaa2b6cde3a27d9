// SPDX-License-Identifier: MIT
// --shape bspline --transfer apic --precision double, with both schemes
#include "composition.hpp"
#include "compositions.hpp"

#include "bolide/shape/quadratic_bspline.hpp"

namespace impact {
template <> std::unique_ptr<simulation> compose_bspline_apic(const settings& s, const chosen_material<double>& ball,
                                                             const chosen_material<double>& plate) {
  return compose<double, bolide::shape::quadratic_bspline, bolide::transfer::apic>(s, ball, plate);
}
} // namespace impact
