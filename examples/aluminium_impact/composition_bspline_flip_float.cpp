// SPDX-License-Identifier: MIT
// --shape bspline --transfer flip --precision float, with both schemes
#include "composition.hpp"
#include "compositions.hpp"

#include "bolide/shape/quadratic_bspline.hpp"

namespace impact {
template <> std::unique_ptr<simulation> compose_bspline_flip(const settings& s, const chosen_material<float>& ball,
                                                             const chosen_material<float>& plate) {
  return compose<float, bolide::shape::quadratic_bspline, bolide::transfer::flip>(s, ball, plate);
}
} // namespace impact
