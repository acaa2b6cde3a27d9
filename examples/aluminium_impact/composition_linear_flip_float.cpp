// SPDX-License-Identifier: MIT
// --shape linear --transfer flip --precision float, with both schemes
#include "composition.hpp"
#include "compositions.hpp"

#include "bolide/shape/linear.hpp"

namespace impact {
template <> std::unique_ptr<simulation> compose_linear_flip(const settings& s, const chosen_material<float>& ball,
                                                            const chosen_material<float>& plate) {
  return compose<float, bolide::shape::linear, bolide::transfer::flip>(s, ball, plate);
}
} // namespace impact
