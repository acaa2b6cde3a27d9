// SPDX-License-Identifier: MIT
// The door for a combination that is known to be unsound: accept_unsound<scheme::usl>{} is scheme::usl without its demand for a smooth
// shape function. For studies of what goes wrong; docs/verification.md has the figures.
#pragma once

namespace bolide {

template <class Model> struct accept_unsound : Model {
  static constexpr bool wants_smooth_shape = false;
};

} // namespace bolide
