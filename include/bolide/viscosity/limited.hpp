// SPDX-License-Identifier: MIT
// Modifier: an artificial viscosity that is limited by the shape of the flow, q <- f q, all from the velocity gradient L of the particle alone.
//
//   shear limiter      f = |D| / (|D| + |w|)                              D = tr L, w the vorticity |curl v| (Balsara)
//   isotropy limiter   f = min(1, sqrt(3/2) |dev| / |D|)                  |dev|^2 = d:d, d the deviator of the rate of deformation
// Each is a choice; both multiply. In a planar shock D = -a, w = 0 and |dev|^2 = 2 a^2/3: both factors are 1 and q is unchanged.
//   shear limiter: removes q where a flow mostly shears and compresses a little (a boundary layer, a vortex, numerical noise in either). Balsara's
//     noise term (1e-4 c/h beside |w|) is left out: it would take 1e-4 of a shock's q as well.
//   isotropy limiter: uniform compression from all sides (a homologous implosion, L = -a I) makes no q, uniform compression from two sides half.
//     It says nothing of a uniform compression along one axis: L alone cannot tell an isentropic ramp from a shock, for that needs the change of L
//     across the cell. Where a shock converges on a point, L behind it tends to isotropy and q is lost too: off by default.
// The time step goes on counting q in full. Cost: a square root and a division per limiter, particle and step.
#pragma once

#include "bolide/core/lane.hpp"
#include "bolide/core/math.hpp"
#include "bolide/viscosity/bulk.hpp"

#include <limits>

namespace bolide::viscosity {

template <class Viscosity> struct limited : Viscosity {
  bool shear;
  bool isotropy;

  explicit limited(Viscosity v = Viscosity(), bool by_shear = true, bool by_isotropy = false) : Viscosity(v), shear(by_shear), isotropy(by_isotropy) {}

  /// f from tr L (1/s), |curl v|^2 and d:d (1/s2).
  template <class V> BOLIDE_INLINE V factor(V divergence, V vorticity2, V deviatoric2) const {
    using T = scalar_t<V>;
    const V d = max(abs(divergence), V(std::numeric_limits<T>::min()));
    V f(T(1));
    if (shear) f = d / (d + sqrt(vorticity2));
    if (isotropy) f = f * min(V(T(1)), sqrt(T(1.5) * deviatoric2) / d);
    return f;
  }
};

} // namespace bolide::viscosity
