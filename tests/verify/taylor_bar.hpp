// SPDX-License-Identifier: MIT
// Taylor bar of OFHC copper (Johnson 1988; deck and figures of a public 3-D MPM code): 25.4 mm long, 7.6 mm thick, 190 m/s on a rigid slip wall, 80
// us.
//
// rho 8930, E 117 GPa, nu 0.35, yield 157 MPa + 425 MPa times plastic strain, Mie-Grueneisen c0 3940, s 1.49, Gamma 1.96, viscosity 1.5/0.06. No
// exact answer: measured are final length, foot diameter and diameter at 0.2 L. The public code, 0.76 mm cells: 16.58, 13.50, 10.37 mm, total energy
// -0.95 %; the test (from memory): 16.2, 13.5, 10.1 mm. Particles are points: half a particle's first size is added at every end.
#pragma once

#include "verify/elastic.hpp"

#include "bolide/eos/mie_grueneisen.hpp"
#include "bolide/strength/linear_hardening.hpp"

#include <algorithm>

namespace bolide::verify {

struct taylor_bar {
  double length = 0, foot = 0, waist = 0; // mm: final length, foot diameter, diameter at 0.2 of the first length
  double strain = 0, drift = 0, plastic = 0, seconds = 0;
};

template <class Method> taylor_bar taylor(double h) {
  using point = vec<double, 2>;
  const double e = 117e9, nu = 0.35, dx = h / 2, first_length = 25.4 * mm;
  const material copper{eos::mie_grueneisen{{.rho0 = 8930, .c0 = 3940, .s = 1.49, .gamma0 = 1.96}},
                        strength::linear_hardening{e / (2 * (1 + nu)), 157e6, 425e6}, failure::none{}, viscosity::bulk{1.5, 0.06}};
  const body bar{"bar", box{point{0, 0}, point{3.8 * mm, first_length}}, copper, dx, initial_state{8930, 0}, point{0, -190}};
  solver sim{space::axisymmetric{},
             grid::sparse{h},
             typename Method::shape_type{},
             typename Method::transfer_type{},
             typename Method::scheme_type{},
             one_thread<typename Method::scalar>(),
             bar};
  sim.add(grid::mirror{1, 0, true});
  sim.run(80 * us);
  taylor_bar r;
  sim.for_each_body([&](const auto& s) {
    const auto& p = s.columns;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double radius = p.template get<field::position>(0)[i] + dx / 2, z = p.template get<field::position>(1)[i];
      r.length = std::max(r.length, (z + dx / 2) / mm);
      r.foot = std::max(r.foot, 2 * radius / mm);
      if (std::abs(z - 0.2 * first_length) < h / 2) r.waist = std::max(r.waist, 2 * radius / mm);
      r.strain = std::max(r.strain, p.template get<field::plastic_strain>()[i]);
    }
  });
  const auto& l = sim.energies();
  r.drift = l.drift();
  r.plastic = l.plastic_work / l.initial.kinetic;
  r.seconds = sim.solver_seconds();
  return r;
}

/// Cells of 0.76 mm, 0.38 mm, ... ; the bounds are for the finest.
template <class Method> void check_taylor(int resolutions) {
  taylor_bar r[3];
  for (int i = 0; i < resolutions; ++i) r[i] = taylor<Method>(0.76 * mm / (1 << i));
  const taylor_bar &fine = r[resolutions - 1], &coarse = r[resolutions - 2];
  char cells[60];
  std::snprintf(cells, sizeof cells, "cells of %.2f mm", 0.76 / (1 << (resolutions - 1)));
  const auto row = [&](const char* what, double value, double before, double test) {
    char note[120];
    std::snprintf(note, sizeof note, "%.2f mm; on cells twice as large %.2f mm", value, before);
    record({.section = "solids",
            .problem = "Taylor bar, copper, 190 m/s",
            .composition = composition<Method>("axisymmetric"),
            .measure = std::string(what) + " against the test (" + to_text(test) + " mm), " + cells,
            .value = value / test - 1,
            .bound = 0.04,
            .seconds = fine.seconds,
            .note = note});
    EXPECT_NEAR(value / test, 1, 0.04) << what;
    EXPECT_NEAR(value / before, 1, 0.05) << what;
  };
  row("final length", fine.length, coarse.length, 16.2);
  row("foot diameter", fine.foot, coarse.foot, 13.5);
  row("diameter at 0.2 L", fine.waist, coarse.waist, 10.1);
  EXPECT_GT(fine.plastic, 0.9); // most of the kinetic energy; the rest is viscous heat, elastic energy and vibration
  EXPECT_LT(fine.plastic, 1);
  EXPECT_LT(std::abs(fine.drift), 1e-12);
}

} // namespace bolide::verify
