// SPDX-License-Identifier: MIT
// --shape linear --transfer flip --precision double, with both schemes
#include "composition.hpp"
#include "compositions.hpp"

#include "bolide/shape/linear.hpp"

namespace impact {
template <> std::unique_ptr<simulation> compose_linear_flip(const settings& s, const chosen_material<double>& ball,
                                                            const chosen_material<double>& plate) {
  return compose<double, bolide::shape::linear, bolide::transfer::flip>(s, ball, plate);
}
} // namespace impact
