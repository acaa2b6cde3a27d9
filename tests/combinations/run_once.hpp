// SPDX-License-Identifier: MIT
// One composition run once: two small blocks that hit each other off centre, thirty steps, on any space, grid, shape, transfer, scheme and precision.
// Everything stays finite, mass is kept, momentum and energy are kept as the composition promises, and the books close.
#pragma once

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/failure/none.hpp"
#include "bolide/shape/cubic_bspline.hpp"
#include "bolide/shape/gimp.hpp"
#include "bolide/shape/linear.hpp"
#include "bolide/shape/quadratic_bspline.hpp"
#include "bolide/solver/solver.hpp"
#include "bolide/space/axisymmetric.hpp"
#include "bolide/space/cartesian_3d.hpp"
#include "bolide/space/planar_1d.hpp"
#include "bolide/space/plane_strain.hpp"
#include "bolide/strength/elastic_perfectly_plastic.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>

namespace bolide::combinations {

/// Is this combination allowed? The same rules as the solver's sentences.
template <class Shape, class Transfer, class Scheme>
inline constexpr bool allowed = (!Transfer::wants_smooth_shape || Shape::smooth) && (!Scheme::wants_smooth_shape || Shape::smooth) &&
                                (!Transfer::affine || requires { Shape::inertia; });

/// What went wrong; empty if nothing.
template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme> std::string run_once() {
  constexpr int dim = Space::dim;
  using point = vec<double, dim>;
  const double h = 1e-3, dx = h / 2;
  const auto at = [](double x, double y, double z) {
    const double all[] = {x, y, z};
    point p;
    for (int d = 0; d < dim; ++d) p[d] = all[d];
    return p;
  };
  const material metal{eos::mie_grueneisen{{}}, strength::elastic_perfectly_plastic{27e9, 0.3e9}, failure::none{}};
  const initial_state start{2785, 0};
  const body left{"left", box{at(0, 0, 0), at(3 * h, 3 * h, 2 * h)}, metal, dx, start, dim == 1 || Space::hoop ? at(dim == 1 ? 400 : 0, 400, 0) : at(50, 400, 20)};
  const body right{"right", box{at(dim == 1 ? 3 * h : 0, 3 * h, 0), at(dim == 1 ? 6 * h : 4 * h, 6 * h, 2 * h)}, metal, dx, start};
  controls<T> c;
  c.threads = 1;
  solver sim{Space{}, Grid{h}, Shape{}, Transfer{}, Scheme{}, c, left, right};
  const std::size_t particles = sim.particle_count();
  double most = 0; // largest pressure so far
  for (int i = 0; i < 30; ++i) {
    sim.step();
    std::string wrong;
    sim.for_each_body([&](const auto& s) {
      for (std::size_t k = 0; k < s.columns.size(); ++k) {
        const double p = static_cast<double>(s.columns.template get<field::pressure>()[k]);
        if (!std::isfinite(p)) wrong = "a pressure is not finite";
        most = std::max(most, p);
      }
    });
    if (!wrong.empty()) return wrong;
  }

  const double round_off = std::is_same_v<T, double> ? 1e-12 : 5e-5;
  const auto& e = sim.energies();
  if (sim.particle_count() != particles) return "particles were lost";
  if (!(std::abs(e.residual()) < round_off)) return "ledger residual " + std::to_string(e.residual());
  if (!(std::abs(e.drift()) < round_off)) return "energy drift " + std::to_string(e.drift());
  for (std::size_t d = 0; d < dim; ++d)
    if (!(Space::hoop && d == 0) && !(std::abs(e.momentum_error(d)) < 10 * round_off)) return "momentum error " + std::to_string(e.momentum_error(d));
  std::string wrong;
  if (!(most > 0.1e9 && most < 30e9)) wrong = "largest pressure " + std::to_string(most / 1e9) + " GPa (3.2 behind the shock; PIC smears it)";
  return wrong;
}

/// Runs a combination if it is allowed; prints and counts. False where something is wrong.
struct tally {
  int run = 0, refused = 0, wrong = 0;
};
template <class T, class Space, class Grid, class Shape, class Transfer, class Scheme> void try_one(tally& t) {
  if constexpr (!allowed<Shape, Transfer, Scheme>) ++t.refused;
  else {
    ++t.run;
    std::string wrong;
    try {
      wrong = run_once<T, Space, Grid, Shape, Transfer, Scheme>();
    } catch (const std::exception& stopped) {
      wrong = stopped.what();
    }
    if (wrong.empty()) return;
    ++t.wrong;
    std::printf("%s, %s grid, %s, %s, %s, %s: %s\n", Space::name, Grid::name, Shape::name, Transfer::name, Scheme::name, sizeof(T) == 4 ? "float" : "double", wrong.c_str());
  }
}

} // namespace bolide::combinations
