// SPDX-License-Identifier: MIT
// Contact between bodies that keep a velocity field of their own (Bardenhagen, Brackbill, Sulsky 2000), with Coulomb friction.
//
// On a node that two bodies share, with u the velocity of one of them relative to their centre of mass and n its outward normal:
//   u.n <= 0   they part: nothing is done
//   u.n >  0   the normal part is taken away, and of the tangential part at most friction times as much
// friction = 0 is slip, infinity is stick. Equal and opposite on the two bodies: momentum is kept; what is lost is booked in the ledger's
// channel `contact`. The normal is the gradient of volume of the body that has more of it there. On a node that three or more bodies
// share they stick. Validity: at corners the direction is right with linear shapes and off by some per cent with B-splines; contact is felt as soon as bodies share a node, up to a cell (linear) or two (B-splines) before they touch.
// Cost: node values per body, one more sweep.
#pragma once

#include "bolide/concepts/contact.hpp"
#include "bolide/core/contract.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bolide::contact {

struct frictional {
  static constexpr bool multi_field = true;
  static constexpr const char* name = "frictional";

  double friction; // Coulomb's coefficient

  explicit frictional(double mu = 0) : friction(mu) { require(mu >= 0, "coefficient of friction", mu, "non-negative"); }

  /// Change of the velocity `u` of a body relative to the centre of mass, m/s; n is its unit outward normal.
  template <class T, std::size_t Dim> std::array<T, Dim> correction(const std::array<T, Dim>& u, const std::array<T, Dim>& n) const {
    T normal = 0, squares = 0;
    for (std::size_t d = 0; d < Dim; ++d) normal += u[d] * n[d];
    std::array<T, Dim> c{};
    if (!(normal > T(0))) return c;
    for (std::size_t d = 0; d < Dim; ++d) {
      c[d] = u[d] - normal * n[d]; // the tangential part
      squares += c[d] * c[d];
    }
    const T tangential = std::sqrt(squares);
    const T part = tangential > T(0) ? static_cast<T>(std::min(1.0, friction * static_cast<double>(normal / tangential))) : T(0);
    for (std::size_t d = 0; d < Dim; ++d) c[d] = -normal * n[d] - part * c[d];
    return c;
  }
};
static_assert(Contact<frictional>);

} // namespace bolide::contact
